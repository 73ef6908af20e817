"""What touches for an instant only: two vertices that meet on the way, a third feature at a vertex.

The contacts that last along a stretch of the trajectory do not tell these.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable
from math import lcm

from exactsweep.draw.features import Features
from exactsweep.evidence.contact import Boundary, Contact, edges_of, facing, minus
from exactsweep.evidence.swept import Swept
from exactsweep.geometry.frame import Frame
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.point import Point, Vertex

# The numbers below which it takes some seconds at most to find them.
_MOST = 10**6


def can_be_found(s: Swept) -> bool:
    """Whether a sweep is small enough: t (m + n) and m n are at most a million each."""
    m, n = len(s.directrix), len(s.generatrix)
    return len(s.trajectory) * (m + n) <= _MOST and m * n <= _MOST


def meetings_on_edges(s: Swept) -> dict[Point, list[Contact]]:
    """Find where two vertices meet while the reference point is inside an edge of the trajectory.

    Nothing else touches there for an instant only: two features that touch at positions on a
    segment, which does not cross the trajectory, touch it inside an edge with an end only.

    Returns:
        dict of the VV contacts by the position.

    Cost: O((m + n + p) log(m + n + t)) for p pairs of an edge and a vertex that can touch without
    overlap: O(m + n) for convex polygons, O(m n) for any.

    Example:
        >>> from exactsweep import sweep
        >>> s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (3, 0), (0, 3)])
        >>> meetings_on_edges(s)[Point(2, -1)]
        [Contact(event='VV', generatrix=2, directrix=1)]
    """
    x, y = s.reference
    origin_path = s.trajectory.translated((-x, -y))
    polygons = s.generatrix, s.directrix, origin_path
    frame = Frame(s.direction, lcm(*(polygon.lattice()[0] for polygon in polygons)))
    g, d, path = (frame.turned(frame.lattice(polygon)) for polygon in polygons)
    pairs = set()
    for i, j in facing(dict(enumerate(edges_of(g))), Outline([d])):
        pairs |= {(i, j), ((i + 1) % len(g), j)}
    for j, i in facing(dict(enumerate(edges_of(d))), Outline([g])):
        pairs |= {(i, j), (i, (j + 1) % len(d))}
    boundary = Boundary(path)
    meetings: defaultdict[Vertex, list[Contact]] = defaultdict(list)
    for i, j in pairs:
        found = Contact("VV", s.generatrix.vertex_index(i), s.directrix.vertex_index(j))
        meetings[minus(d[j], g[i])].append(found)
    on_edges = [t for t in meetings if next(boundary.edges_through(t), None) is not None]
    if not on_edges:
        return {}
    positions = frame.leave(on_edges, s.reference)
    return {p: meetings[t] for p, t in zip(positions, on_edges, strict=True)}


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
