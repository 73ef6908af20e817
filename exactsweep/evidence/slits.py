"""Slits: positions of zero area between sums, which do not belong to the answer.

A swept area has a slit where an edge of the trajectory is parallel to a cut between two pieces of
the generatrix.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import starmap

from exactsweep.evidence.homogeneous import DirectedSegment, make_side, place
from exactsweep.geometry.frame import HomogeneousPoint, to_homogeneous

Gap = tuple[HomogeneousPoint, HomogeneousPoint]
_PlanePoint = tuple[Fraction, Fraction]


def unite(gaps: Iterable[Gap], known: Sequence[DirectedSegment]) -> list[DirectedSegment]:
    """Join collinear gaps; drop points on other gaps or on known edges.

    Segments meet known edges only at endpoints; two slits have at most one common point. Cost:
    O(n log n), plus O(1) for each point and each edge.

    >>> a, b, c = (0, 0, 1), (1, 0, 1), (2, 0, 1)
    >>> [(slit.start, slit.end) for slit in unite([(b, c), (b, b), (b, a)], [])]
    [((0, 0, 1), (2, 0, 1))]
    """
    along: dict[object, list[tuple[_PlanePoint, _PlanePoint]]] = defaultdict(list)
    points: set[_PlanePoint] = set()
    for p, q in gaps:
        start, end = sorted((place(p), place(q)))
        if start == end:
            points.add(start)
        else:
            line = make_side(to_homogeneous(*start), to_homogeneous(*end)).line
            along[line].append((start, end))
    slits = []
    for spans in along.values():
        spans.sort()
        low, high = spans[0]
        for start, end in spans:
            if start > high:
                slits.append((low, high))
                low, high = start, end
            high = max(high, end)
        slits.append((low, high))
    found = [make_side(*starmap(to_homogeneous, ends)) for ends in sorted(slits)]
    edges = [*known, *found]
    others = starmap(to_homogeneous, sorted(points))
    alone = [p for p in others if not any(_is_on(p, edge) for edge in edges)]
    return found + [make_side(p, p) for p in alone]


def _is_on(p: HomogeneousPoint, edge: DirectedSegment) -> bool:
    (a, b, c), (x, y, w) = edge.line, p
    if a * x + b * y + c * w:
        return False
    start, end = sorted((place(edge.start), place(edge.end)))
    return start <= place(p) <= end
