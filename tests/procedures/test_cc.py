"""The CC procedures on chains: Lemmas 3.1 and 3.2."""

from fractions import Fraction
from itertools import pairwise
from math import inf

import pytest
import strategies as own
from hypothesis import example, given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.numbers.number import Rational, Vertex
from exactsweep.procedures.cc import merge_by_slope, sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import ChainError, inverse, split
from exactsweep.procedures.cm import trajectory_cm
from exactsweep.procedures.convex_part import ConvexPart, CrossingPart, measure_unit, take_whole
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.mm import trajectory_mm

Pair = tuple[Polygon, Polygon]
usually = examples(100)


def steps(*chains: list[Vertex]) -> list[Vertex]:
    """The edges as vectors, by slope, parallel ones added up."""
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
    assert found == merge_by_slope(g_bottom, trajectory_cc(g_top, bottom))


@given(own.pairs("CC"))
@usually
def test_inner_boundary_is_the_directrix(pair: Pair) -> None:
    """Lemma 3.2."""
    (_, top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    assert sweep_inner_cc(top, bottom) == bottom


@given(own.pairs("CC"))
@usually
def test_merging_is_commutative_and_inverse_to_nothing(pair: Pair) -> None:
    one, other = (split(polygon.vertices)[0] for polygon in pair)
    assert merge_by_slope(one, other) == merge_by_slope(other, one)
    assert merge_by_slope(one, [(0, 0)]) == one
    assert merge_by_slope([(1, 2)], one) == [plus(v, (1, 2)) for v in one]


def take_with_ends(
    chain: list[Vertex], unit: Rational | None, turns_left: bool, turns_right: bool
) -> ConvexPart:
    """A convex chain, at whose ends the other polygon has to turn, or not."""
    part = take_whole(chain, unit)
    return part._replace(
        flattest=-inf if turns_left else part.slopes[0],
        steepest=inf if turns_right else part.slopes[-1],
    )


@given(own.pairs("CC"), st.tuples(*[st.booleans()] * 4))
@usually
def test_a_cut_end_leaves_out_the_other_chains_edges_beyond_it(
    pair: Pair, cut: tuple[bool, bool, bool, bool]
) -> None:
    one, other = (split(polygon.vertices)[0] for polygon in pair)
    unit = measure_unit(one, other)
    first, second = (
        take_with_ends(chain, unit, not left, not right)
        for chain, left, right in ((one, *cut[:2]), (other, *cut[2:]))
    )
    swept = second.sweep(first, 0)
    found = list(swept) if swept else []
    slopes = [[y / x for x, y in steps(chain)] for chain in (one, other)]
    ends = [s[k] for s in slopes for k in (0, -1)]
    low = max((e for e, c in zip(ends[::2], cut[::2], strict=True) if c), default=None)
    high = min((e for e, c in zip(ends[1::2], cut[1::2], strict=True) if c), default=None)
    kept = [
        (x, y)
        for x, y in steps(one, other)
        if (low is None or y / x >= low) and (high is None or y / x <= high)
    ]
    assert [(q[0] - p[0], q[1] - p[1]) for p, q in pairwise(found)] == kept
    assert not kept or set(found) <= set(merge_by_slope(one, other))


@given(own.pairs("CC"), st.tuples(*[st.booleans()] * 4))
@usually
def test_a_part_known_by_its_lines_is_swept_as_one_on_the_lattice(
    pair: Pair, turns: tuple[bool, bool, bool, bool]
) -> None:
    one, other = (split(polygon.vertices)[0] for polygon in pair)
    unit = measure_unit(one, other)
    chain, part = (
        take_with_ends(points, unit, left, right)
        for points, left, right in ((one, *turns[:2]), (other, *turns[2:]))
    )
    whole = Envelope.of(other)
    same = CrossingPart(whole.pieces, whole.breaks, part.flattest, part.steepest, part.slopes)
    found, again = part.sweep(chain, 0), same.sweep(chain, 0)
    assert (found is None) == (again is None)
    if found and again:
        assert len(found.pieces) == len(again.pieces)
        assert list(found) == list(again)


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
def test_slopes_however_close_are_told_apart(one: list[Vertex], other: list[Vertex]) -> None:
    """By products here, by ints in a unit there, of chains and of an envelope's edges."""
    merged = trajectory_cc(inverse(one), other)
    assert list(trajectory_cm(inverse(one), other)) == merged
    assert list(trajectory_mm(inverse(one), Envelope.of(other))) == merged


def test_slopes_of_ints_over_fractions_are_told_apart() -> None:
    """In units of the greatest width, 1, both slopes that are not 0 would be rounded to others."""
    one: list[Vertex] = [(0, 0), (1, 0)]
    other: list[Vertex] = [(0, 0), (1, Fraction(-1, 9)), (2, Fraction(-1, 9) + Fraction(1, 50))]
    merged = trajectory_cc(inverse(one), other)
    assert list(trajectory_mm(inverse(one), other)) == merged
    assert list(trajectory_mm(inverse(one), Envelope.of(other))) == merged


def test_a_chain_that_is_not_convex_is_refused() -> None:
    with pytest.raises(ChainError, match="convex"):
        take_whole([(0, 0), (1, 2), (2, 0)], 4)
