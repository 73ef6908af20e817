"""The CM procedures on chains."""

from fractions import Fraction
from itertools import pairwise

import strategies as own
from hypothesis import given, settings
from hypothesis import strategies as st

from exactsweep import Polygon, sweep
from exactsweep.geometry.point import Vertex
from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import inverse, split
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm

Pair = tuple[Polygon, Polygon]
usually = settings(max_examples=100)


@given(own.pairs("CC"))
@usually
def test_along_a_convex_directrix_it_is_the_cc_sweep(pair: Pair) -> None:
    (g_bottom, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    assert list(trajectory_cm(g_top, bottom)) == trajectory_cc(g_top, bottom)
    assert sweep_inner_cm(g_top, bottom) == sweep_inner_cc(g_top, bottom)
    outer = sweep_outer_cm(g_top, g_bottom, bottom)
    assert list(outer) == sweep_outer_cc(g_top, g_bottom, bottom)


@given(own.pairs("CM"))
@usually
def test_halves_are_those_of_the_whole_sweep(pair: Pair) -> None:
    (g_bottom, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    s = sweep(*pair, direction=(1, 0))
    found = (
        list(trajectory_cm(g_top, bottom)),
        sweep_inner_cm(g_top, bottom),
        list(sweep_outer_cm(g_top, g_bottom, bottom)),
    )
    for chain, loop in zip(found, (s.trajectory, s.inner, s.outer), strict=True):
        assert chain == split(loop.vertices)[0]


@given(own.pairs("CM"))
@usually
def test_outer_boundary_is_the_trajectory_swept_by_the_inverse(pair: Pair) -> None:
    """The outer loop bounds T plus G: Lemma 5.3, for a convex G."""
    (g_bottom, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    outer = list(sweep_outer_cm(g_top, g_bottom, bottom))
    envelope = trajectory_cm(g_top, bottom)
    assert list(trajectory_cm(inverse(g_bottom), list(envelope))) == outer
    assert list(trajectory_cm(inverse(g_bottom), envelope)) == outer


@given(own.pairs("CM"))
@usually
def test_inner_boundary_closes_and_never_opens(pair: Pair) -> None:
    """Swept again, the inner boundary is its own inner boundary, and has the same trajectory."""
    (_, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    inner = sweep_inner_cm(g_top, bottom)
    assert (inner[0], inner[-1]) == (bottom[0], bottom[-1])
    assert sweep_inner_cm(g_top, inner) == inner
    assert list(trajectory_cm(g_top, inner)) == list(trajectory_cm(g_top, bottom))


@given(own.pairs("CM"))
@usually
def test_trajectory_at_hand_may_be_given(pair: Pair) -> None:
    (_, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    envelope = trajectory_cm(g_top, bottom)
    before = list(envelope)
    assert sweep_inner_cm(g_top, bottom, envelope) == sweep_inner_cm(g_top, bottom)
    assert list(envelope) == before


@given(own.pairs("CM"))
@usually
def test_ints_and_fractions_give_the_same(pair: Pair) -> None:
    g, d = (list(polygon.lattice()[1]) for polygon in pair)
    (g_bottom, g_top), (bottom, _) = split(g), split(d)

    def shrunk(chain: list[Vertex]) -> list[Vertex]:
        return [(Fraction(x) / 7, Fraction(y) / 7) for x, y in chain]

    top, floor, wall = map(shrunk, (g_top, g_bottom, bottom))
    assert shrunk(list(trajectory_cm(g_top, bottom))) == list(trajectory_cm(top, wall))
    assert shrunk(sweep_inner_cm(g_top, bottom)) == sweep_inner_cm(top, wall)
    outer = shrunk(list(sweep_outer_cm(g_top, g_bottom, bottom)))
    assert outer == list(sweep_outer_cm(top, floor, wall))


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
def test_sources_number_the_convex_parts_from_left_to_right(pair: Pair) -> None:
    (_, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    sources = trajectory_cm(g_top, bottom).sources
    assert sources == sorted(sources)
