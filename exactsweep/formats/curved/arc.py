"""Angles, whose sines are irrational, and the arcs between two of them.

An arc is drawn between two rational points of the unit circle whose images are at most a sixteenth
of the tolerance from its ends, which interval arithmetic proves. Open ends are moved to the ends of
other lines that are at most a fourth of the tolerance from there. With the half that chords may
take, and a sixteenth for a map that is irrational itself, lines and arc are apart by at most
1/2 + 1/4 + pi/2 * 1/16 + 1/16 < 1 tolerance.
"""

from __future__ import annotations

from fractions import Fraction
from functools import cache
from typing import NamedTuple

from exactsweep.formats.curved.affine import Affine, make_affine
from exactsweep.formats.curved.curves import bound_root, flatten_arc
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.geometry.turn import find_unit_point
from exactsweep.numbers.number import ORIGIN, Point

_PI_DIGITS = 120
_MAX_TURN = 10**6


class Arc(NamedTuple):
    """The image of an arc of the unit circle, counter-clockwise between two points of it."""

    image: Affine
    start: Point
    end: Point

    @property
    def ends(self) -> tuple[Point, Point]:
        """The images of both ends."""
        return self.image.point(*self.start), self.image.point(*self.end)

    def flatten(self, reading: Reading) -> list[Point]:
        """Return it as lines, within the tolerance."""
        return flatten_arc(ORIGIN, self.start, self.end, True, self.image, reading)


def make_arc(image: Affine, start: Fraction, end: Fraction, reading: Reading) -> Arc:
    """Make an arc of the unit circle's image, between two angles in degrees."""
    stretch = bound_root(image.a**2 + image.b**2 + image.c**2 + image.d**2)
    allowed = reading.allow_curve() / (16 * max(stretch, Fraction(1, 10**30)))
    return Arc(image, find_unit_point(start, allowed), find_unit_point(end, allowed))


def make_rotation(degrees: Fraction, reading: Reading, power: int = 1) -> Affine:
    """Make the rotation by an angle: exactly by quarter turns, others as a tolerance allows.

    Args:
        degrees: the angle.
        reading: says how far off it may be.
        power: to which power of that it is true.

    >>> make_rotation(Fraction(90), Reading()).point(Fraction(1), Fraction(0))
    Point(x=Fraction(0, 1), y=Fraction(1, 1))
    """
    off = reading.allow_angle(degrees) ** power if degrees % 90 else Fraction(0)
    c, s = find_unit_point(degrees, off)
    return make_affine(c, s, -s, c, 0, 0)._replace(off=off)


def to_degrees(radians: Fraction) -> Fraction:
    """Return an angle in degrees, off by less than a part in 10**100."""
    if abs(radians) > _MAX_TURN:
        raise FormatError(f"an angle beyond {_MAX_TURN} radians")
    return radians * 180 / _pi()


@cache
def _pi() -> Fraction:
    from mpmath import mp
    from mpmath.libmp import to_rational

    with mp.workdps(_PI_DIGITS):
        return Fraction(*map(int, to_rational((+mp.pi)._mpf_)))
