"""Workers side by side, each with a process of the implementation."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from queue import SimpleQueue
from threading import Thread
from typing import Any, Self

from exactsweep.conform.run.outcome import Outcome, outcome_from_json
from exactsweep.conform.run.peer import SECONDS
from exactsweep.conform.run.process import TO_START
from exactsweep.conform.run.protocol import Hello, ProtocolError, read_hello
from exactsweep.corpus import Case, case_to_json
from exactsweep.geometry.number import quoted
from exactsweep.processes import Started

_Job = tuple[str, dict[str, Any]]

_ENDED = "the process that judges has ended"


class JudgeError(ValueError):
    """What could not be judged, by no fault of the implementation; the message says why."""


class Pool:
    """An implementation, started once for each worker; a context manager.

    Nothing that was started is left running after the `with` block, however it ends.

    Args:
        command: the program and its arguments.
        seconds: that an answer may take.
        workers: how many cases are worked on at a time.
        to_start: seconds that the implementation may take to say hello.

    Attributes:
        hello: what the implementation says of itself.
        complaints: what went wrong when it was told to end, once `finish` has been called.

    Raises:
        ProtocolError: the implementation cannot be started, or says no hello, or not always the
            same.
        JudgeError: a worker has ended.
    """

    def __init__(
        self,
        command: Sequence[str],
        *,
        seconds: float = SECONDS,
        workers: int = 1,
        to_start: float = TO_START,
    ) -> None:
        settings = {"command": list(command), "seconds": seconds, "to_start": to_start}
        self.complaints: list[str] = []
        self._workers: list[_Worker] = []
        try:
            self._workers += (_Worker(settings) for _ in range(workers))
            hellos = [worker.hello() for worker in self._workers]
            self.hello = hellos[0]
            if any(hello != self.hello for hello in hellos):
                raise ProtocolError("not all its processes say the same hello")
        except BaseException:
            self.kill()
            raise

    def judge(self, cases: Iterable[Case]) -> Iterator[Outcome]:
        """Put cases to the implementation.

        Args:
            cases: the cases; they are taken as they are needed.

        Returns:
            An iterator of their outcomes, in the order in which they come about.

        Raises:
            JudgeError: a case cannot be judged; outcomes that are under way are lost.
        """
        jobs = ((case.id, {"case": case_to_json(case)}) for case in cases)
        return (outcome for _, outcome in self._done(jobs))

    def smaller(self, outcomes: Iterable[Outcome], seconds: float) -> Iterator[tuple[str, Outcome]]:
        """Look for smaller cases that the implementation fails in the same way.

        Args:
            outcomes: of cases that it failed; with the case.
            seconds: after which no smaller one is looked for, for each of them.

        Returns:
            An iterator of pairs: the id of the first case, and the outcome of the smaller one.

        Raises:
            JudgeError: as by `judge`.
        """
        jobs = (
            (outcome.id, {"smaller": outcome.to_json(), "seconds": seconds}) for outcome in outcomes
        )
        return self._done(jobs)

    def _done(self, jobs: Iterable[_Job]) -> Iterator[tuple[str, Outcome]]:
        """Let the workers do jobs, an id and a message each."""
        waiting: SimpleQueue[_Job | None] = SimpleQueue()
        found: SimpleQueue[tuple[str, Outcome] | JudgeError] = SimpleQueue()
        for worker in self._workers:
            Thread(target=_work, args=(worker, waiting, found), daemon=True).start()
        under_way = 0
        try:
            for job in jobs:
                waiting.put(job)
                under_way += 1
                # One more for each worker, so that none waits for the next case to be made.
                if under_way >= 2 * len(self._workers):
                    yield _of(found.get())
                    under_way -= 1
            for _ in range(under_way):
                yield _of(found.get())
        finally:
            for _ in self._workers:
                waiting.put(None)

    def finish(self) -> None:
        """Say bye to the implementation, and note in `complaints` what goes wrong then.

        Raises:
            JudgeError: a worker has ended.
        """
        for worker in self._workers:
            worker.close_input()
        for worker in self._workers:
            complaint = worker.read()["complaint"]
            if complaint is not None:
                self.complaints.append(complaint)

    def kill(self) -> None:
        """End all workers and all that they started, at once."""
        for worker in self._workers:
            worker.kill()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self.kill()


def _work(
    worker: _Worker,
    waiting: SimpleQueue[_Job | None],
    found: SimpleQueue[tuple[str, Outcome] | JudgeError],
) -> None:
    """Do jobs until there is no more, in a thread."""
    while (job := waiting.get()) is not None:
        id, message = job
        try:
            found.put((id, worker.done(message)))
        except (OSError, ValueError) as error:
            found.put(JudgeError(f"case {quoted(id)}: {error}"))


def _of(outcome: tuple[str, Outcome] | JudgeError) -> tuple[str, Outcome]:
    if isinstance(outcome, JudgeError):
        raise outcome
    return outcome


class _Worker:
    """One worker, seen from the pool."""

    def __init__(self, settings: dict[str, Any]) -> None:
        # Without -P, modules of the working directory would come before those of Python.
        command = [sys.executable, "-P", "-m", "exactsweep.conform.run.worker"]
        self._started = Started(command, stderr=None)
        process = self._started.process
        assert process.stdin is not None
        assert process.stdout is not None
        self._to, self._from = process.stdin, process.stdout
        self._send(settings)

    def hello(self) -> Hello:
        said = self.read()
        if "refused" in said:
            raise ProtocolError(said["refused"])
        return read_hello(json.dumps(said["hello"]))

    def done(self, message: dict[str, Any]) -> Outcome:
        self._send(message)
        found = self.read()
        if "refused" in found:
            raise ValueError(found["refused"])
        return outcome_from_json(found)

    def read(self) -> dict[str, Any]:
        line = self._from.readline()
        if not line.endswith(b"\n"):
            raise JudgeError(_ENDED)
        found: dict[str, Any] = json.loads(line)
        return found

    def close_input(self) -> None:
        with suppress(BrokenPipeError):
            self._to.close()

    def kill(self) -> None:
        self._started.end()

    def _send(self, data: dict[str, Any]) -> None:
        try:
            self._to.write(json.dumps(data).encode() + b"\n")
            self._to.flush()
        except BrokenPipeError:
            raise JudgeError(_ENDED) from None
