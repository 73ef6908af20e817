"""Chains: the operators of the paper, convex parts, and splitting a polygon."""

import re
from fractions import Fraction
from itertools import pairwise, product
from typing import Any

import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Vertex
from exactsweep.paper.kernel import (
    find_convex_parts,
    require_convex,
    sweep_inner_cm,
    sweep_mm,
    sweep_outer_cm,
    trajectory_cm,
    trajectory_mm,
)
from exactsweep.procedures import chain as kernel
from exactsweep.procedures.chain import Chain, ChainError, complement, inverse, split, take_corners
from exactsweep.procedures.exact_fit import list_edges

usually = examples(100)

steps = st.lists(st.tuples(own.tiny(0, 2), own.tiny(-2, 2)), min_size=1, max_size=9)


@st.composite
def chains(draw: st.DrawFn) -> list[Vertex]:
    """Chains from left to right with walls, collinear runs and repeated points."""
    x, y = 0, 0
    chain: list[Vertex] = [(0, 0)]
    for dx, dy in draw(steps):
        x, y = x + dx, y + dy
        chain.append((x, y))
    return [*chain, (x + 1, y)]


def turn(p: Vertex, q: Vertex, r: Vertex) -> Any:
    return (q[0] - p[0]) * (r[1] - q[1]) - (q[1] - p[1]) * (r[0] - q[0])


@given(chains())
@usually
def test_inverse_and_complement_are_involutions(chain: list[Vertex]) -> None:
    assert inverse(inverse(chain)) == chain
    assert complement(complement(chain)) == chain
    assert inverse(complement(chain)) == complement(inverse(chain))


@given(st.integers(1, 40), st.data())
@usually
def test_slopes_are_in_order_in_the_unit_of_a_chain(width: int, data: st.DataObject) -> None:
    """Slopes of two edges as wide as the chain can differ by 1 / width squared."""
    vectors = st.tuples(st.integers(1, width), st.integers(-3 * width, 3 * width))
    edges = data.draw(st.lists(vectors, min_size=2, max_size=9))
    exact = [Fraction(dy, dx) for dx, dy in edges]
    drawn = [Chain.of([(0, 0), edge]) for edge in edges]
    for a, b in product(range(len(edges)), repeat=2):
        parts = kernel.partition(drawn[a], drawn[b])
        one, other = (part.edges[0][0] for (part,) in parts)
        assert (one < other) == (exact[a] < exact[b])


@given(chains(), st.sampled_from([1, 3, Fraction(7, 3)]))
@usually
def test_parts_do_not_depend_on_the_number_type(chain: list[Vertex], scale: int) -> None:
    scaled: list[Vertex] = [(x * scale, y * scale) for x, y in chain]
    parts = [[(x * scale, y * scale) for x, y in part] for part in find_convex_parts(chain)]
    assert find_convex_parts(scaled) == parts


@given(chains())
@usually
def test_two_half_turns_are_the_identity(points: list[Vertex]) -> None:
    chain = Chain.of(points)
    assert chain.half_turn().points == inverse(complement(chain.points))
    again = chain.half_turn().half_turn()
    assert (again.vertices, again.lines) == (chain.vertices, chain.lines)
    assert Chain(chain.vertices).lines == chain.lines


@given(chains())
@usually
def test_convex_parts_are_convex_and_lie_on_the_chain(chain: list[Vertex]) -> None:
    parts = find_convex_parts(chain)
    for part in parts:
        assert len(part) > 1
        assert all(p[0] < q[0] for p, q in pairwise(part))
        assert all(turn(*part[k : k + 3]) >= 0 for k in range(len(part) - 2))
    walls = {p[0] for p, q in pairwise(chain) if p[0] == q[0] and p != q}
    for before, after in pairwise(parts):
        assert before[-1][0] == after[0][0]
        if after[0][0] not in walls:
            assert before[-1] == after[0]
            assert turn(before[-2], after[0], after[1]) < 0
    covered = {edge for part in parts for edge in pairwise(part)}
    for p, q in list_edges(chain):
        assert any(turn(*e, p) == 0 == turn(*e, q) and e[0][0] <= p[0] < e[1][0] for e in covered)


@given(chains())
@usually
def test_corners_are_the_chain_without_straight_points(chain: list[Vertex]) -> None:
    # A monotone chain: vertical edges only upwards.
    chain = [v for k, v in enumerate(chain) if k == 0 or v[0] > chain[k - 1][0]]
    kept = [(x, y) for x, y, _ in take_corners((x, y, 1) for x, y in chain)]
    assert (kept[0], kept[-1]) == (chain[0], chain[-1])
    assert set(kept) <= set(chain)
    assert all(turn(*kept[k : k + 3]) != 0 for k in range(len(kept) - 2))
    for v in set(chain) - set(kept):
        assert any(p[0] <= v[0] <= q[0] and turn(p, v, q) == 0 for p, q in pairwise(kept))


@given(own.monotone_polygons() | own.convex_polygons())
@usually
def test_split_returns_the_boundary_except_for_vertical_ends(polygon: Polygon) -> None:
    v = polygon.vertices
    bottom, top = split(v)
    left, right = min(x for x, _ in v), max(x for x, _ in v)
    assert all(p[0] <= q[0] for p, q in pairwise(bottom))
    assert all(p[0] >= q[0] for p, q in pairwise(top))
    assert bottom[0][0] == top[-1][0] == left
    assert bottom[-1][0] == top[0][0] == right
    found = {*pairwise(bottom), *pairwise(top)}
    whole = set(zip(v, (*v[1:], v[0]), strict=True))
    assert found <= whole
    assert all(p[0] == q[0] in (left, right) for p, q in whole - found)


@pytest.mark.parametrize("first", [0, Fraction(1, 3)])
def test_repeated_points_change_no_result(first: Any) -> None:
    """In a former version, a doubled convex vertex counted as a reflex one."""
    vertex = (1, -1)
    top: list[Vertex] = [(1, 0), (0, 0)]
    doubled: list[Vertex] = [(0, first), vertex, vertex, (2, first), (2, first)]
    plain: list[Vertex] = [(0, first), vertex, (2, first)]
    assert list(trajectory_cm(top, doubled)) == list(trajectory_cm(top, plain))
    assert list(trajectory_mm(top, doubled)) == list(trajectory_mm(top, plain))
    assert sweep_inner_cm(top, doubled) == sweep_inner_cm(top, plain)
    bottom: list[Vertex] = [(0, -1), (1, -1)]
    outer = [list(sweep_outer_cm(top, bottom, chain)) for chain in (doubled, plain)]
    assert outer[0] == outer[1]
    assert sweep_mm(top, bottom, doubled) == sweep_mm(top, bottom, plain)


def test_chains_that_reverse_are_rejected() -> None:
    message = r"\(1, 1\) lies left of \(2, 0\): not an X-monotone chain"
    back: list[Vertex] = [(0, 0), (2, 0), (1, 1), (3, 1)]
    top: list[Vertex] = [(1, 0), (0, 0)]
    for procedure in trajectory_cm, trajectory_mm, sweep_inner_cm:
        with pytest.raises(ChainError, match=message):
            procedure(top, back)
    with pytest.raises(ChainError, match=message):
        find_convex_parts(back)
    assert issubclass(ChainError, ValueError)


def test_polygons_that_are_not_monotone_have_no_chains() -> None:
    _, top = split([(0, 0), (3, 0), (3, 3), (0, 3), (2, 1)])
    with pytest.raises(ChainError, match="not an X-monotone chain"):
        Chain.of(inverse(top))


@pytest.mark.parametrize(
    ("chain", "place"),
    [
        ([(0, 0), (1, 2), (4, 1), (5, 5)], r"\(1, 2\)"),
        ([(0, 0), (2, 0), (2, 3), (5, 3)], r"\(2, 3\)"),
        ([(0, 5), (2, 0), (3, 2), (5, 1), (7, 0)], r"\(3, 2\)"),
    ],
)
def test_a_chain_of_two_parts_is_rejected_at_the_start_of_the_second(
    chain: list[Vertex], place: str
) -> None:
    with pytest.raises(ExactSweepError, match=f"at {place}$"):
        require_convex(chain)


@pytest.mark.parametrize("chain", [[], [(0, 0)], [(0, 0), (0, 1)]])
def test_chains_of_zero_width_are_rejected(chain: list[Vertex]) -> None:
    with pytest.raises(ChainError):
        find_convex_parts(chain)
    for procedure in trajectory_cm, trajectory_mm, sweep_inner_cm:
        with pytest.raises(ChainError):
            procedure([(1, 0), (0, 0)], chain)


def test_the_first_point_to_the_left_is_named() -> None:
    for chain, k in ([(1, 0), (0, 0), (-1, 0)], 1), ([(0, 0), (1, 0), (1, 5), (0, 0)], 3):
        message = re.escape(f"{chain[k]} lies left of {chain[k - 1]}")
        with pytest.raises(ChainError, match=message):
            find_convex_parts(chain)
