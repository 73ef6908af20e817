"""The arcs of DXF, whose ends are given by angles in degrees and so are irrational.

An arc is drawn between two rational points of its circle that are at most a sixteenth of the
tolerance from its ends, which interval arithmetic proves. Its ends are moved to the ends of other
lines that are at most a fourth of the tolerance from there. With the half that chords may take,
lines and arc are apart by at most 1/2 + 1/4 + pi/2 * 1/16 < 1 tolerance.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from exactsweep.formats.curved.affine import IDENTITY
from exactsweep.formats.curved.curves import flatten_arc, rounded
from exactsweep.formats.error import FormatError
from exactsweep.geometry.point import Point


class Arc(NamedTuple):
    """An arc of a circle, counter-clockwise between two points of it."""

    center: Point
    start: Point
    end: Point

    def flattened(self, first: Point, last: Point, tolerance: Fraction) -> list[Point]:
        """Return the arc as lines, its ends moved to the points first and last."""
        inner = flatten_arc(self.center, self.start, self.end, True, IDENTITY, tolerance)[1:-1]
        return [first, *inner, last]


def make_arc(
    center: Point, radius: Fraction, start: Fraction, end: Fraction, tolerance: Fraction
) -> Arc:
    """Make an arc between two angles in degrees, its ends within tolerance / 16."""
    allowed = tolerance / (16 * radius)
    ends = (unit_point(angle, allowed) for angle in (start, end))
    first, last = (Point(center.x + radius * x, center.y + radius * y) for x, y in ends)
    return Arc(center, first, last)


def unit_point(degrees: Fraction, allowed: Fraction) -> Point:
    """Find a rational point of the unit circle near an angle.

    Args:
        degrees: the angle.
        allowed: how far it may be from the point at exactly that angle.

    Returns:
        A Point of the circle.

    Example:
        >>> unit_point(Fraction(270), Fraction(1))
        Point(x=Fraction(0, 1), y=Fraction(-1, 1))
    """
    quarter, rest = divmod(degrees % 360, 90)
    t = _half_tangent(rest, allowed / 2) if rest else Fraction(0)
    # A step of t is at most two steps on the circle.
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(quarter):
        c, s = -s, c
    return Point(c, s)


def _half_tangent(degrees: Fraction, allowed: Fraction) -> Fraction:
    """Find a decimal that is no farther from the tangent of half the angle than allowed."""
    from mpmath import iv
    from mpmath.libmp import to_rational

    digits = 3
    while allowed * 10**digits < 4:
        digits += 1
    before = iv.prec
    try:
        iv.prec = 4 * digits + 64
        angle = iv.pi * iv.mpf(degrees.numerator) / (180 * iv.mpf(degrees.denominator))
        low, high = (
            Fraction(*map(int, to_rational(end)))
            for end in (iv.sin(angle) / (1 + iv.cos(angle)))._mpi_
        )
    finally:
        iv.prec = before
    found = round((low + high) / 2, digits)
    assert max(high - found, found - low) <= allowed
    return found


class Joints:
    """The ends of lines of one layer, for the ends of arcs that are close to one of them."""

    def __init__(self, ends: Iterable[Point], tolerance: Fraction) -> None:
        self.tolerance = tolerance
        self.cells: defaultdict[tuple[int, int], set[Point]] = defaultdict(set)
        for end in ends:
            self.cells[self._cell(end)].add(end)

    def nearest(self, end: Point) -> Point:
        """Return the joint at most tolerance / 4 away; if there is none, make one."""
        x, y = self._cell(end)
        cells = [(x + i, y + j) for i in (-1, 0, 1) for j in (-1, 0, 1)]
        close = [
            joint
            for cell in cells
            for joint in self.cells.get(cell, ())
            if 16 * ((joint.x - end.x) ** 2 + (joint.y - end.y) ** 2) <= self.tolerance**2
        ]
        if len(close) > 1:
            raise FormatError("an end of the arc is within the tolerance of two other ends")
        if close:
            return close[0]
        (joint,) = rounded([end], self.tolerance)
        self.cells[self._cell(joint)].add(joint)
        return joint

    def _cell(self, point: Point) -> tuple[int, int]:
        return point.x // self.tolerance, point.y // self.tolerance
