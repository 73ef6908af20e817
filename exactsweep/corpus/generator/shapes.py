"""Random simple rings with integer coordinates, convex or weakly x-monotone, counter-clockwise."""

from collections.abc import Iterable, Sequence
from itertools import accumulate, combinations
from typing import Any, NamedTuple, TypeVar

from exactsweep.corpus.generator.prng import Prng
from exactsweep.geometry.vectors import find_hull, orientation

IntegerPoint = tuple[int, int]
Ring = list[IntegerPoint]
P = TypeVar("P", bound=tuple[Any, Any])


class Grid(NamedTuple):  # parameters of a random monotone ring
    cells: tuple[int, int]  # minimum and maximum number of cells of each chain
    widths: Sequence[int]  # of a cell
    height: int  # maximum y of each chain; the minimum is 0
    walls: int = 0  # probability of a vertical edge between cells, in eighths
    pointed: int = 3  # probability of a point instead of a vertical edge at an end, in eighths


def draw_convex(random: Prng, most: int, side: int) -> Ring:
    points = [
        (random.between(0, side), random.between(0, side)) for _ in range(random.between(3, most))
    ]
    found = find_hull(points)
    return found if len(found) > 2 else [(0, 0), (side, 0), (0, side)]


def walk(
    steps: Iterable[tuple[Any, Any]], start: tuple[Any, Any] = (0, 0)
) -> list[tuple[Any, Any]]:
    return list(accumulate(steps, lambda p, step: (p[0] + step[0], p[1] + step[1]), initial=start))


def draw_monotone(random: Prng, grid: Grid) -> Ring:
    bottom, top = _chain(random, grid), _chain(random, grid)
    return close_between(random, bottom, top, grid.pointed)


def _chain(random: Prng, grid: Grid) -> Ring:
    widths = [random.choice(grid.widths) for _ in range(random.between(*grid.cells))]
    xs = [x for x, _ in walk((width, 0) for width in widths)]
    chain = [(0, random.between(0, grid.height))]
    for x in xs[1:]:
        chain.append((x, random.between(0, grid.height)))
        if x != xs[-1] and random.chance(grid.walls, 8):
            chain.append((x, random.between(0, grid.height)))
    return chain


def draw_rectilinear(
    random: Prng, cells: tuple[int, int], widths: Sequence[int], height: int
) -> Ring:
    def chain() -> Ring:
        widths_drawn = [random.choice(widths) for _ in range(random.between(*cells))]
        return build_columns(widths_drawn, [random.between(0, height) for _ in widths_drawn])

    bottom, top = chain(), chain()
    return close_between(random, bottom, top, pointed=0)


def build_columns(widths: Sequence[int], heights: Sequence[int]) -> Ring:
    """List the top boundary of adjacent columns from left to right, starting at x = 0."""
    xs = [x for x, _ in walk((width, 0) for width in widths)]
    return [(x, y) for k, y in enumerate(heights) for x in xs[k : k + 2]]


def close_between(random: Prng, bottom: Ring, top: Ring, pointed: int = 3) -> Ring:
    """Join two chains to a ring, and raise the top one until they are disjoint."""
    last = max(bottom[-1][0], top[-1][0])
    bottom, top = (
        chain if chain[-1][0] == last else [*chain, (last, chain[0][1])] for chain in (bottom, top)
    )
    lift = max(y for _, y in bottom) - min(y for _, y in top) + random.between(1, 3)
    unit = max(1, last // 8)
    tips: list[Ring] = []
    for x, low, high in (last + unit, bottom[-1], top[-1]), (-unit, bottom[0], top[0]):
        # A tip may be above or below the ends of both chains.
        y = random.between(low[1] - 1, high[1] + lift + 1)
        tips.append([(x, y)] if random.chance(pointed, 8) else [])
    right, left = tips
    return [*bottom, *right, *((x, y + lift) for x, y in reversed(top)), *left]


def reflect_ring(ring: Ring) -> Ring:
    return [(-x, -y) for x, y in ring]


def untangle(points: Iterable[IntegerPoint]) -> Ring:
    """Order points on a closed path without crossing edges by 2-opt; edges may still touch.

    >>> untangle([(0, 0), (2, 2), (2, 0), (0, 2)])
    [(0, 0), (2, 0), (2, 2), (0, 2)]
    """
    ring = list(points)
    while pair := _find_crossing(ring):
        i, j = pair
        ring[i + 1 : j + 1] = ring[i + 1 : j + 1][::-1]
    return ring


def _find_crossing(ring: Ring) -> IntegerPoint | None:
    for i, j in combinations(range(len(ring)), 2):
        a, b, p, q = ring[i], ring[i + 1], ring[j], ring[(j + 1) % len(ring)]
        if (
            orientation(a, b, p) * orientation(a, b, q) < 0
            and orientation(p, q, a) * orientation(p, q, b) < 0
        ):
            return i, j
    return None
