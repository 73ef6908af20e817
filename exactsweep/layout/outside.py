"""Convex pieces of the complement of a container, within a frame.

Four rectangles surround the bounding box of the container; parts inside the box need no normals for
them. The rest consists of pockets between the box and the container.
"""

from __future__ import annotations

from itertools import pairwise

from exactsweep.geometry.convex import ConvexRing, IntRing, IntVertex, cut_to_convex
from exactsweep.layout.pieces import bound_piece


def cut_outside(exterior: IntRing, frame: tuple[int, int, int, int]) -> list[ConvexRing]:
    """Cut the space between a counter-clockwise container and a larger frame into convex pieces.

    >>> len(cut_outside([(0, 0), (2, 0), (2, 2), (1, 2), (0, 1)], (-1, -1, 3, 3)))
    5
    """
    west, south, east, north = frame
    left, right, low, high = bound_piece(exterior)
    pieces = [
        _rectangle(west, south, left, north),
        _rectangle(right, south, east, north),
        _rectangle(left, south, right, low),
        _rectangle(left, high, right, north),
    ]
    corners = _rectangle(left, low, right, high)

    def find_side(p: IntVertex) -> int | None:
        """Return the index of the box side through p; at a corner, the side that ends there."""
        x, y = p
        sides = [y == low and x > left, x == right and y > low, y == high and x < right, x == left]
        return sides.index(True) if any(sides) else None

    on_border = [k for k, p in enumerate(exterior) if find_side(p) is not None]
    for first, last in pairwise([*on_border, on_border[0] + len(exterior)]):
        chain = [exterior[k % len(exterior)] for k in range(first, last + 1)]
        start, end = find_side(chain[0]), find_side(chain[-1])
        assert start is not None
        assert end is not None
        passed = range(start, start + (end - start) % 4)
        # A corner belongs to the side that ends there, so the chain may start at the first one.
        border = [c for c in (corners[(k + 1) % 4] for k in passed) if c != chain[0]]
        ring = [chain[0], *border, *chain[:0:-1]]
        if len(chain) > 2 or border:
            pieces += cut_to_convex([ring])
    return pieces


def _rectangle(left: int, low: int, right: int, high: int) -> ConvexRing:
    return [(left, low), (right, low), (right, high), (left, high)]
