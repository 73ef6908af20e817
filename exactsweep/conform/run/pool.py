"""Parallel judging processes, each with its own process of the program."""

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
from exactsweep.numbers.limits import get_limits, set_limits
from exactsweep.processes import Pool

_ENDED = "a judging process ended unexpectedly"
# The id of a case, a function and its arguments.
_Call = tuple[str, Callable[..., Outcome], tuple[object, ...]]


class JudgeError(ExactSweepError):
    """A failure of the judge, not of the program."""


class Judges:
    """Judging processes, each with its own copy of a program; `close` ends all of them."""

    def __init__(self, terms: Terms, workers: int = 1) -> None:
        self.complaints: list[str] = []  # how processes ended; complete after `finish`
        try:
            self._pool = Pool(workers, set_limits, get_limits())
        except OSError as error:
            raise JudgeError(f"cannot start a process: {error.strerror or error}") from None
        try:
            hellos: list[Hello] = self._call_in_each(_start, terms)
            self.hello = hellos[0]
            if any(hello != self.hello for hello in hellos):
                raise ProtocolError("the processes of the program report different hellos")
        except BaseException:
            self.close()
            raise

    def judge(self, cases: Iterable[Case]) -> Iterator[Outcome]:
        """Yield the outcomes of cases as they arrive; after a JudgeError, pending ones are lost."""
        jobs: Iterator[_Call] = ((case.id, _judge, (case,)) for case in cases)
        return (outcome for _, outcome in self._work_on(jobs))

    def shrink(self, outcomes: Iterable[Outcome], seconds: float) -> Iterator[tuple[str, Outcome]]:
        return self._work_on((outcome.id, _shrink, (outcome, seconds)) for outcome in outcomes)

    def finish(self) -> None:
        self.complaints += filter(None, self._call_in_each(_finish))

    def close(self) -> None:
        self._pool.close()

    def _work_on(self, jobs: Iterable[_Call]) -> Iterator[tuple[str, Outcome]]:
        jobs, pending = iter(jobs), dict[Future[Outcome], str]()
        # One spare case for each process.
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


# The functions below run in the judging processes.

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
