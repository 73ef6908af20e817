"""Intervals of constant contact along loops of positions."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import NamedTuple

from exactsweep.draw.features import SweepFeatures
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.sweep import SweepAnswer
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Point


class ContactInterval(NamedTuple):
    """A part of an edge of a loop of positions along which the contacts are constant.

    Attributes:
        edge: the index of the edge, equal to that of its first vertex.
        start, end: the ends, as Points, in the order of travel.
        contacts: all contacts between start and end.
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

    Cost: that of `Sweep.contacts`, plus O(c log c) for each edge with c contacts.

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
