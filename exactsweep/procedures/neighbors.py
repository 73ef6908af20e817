"""The pruning step for thin shapes, in which adjacent edges prove that ends of segments are in O.

Let a be an edge of D, v a vertex of H that faces it, and c and c' the two edges after v. For any
edge e of D and any edge f of H, O contains the interior of the parallelogram e + f: there e crosses
an edge of G.

(1) If c' crosses the line through v along a, at v + w, the interior of a + c' contains x + v for
    each x of a with x - w inside a. Only the first part of a + v remains, if w leads forward along
    a, or only the last part, if w leads back; each has the length of w.
(2) If the edge b before a ends in a reflex vertex, and c leads to the right of b, the interior of
    b + c contains the first part of a + v.

The same holds for the edges before v and after a. Remaining parts are rounded outwards to ints, so
numbers stay short.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import lcm

from exactsweep.geometry.vectors import minus
from exactsweep.numbers.number import Vertex
from exactsweep.procedures.segments import EdgeFeature

_FEW = 14
"""The number of facing edges up to which all are kept; pruning them takes longer than it saves."""


def leave_out_overlapped(
    edges: Sequence[EdgeFeature], ring: Sequence[Vertex], k: int
) -> Sequence[EdgeFeature]:
    """Return the edges that vertex k of a ring faces, without the parts in O by (1) and (2)."""
    if len(edges) <= _FEW:
        return edges
    points = [ring[(k + i) % len(ring)] for i in (-2, -1, 0, 1, 2)]
    unit = lcm(*(c.denominator for point in points for c in point))
    o, p, v, q, r = ((int(x * unit), int(y * unit)) for x, y in points)
    # The far ends of c and c', seen from v.
    after, before = (*minus(q, v), *minus(r, v)), (*minus(p, v), *minus(o, v))
    kept: list[EdgeFeature] = []
    for edge in edges:
        dx, dy, offset, low, high, ahead, adjacent = edge
        ux, uy = (dx, dy) if ahead else (-dx, -dy)
        start, end = low, high
        bx, by, ax, ay, next_unit = adjacent
        for (px, py, qx, qy), nx, ny, is_first in (
            (after, bx, by, True),
            (before, ax, ay, False),
        ):
            # How far c leads to the left of the line along a, and c' ends to its right.
            past, back = ux * py - uy * px, uy * qx - ux * qy
            if past > 0 < back:  # (1)
                w = (qx * past + px * back) if dx else (qy * past + py * back)
                reach = abs(w) // ((past + back) * unit) + 1
                if w > 0:
                    end = min(end, -(-low // 1) + reach)
                else:
                    start = max(start, high // 1 - reach)
            product, bend = px * ny - py * nx, nx * uy - ny * ux
            is_reflex = bend < 0 if is_first else bend > 0
            if is_reflex and past and product > 0:  # (2)
                across = max(past * next_unit, abs(bend) * unit)
                reach = -(-product * abs(dx or dy) // across) - 1
                if is_first == ahead:
                    start = max(start, low // 1 + reach)
                else:
                    end = min(end, -(-high // 1) - reach)
        if start < end:
            kept.append((dx, dy, offset, start, end, ahead, adjacent))
    return kept
