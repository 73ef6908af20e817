"""Points of contact, and intervals of constant contact along loops of positions."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from exactsweep.evidence.contact import Contact
from exactsweep.evidence.sweep import SweepAnswer
from exactsweep.geometry.outline import number_features
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Point

Ends = tuple[Point, Point]


class SweepFeatures:
    """The vertices and edges of both polygons of a Sweep, by their numbers in contacts."""

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
        (x, y), g, d = self._reference, self.g_vertices[i], self.d_vertices[j]
        return Point(d.x - g.x + x, d.y - g.y + y)

    def spot(self, contact: Contact, position: Point) -> Ends:
        """Return the ends of the segment along which two features touch, equal for a point."""
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


class ContactInterval(NamedTuple):
    """An interval of constant contact on an edge of a loop of positions.

    Attributes:
        edge: the index of the edge, equal to that of its first vertex.
        start, end: the ends, in the order of travel.
        contacts: all contacts between `start` and `end`.
    """

    edge: int
    start: Point
    end: Point
    contacts: tuple[Contact, ...]

    @property
    def event(self) -> str:
        """The event of the contacts, "EV", "VE" or "EE", or "several" if they differ."""
        events = {contact.event for contact in self.contacts}
        return events.pop() if len(events) == 1 else "several"


@explain_type_errors
def cut_trajectory(s: SweepAnswer) -> list[ContactInterval]:
    """Cut the trajectory of a Sweep where contacts begin or end.

    Returns:
        the intervals in order, starting at the first vertex of the trajectory.

    Cost: O(c log c) for each edge with c contacts, after `Sweep.contacts`.

    Example:
        >>> from exactsweep import sweep
        >>> s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (3, 0), (0, 3)])
        >>> [interval.event for interval in cut_trajectory(s)]
        ['EE', 'EV', 'VE', 'EV', 'EE']
    """
    return _cut(SweepFeatures(s), s.trajectory.vertices, s.contacts)


def cut_loops(s: SweepAnswer, loops: Sequence[Sequence[Point]]) -> Iterator[list[ContactInterval]]:
    """Yield the intervals of each loop of positions, like `cut_trajectory`."""
    features = SweepFeatures(s)
    for loop, contacts in zip(loops, s.contacts_along(loops), strict=True):
        yield _cut(features, loop, contacts)


def _cut(
    features: SweepFeatures, corners: Sequence[Point], along: Sequence[Sequence[Contact]]
) -> list[ContactInterval]:
    found: list[ContactInterval] = []
    for k, contacts in enumerate(along):
        start, end = corners[k], corners[(k + 1) % len(corners)]
        first, last = sorted((start, end))
        whole = map(sorted, map(features.span, contacts))
        spans = [(max(low, first), min(high, last)) for low, high in whole]
        cuts = sorted({p for span in spans for p in span}, reverse=end < start)
        number = {p: i for i, p in enumerate(cuts)}
        lasting: list[list[Contact]] = [[] for _ in cuts]
        for contact, span in zip(contacts, spans, strict=True):
            for i in range(*sorted(number[p] for p in span)):
                lasting[i].append(contact)
        found += (
            ContactInterval(k, a, b, tuple(now))
            for (a, b), now in zip(pairwise(cuts), lasting, strict=False)
        )
    return found
