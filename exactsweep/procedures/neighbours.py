"""Parts of contact segments that the edges next to them prove to be overlapped.

Let the vertex v of H face the edge a of D, in the terms of `contact_lines`, and let the edges of H
after v be c and c'. For any edge p of D and any edge q of H, the inside of the parallelogram p + q
overlaps: there p and the edge -q of G cross, and where edges cross, interiors meet.

(1) Let c' cross the line through v along a, in v + w. Then the common points of the segments a + v
    and a + v + w, but for the ends of the latter, are inside the parallelogram a + c'. If w has the
    direction of a, only the start of a + v is left, as far as w; otherwise only its end. The two
    edges before v serve likewise.
(2) Let the edge b of D before a end in a reflex vertex, and let c turn to the right of b. Then a
    runs from that vertex into the angle between b and c, reversed and not, so the start of a + v
    lies inside the parallelogram b + c. At the vertex itself the interiors of D and G meet, as the
    cone of G at v reaches beyond the angle that D leaves open. The edge after a and the edge before
    v serve likewise.

For thin spikes across thin spikes this leaves little more than the answer. Such shapes contain no
squares for the cover.

Ends are rounded outwards to ints. So overlap lies just inside, and numbers stay short.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import lcm

from exactsweep.geometry.direction import Vector
from exactsweep.numbers.number import Rational, Vertex

_Scaled = tuple[()] | tuple[int, int, int]
"""A vector times a common unit, and the unit; empty if there is none."""

Beside = tuple[()] | tuple[_Scaled, _Scaled]
"""The edges before and after an edge, beyond reflex vertices."""

RankedEdge = tuple[int, int, bool, Rational, Rational, Rational, Beside]
"""An edge: its rank; the number of its direction, which opposite directions share; whether the edge
runs along that direction; dx y - dy x; its least place; its greatest place; its neighbours."""

Around = tuple[int, tuple[tuple[int, int, int, int], tuple[int, int, int, int]]]
"""A unit, and the next vertices after and before a vertex, from it, times the unit."""


def look_around(ring: Sequence[Vertex], i: int) -> tuple[Beside, Around | None]:
    """Look at the edges and the vertices near vertex i.

    Returns:
        The edges before and after the one that ends there, beyond reflex vertices; the vertices
        around it, or None if (1) leaves out nothing there.
    """
    points = [ring[k % len(ring)] for k in (i, i + 1, i + 2, i - 1, i - 2)]
    unit = lcm(*(c.denominator for point in points for c in point))
    (x, y), *others = ((int(px * unit), int(py * unit)) for px, py in points)
    f, g, b, a = [(px - x, py - y) for px, py in others]
    before = b[0] - a[0], b[1] - a[1]
    beside = (
        (*before, unit) if before[0] * b[1] > before[1] * b[0] else (),
        (*f, unit) if b[0] * f[1] > b[1] * f[0] else (),
    )
    # The cone of the vertex is left of f and right of b.
    if all(f[0] * y >= f[1] * x and b[0] * y <= b[1] * x for x, y in (g, a)):
        return beside, None
    return beside, (unit, ((*f, *g), (*b, *a)))


def leave_out_overlapped(
    facing: Iterable[RankedEdge], directions: Sequence[Vector], around: Around
) -> Iterator[RankedEdge]:
    """Yield the pieces of edges that a vertex passes without overlap, as far as (1) and (2) tell.

    Args:
        facing: the edges that the vertex faces.
        directions: their directions, by number.
        around: the vertices around the vertex.

    Cost: O(1) for each edge.
    """
    unit, sides = around
    for rank, k, ahead, offset, low, high, beside in facing:
        dx, dy = directions[k]
        if not ahead:
            dx, dy = -dx, -dy
        start, end = low, high
        for (px, py, qx, qy), other, is_after in zip(sides, beside, (True, False), strict=True):
            p, q = dx * py - dy * px, dx * qy - dy * qx
            if q < 0 < p:
                w = qx * p - px * q if dx else qy * p - py * q
                past = abs(w) // ((p - q) * unit) + 1
                if w > 0:
                    end = min(end, -(-low // 1) + past)
                else:
                    start = max(start, high // 1 - past)
            if other and p:
                nx, ny, other_unit = other
                c = (px * ny - py * nx) * abs(dx or dy)
                if c > 0:
                    past = max(-c // (unit * abs(dx * ny - dy * nx)), -c // (other_unit * p)) + 1
                    if is_after == ahead:
                        start = max(start, low // 1 - past)
                    else:
                        end = min(end, -(-high // 1) + past)
        if start < end:
            yield rank, k, ahead, offset, start, end, beside
