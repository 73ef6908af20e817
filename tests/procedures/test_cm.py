"""The CM procedures on chains."""

from fractions import Fraction
from itertools import pairwise

import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.numbers.number import Vertex
from exactsweep.paper.kernel import sweep_outer_cm, trajectory_cm
from exactsweep.procedures.chain import split

Pair = tuple[Polygon, Polygon]
usually = examples(100)


@given(own.pairs("CM"), st.data())
@usually
def test_collinear_runs_and_repeated_points_change_nothing(pair: Pair, data: st.DataObject) -> None:
    (g_bottom, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    run: list[Vertex] = []
    for (px, py), (qx, qy) in pairwise(bottom):
        run += [(px, py)] * data.draw(own.tiny(1, 2))
        if data.draw(st.booleans()):
            run.append((Fraction(px + 2 * qx) / 3, Fraction(py + 2 * qy) / 3))
    run.append(bottom[-1])
    assert list(trajectory_cm(g_top, run)) == list(trajectory_cm(g_top, bottom))
    outer = sweep_outer_cm(g_top, g_bottom, run)
    assert list(outer) == list(sweep_outer_cm(g_top, g_bottom, bottom))


@given(own.pairs("CM"))
@usually
def test_contacts_move_from_left_to_right(pair: Pair) -> None:
    """Lemma A.2."""
    (_, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    numbers = [i for piece in trajectory_cm(g_top, bottom).pieces for _, i, _ in piece[3:]]
    assert numbers == sorted(numbers)
