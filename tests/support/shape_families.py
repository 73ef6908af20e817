"""Seeded pairs of shapes of any kind: caves, holes, and parts that fit into each other.

Most are sets of squares, which meet and fit as a matter of course, or random polygons on small
grids. Then both are sheared by an integer matrix, scaled, and moved. One `random.Random` decides
everything, so that a pair is known by its seed.
"""

import math
from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from random import Random
from typing import NamedTuple

from cells import Holed, shape_of

from exactsweep import Polygon, PolygonError
from exactsweep.corpus.generator.cells import (
    Cell,
    Matrix,
    block,
    connect,
    grow,
    move,
    neighbours,
)

Shapes = tuple[Holed, Holed]

SHEARS: list[Matrix] = [
    ((1, 0), (0, 1)),
    ((1, 1), (0, 1)),
    ((1, 0), (2, 1)),
    ((2, 1), (1, 1)),
    ((0, -1), (1, 3)),
    ((3, -4), (4, 3)),
    ((1, 2), (3, -1)),
]
SCALES = [Fraction(1), Fraction(1), Fraction(7, 3), Fraction(10**30), Fraction(1, 10**30)]


class ShapePair(NamedTuple):
    """D and G, and where they come from."""

    family: str
    placement: str
    directrix: Holed
    generatrix: Holed


def clump(rng: Random, most: int) -> frozenset[Cell]:
    """A connected set of squares."""
    return grow(rng.randrange(10**6) for _ in range(rng.randint(0, most - 1)))


def polyominoes(rng: Random) -> Shapes:
    return shape_of(clump(rng, 24)), shape_of(clump(rng, 8))


def jigsaw(rng: Random) -> Shapes:
    """A clump cut in two."""
    cells = set(clump(rng, 30)) | block(2, 2)
    part = {rng.choice(sorted(cells))}
    for _ in range(rng.randint(0, len(cells) // 2)):
        around = sorted({n for cell in part for n in neighbours(cell)} & cells - part)
        if around and len(cells) > len(part) + 1:
            part.add(rng.choice(around))
    return shape_of(connect(cells - part)), shape_of(part)


def mould(rng: Random) -> Shapes:
    """A block of squares with the part cut out of it, closed or open to a side."""
    part = clump(rng, 7)
    low_x, low_y = (min(cell[k] for cell in part) for k in (0, 1))
    inside = move(part, (rng.randint(0, 1) - low_x, rng.randint(0, 1) - low_y))
    width, height = (max(c[k] for c in inside) + rng.randint(1, 2) for k in (0, 1))
    around = move(block(width + 2, height + 2), (-1, -1))
    solid = around - inside
    return shape_of(connect(solid)), shape_of(part)


def cave(rng: Random) -> Shapes:
    """A block with a room and a door, about as wide as the part."""
    width, height = rng.randint(3, 7), rng.randint(3, 7)
    room = move(block(width - 2, height - 2), (1, 1))
    start = rng.randint(1, width - 2)
    door = {(x, 0) for x in range(start, min(start + rng.randint(0, 2), width - 1))}
    pillars = {c for c in room if rng.random() < 0.1}
    solid = block(width, height) - room - door | pillars
    part = block(rng.randint(1, 2), rng.randint(1, 2))
    if rng.random() < 0.3:
        part = set(clump(rng, 5))
    return shape_of(connect(solid)), shape_of(part)


def spiral(rng: Random) -> Shapes:
    """A wall that winds inwards, the corridor beside it one or two wide."""
    turns, gap = rng.randint(3, 7), rng.randint(2, 3)
    x = y = 0
    cells = {(0, 0)}
    for k in range(turns):
        dx, dy = ((1, 0), (0, 1), (-1, 0), (0, -1))[k % 4]
        for _ in range((turns - k + 1) // 2 * gap + 1):
            x, y = x + dx, y + dy
            cells.add((x, y))
    part = block(rng.randint(1, gap), rng.randint(1, gap)) if rng.random() < 0.6 else clump(rng, 5)
    return shape_of(cells), shape_of(part)


def rings(rng: Random) -> Shapes:
    """Two frames, one often as wide as the hole of the other."""

    def frame(width: int, height: int) -> set[Cell]:
        return block(width, height) - move(block(width - 2, height - 2), (1, 1))

    width, height = rng.randint(3, 5), rng.randint(3, 5)
    more = [rng.randint(0, 2) if rng.random() < 0.5 else 2 for _ in "xy"]
    outer = frame(width + more[0], height + more[1])
    inner = frame(width, height)
    if rng.random() < 0.3:
        inner.discard((1, 0))
    pair = shape_of(connect(inner)), shape_of(outer)
    return pair if rng.random() < 0.5 else pair[::-1]


def radial(rng: Random) -> Shapes:
    def shape() -> Holed:
        n, size = rng.randint(5, 14), rng.choice([9, 30, 1000])
        turn = 2 * math.pi / n
        points = []
        for k in range(n):
            r = rng.uniform(0.35, 1) * size
            points.append((round(r * math.cos(k * turn)), round(r * math.sin(k * turn))))
        return Holed(Polygon(points))

    return shape(), shape()


def untangled(rng: Random, most: int = 12, side: int = 9) -> Polygon:
    """A random simple polygon: of a random walk, parts are turned until no edges cross."""
    while True:
        n = rng.randint(3, most)
        points = [(rng.randint(0, side), rng.randint(0, side)) for _ in range(n)]
        ring = list(dict.fromkeys(points))
        try:
            return Polygon(_without_crossings(ring))
        except PolygonError:
            continue


def _without_crossings(ring: list[Cell]) -> list[Cell]:
    def turn(a: Cell, b: Cell, c: Cell) -> int:
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    n = len(ring)
    for _ in range(20 * n):
        for i in range(n):
            for j in range(i + 2, n):
                a, b, c, d = ring[i], ring[i + 1], ring[j], ring[(j + 1) % n]
                if turn(a, b, c) * turn(a, b, d) < 0 and turn(c, d, a) * turn(c, d, b) < 0:
                    ring[i + 1 : j + 1] = ring[i + 1 : j + 1][::-1]
                    break
            else:
                continue
            break
        else:
            break
    return ring


def tangles(rng: Random) -> Shapes:
    return Holed(untangled(rng)), Holed(untangled(rng))


def plate(rng: Random) -> Shapes:
    """A plate with holes, some of them of the shape of the part."""
    part = untangled(rng, 6, 4)
    low, high = part.bounding_box
    width, height = (int(c) + 1 for c in (high.x - low.x, high.y - low.y))
    across, up = rng.randint(1, 3), rng.randint(1, 2)
    holes = []
    for i in range(across):
        for j in range(up):
            corner = i * (width + 1) + 1, j * (height + 1) + 1
            kind = rng.random()
            if kind < 0.5:
                holes.append(part.translated((corner[0] - low.x, corner[1] - low.y)))
            elif kind < 0.8:
                more = rng.randint(0, 1)
                size = width - 1 + more, height - rng.randint(0, 1)
                holes.append(_box(corner, (corner[0] + size[0], corner[1] + max(size[1], 1))))
    size = across * (width + 1) + 1, up * (height + 1) + 1
    holes.sort(key=lambda hole: hole.vertices)
    return Holed(_box((0, 0), size), tuple(holes)), Holed(part)


def _box(low: Cell, high: Cell) -> Polygon:
    return Polygon([low, (high[0], low[1]), high, (low[0], high[1])])


def container(rng: Random) -> Shapes:
    """A container, with a defect or without, that the part fits in one or both directions."""
    part = untangled(rng, 7, 5)
    low, high = part.bounding_box
    width, height = int(high.x - low.x), int(high.y - low.y)
    size = width + rng.choice([0, 0, 1, 4]), height + rng.choice([0, 0, 1, 4])
    holes: list[Polygon] = []
    if rng.random() < 0.4 and min(size) > 2:
        x, y = rng.randint(1, size[0] - 2), rng.randint(1, size[1] - 2)
        holes.append(Polygon([(x, y), (x + 1, y), (x, y + 1)]))
    return Holed(_box((0, 0), size), tuple(holes)), Holed(part)


def combs(rng: Random) -> Shapes:
    """Teeth and gaps, often of one width."""

    def comb() -> set[Cell]:
        ends = [0]
        for _ in range(2 * rng.randint(1, 3) + 1):
            ends.append(ends[-1] + rng.choice([1, 1, 2]))
        cells = {(x, 0) for x in range(ends[-1])}
        for start, end in list(pairwise(ends))[::2]:
            cells |= {(x, y) for x in range(start, end) for y in range(rng.randint(2, 4))}
        return cells

    return shape_of(comb()), shape_of({(-x, -y) for x, y in comb()})


SHAPES: dict[str, Callable[[Random], Shapes]] = {
    "polyominoes": polyominoes,
    "jigsaw": jigsaw,
    "mould": mould,
    "cave": cave,
    "spiral": spiral,
    "rings": rings,
    "radial": radial,
    "tangles": tangles,
    "plate": plate,
    "container": container,
    "combs": combs,
}


def random_shapes(rng: Random, families: tuple[str, ...] = tuple(SHAPES)) -> ShapePair:
    """A pair of shapes, placed."""
    family = rng.choice(families)
    while True:
        try:
            d, g = SHAPES[family](rng)
            break
        except PolygonError:  # rounding has made points coincide
            continue
    if rng.random() < 0.2:
        d, g = g, d
    shear, scale = rng.choice(SHEARS), rng.choice(SCALES)
    placed = []
    for shape in (d, g):
        by = rng.randint(-9, 9), rng.randint(-9, 9)
        placed.append(shape.mapped(shear, scale, by))
    placement = "minute" if scale < 1 else "huge" if scale > 10 else "as built"
    return ShapePair(family, placement, placed[0], placed[1])
