"""The shipped corpus, read once per process."""

from functools import cache

from exactsweep.corpus import Case, cases


@cache
def shipped_cases() -> tuple[Case, ...]:
    return tuple(cases())
