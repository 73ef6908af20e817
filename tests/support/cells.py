"""Polyominoes: sets of unit squares, their rings, and their relation by counting squares."""

from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple

from exactsweep.corpus.generator.cells import Cell, Matrix, map_region, trace_outline
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region


class Holed(NamedTuple):
    """A polygon with holes."""

    exterior: Polygon
    holes: tuple[Polygon, ...] = ()

    def mapped(self, matrix: Matrix, scale: Fraction) -> "Holed":
        """Return the image under a matrix, then scaled."""
        image = map_region(Region(self.exterior, self.holes), matrix, scale)
        return Holed(image.exterior, image.holes)

    @property
    def area(self) -> Fraction:
        return self.exterior.area - sum(hole.area for hole in self.holes)


def shape_of(cells: Iterable[Cell]) -> Holed:
    """Return the shape of a connected set of cells."""
    shape = trace_outline(cells)
    return Holed(shape.exterior, shape.holes)


def grid(*rows: str) -> Holed:
    """Read a shape from a drawing with one character per square, the bottom row last."""
    height = len(rows)
    return shape_of(
        (x, height - 1 - y) for y, row in enumerate(rows) for x, c in enumerate(row) if c == "#"
    )


def doubled(cells: Iterable[Cell]) -> set[Cell]:
    """Return the same set in squares of half the width."""
    return {(2 * x + dx, 2 * y + dy) for x, y in cells for dx in (0, 1) for dy in (0, 1)}


def verdict_by_counting(d: Iterable[Cell], g: Iterable[Cell]) -> str:
    """Return OVERLAP for a common cell, CONTACT for a common corner, FREE otherwise."""
    filled, other = set(d), set(g)
    if filled & other:
        return "OVERLAP"
    around = {(x + dx, y + dy) for x, y in filled for dx in (-1, 0, 1) for dy in (-1, 0, 1)}
    return "CONTACT" if around & other else "FREE"
