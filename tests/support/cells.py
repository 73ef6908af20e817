"""Polyominoes: sets of unit squares, their rings, and how two of them lie by counting squares."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.geometry.polygon import Polygon

Cell = tuple[int, int]
Matrix = tuple[tuple[int, int], tuple[int, int]]

SIDES = ((1, 0), (0, 1), (-1, 0), (0, -1))


class Holed(NamedTuple):
    """A polygon and its holes, as a Region has them."""

    exterior: Polygon
    holes: tuple[Polygon, ...] = ()

    def mapped(self, matrix: Matrix, scale: Fraction = Fraction(1), by: Cell = (0, 0)) -> "Holed":
        """The image under a matrix, then moved, then scaled."""
        (a, b), (c, d) = matrix
        image = [
            Polygon(
                [
                    ((a * x + b * y + by[0]) * scale, (c * x + d * y + by[1]) * scale)
                    for x, y in polygon.vertices
                ]
            )
            for polygon in (self.exterior, *self.holes)
        ]
        return Holed(image[0], tuple(sorted(image[1:], key=lambda hole: hole.vertices)))

    @property
    def area(self) -> Fraction:
        return self.exterior.area - sum(hole.area for hole in self.holes)

    def size(self) -> int:
        return sum(map(len, (self.exterior, *self.holes)))


def neighbours(cell: Cell) -> list[Cell]:
    return [(cell[0] + dx, cell[1] + dy) for dx, dy in SIDES]


def grown(choices: Iterable[int]) -> frozenset[Cell]:
    """A connected set of cells: each choice adds one of the neighbours."""
    cells = {(0, 0)}
    for choice in choices:
        around = sorted({n for cell in cells for n in neighbours(cell)} - cells)
        cells.add(around[choice % len(around)])
    return frozenset(cells)


def shape_of(cells: Iterable[Cell]) -> Holed:
    """The shape of a connected set of cells.

    Where two cells meet in a corner only, the walk goes on along the other one, so that a shape
    that touches itself there is written as rings that touch.
    """
    filled = set(cells)
    ahead: dict[Cell, list[Cell]] = defaultdict(list)
    for x, y in filled:
        corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
        beyond = [(x, y - 1), (x + 1, y), (x, y + 1), (x - 1, y)]
        for k in range(4):
            if beyond[k] not in filled:
                ahead[corners[k]].append(corners[(k + 1) % 4])
    rings: list[Polygon] = []
    while ahead:
        start = p = min(ahead)
        ring = [p]
        q = ahead[p][0]
        while True:
            ahead[p].remove(q)
            if not ahead[p]:
                del ahead[p]
            if q == start:
                break
            ring.append(q)
            right = (q[0] + q[1] - p[1], q[1] - q[0] + p[0])
            p, q = q, right if right in ahead[q] else ahead[q][0]
        rings.append(Polygon(ring))
    exterior = max(rings, key=lambda ring: ring.area)
    holes = [ring for ring in rings if ring is not exterior]
    return Holed(exterior, tuple(sorted(holes, key=lambda hole: hole.vertices)))


def grid(*rows: str) -> Holed:
    """A shape drawn with one character a square, the lowest row last."""
    height = len(rows)
    return shape_of(
        (x, height - 1 - y) for y, row in enumerate(rows) for x, c in enumerate(row) if c == "#"
    )


def connected(cells: set[Cell]) -> set[Cell]:
    """The part of a set of cells that is connected to its least one."""
    found, left = {min(cells)}, [min(cells)]
    while left:
        around = set(neighbours(left.pop())) & cells - found
        found |= around
        left += around
    return found


def doubled(cells: Iterable[Cell]) -> set[Cell]:
    """The same set in squares of half the width."""
    return {(2 * x + dx, 2 * y + dy) for x, y in cells for dx in (0, 1) for dy in (0, 1)}


def moved(cells: Iterable[Cell], by: Sequence[int]) -> set[Cell]:
    return {(x + by[0], y + by[1]) for x, y in cells}


def verdict_by_counting(d: Iterable[Cell], g: Iterable[Cell]) -> str:
    """How two sets of cells lie: with a common cell, with a common corner, or apart."""
    filled, other = set(d), set(g)
    if filled & other:
        return "OVERLAP"
    around = {(x + dx, y + dy) for x, y in filled for dx in (-1, 0, 1) for dy in (-1, 0, 1)}
    return "CONTACT" if around & other else "FREE"
