"""A limit on the time of a comparison in this process."""

from __future__ import annotations

import signal
from collections.abc import Collection, Iterator
from contextlib import contextmanager
from typing import NoReturn

from exactsweep.conform.outcome import Outcome, outcome_of
from exactsweep.conform.peer import Answer
from exactsweep.conform.verdict import Verdict
from exactsweep.corpus import Case

TO_COMPARE = 60.0
"""Seconds that comparing one answer may take: a hostile one could keep us busy for hours."""


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
        exactsweep.conform.overtime.OvertimeError
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
