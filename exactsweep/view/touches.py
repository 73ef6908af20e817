"""What touches for an instant only: two vertices that meet on the way, a third feature at a vertex.

The contacts that last along a stretch of the trajectory do not tell these.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import lcm

from exactsweep.draw.features import Features
from exactsweep.evidence.contact import Contact, find_facing, minus
from exactsweep.evidence.swept import Swept
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.point import Point, Vertex
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region

# The numbers below which it takes some seconds at most to find them.
_MOST = 10**6


def can_be_found(s: Swept) -> bool:
    """Whether a sweep is small enough: t (m + n) and m n are at most a million each."""
    m, n = len(s.directrix), len(s.generatrix)
    return len(s.trajectory) * (m + n) <= _MOST and m * n <= _MOST


class Meetings:
    """The positions at which two vertices meet without overlap near them.

    Cost: O((m + n) log(m + n) + p log p) for p pairs of an edge and a vertex that can touch without
    overlap: O(m + n) for convex polygons, O(m n) for any.

    Args:
        s: a Sweep.
    """

    def __init__(self, s: Swept) -> None:
        self._reference = s.reference
        self._scale = lcm(s.generatrix.lattice()[0], s.directrix.lattice()[0])
        g, g_numbers = _outline(s.generatrix, self._scale)
        d, d_numbers = _outline(s.directrix, self._scale)
        pairs = set()
        for i, j in find_facing(dict(enumerate(g.edges)), d):
            pairs |= {(i, j), (g.after[i], j)}
        for j, i in find_facing(dict(enumerate(d.edges)), g):
            pairs |= {(i, j), (i, d.after[j])}
        self._contacts: defaultdict[Vertex, list[Contact]] = defaultdict(list)
        for i, j in pairs:
            contact = Contact("VV", g_numbers[i], d_numbers[j])
            self._contacts[minus(d.vertices[j], g.vertices[i])].append(contact)
        self._translations = sorted(self._contacts)

    def on_edges(self, loop: Sequence[Point]) -> dict[Point, list[Contact]]:
        """Find where two vertices meet inside an edge of a loop of free positions.

        Nothing else touches there for an instant only: two features that touch at positions on a
        segment, which does not cross the loop, touch it inside an edge with an end only.

        Returns:
            dict of the VV contacts by the position.

        Cost: O(t log p), and O(1) for each edge and each position in its x-range.

        Example:
            >>> from exactsweep import sweep
            >>> s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (3, 0), (0, 3)])
            >>> Meetings(s).on_edges(s.trajectory.vertices)[Point(2, -1)]
            [Contact(event='VV', generatrix=2, directrix=1)]
        """
        (rx, ry), scale = self._reference, self._scale
        raised = [((x - rx) * scale, (y - ry) * scale) for x, y in loop]
        found = {}
        for p, q in pairwise([*raised, raised[0]]):
            (px, py), (qx, qy) = low, high = sorted((p, q))
            start = bisect_right(self._translations, low)
            for t in self._translations[start : bisect_left(self._translations, high)]:
                x, y = t
                if (qx - px) * (y - py) == (qy - py) * (x - px):
                    found[Point(Fraction(x, scale) + rx, Fraction(y, scale) + ry)] = self._contacts[
                        t
                    ]
        return found


def _outline(shape: Polygon | Region, scale: int) -> tuple[Outline, list[int]]:
    """The features of a shape on a lattice, and the caller's numbers of its vertices."""
    rings = []
    numbers: list[int] = []
    for k, ring in enumerate(shape.rings):
        first = len(numbers)
        order = list(range(len(ring)))
        if k:
            # With the interior on the left, as all of an outline has it.
            order[1:] = reversed(order[1:])
        rings.append([(int(ring[i].x * scale), int(ring[i].y * scale)) for i in order])
        numbers += [shape.vertex_index(first + i) for i in order]
    return Outline(rings), numbers


def brief_contacts(
    features: Features, here: Iterable[Contact], lasting: set[Contact]
) -> set[Contact]:
    """Choose the contacts at a position that last neither up to it nor from it.

    Args:
        features: of the sweep.
        here: all contacts at the position.
        lasting: the contacts that last up to it or from it.

    Returns:
        Contacts, VV among them. An EV or VE that is part of an EE contact is not listed beside it.

    Cost: linear in the number of contacts.
    """
    found = set(here)
    parts = [features.parts(contact) for contact in found | lasting if contact.event == "EE"]
    return found.difference(lasting, *parts)
