"""Balanced addition of many fractions.

A running sum of n fractions with unrelated denominators grows at each step, and each step computes
a greatest common divisor in quadratic time. `add_up` adds pairs, then pairs of sums, and so on, so
the last addition, which is unavoidable, takes half the time.
"""

from collections.abc import Iterable
from fractions import Fraction


def add_up(terms: Iterable[Fraction]) -> Fraction:
    """Add any number of fractions.

    Cost: O(s^2) for s digits in all denominators, if these have no common factors.

    >>> add_up(Fraction(1, k * (k + 1)) for k in range(1, 100))
    Fraction(99, 100)
    """
    sums = [*terms]
    while len(sums) > 1:
        pairs = zip(sums[::2], sums[1::2], strict=False)
        # An odd last term stays.
        sums = [one + other for one, other in pairs] + sums[len(sums) & ~1 :]
    return sums[0] if sums else Fraction(0)
