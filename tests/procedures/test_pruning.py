"""The two pruning steps change no answer: pairs with one of them, with both, and with none.

Most pairs are too small for these steps, so the tests force them.
"""

from fractions import Fraction
from itertools import groupby
from random import Random

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes
from pruned import STEPS, pruning, require_the_same_without_steps, rings
from shape_families import random_shapes
from strategies import Ring, simple_rings
from tiers import examples

from exactsweep import Polygon, Region
from exactsweep.corpus import cases
from exactsweep.evidence.no_fit import NoFitAnswer
from exactsweep.geometry.edges import Rings
from exactsweep.geometry.region import share_lattice
from exactsweep.numbers.number import Vertex
from exactsweep.procedures.positions import find_sum, path_rings

SCALES = st.sampled_from([Fraction(1), Fraction(7, 3), Fraction(10**30), Fraction(1, 10)])
MATRICES = st.sampled_from([(1, 0, 0, 1), (7, 0, 0, 7), (5, 3, -2, 9), (6, -1, 6, 5)])


# The second edge crosses the line of the segment one unit ahead of the vertex.
@example([(2, 1), (3, 0), (5, 4)], [(2, 4), (4, 3), (3, 5), (3, 4)], Fraction(1))
@given(simple_rings(), simple_rings(), SCALES)
@examples(32)
def test_polygons_have_the_same_answer(d: Ring, g: Ring, scale: Fraction) -> None:
    stationary, orbiting = (
        [[(x * scale, y * scale) for x, y in Polygon(ring).vertices]] for ring in (d, g)
    )
    require_the_same_without_steps(stationary, orbiting)


@given(polyominoes(12, 4), polyominoes(7, 3), MATRICES)
@examples(60)
def test_polyominoes_have_the_same_answer(
    d: Cells, g: Cells, matrix: tuple[int, int, int, int]
) -> None:
    require_the_same_without_steps(rings(d, matrix), rings(g, matrix))


@given(
    simple_rings(),
    st.lists(st.tuples(st.integers(-9, 9), st.integers(-9, 9)), min_size=2, max_size=6),
    st.booleans(),
    SCALES,
)
@examples(40)
def test_sums_with_paths_have_the_same_answer(
    d: Ring, points: list[tuple[int, int]], closed: bool, scale: Fraction
) -> None:
    steps = [point for point, _ in groupby(points)]
    if len(steps) < 2 or (closed and (len(steps) < 3 or steps[0] == steps[-1])):
        return
    shape: Rings = [[(x * scale, y * scale) for x, y in Polygon(d).vertices]]
    path = path_rings([(x * scale, y * scale) for x, y in steps], closed=closed)
    found = []
    for thin, wide in STEPS:
        with pruning(thin=thin, wide=wide):
            found += [find_sum(shape, path), find_sum(path, shape)]
    assert all(answer == found[0] for answer in found)


@pytest.mark.parametrize("number", range(30))
def test_shapes_with_holes_have_the_same_answer(number: int) -> None:
    pair = random_shapes(Random(f"pruning:{number}"))
    d, g = (Region(shape.exterior, shape.holes) for shape in (pair.directrix, pair.generatrix))
    require_the_same_without_steps(*share_lattice([d, g])[1])


@pytest.mark.parametrize(("thin", "wide"), STEPS)
@pytest.mark.long
def test_pruning_changes_no_answer_of_the_corpus(thin: bool, wide: bool) -> None:
    for case in cases(max_size=200):
        if case.kind != "SS":
            continue
        with pruning(thin=thin, wide=wide):
            n = NoFitAnswer(Region(case.directrix), Region(case.generatrix), None, case.reference)
            assert (n.exterior, n.holes, n.exact_fits) == (
                case.trajectory,
                case.holes,
                case.exact_fits,
            ), case.id


def test_the_same_shape_may_be_placed_twice() -> None:
    up: list[Vertex] = [(2 * i, 400 if i % 2 else 0) for i in range(10)]
    strip = [*up, *((x, y + 3) for x, y in reversed(up))]
    require_the_same_without_steps([strip], [[(0, 0), (1, 0), (0, 1)]])
