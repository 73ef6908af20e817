"""Processes that judge side by side, each with a process of the implementation."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from concurrent.futures.process import BrokenProcessPool
from itertools import islice
from typing import Any

from exactsweep.conform.run.outcome import Outcome, judge_case, shrink_outcome
from exactsweep.conform.run.process import ProcessPeer, Terms
from exactsweep.conform.run.protocol import Hello, ProtocolError
from exactsweep.corpus import Case
from exactsweep.numbers.error import ExactSweepError, quote
from exactsweep.numbers.limits import keep_limits, list_limits
from exactsweep.processes import Pool

_ENDED = "the process that judges has ended"

# The id of a case, and what a process is to call for it.
_Call = tuple[str, Callable[..., Outcome], tuple[object, ...]]


class JudgeError(ExactSweepError):
    """A failure of judging, not of the implementation; the message says why."""


class Judges:
    """An implementation, started once for each process that judges it.

    `close` leaves nothing running that was started, however that goes on.

    Args:
        terms: the program, and what it may take.
        workers: how many cases are worked on at a time.

    Attributes:
        hello: the implementation's first line, about itself.
        complaints: errors as its processes ended; complete once `finish` has been called.

    Raises:
        ProtocolError: the implementation cannot be started, or says no hello, or not always the
            same.
        JudgeError: a process that judges was killed, or cannot be started.
    """

    def __init__(self, terms: Terms, workers: int = 1) -> None:
        self.complaints: list[str] = []
        try:
            self._pool = Pool(workers, keep_limits, list_limits())
        except OSError as error:
            raise JudgeError(f"no process can be started: {error.strerror or error}") from None
        try:
            hellos: list[Hello] = self._call_in_each(_start, terms)
            self.hello = hellos[0]
            if any(hello != self.hello for hello in hellos):
                raise ProtocolError("not all its processes say the same hello")
        except BaseException:
            self.close()
            raise

    def judge(self, cases: Iterable[Case]) -> Iterator[Outcome]:
        """Put cases to the implementation.

        Args:
            cases: the cases, read as they are needed.

        Returns:
            An iterator of their outcomes, in the order in which they are ready.

        Raises:
            JudgeError: a case cannot be judged; outcomes that are under way are lost.
        """
        jobs: Iterator[_Call] = ((case.id, _judge, (case,)) for case in cases)
        return (outcome for _, outcome in self._work_on(jobs))

    def shrink(self, outcomes: Iterable[Outcome], seconds: float) -> Iterator[tuple[str, Outcome]]:
        """Look for smaller cases that show the same fault of the implementation.

        Args:
            outcomes: of cases that it failed; with the case.
            seconds: after which no smaller one is looked for, for each of them.

        Returns:
            An iterator of pairs: the id of the first case, and the outcome of the smaller one.

        Raises:
            JudgeError: as by `judge`.
        """
        return self._work_on((outcome.id, _shrink, (outcome, seconds)) for outcome in outcomes)

    def finish(self) -> None:
        """Say bye to the implementation, and note in `complaints` what goes wrong then.

        Raises:
            JudgeError: a process that judges was killed.
        """
        self.complaints += filter(None, self._call_in_each(_finish))

    def close(self) -> None:
        """End all processes and all that they started, at once."""
        self._pool.close()

    def _work_on(self, jobs: Iterable[_Call]) -> Iterator[tuple[str, Outcome]]:
        jobs, pending = iter(jobs), dict[Future[Outcome], str]()
        # One more for each process, so that none waits for the next case to be made.
        most = 2 * self._pool.count  # pragma: no mutate: costs only time
        while (fresh := [*islice(jobs, most - len(pending))]) or pending:
            try:
                for id, function, arguments in fresh:
                    pending[self._pool.submit(function, *arguments)] = id
                done, _ = wait(pending, return_when=FIRST_COMPLETED)
                for future in [future for future in pending if future in done]:
                    id = pending.pop(future)
                    yield id, future.result()
            except BrokenProcessPool:
                raise JudgeError(f"case {quote(id)}: {_ENDED}") from None
            except (OSError, ValueError) as error:
                raise JudgeError(f"case {quote(id)}: {error}") from None

    def _call_in_each(self, function: Callable[..., Any], *arguments: object) -> list[Any]:
        try:
            return self._pool.call_in_each(function, *arguments)
        except BrokenProcessPool:
            raise JudgeError(_ENDED) from None


# The functions below run in the processes that judge.

_peer: ProcessPeer


def _start(terms: Terms) -> Hello:
    global _peer
    _peer = ProcessPeer(terms)
    return _peer.hello


def _judge(case: Case) -> Outcome:
    return judge_case(_peer, case, _peer.terms.rounding)


def _shrink(outcome: Outcome, seconds: float) -> Outcome:
    return shrink_outcome(_peer, outcome, seconds, _peer.terms.rounding)


def _finish() -> str | None:
    return _peer.close()
