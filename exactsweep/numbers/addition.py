"""Sums of many fractions, in the time that their result asks for.

A running sum of n fractions with unrelated denominators is, after each step, a fraction longer than
the last one, whose greatest common divisors take time with the square of its length: n times. Added
in pairs, and the sums in pairs again, numbers of equal length meet, and the last step, which is
needed in any case, takes half of all the time. Short fractions are not reduced at all on the way.
"""

from collections.abc import Callable, Iterable
from fractions import Fraction
from operator import add
from typing import TypeVar

from exactsweep.numbers.number import split_ratios

_Pair = tuple[int, int]
_Term = TypeVar("_Term", _Pair, Fraction)

# As long as it may be before it is reduced: later, what cancels would be carried on.
_BITS = 2000


def add_up(terms: Iterable[Fraction]) -> Fraction:
    """Add fractions.

    Args:
        terms: any number of them, in any order.

    Returns:
        Their sum, 0 of none.

    Cost: O(s^2) for s digits in all denominators that have no common factors.

    Example:
        >>> add_up(Fraction(1, k * (k + 1)) for k in range(1, 100))
        Fraction(99, 100)
    """
    return add_ratios(zip(*split_ratios([*terms]), strict=True))


def add_ratios(terms: Iterable[_Pair]) -> Fraction:
    """Add fractions that need not be in lowest terms.

    Args:
        terms: pairs of a numerator and a positive denominator.

    Returns:
        Their sum.

    Cost: as `add_up`.

    Example:
        >>> add_ratios([(2, 4), (3, 6)])
        Fraction(1, 1)
    """
    pairs = [*terms]
    while len(pairs) > 1 and max(d for _, d in pairs).bit_length() < _BITS:
        pairs = _in_pairs(_add_unreduced, pairs)
    sums = [Fraction(n, d) for n, d in pairs]
    while len(sums) > 1:
        sums = _in_pairs(add, sums)
    return sums[0] if sums else Fraction(0)


def _in_pairs(add: Callable[[_Term, _Term], _Term], terms: list[_Term]) -> list[_Term]:
    """Add the first two, the next two and so on; the last one stays as it is if it is alone."""
    pairs = zip(terms[::2], terms[1::2], strict=False)
    return [add(one, other) for one, other in pairs] + terms[len(terms) & ~1 :]


def _add_unreduced(one: _Pair, other: _Pair) -> _Pair:
    (n, d), (m, e) = one, other
    return (n * e + m * d, d * e) if d != e else (n + m, d)
