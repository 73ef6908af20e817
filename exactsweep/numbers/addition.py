"""Sums of many fractions, in about twice the time of the last addition.

A running sum of n fractions with unrelated denominators grows at each step, and each step computes
a greatest common divisor in quadratic time. `add_up` adds pairs, then pairs of sums, and so on, so
the last addition, which is unavoidable, takes half the time. Short fractions stay unreduced.
"""

from collections.abc import Callable, Iterable
from fractions import Fraction
from operator import add
from typing import TypeVar

_Pair = tuple[int, int]
_Term = TypeVar("_Term", _Pair, Fraction)

# Maximum length of unreduced fractions; in longer ones, common factors would cost more.
_BITS = 2000


def add_up(terms: Iterable[Fraction]) -> Fraction:
    """Add any number of fractions.

    Cost: O(s^2) for s digits in all denominators, if these have no common factors.

    >>> add_up(Fraction(1, k * (k + 1)) for k in range(1, 100))
    Fraction(99, 100)
    """
    return add_ratios(term.as_integer_ratio() for term in terms)


def add_ratios(terms: Iterable[_Pair]) -> Fraction:
    """Add fractions given as pairs of a numerator and a positive denominator, reduced or not."""
    pairs = [*terms]
    while len(pairs) > 1 and max(d for _, d in pairs).bit_length() < _BITS:
        pairs = _in_pairs(_add_unreduced, pairs)
    sums = [Fraction(n, d) for n, d in pairs]
    while len(sums) > 1:
        sums = _in_pairs(add, sums)
    return sums[0] if sums else Fraction(0)


def _in_pairs(add: Callable[[_Term, _Term], _Term], terms: list[_Term]) -> list[_Term]:
    """Add adjacent pairs of terms; an odd last term stays."""
    pairs = zip(terms[::2], terms[1::2], strict=False)
    return [add(one, other) for one, other in pairs] + terms[len(terms) & ~1 :]


def _add_unreduced(one: _Pair, other: _Pair) -> _Pair:
    (n, d), (m, e) = one, other
    return (n * e + m * d, d * e) if d != e else (n + m, d)
