"""The exact decision whether two solids overlap or touch, among the edges that are near both.

By (1) and (2) of `geometry.overlap`. Edges that cross, and places where boundaries touch, lie in
the common part of the two boxes, the *window*; so does each point of both interiors. Nothing
outside of the window is looked at.
"""

from __future__ import annotations

from collections import defaultdict
from enum import Enum

from exactsweep.geometry.overlap import Places, find_points_between, touch
from exactsweep.layout.solid import LatticeBox, Solid


class Relation(Enum):
    """The relation of two solids."""

    APART = "apart"
    CONTACT = "contact"
    OVERLAP = "overlap"


def meet(a: Solid, b: Solid) -> Relation:
    """Decide whether two solids of one lattice overlap, touch or are apart.

    Args:
        a: a solid.
        b: another one, on the same lattice.

    Cost: O(k h) for k edges of one and h edges of the other that meet the window, and O(m + n) for
    each place at which the boundaries touch.
    """
    # In the coordinates of a's form, where b's is moved by (x, y).
    x, y = b.x - a.x, b.y - a.y
    left, right, low, high = a.form.box
    west, east, south, north = b.form.box
    window = (
        max(left, west + x),
        min(right, east + x),
        max(low, south + y),
        min(high, north + y),
    )
    left, right, low, high = window
    if left > right or low > high:
        return Relation.APART
    ours = a.form.near(window)
    theirs = b.form.near((left - x, right - x, low - y, high - y)) if ours else ()
    on_a: Places = defaultdict(set)
    on_b: Places = defaultdict(set)
    for west, east, south, north, ax, ay, bx, by, ring, number in theirs:
        ax, ay, bx, by = ax + x, ay + y, bx + x, by + y
        west, east, south, north = west + x, east + x, south + y, north + y
        for left, right, low, high, px, py, qx, qy, other, k in ours:
            if left > east:
                break
            if right < west or low > north or high < south:
                continue
            # Most edges are on one side of the other one.
            dx, dy = qx - px, qy - py
            of_a = dx * (ay - py) - dy * (ax - px)
            of_b = dx * (by - py) - dy * (bx - px)
            if (of_a > 0 < of_b) or (of_a < 0 > of_b):
                continue
            shared = touch((ax, ay), (bx, by), (px, py), (qx, qy))
            if shared is None:
                return Relation.OVERLAP
            if shared:
                on_a[other, k].update(shared)
                on_b[ring, number].update(shared)
    if _enters(a, b, on_a, (x, y), window):
        return Relation.OVERLAP
    back = -x, -y
    moved: Places = defaultdict(
        set, {place: {(px - x, py - y) for px, py in points} for place, points in on_b.items()}
    )
    left, right, low, high = window
    if _enters(b, a, moved, back, (left - x, right - x, low - y, high - y)):
        return Relation.OVERLAP
    return Relation.CONTACT if on_a else Relation.APART


def _enters(a: Solid, b: Solid, places: Places, shift: tuple[int, int], window: LatticeBox) -> bool:
    """Decide whether a piece of a's boundary between places runs through the inside of b."""
    left, right, low, high = window
    dx, dy = 2 * shift[0], 2 * shift[1]
    holds = b.form.holds
    if not places:
        # Without a common point of the boundaries, vertices of the exteriors decide.
        x, y = a.form.rings[0][0]
        return left <= x <= right and low <= y <= high and holds(2 * x - dx, 2 * y - dy)
    left, right, low, high = 2 * left, 2 * right, 2 * low, 2 * high
    return any(
        left <= x <= right and low <= y <= high and holds(x - dx, y - dy)
        for x, y in find_points_between(dict(enumerate(a.form.rings)), places)
    )
