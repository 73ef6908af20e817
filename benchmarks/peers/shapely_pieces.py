"""shapely: convex pieces of both polygons, their pairwise sums, and the union of those.

Floats. The pieces are trapezoids between neighbouring x, joined as long as they stay convex.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
import numpy.typing as npt
import shapely

from benchmarks.peers.worker import Loop
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.numbers.point import Rational, Vertex
from exactsweep.procedures.chain import split

Array = npt.NDArray[np.float64]
FloatPoint = tuple[float, float]
ROUNDING = 1e-9


class Piece(NamedTuple):
    """A convex polygon: its lowest vertex, and its edges from there by their angles."""

    start: Array
    edges: Array
    angles: Array

    @classmethod
    def of(cls, ring: Array) -> Piece:
        """From vertices, counter-clockwise."""
        lowest = np.lexsort((ring[:, 0], ring[:, 1]))[0]
        ring = np.roll(ring, -lowest, axis=0)
        edges = np.roll(ring, -1, axis=0) - ring
        return cls(ring[0], edges, np.arctan2(edges[:, 1], edges[:, 0]) % (2 * np.pi))


def version() -> str:
    return f"shapely {shapely.__version__}, GEOS {shapely.geos_version_string}"


def trajectory(generatrix: Ring, directrix: Ring) -> Callable[[], list[Loop]]:
    inverse = [(-x, -y) for x, y in generatrix]

    def run() -> list[Loop]:
        first, second = convex_pieces(directrix), convex_pieces(inverse)
        sums = [convex_sum(p, q) for p in first for q in second]
        owner = np.repeat(np.arange(len(sums)), [len(ring) for ring in sums])
        rings = shapely.linearrings(np.concatenate(sums), indices=owner)
        union = shapely.union_all(shapely.polygons(rings))
        return [[(float(x), float(y)) for x, y in union.exterior.coords[:-1]]]

    return run


def convex_pieces(polygon: Ring) -> list[Piece]:
    """Convex pieces of an X-monotone polygon."""
    bottom, top = split(polygon)
    xs = sorted({x for x, _ in polygon})
    lows, highs = heights(bottom, xs), heights(top[::-1], xs)
    pieces: list[tuple[list[FloatPoint], list[FloatPoint]]] = []
    for k in range(len(xs) - 1):
        below = [(float(xs[k]), lows[k][1]), (float(xs[k + 1]), lows[k + 1][0])]
        above = [(float(xs[k]), highs[k][1]), (float(xs[k + 1]), highs[k + 1][0])]
        if pieces:
            low, high = pieces[-1]
            if low[-1] == below[0] and high[-1] == above[0]:
                longer, higher = [*low, below[1]], [*high, above[1]]
                if turns(longer, 1) and turns(higher, -1):
                    pieces[-1] = longer, higher
                    continue
        pieces.append((below, above))
    return [
        Piece.of(np.array(list(dict.fromkeys([*low, *reversed(high)])))) for low, high in pieces
    ]


def convex_sum(first: Piece, second: Piece) -> Array:
    """The closed ring of the sum of two convex pieces: their edges by angle."""
    edges = np.concatenate((first.edges, second.edges))
    edges = edges[np.argsort(np.concatenate((first.angles, second.angles)), kind="stable")]
    return np.concatenate(
        ([first.start + second.start], first.start + second.start + edges.cumsum(axis=0))
    )


def turns(chain: Sequence[FloatPoint], side: int) -> bool:
    """Whether a chain's last turn is to that side, or so little that it is taken for none."""
    if len(chain) < 3:
        return True
    (px, py), (qx, qy), (rx, ry) = chain[-3:]
    first, second = (qx - px) * (ry - qy), (qy - py) * (rx - qx)
    return side * (first - second) >= -ROUNDING * (abs(first) + abs(second))


def heights(chain: Sequence[Vertex], xs: Sequence[Rational]) -> list[FloatPoint]:
    """The heights of a chain just left and just right of each x."""
    between = np.interp(np.array(xs, dtype=float), *np.array(chain, dtype=float).reshape(-1, 2).T)
    first: dict[Rational, float] = {}
    last: dict[Rational, float] = {}
    for x, y in chain:
        first.setdefault(x, float(y))
        last[x] = float(y)
    return [
        (first.get(x, float(y)), last.get(x, float(y))) for x, y in zip(xs, between, strict=True)
    ]
