"""The exact decision whether two solids overlap or touch, by the edges that are near both.

The method is that of (1) and (2) of `geometry.overlap`. All crossings of edges, all places where
boundaries touch, and all points of both interiors lie in the intersection of the two boxes, the
*window*. So the functions examine the window only.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Container, Sequence
from enum import Enum

from exactsweep.geometry.overlap import Places, find_points_between, touch
from exactsweep.layout.solid import BoxedEdge, LatticeBox, LatticeForm, Solid
from exactsweep.numbers.point import Vertex

_EdgePlace = tuple[int, int]
"""The number of a ring, and the number of an edge in it."""


class Relation(Enum):
    """The relation of two solids."""

    APART = "apart"
    CONTACT = "contact"
    OVERLAP = "overlap"


def meet(a: Solid, b: Solid) -> Relation:
    """Decide whether two solids of one lattice overlap, touch or are apart.

    Args:
        a: a solid.
        b: another solid on the same lattice.

    Cost: O(k h) for k edges of one and h edges of the other that meet the window, and O(m + n) for
    each place at which the boundaries touch.
    """
    # In the coordinates of a's form, b's form is moved by (x, y).
    x, y = b.x - a.x, b.y - a.y
    left, right, low, high = a.form.box
    west, east, south, north = b.form.box
    west, east, south, north = west + x, east + x, south + y, north + y
    if left > east or west > right or low > north or south > high:
        return Relation.APART
    window = (
        left if left > west else west,
        right if right < east else east,
        low if low > south else south,
        high if high < north else north,
    )
    ours = a.form.near(window)
    moved = window[0] - x, window[1] - x, window[2] - y, window[3] - y
    touching = _find_touching(ours, b.form.near(moved), x, y) if ours else []
    if touching is None:
        return Relation.OVERLAP
    if not touching:
        # The boundaries have no common point, so one exterior may be inside the other solid.
        for form, other, at, sense, box in (
            (a.form, b.form, a.form.box, -2, window),
            (b.form, a.form, b.form.box, 2, moved),
        ):
            u, v = form.rings[0][0]
            if at == box and other.holds(2 * u + sense * x, 2 * v + sense * y):
                return Relation.OVERLAP
        return Relation.APART
    on_a: Places = defaultdict(set)
    on_b: Places = defaultdict(set)
    # The middle of a common piece of both boundaries, times two, is inside neither.
    shared_pieces: set[Vertex] = set()
    for ours_at, theirs_at, shared in touching:
        on_a[ours_at].update(shared)
        on_b[theirs_at].update((px - x, py - y) for px, py in shared)
        if len(shared) == 2:
            start, end = shared
            shared_pieces.add((start[0] + end[0], start[1] + end[1]))
    if _enters(a.form, b.form, on_a, (-2 * x, -2 * y), window, shared_pieces):
        return Relation.OVERLAP
    shared_pieces = {(px - 2 * x, py - 2 * y) for px, py in shared_pieces}
    if _enters(b.form, a.form, on_b, (2 * x, 2 * y), moved, shared_pieces):
        return Relation.OVERLAP
    return Relation.CONTACT


def _find_touching(
    ours: Sequence[BoxedEdge], theirs: Sequence[BoxedEdge], x: int, y: int
) -> list[tuple[_EdgePlace, _EdgePlace, list[Vertex]]] | None:
    """Find the pairs of edges that touch, and where; None if two of them cross."""
    found = []
    for west, east, south, north, ax, ay, bx, by, ring, number in theirs:
        ax, ay, bx, by = ax + x, ay + y, bx + x, by + y
        west, east, south, north = west + x, east + x, south + y, north + y
        for left, right, low, high, px, py, qx, qy, other, k in ours:
            if left > east:
                break
            if right < west or low > north or high < south:
                continue
            # Most edges are on one side of the other edge.
            dx, dy = qx - px, qy - py
            of_a = dx * (ay - py) - dy * (ax - px)
            of_b = dx * (by - py) - dy * (bx - px)
            if (of_a > 0 < of_b) or (of_a < 0 > of_b):
                continue
            shared = touch((ax, ay), (bx, by), (px, py), (qx, qy))
            if shared is None:
                return None
            if shared:
                found.append(((other, k), (ring, number), shared))
    return found


def _enters(
    a: LatticeForm,
    b: LatticeForm,
    places: Places,
    shift: tuple[int, int],
    window: LatticeBox,
    shared: Container[Vertex],
) -> bool:
    """Decide whether a piece of a's boundary between places runs through the inside of b.

    The shift leads from a's coordinates, times two, to b's. Points of both boundaries are left out.
    """
    left, right, low, high = (2 * end for end in window)
    dx, dy = shift
    return any(
        left <= x <= right and low <= y <= high and (x, y) not in shared and b.holds(x + dx, y + dy)
        for x, y in find_points_between(dict(enumerate(a.rings)), places)
    )
