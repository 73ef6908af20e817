"""Permitted coordinate errors, and a diagnosis of arithmetic errors."""

import struct
import sys
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from itertools import chain
from math import floor, ulp

from exactsweep.conform.judge.verdict import LOOPS, AnsweredLoop
from exactsweep.conform.judge.witness import SUM, list_exact_rings
from exactsweep.corpus import Case
from exactsweep.numbers.number import Point, PointRings

Change = Callable[[Fraction], Fraction]
_MAX_DECIMALS = 12
_DIGITS = range(3, 16)
_WIDTHS = (32, 64, 16, 8)
# The least numbers that round to infinity as doubles, and as singles after rounding to double.
BEYOND = Fraction(2**1024 - 2**970)
_BEYOND_SINGLE = Fraction(2**128 - 2**103 - 2**74)

# Units in the last place of the largest coordinate, for sums of three vertices and a crossing.
ULPS = 16
# The additional fraction of the smaller polygon's size, for nearly parallel edges.
SHARE = Fraction(1, 2**32)
_NEAREST = Fraction(9, 16)
_GREATEST = Fraction(sys.float_info.max)


def grant_rounding(case: Case, name: str, loop: AnsweredLoop, numbers: str | None) -> Fraction:
    """Return the strict bound on coordinate errors of a loop; VERDICTS.md has the rules."""
    if loop.has_floats or numbers == "binary64":
        unit = Fraction(ulp(min(_largest(case), _GREATEST)))
        return ULPS * unit + SHARE * measure_smaller(case)
    exact = chain.from_iterable(chain.from_iterable(list_exact_rings(case, name)))
    if numbers == "rational" or not loop.is_integer or all(c.denominator == 1 for c in exact):
        return Fraction(0)
    return max(_NEAREST, min(Fraction(1), measure_smaller(case)))


def measure_smaller(case: Case) -> Fraction:
    """Return the size of the smaller polygon: its width or height, whichever is greater."""
    boxes = case.directrix.bounding_box, case.generatrix.bounding_box
    return min(max(high.x - low.x, high.y - low.y) for low, high in boxes)


def _largest(case: Case) -> Fraction:
    loops = chain.from_iterable(list_exact_rings(case, name) for name in LOOPS if name != SUM)
    rings = (*case.directrix_rings, *case.generatrix_rings, (case.reference,))
    return max(abs(c) for ring in (*rings, *loops) for point in ring for c in point)


def name_arithmetic(exact: PointRings, theirs: PointRings) -> tuple[str, ...]:
    """Name the arithmetic errors that explain all vertices of a loop, most likely first.

    Examples are "rounded to integers" and "wraps around at 32 bits". The answered rings may cross.

    >>> third = [[Point(Fraction(0), Fraction(0)), Point(Fraction(1), Fraction(1, 3))]]
    >>> theirs = [[Point(Fraction(0), Fraction(0)), Point(Fraction(1), Fraction(33, 100))]]
    >>> name_arithmetic(third, theirs)
    ('rounded to 2 decimals',)
    """
    points = {*chain.from_iterable(exact)}
    answered = {*chain.from_iterable(theirs)}
    if answered in (points, {Point(to_double(x), to_double(y)) for x, y in points}):
        return ()
    found = []
    for words, change in _changes():
        image = {Point(change(x), change(y)) for x, y in points}
        doubles = {Point(to_double(x), to_double(y)) for x, y in image}
        if answered in (image, doubles):
            found.append(words)
    return tuple(found)


def _changes() -> Iterator[tuple[str, Change]]:
    yield "rounded down to integers", lambda c: Fraction(floor(c))
    yield "rounded to integers", lambda c: Fraction(round(c))
    for k in range(1, _MAX_DECIMALS + 1):
        yield f"rounded to {k} decimal{'s' * (k > 1)}", partial(_print, form=f".{k}f")
    for k in _DIGITS:
        yield f"rounded to {k} digits", partial(_print, form=f".{k}g")
    yield "rounded to single precision", _to_single
    for bits in _WIDTHS:
        yield f"wraps around at {bits} bits", partial(_wrap, half=2 ** (bits - 1))


def _print(c: Fraction, form: str) -> Fraction:
    return Fraction(format(float(c), form)) if abs(c) < BEYOND else c


def to_double(c: Fraction) -> Fraction:
    return Fraction(float(c)) if abs(c) < BEYOND else c


def _to_single(c: Fraction) -> Fraction:
    if abs(c) >= _BEYOND_SINGLE:
        return c
    (single,) = struct.unpack("f", struct.pack("f", float(c)))
    return Fraction(single)


def _wrap(c: Fraction, half: int) -> Fraction:
    return (c + half) % (2 * half) - half if c.denominator == 1 else c
