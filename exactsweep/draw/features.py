"""The features of G and D in contact, and their points of contact."""

from __future__ import annotations

from typing import TYPE_CHECKING

from exactsweep.evidence.contact import Contact
from exactsweep.geometry.outline import number_features
from exactsweep.numbers.number import Point

if TYPE_CHECKING:
    from exactsweep.evidence.sweep import SweepAnswer

Ends = tuple[Point, Point]


class SweepFeatures:
    """The vertices and edges of both polygons of a Sweep, by their indices in contacts."""

    def __init__(self, s: SweepAnswer) -> None:
        self._reference = s.reference
        self.g_vertices, self._g_ends = number_features(s.generatrix)
        self.d_vertices, self._d_ends = number_features(s.directrix)

    def span(self, contact: Contact) -> Ends:
        """Return the ends of the segment of positions at which a contact lasts."""
        event, i, j = contact
        (a, b), (c, d) = (
            ends[k] if letter == "E" else (k, k)
            for ends, k, letter in ((self._g_ends, i, event[0]), (self._d_ends, j, event[1]))
        )
        return self._position(a, c), self._position(b, d)

    def _position(self, i: int, j: int) -> Point:
        """Return the position at which vertex i of G is on vertex j of D."""
        (x, y), g, d = self._reference, self.g_vertices[i], self.d_vertices[j]
        return Point(d.x - g.x + x, d.y - g.y + y)

    def spot(self, contact: Contact, position: Point) -> Ends:
        """Return the ends of the segment along which two features touch; equal ends for a point."""
        event, i, j = contact
        if event[1] == "V":
            return self.d_vertices[j], self.d_vertices[j]
        if event[0] == "V":
            touching = self._move(self.g_vertices[i], position)
            return touching, touching
        ends = [self.d_vertices[k] for k in self._d_ends[j]]
        ends += [self._move(self.g_vertices[k], position) for k in self._g_ends[i]]
        _, low, high, _ = sorted(ends)
        return low, high

    def _move(self, point: Point, position: Point) -> Point:
        return Point(
            point.x + position.x - self._reference.x, point.y + position.y - self._reference.y
        )
