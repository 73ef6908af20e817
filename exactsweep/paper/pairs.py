"""Seeded random pairs for the checks: small integer grids, where features meet often.

"CC", "CM" and "MM" are the paper's classes. Strict polygons have no vertical edge, as the paper
takes for granted; weak ones have vertical edges, at the ends and inside their chains.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from random import Random
from typing import Any, Literal, NamedTuple, TypeVar

from exactsweep.geometry.point import Vertex
from exactsweep.geometry.polygon import Polygon
from exactsweep.paper.claim import Run
from exactsweep.procedures.chain import inverse, split

Ring = list[tuple[int, int]]
Kind = Literal["CC", "CM", "MM"]


P = TypeVar("P", bound=tuple[Any, Any])


class Chains(NamedTuple):
    """The chains of a lower sweep (G_t, D_b), and G_b; tops run from right to left."""

    top: list[Vertex]
    bottom: list[Vertex]
    directrix: list[Vertex]


class Pair(NamedTuple):
    """An X-monotone generatrix and directrix."""

    generatrix: Ring
    directrix: Ring

    @property
    def chains(self) -> Chains:
        """The chains of the lower sweep."""
        bottom, top = split(self.generatrix)
        return Chains(top, bottom, split(self.directrix)[0])

    @property
    def mirrored(self) -> Pair:
        """The pair turned by half a turn, so that the upper sweep is the lower one."""
        g, d = (
            [(int(x), int(y)) for x, y in inverse(ring)]
            for ring in (self.generatrix, self.directrix)
        )
        return Pair(g, d)


def hull(points: Sequence[P]) -> list[P]:
    """The convex hull, counter-clockwise, corners only (Andrew's monotone chain).

    >>> hull([(0, 0), (1, 1), (2, 0), (1, 0), (0, 2)])
    [(0, 0), (2, 0), (0, 2)]
    """
    ordered = sorted(set(points))
    ring: list[P] = []
    for run in (ordered, ordered[::-1]):
        half: list[P] = []
        for point in run:
            x, y = point
            while len(half) > 1:
                (ax, ay), (bx, by) = half[-2:]
                if (bx - ax) * (y - by) - (by - ay) * (x - bx) > 0:
                    break
                half.pop()
            half.append(point)
        ring += half[:-1]
    return ring


def convex(rng: Random, *, strict: bool) -> Ring:
    """A convex polygon; where it is strict, the grid is sheared until no edge is vertical."""
    side = rng.choice([2, 4, 9])
    points = [(rng.randint(0, side), rng.randint(0, side)) for _ in range(rng.randint(3, 9))]
    found = hull(points)
    if len(found) < 3:
        found = [(0, 0), (side, 0), (rng.randint(0, side), side)]
    return [((side + 1) * x + y, y) for x, y in found] if strict else found


def monotone(rng: Random, *, strict: bool) -> Ring:
    """An X-monotone polygon, seldom convex."""
    height, width = rng.choice([2, 5, 30]), rng.randint(3, 9)
    slope = rng.randint(-2, 2)
    chains: list[Ring] = []
    for sign in (-1, 1):
        chain: Ring = []
        for x in sorted(rng.sample(range(1, width), rng.randint(1, min(5, width - 1)))):
            chain.append((x, sign * rng.randint(1, height)))
            if not strict and rng.random() < 0.5:
                chain.append((x, sign * rng.randint(1, height)))
        chains.append(chain)
    bottom, top = chains
    left, right = [(0, 0)], [(width, 0)]
    if not strict:
        for end in (left, right):
            if rng.random() < 0.5:
                end.append((end[0][0], rng.randint(1, height)))
        left.reverse()
    ring = [left[-1], *bottom, *right, *reversed(top), *left[:-1]]
    return [(x, y + slope * x) for x, y in ring]


def random_pair(rng: Random, kind: Kind, *, strict: bool = True) -> Pair:
    """Draw a pair of a class; now and then both on one scale, now and then on two."""
    shapes: dict[str, Callable[..., Ring]] = {"C": convex, "M": monotone}
    generatrix, directrix = (shapes[letter](rng, strict=strict) for letter in kind)
    factor = rng.choice([1, 1, 2, 7])
    enlarged = [(factor * x, factor * y) for x, y in directrix]
    return Pair(_corners(generatrix), _corners(enlarged))


def _corners(ring: Ring) -> Ring:
    """The canonical ring, without collinear vertices."""
    return [(int(x), int(y)) for x, y in Polygon(ring).vertices]


def random_pairs(run: Run, kind: Kind, count: int, *, strict: bool = True) -> Iterator[Pair]:
    """Draw pairs that depend on the seed of the run, their class and their number alone."""
    for number in range(count):
        yield random_pair(run.random(f"{kind} {strict} {number}"), kind, strict=strict)
