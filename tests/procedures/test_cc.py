"""The CC procedures on chains: Lemmas 3.1 and 3.2."""

from fractions import Fraction
from itertools import pairwise
from math import inf

import strategies as own
from hypothesis import example, given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.numbers.number import Vertex
from exactsweep.paper.kernel import (
    sweep_inner_cc,
    sweep_outer_cc,
    trajectory_cc,
    trajectory_cm,
    trajectory_mm,
)
from exactsweep.procedures import cc
from exactsweep.procedures.cc import subtrajectory
from exactsweep.procedures.chain import Chain, inverse, partition, split

Pair = tuple[Polygon, Polygon]
usually = examples(100)


def steps(*chains: list[Vertex]) -> list[Vertex]:
    """Return the edge vectors sorted by slope, with parallel vectors added."""
    found: list[Vertex] = []
    vectors = [(q[0] - p[0], q[1] - p[1]) for chain in chains for p, q in pairwise(chain)]
    for x, y in sorted(vectors, key=lambda v: Fraction(v[1]) / v[0]):
        if found and found[-1][0] * y == found[-1][1] * x:
            x, y = x + found[-1][0], y + found[-1][1]
            found.pop()
        found.append((x, y))
    return found


def plus(p: Vertex, q: Vertex) -> Vertex:
    return p[0] + q[0], p[1] + q[1]


@given(own.pairs("CC"))
@usually
def test_trajectory_is_the_edges_in_order_of_slope(pair: Pair) -> None:
    """Lemma 3.1."""
    (_, top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    found = trajectory_cc(top, bottom)
    assert steps(found) == steps(inverse(top), bottom)
    assert steps(found) == [(q[0] - p[0], q[1] - p[1]) for p, q in pairwise(found)]
    assert found[0] == plus(bottom[0], inverse(top)[0])
    assert found[-1] == plus(bottom[-1], inverse(top)[-1])


@given(own.pairs("CC"))
@usually
def test_outer_boundary_is_three_chains_in_order_of_slope(pair: Pair) -> None:
    """Lemma 3.2."""
    (g_bottom, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    found = sweep_outer_cc(g_top, g_bottom, bottom)
    assert steps(found) == steps(inverse(g_top), g_bottom, bottom)
    assert found[0] == plus(plus(bottom[0], inverse(g_top)[0]), g_bottom[0])
    path = Chain.of(trajectory_cc(g_top, bottom))
    assert found == list(cc.trajectory_cc(Chain.of(g_bottom), path))


@given(own.pairs("CC"))
@usually
def test_inner_boundary_is_the_directrix(pair: Pair) -> None:
    """Lemma 3.2."""
    (_, top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    assert sweep_inner_cc(top, bottom) == bottom


@given(own.pairs("CC"))
@usually
def test_merging_is_commutative_and_associative(pair: Pair) -> None:
    one, other = (Chain.of(split(polygon.vertices)[0]) for polygon in pair)
    assert list(cc.trajectory_cc(one, other)) == list(cc.trajectory_cc(other, one))
    together = list(cc.trajectory_cc(cc.trajectory_cc(one, other), one))
    assert together == list(cc.trajectory_cc(one, cc.trajectory_cc(other, one)))


@given(own.pairs("CC"), st.tuples(*[st.booleans()] * 4))
@usually
def test_a_sum_of_parts_has_only_their_relevant_edges(
    pair: Pair, cut: tuple[bool, bool, bool, bool]
) -> None:
    """At a cut end of one chain, edges of the other one beyond it are irrelevant."""
    one, other = (split(polygon.lattice()[1])[0] for polygon in pair)
    parts = []
    for (part,), left, right in zip(
        partition(Chain.of(one), Chain.of(other)), cut[::2], cut[1::2], strict=True
    ):
        least_slope = (part.edges[0][0],) if left else part.least_slope
        greatest_slope = (part.edges[-1][0], inf) if right else part.greatest_slope
        parts.append(part._replace(least_slope=least_slope, greatest_slope=greatest_slope))
    g, d = parts
    found = list(subtrajectory(g, d)) if g.faces(d) else []
    slopes = [[Fraction(y) / x for x, y in steps(chain)] for chain in (one, other)]
    ends = [s[k] for s in slopes for k in (0, -1)]
    low = max((e for e, c in zip(ends[::2], cut[::2], strict=True) if c), default=None)
    high = min((e for e, c in zip(ends[1::2], cut[1::2], strict=True) if c), default=None)
    kept = [
        (x, y)
        for x, y in steps(one, other)
        if (low is None or Fraction(y) / x >= low) and (high is None or Fraction(y) / x <= high)
    ]
    assert [(q[0] - p[0], q[1] - p[1]) for p, q in pairwise(found)] == kept
    assert not kept or set(found) <= set(cc.trajectory_cc(Chain.of(one), Chain.of(other)))


@given(own.pairs("CC"))
@usually
def test_pieces_carry_the_events_of_table_1(pair: Pair) -> None:
    """At both ends of a piece a vertex of D_b meets one of reversed G_t, and one or both move."""
    one, other = (split(polygon.lattice()[1])[0] for polygon in pair)
    (g,), (d,) = partition(Chain.of(one), Chain.of(other))
    swept = subtrajectory(g, d)
    for dx, dy, c, start, end in swept.pieces:
        for (x, y, w), i, j in (start, end):
            assert (x, y, w) == (*plus(one[j], other[i]), 1)
            assert y * dx == dy * x + c
        assert (end[1] - start[1], end[2] - start[2]) in ((0, 1), (1, 0), (1, 1))
    assert all(p[4] == q[3] for p, q in pairwise(swept.pieces))


@st.composite
def nearly_parallel(draw: st.DrawFn) -> list[Vertex]:
    """Convex chains of edges whose slopes lie close together."""
    vectors = draw(st.lists(st.tuples(st.integers(1, 40), st.integers(-1, 2)), min_size=1))
    slopes = {Fraction(dy, dx): (dx, dy) for dx, dy in vectors[:4]}
    x, y = 0, 0
    chain: list[Vertex] = [(0, 0)]
    for _, (dx, dy) in sorted(slopes.items()):
        x, y = x + dx, y + dy
        chain.append((x, y))
    return chain


@given(nearly_parallel(), nearly_parallel())
@example([(0, 0), (1, 0)], [(0, 0), (1, -1), (41, 0)])
@usually
def test_arbitrarily_close_slopes_are_distinguished(one: list[Vertex], other: list[Vertex]) -> None:
    merged = trajectory_cc(inverse(one), other)
    assert steps(merged) == steps(one, other)
    assert list(trajectory_cm(inverse(one), other)) == merged
    assert list(trajectory_mm(inverse(one), other)) == merged


def test_slopes_of_ints_over_fractions_are_distinguished() -> None:
    """Scaled to a greatest width of 1, both nonzero slopes would be rounded."""
    one: list[Vertex] = [(0, 0), (1, 0)]
    other: list[Vertex] = [(0, 0), (1, Fraction(-1, 9)), (2, Fraction(-1, 9) + Fraction(1, 50))]
    merged = trajectory_cc(inverse(one), other)
    assert steps(merged) == steps(one, other)
    assert list(trajectory_mm(inverse(one), other)) == merged
