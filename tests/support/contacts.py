"""Contacts in the form of the pages."""

from collections.abc import Iterable

from exactsweep import Sweep
from exactsweep.evidence.contact import Contact
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.region import Region
from exactsweep.numbers.number import Point


def without_parts(s: Sweep, contacts: Iterable[Contact]) -> set[Contact]:
    """Drop EV and VE contacts implied by an EE contact."""
    listed = set(contacts)
    ends = [_ends(Region(shape)) for shape in (s.generatrix, s.directrix)]
    implied: set[Contact] = set()
    for event, i, j in listed:
        if event == "EE":
            implied |= {Contact("VE", k, j) for k in ends[0][i]}
            implied |= {Contact("EV", i, k) for k in ends[1][j]}
    return listed - implied


def _ends(shape: Region) -> dict[int, set[int]]:
    """Map each edge to the indices of its ends."""
    return {
        shape.edge_index(k): {shape.vertex_index(k), shape.vertex_index(following)}
        for k, following in enumerate(Outline(shape.rings).after)
    }


def between(a: Point, b: Point) -> Point:
    """Return a point of a segment, closer to its start."""
    return Point((2 * a.x + b.x) / 3, (2 * a.y + b.y) / 3)
