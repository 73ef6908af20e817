"""Containers with placed shapes, and the positions of a part compared with `classify`.

The only source of randomness is one `random.Random`, so the seed reproduces a scene.
"""

from collections.abc import Callable, Iterator
from fractions import Fraction
from itertools import chain, product
from random import Random
from typing import NamedTuple

from shape_families import untangled

from exactsweep import InnerFit, Point, Polygon, Region, free_positions
from exactsweep.check import classify
from exactsweep.corpus.generator.cells import Cell, build_block, grow, move, trace_outline

SHEARS = [((1, 0), (0, 1)), ((1, 1), (0, 1)), ((2, 1), (1, 1)), ((0, -1), (1, 3))]
SCALES = [Fraction(1), Fraction(1), Fraction(2, 3), Fraction(10**30), Fraction(1, 10**30)]
SIDE = 6
MOST = 100  # positions of a scene


class Scene(NamedTuple):
    """A container, the shapes placed in it, the part, and the step of a lattice of positions."""

    family: str
    container: Region
    placed: list[Region]
    part: Region
    step: Fraction


def draw_cells(rng: Random) -> list[Region]:
    """Draw placed polyominoes that touch or overlap walls and each other, and leave exact gaps."""
    container = set(grow(rng.choices(range(60), k=rng.randint(20, 50))))
    left, low = min(x for x, _ in container), min(y for _, y in container)
    placed = [
        move(
            grow(rng.choices(range(30), k=rng.randint(0, 7))),
            (left + rng.randint(0, 8), low + rng.randint(0, 8)),
        )
        for _ in range(rng.randint(0, 4))
    ]
    part = grow(rng.choices(range(30), k=rng.randint(0, 4)))
    return _sheared(rng, [container, *placed, set(part)])


def draw_jigsaw(rng: Random) -> list[Region]:
    """Draw a rectangle cut into polyominoes, some of which are removed."""
    free = build_block(SIDE, SIDE)
    pieces: list[set[Cell]] = []
    while free:
        piece = {min(free)}
        for _ in range(rng.randint(0, 5)):
            adjacent = sorted({(x + 1, y) for x, y in piece} | {(x, y + 1) for x, y in piece})
            piece |= set(rng.sample(adjacent, 1)) & free
        free -= piece
        pieces.append(piece)
    rng.shuffle(pieces)
    part = pieces[0] if rng.random() < 0.7 else set(grow([0]))
    out = rng.choice([0, 1, 1, 2, 5])
    return _sheared(rng, [build_block(SIDE, SIDE), *pieces[out:], part])


def _sheared(rng: Random, cells: list[set[Cell]]) -> list[Region]:
    matrix = rng.choice(SHEARS)
    return [
        Region(Polygon(_mapped(r.exterior, matrix)), [_mapped(h, matrix) for h in r.holes])
        for r in map(trace_outline, cells)
    ]


def _mapped(ring: Polygon, matrix: tuple[Cell, Cell]) -> list[tuple[Fraction, Fraction]]:
    (a, b), (c, d) = matrix
    return [(a * x + b * y, c * x + d * y) for x, y in ring.vertices]


def draw_polygons(rng: Random) -> list[Region]:
    """Draw random simple polygons."""
    placed = [
        Region(untangled(rng, 6, 5)).translated((rng.randint(0, 8), rng.randint(0, 8)))
        for _ in range(rng.randint(0, 4))
    ]
    container = Region(untangled(rng, 9, 12)) if rng.random() < 0.5 else Region(_box(12))
    return [container, *placed, Region(untangled(rng, 5, 3))]


def _box(side: int) -> list[Cell]:
    return [(0, 0), (side, 0), (side, side), (0, side)]


FAMILIES: dict[str, Callable[[Random], list[Region]]] = {
    "cells": draw_cells,
    "jigsaw": draw_jigsaw,
    "polygons": draw_polygons,
}


def draw_scene(rng: Random) -> Scene:
    """Draw a scene of any family and size."""
    family, scale = rng.choice(sorted(FAMILIES)), rng.choice(SCALES)
    container, *placed, part = (shape.scaled(scale) for shape in FAMILIES[family](rng))
    return Scene(family, container, placed, part, scale / 2)


def expected(scene: Scene, t: Point) -> str:
    """Locate a position by the definition; the outside of the container is solid."""
    low, high = scene.container.bounding_box
    # The frame contains everything that the part reaches.
    a, b = scene.part.translated(t).bounding_box
    left, right = min(low.x, a.x) - 1, max(high.x, b.x) + 1
    floor, ceiling = min(low.y, a.y) - 1, max(high.y, b.y) + 1
    around = [(left, floor), (right, floor), (right, ceiling), (left, ceiling)]
    frame = Region(around, [scene.container.exterior])
    solid = [frame, *map(Region, scene.container.holes), *scene.placed]
    verdicts = {classify(shape, scene.part, t).verdict for shape in solid}
    if "OVERLAP" in verdicts:
        return "outside"
    return "boundary" if "CONTACT" in verdicts else "inside"


def list_positions(scene: Scene, found: InnerFit) -> Iterator[Point]:
    """List a lattice of positions, and the features of the answer."""
    low, high = scene.container.bounding_box
    a, b = scene.part.bounding_box
    step = scene.step
    xs, ys = (
        [first + k * step for k in range(-1, int((last - first) / step) + 2)]
        for first, last in ((low.x - a.x, high.x - b.x), (low.y - a.y, high.y - b.y))
    )
    yield from (Point(x, y) for x, y in product(xs, ys))
    loops = [ring for region in found.regions for ring in region.rings]
    edges = [(ring[k - 1], p) for ring in loops for k, p in enumerate(ring)]
    for p, q in chain(edges, found.exact_fits):
        yield p
        yield Point((p.x + q.x) / 2, (p.y + q.y) / 2)


def compare(scene: Scene, rng: Random, deep: bool) -> str:
    """Return the first position that the kernel and the definition locate differently."""
    found = free_positions(scene.container, scene.placed, scene.part)
    positions = list(list_positions(scene, found))
    for t in rng.sample(positions, min(MOST, len(positions))):
        if (answer := found.locate(t)) != (true := expected(scene, t)):
            return f"{answer} at {t}, not {true}"
    return ""
