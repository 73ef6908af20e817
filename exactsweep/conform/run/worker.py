"""`python -m exactsweep.conform.run.worker`: judges an implementation, in a process of its own.

The pool starts it and talks to it in JSON lines: the command and the limits in, the hello or a
refusal out; then a case in, or the outcome of one that is to be made smaller, and an outcome or a
refusal out; at the end of the input, the complaint about the implementation's end, or null. When
the pool is killed, the worker ends, too, and takes the implementation with it.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import time
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from threading import Thread
from typing import Any, NoReturn

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import Outcome, outcome_from_json, outcome_of, put_to, smaller
from exactsweep.conform.run.peer import Answer, Peer
from exactsweep.conform.run.process import ProcessPeer
from exactsweep.conform.run.protocol import ProtocolError
from exactsweep.corpus import Case, case_from_json

_LOOKING = 0.2
"""Seconds after which to look whether the pool is still there."""


TO_COMPARE = 60.0
"""Seconds that comparing one answer may take: a hostile one could keep us busy for hours."""


def main() -> None:
    """Do the work of the module."""
    signal.signal(signal.SIGTERM, lambda number, frame: sys.exit(1))
    Thread(target=_end_without, args=(os.getppid(),), daemon=True).start()
    settings = json.loads(sys.stdin.readline())
    try:
        peer = ProcessPeer(**settings)
    except ProtocolError as error:
        _write({"refused": str(error)})
        return
    try:
        _write({"hello": peer.hello.to_json()})
        for line in sys.stdin:
            try:
                _write(_done(peer, json.loads(line)).to_json())
            except ValueError as error:
                _write({"refused": str(error)})
        _write({"complaint": peer.close()})
    except BrokenPipeError:
        # The pool is gone; what is still in the buffer would fail again on exit.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    finally:
        peer.kill()


def _end_without(pool: int) -> None:
    """Ask this process to end once that of the pool is gone, whatever it is busy with."""
    while os.getppid() == pool:
        time.sleep(_LOOKING)
    os.kill(os.getpid(), signal.SIGTERM)


def _done(peer: ProcessPeer, job: dict[str, Any]) -> Outcome:
    if "smaller" in job:
        return smaller(peer, outcome_from_json(job["smaller"]), job["seconds"], judge)
    return judge(peer, case_from_json(job["case"]))


def judge(peer: Peer, case: Case) -> Outcome:
    """Judge a case, but do not compare for ever."""
    answer, put = put_to(peer, case)
    return outcome_in_time(case, put, answer, peer.hello.loops)


def _write(data: dict[str, Any]) -> None:
    print(json.dumps(data), flush=True)


class OvertimeError(Exception):
    """A computation took too long."""


@contextmanager
def overtime(seconds: float) -> Iterator[None]:
    """Stop what is in the `with` block after some seconds; in the main thread only.

    Raises:
        OvertimeError: it was stopped.

    Example:
        >>> with overtime(0.01):
        ...     while True:
        ...         pass
        Traceback (most recent call last):
        exactsweep.conform.run.worker.OvertimeError
    """

    def stop(number: int, frame: object) -> NoReturn:
        raise OvertimeError

    old = signal.signal(signal.SIGALRM, stop)
    try:
        signal.setitimer(signal.ITIMER_REAL, seconds)
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, old)


def outcome_in_time(case: Case, put: Case, answer: Answer, promised: Collection[str]) -> Outcome:
    """Judge an answer as `outcome_of` does; in the main thread only.

    Returns:
        The Outcome; its verdict is timeout if comparing takes more than TO_COMPARE seconds.
    """
    try:
        with overtime(TO_COMPARE):
            return outcome_of(case, put, answer, promised)
    except OvertimeError:
        reason = f"there is an answer, but comparing it takes more than {TO_COMPARE:g} s"
        late = Answer(verdict=Verdict.TIMEOUT, reason=reason, seconds=answer.seconds)
        return outcome_of(case, put, late, ())


if __name__ == "__main__":
    main()
