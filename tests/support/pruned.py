"""Pairs of any shape with and without the two pruning steps."""

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from unittest.mock import patch

from polyominoes import Cells, region

from exactsweep.geometry.edges import EdgeIndex, Rings
from exactsweep.geometry.overlap import Relation, relate
from exactsweep.numbers.number import Point, Vertex
from exactsweep.procedures import cover, neighbors, positions
from exactsweep.procedures.positions import FreeRegions, find_inner_fit, find_no_fit
from exactsweep.procedures.walk import FreeBoundary


def rings(cells: Cells, matrix: tuple[int, int, int, int]) -> list[list[Vertex]]:
    """Return the rings of cells under a matrix, on the lattice."""
    return [list(ring) for ring in region(cells, matrix).lattice()[1]]


@contextmanager
def pruning(*, thin: bool, wide: bool) -> Iterator[None]:
    """Run each pruning step on all pairs, even small ones, or on none."""
    with (
        patch.object(cover, "_FEW", 1),
        patch.object(cover, "_CROSSINGS", 0),
        patch.object(neighbors, "_FEW", 0),
    ):
        without_thin = patch.object(positions, "leave_out_overlapped", lambda edges, *_: edges)
        without_wide = patch.object(positions, "leave_out_covered", lambda segments, *_: segments)
        if thin and wide:
            yield
        elif thin:
            with without_wide:
                yield
        elif wide:
            with without_thin:
                yield
        else:
            with without_thin, without_wide:
                yield


STEPS = [(thin, wide) for thin in (True, False) for wide in (True, False)]


def require_the_same_without_steps(stationary: Rings, orbiting: Rings) -> None:
    """Require the same answers with each of the steps, with both, and with none."""
    container = [[(3 * x, 3 * y) for x, y in ring] for ring in stationary]
    found: list[tuple[FreeBoundary, FreeRegions]] = []
    for thin, wide in STEPS:
        with pruning(thin=thin, wide=wide):
            found.append((find_no_fit(stationary, orbiting), find_inner_fit(container, orbiting)))
    plain = find_no_fit(stationary, orbiting), find_inner_fit(container, orbiting)
    assert all(answer == plain for answer in found)


class Overlaps:
    """A test of two shapes at a position of the second one."""

    def __init__(self, stationary: Rings, orbiting: Rings) -> None:
        self._pair = EdgeIndex(stationary), EdgeIndex(orbiting)

    def at(self, t: Point) -> bool:
        (x, b), (y, d) = Fraction(t.x).as_integer_ratio(), Fraction(t.y).as_integer_ratio()
        return relate(*self._pair, x * d, y * b, b * d) is Relation.OVERLAP
