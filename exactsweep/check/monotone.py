"""The search for a direction to which two polygons are monotone."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from exactsweep.check.cone import dot, reduce_way, subtract
from exactsweep.check.shape import LatticeRing, list_edges
from exactsweep.numbers.number import Vertex


def has_shared_direction(rings: Sequence[LatticeRing]) -> bool:
    """Decide whether some direction is one to which all rings are weakly monotone.

    These directions are closed angles, which end in directions square to edges; so it is enough to
    try those.

    Cost: O(n**2) for n edges.
    """
    edges = [[reduce_way(subtract(b, a)) for a, b in list_edges([ring])] for ring in rings]
    square = {(-y, x) for ways in edges for x, y in ways}
    return any(all(_turns(ways, u) == 2 for ways in edges) for u in square)


def _turns(ways: Iterable[Vertex], u: Vertex) -> int:
    """Count how often a ring turns back in a direction; edges square to it do not count."""
    signs = [along > 0 for way in ways if (along := dot(way, u))]
    return sum(a != b for a, b in zip(signs, signs[1:] + signs[:1], strict=True))
