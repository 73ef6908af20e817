"""What a program's numbers did to each coordinate of an exact loop, where that is one thing."""

from __future__ import annotations

import struct
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from itertools import chain
from math import floor

from exactsweep.numbers.point import Point, PointRings

Change = Callable[[Fraction], Fraction]

_MOST_DECIMALS = 12
_DIGITS = range(3, 16)
_WIDTHS = (32, 64, 16, 8)
# The least numbers that are rounded to infinity; such numbers are left as they are.
_BEYOND = Fraction(2**1024 - 2**970)
_BEYOND_SINGLE = Fraction(2**128 - 2**103)


def name_arithmetic(exact: PointRings, theirs: PointRings) -> tuple[str, ...]:
    """Say how all coordinates of a loop were spoilt by the numbers that a program works with.

    Args:
        exact: the rings that should have been answered.
        theirs: what was answered, whether or not these are sound rings.

    Returns:
        Those of these that explain every coordinate, the likeliest first: "rounded down to
        integers", "rounded to integers", "rounded to 2 decimals", "rounded to 6 digits", "rounded
        to single precision", "wraps around at 32 bits".

    Cost: that of some thirty changes of all coordinates.

    Example:
        >>> third = [[Point(Fraction(0), Fraction(0)), Point(Fraction(1), Fraction(1, 3))]]
        >>> theirs = [[Point(Fraction(0), Fraction(0)), Point(Fraction(1), Fraction(33, 100))]]
        >>> name_arithmetic(third, theirs)
        ('rounded to 2 decimals',)
    """
    points = {*chain.from_iterable(exact)}
    answered = {*chain.from_iterable(theirs)}
    if points == answered:
        return ()
    found = []
    for words, change in _changes():
        image = {Point(change(x), change(y)) for x, y in points}
        doubles = {Point(_to_double(x), _to_double(y)) for x, y in image}
        if answered in (image, doubles):
            found.append(words)
    return tuple(found)


def _changes() -> Iterator[tuple[str, Change]]:
    yield "rounded down to integers", lambda c: Fraction(floor(c))
    yield "rounded to integers", lambda c: Fraction(round(c))
    for k in range(1, _MOST_DECIMALS + 1):
        yield f"rounded to {k} decimal{'s' * (k > 1)}", partial(_print, form=f".{k}f")
    for k in _DIGITS:
        yield f"rounded to {k} digits", partial(_print, form=f".{k}g")
    yield "rounded to single precision", _to_single
    for bits in _WIDTHS:
        yield f"wraps around at {bits} bits", partial(_wrap, half=2 ** (bits - 1))


def _print(c: Fraction, form: str) -> Fraction:
    return Fraction(format(float(c), form)) if abs(c) < _BEYOND else c


def _to_double(c: Fraction) -> Fraction:
    return Fraction(float(c)) if abs(c) < _BEYOND else c


def _to_single(c: Fraction) -> Fraction:
    if abs(c) >= _BEYOND_SINGLE:
        return c
    (single,) = struct.unpack("f", struct.pack("f", float(c)))
    return Fraction(single)


def _wrap(c: Fraction, half: int) -> Fraction:
    return (c + half) % (2 * half) - half if c.denominator == 1 else c
