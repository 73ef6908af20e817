"""How far off a rounded answer may be: what its numbers hold where it lies, and no more."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import chain

from exactsweep.conform.judge.answer import LOOPS, AnsweredLoop
from exactsweep.conform.judge.fits import INSIDE, NAME, list_exact_fits
from exactsweep.conform.judge.witness import list_exact_rings
from exactsweep.corpus import Case
from exactsweep.geometry.region import AnyPolygon
from exactsweep.numbers.point import Point

ULPS = 16
"""Units in the last place of the largest coordinate: sums of three vertices, and a crossing."""
SHARE = Fraction(1, 2**32)
"""The part of the smaller polygon's size that edges which are nearly parallel may take besides."""
MOST_CLAIMED = Fraction(1, 100)
"""No answer may claim more for itself than this part of the smaller polygon's size."""
_NEAREST = Fraction(9, 16)
_LEAST_UNIT = Fraction(1, 2**1074)


def grant_rounding(case: Case, name: str, loop: AnsweredLoop, numbers: str | None) -> Fraction:
    """Return by how much less the coordinates of a loop may be off.

    Args:
        case: as it was put to the implementation.
        name: of the loop, or of the exact fits.
        loop: what it answered.
        numbers: what its hello says that it reads, or None.

    Returns:
        For floats, and for whatever a program answers that reads binary64: 16 units in the last
        place of the largest coordinate of the case, and 2^-32 of the size of the smaller
        polygon. For integers 1, or that size if it is less, but 9/16 at least, by which the nearest
        ones are less off, if the exact answer has other numbers, else 0. And 0 for other rationals,
        and for integers of a program that reads any rationals: these claim to be exact.

    Cost: linear.
    """
    if loop.has_floats or numbers == "binary64":
        return ULPS * _unit_in_last_place(_largest(case)) + SHARE * measure_smaller(case)
    if numbers == "rational" or not loop.is_integer:
        return Fraction(0)
    return (
        Fraction(0)
        if _is_integer(case, name)
        else max(_NEAREST, min(Fraction(1), measure_smaller(case)))
    )


def limit_claim(case: Case, claim: Fraction, granted: Fraction) -> Fraction:
    """Return how much of what an answer claims for itself is granted."""
    return min(claim, max(granted, MOST_CLAIMED * measure_smaller(case)))


def measure_smaller(case: Case) -> Fraction:
    """The greater one of width and height, of the polygon for which that is less."""
    return min(_size(case.directrix), _size(case.generatrix))


def _size(shape: AnyPolygon) -> Fraction:
    low, high = shape.bounding_box
    return max(high.x - low.x, high.y - low.y)


def _find_points(case: Case, name: str) -> Iterator[Point]:
    """The points of the exact answer."""
    if name in (NAME, INSIDE):
        return chain.from_iterable(list_exact_fits(case, name))
    return chain.from_iterable(list_exact_rings(case, name))


def _largest(case: Case) -> Fraction:
    loops = (_find_points(case, name) for name in LOOPS)
    rings = (*case.directrix_rings, *case.generatrix_rings, (case.reference,))
    return max(abs(c) for point in chain(*rings, *loops) for c in point)


def _is_integer(case: Case, name: str) -> bool:
    return all(c.denominator == 1 for point in _find_points(case, name) for c in point)


def _unit_in_last_place(value: Fraction) -> Fraction:
    """The distance of two binary64 next to each other, at a positive number of any size.

    >>> _unit_in_last_place(Fraction(1)) == Fraction(2) ** -52
    True
    """
    exponent = value.numerator.bit_length() - value.denominator.bit_length()
    if value < Fraction(2) ** exponent:
        exponent -= 1
    return max(Fraction(2) ** (exponent - 52), _LEAST_UNIT)
