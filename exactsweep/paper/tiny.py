"""All simple polygons on a tiny grid, and the first pair of them with which a statement fails.

Pairs come by their number of vertices, then by the size of both bounding boxes: the first one that
fails is a smallest counterexample on that grid.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cache
from itertools import combinations, permutations, product

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.polygon import Polygon
from exactsweep.paper.pairs import Pair, Ring
from exactsweep.procedures.chain import ChainError, split

Shape = Callable[[Ring], bool]


@cache
def polygons(side: int, vertices: int) -> tuple[tuple[tuple[int, int], ...], ...]:
    """All simple polygons with a number of corners on the grid of 0, ..., side, moved to (0, 0).

    >>> len(polygons(1, 3)), len(polygons(1, 4))
    (4, 1)
    """
    found = set()
    points = sorted(product(range(side + 1), repeat=2))
    for chosen in combinations(points, vertices):
        if min(x for x, _ in chosen) > 0 or min(y for _, y in chosen) > 0:
            continue
        for rest in permutations(chosen[1:]):
            try:
                corners = Polygon([chosen[0], *rest]).vertices
            except PolygonError:
                continue
            if len(corners) == vertices:
                found.add(tuple((int(x), int(y)) for x, y in corners))
    return tuple(sorted(found, key=_size))


def _size(ring: Sequence[tuple[int, int]]) -> tuple[int, Sequence[tuple[int, int]]]:
    return max(x for x, _ in ring) + max(y for _, y in ring), ring


def is_convex(ring: Ring) -> bool:
    """Whether a polygon is convex."""
    return Polygon(ring).is_convex


def is_strict(ring: Ring) -> bool:
    """Whether a polygon is X-monotone and has no vertical edge."""
    return is_weak(ring) and all(
        p[0] != q[0] for p, q in zip(ring, ring[1:] + ring[:1], strict=True)
    )


def is_weak(ring: Ring) -> bool:
    """Whether a polygon is X-monotone, vertical edges allowed."""
    try:
        split(ring)
    except ChainError:
        return False
    return True


def convex_and_strict(ring: Ring) -> bool:
    """Whether a polygon is convex and has no vertical edge."""
    return is_convex(ring) and is_strict(ring)


def tiny_pairs(side: int, most: int, generatrix: Shape, directrix: Shape) -> Iterator[Pair]:
    """All pairs on a grid with no more than so many vertices in all, smallest first."""
    for total in range(6, most + 1):
        pairs = []
        for n in range(3, total - 2):
            gs = _chosen(side, n, generatrix)
            ds = _chosen(side, total - n, directrix)
            pairs += [Pair(g, d) for g in gs for d in ds]
        yield from sorted(pairs, key=lambda p: (_size(p.generatrix)[0] + _size(p.directrix)[0], p))


@cache
def _chosen(side: int, vertices: int, shape: Shape) -> list[Ring]:
    return [ring for ring in map(list, polygons(side, vertices)) if shape(ring)]


def smallest_pair(
    side: int, most: int, generatrix: Shape, directrix: Shape, fails: Callable[[Pair], str]
) -> tuple[Pair, str] | None:
    """Find the first pair on a grid with which something fails, and what does; None if none does.

    >>> def four_corners(pair):
    ...     return "a square" if len(pair.generatrix) == 4 else ""
    >>> smallest_pair(1, 7, is_convex, is_convex, four_corners)[0].generatrix
    [(0, 0), (1, 0), (1, 1), (0, 1)]
    """
    for pair in tiny_pairs(side, most, generatrix, directrix):
        if text := fails(pair):
            return pair, text
    return None
