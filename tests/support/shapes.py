"""Shapes of any kind, with holes, cavities and slots, on grids so small that they often fit."""

from fractions import Fraction

from cells import Holed, shape_of
from hypothesis import strategies as st
from strategies import simple_polygons

from exactsweep.corpus.generator.cells import Cell, Matrix, connect, grow

Cells = frozenset[Cell]

SHEARS: list[Matrix] = [((1, 0), (0, 1)), ((1, 1), (0, 1)), ((2, 1), (1, 1)), ((0, -1), (1, 3))]
SCALES = [Fraction(1), Fraction(2, 3), Fraction(10**30), Fraction(1, 10**30)]


def polyominoes(most: int = 14) -> st.SearchStrategy[Cells]:
    """Draw connected sets of cells, with holes and touching corners."""
    return st.lists(st.integers(0, 30), max_size=most - 1).map(grow)


@st.composite
def ringed(draw: st.DrawFn) -> Cells:
    """Draw a frame of cells, with some cells inside that are connected to it."""
    width, height = draw(st.integers(3, 6)), draw(st.integers(3, 6))
    cells = {(x, y) for x in range(width) for y in range(height)}
    inside = sorted(c for c in cells if 0 < c[0] < width - 1 and 0 < c[1] < height - 1)
    left_out = draw(st.sets(st.sampled_from(inside), min_size=1))
    return frozenset(connect(cells - left_out))


def cell_sets() -> st.SearchStrategy[Cells]:
    return polyominoes() | ringed()


@st.composite
def shape_pairs(draw: st.DrawFn) -> tuple[Holed, Holed]:
    """Draw two polyominoes with a common shear and scale, or two simple polygons."""
    if draw(st.integers(0, 3)) == 0:
        return Holed(draw(simple_polygons())), Holed(draw(simple_polygons()))
    matrix, scale = draw(st.sampled_from(SHEARS)), draw(st.sampled_from(SCALES))
    d, g = shape_of(draw(cell_sets())), shape_of(draw(polyominoes(7) | ringed()))
    return d.mapped(matrix, scale), g.mapped(matrix, scale)
