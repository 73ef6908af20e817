"""Helpers for tests of covered squares: lattice shapes, corners of squares, free positions."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import product

from polyominoes import Cells, region

from exactsweep.geometry.overlap import Overlap
from exactsweep.numbers.number import Point, Vertex
from exactsweep.procedures.contact_lines import Stretch
from exactsweep.procedures.cover import Cover
from exactsweep.procedures.crossings import cut_at_crossings
from exactsweep.procedures.free_positions import Free, find_free_positions


def rings(cells: Cells, matrix: tuple[int, int, int, int]) -> list[list[Vertex]]:
    """The rings of cells under a matrix, on the lattice."""
    return [list(ring) for ring in region(cells, matrix).lattice()[1]]


def list_corners(cover: Cover) -> Iterator[Point]:
    """The corners of all covered squares."""
    side = cover.side
    for k, bits in enumerate(cover.columns):
        for row in range(bits.bit_length()):
            if bits >> row & 1:
                for i, j in product((0, 1), (0, 1)):
                    x, y = (cover.left + k + i) * side, (cover.low + row + j) * side
                    yield Point(Fraction(x), Fraction(y))


def find_free(stretches: list[Stretch], overlap: Overlap) -> Free:
    """Return the loops that stretches bound, in order."""
    cut_at_crossings(stretches)
    around, within, fits = find_free_positions(stretches, overlap.at, 1)
    return Free(sorted(around), sorted(within), fits)
