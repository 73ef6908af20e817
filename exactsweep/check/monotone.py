"""Whether two polygons are monotone to a shared direction."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise

from exactsweep.check.cone import Pair, by_turn, dot, minus
from exactsweep.check.shape import Ring, edges_of


def has_shared_direction(rings: Sequence[Ring]) -> bool:
    """Decide whether some direction is one to which all rings are weakly monotone.

    Between two directions square to edges nothing changes, so it is enough to try those directions
    and one in each gap.

    Cost: O(n**2) for n edges.
    """
    edges = [[minus(b, a) for a, b in edges_of([ring])] for ring in rings]
    # A direction and its opposite are the same: those of the upper half-plane stand for all.
    square = [(-y, x) if (x, -y) > (0, 0) else (y, -x) for ways in edges for x, y in ways]
    square.sort(key=by_turn)
    between = [(px + qx, py + qy) for (px, py), (qx, qy) in pairwise(square)]
    (x, y), (last_x, last_y) = square[0], square[-1]
    between.append((last_x - x, last_y - y))
    return any(all(_turns(ways, u) == 2 for ways in edges) for u in (*square, *between))


def _turns(ways: Iterable[Pair], u: Pair) -> int:
    """How often a ring turns back in a direction; edges square to it do not count."""
    signs = [along > 0 for way in ways if (along := dot(way, u))]
    return sum(a != b for a, b in zip(signs, signs[1:] + signs[:1], strict=True))
