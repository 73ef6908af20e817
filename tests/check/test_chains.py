"""Frames, lower chains, and the heights of one chain over another: against what they mean."""

from fractions import Fraction
from itertools import groupby, pairwise

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from exactsweep import Point
from exactsweep.check.chain import (
    LowerChain,
    Node,
    add_nodes,
    put_longer_first,
    turn,
    walk_heights,
)
from exactsweep.check.loop import MonotoneLoop, NodeFrame, line_through
from exactsweep.check.sums import corners_with_common_slopes
from exactsweep.numbers.point import ORIGIN

Steps = list[tuple[int, int]]

# A fall at 1, a rise at 3, and a corner at 2.
CORNERS = [(0, 0, 1), (1, 2, 1), (1, 1, 1), (2, 0, 1), (3, 0, 1), (3, 2, 1), (4, 2, 1)]


def _chain(nodes: list[Node]) -> LowerChain:
    lines = [line_through(p, q) for p, q in pairwise(nodes)]
    return LowerChain(list(enumerate(nodes)), lines)


def test_nodes_of_a_frame_are_in_lowest_terms() -> None:
    """Along (2, 1), in sixths: the point (1/2, 1/3) is (3, 2), whose products with (2, 1) and
    (-1, 2) are 8 and 1."""
    frame = NodeFrame((2, 1), 6)
    half = Point(Fraction(1, 2), Fraction(1, 3))
    assert frame.enter([half], ORIGIN) == [(8, 1, 1)]
    assert frame.enter([half, half], Point(Fraction(1, 2), Fraction(0))) == [(2, 4, 1)] * 2
    assert frame.enter([Point(Fraction(1, 2), Fraction(1, 2))], ORIGIN) == [(9, 3, 1)]
    assert frame.enter([Point(Fraction(1, 12), Fraction(1, 8))], ORIGIN) == [(7, 4, 4)]
    assert frame.enter([Point(Fraction(1), Fraction(1, 12))], ORIGIN) == [(25, -10, 2)]
    assert frame.unit_area == 5 * 36


@pytest.mark.parametrize("direction", [(1, 0), (0, 1), (2, 3), (3, -2), (1, -5)])
def test_what_leaves_a_frame_is_what_entered_it(direction: tuple[int, int]) -> None:
    frame = NodeFrame(direction, 6)
    points = [Point(Fraction(k, 7), Fraction(5, k + 2)) for k in range(5)]
    assert [*map(frame.leave, frame.enter(points, ORIGIN))] == points


def test_a_chain_knows_its_edges_and_corners() -> None:
    chain = _chain(CORNERS)
    lines = [line_through(p, q) for p, q in pairwise(CORNERS)]
    assert [edge[:2] for edge in chain.edges] == [
        (CORNERS[k], CORNERS[k + 1]) for k in (0, 2, 3, 5)
    ]
    assert chain.jumps == 2
    down, up = (1, 0, 0), (-1, 0, 0)
    assert chain.runs == [
        [(0, CORNERS[0], down, lines[0])],
        [(k, CORNERS[k], lines[k - 1], lines[k]) for k in (2, 3, 4)],
        [(6, CORNERS[6], lines[5], up)],
    ]
    assert chain.concave == [(1, CORNERS[1], -1, CORNERS[0]), (5, CORNERS[5], 1, CORNERS[6])]


def test_the_first_edge_that_reaches_a_place() -> None:
    """Ends at 1/3, 2/3, 1, 1, and 5/2; of two that end at one place there is none in a chain."""
    xs = [Fraction(n, 6) for n in (0, 2, 4, 6, 15)]
    nodes = [(x.numerator, k * k * x.denominator, x.denominator) for k, x in enumerate(xs)]
    chain = _chain(nodes)
    for n in range(-2, 20):
        assert chain.first_reaching(n, 6) == sum(6 * x < n for x in xs[1:])


def test_points_on_a_chain_or_above_it() -> None:
    chain = _chain(CORNERS)
    for half, y in enumerate((0, 1, 1, 0.5, 0, 0, 0, 2, 2)):
        n, w = y.as_integer_ratio()
        assert chain.holds((half * w, 2 * n, 2 * w))
        assert not chain.holds((half * w * 9, 2 * n * 9 - 1, 2 * w * 9))
    assert not chain.holds((-1, 99, 1))
    assert not chain.holds((9, 99, 2))


def test_sums_of_nodes_are_sums_of_points() -> None:
    for one in ((1, 2, 1), (3, -1, 2), (1, 1, 3)):
        for other in ((2, 5, 1), (1, 4, 2), (-3, 7, 2), (1, 2, 5)):
            x, y, w = add_nodes(one, other)
            for c, p, q in ((x, one[0], other[0]), (y, one[1], other[1])):
                assert Fraction(c, w) == Fraction(p, one[2]) + Fraction(q, other[2])


def test_chains_of_equally_many_edges_stay_as_they_are() -> None:
    one, other, short = _chain(CORNERS), _chain(CORNERS), _chain(CORNERS[:4])
    assert put_longer_first(one, other) == (one, other)
    assert put_longer_first(one, short) == put_longer_first(short, one) == (one, short)


def _take_steps(steps: Steps) -> list[Node]:
    """From the origin; (0, dy) is a jump, and no two of those follow each other."""
    x, y = 0, 0
    nodes = [(0, 0, 1)]
    for k, (dx, dy) in enumerate(steps):
        if dx == 0 and (dy == 0 or k == 0 or steps[k - 1][0] == 0 or k == len(steps) - 1):
            dx = 1
        x, y = x + dx, y + dy
        nodes.append((x, y, 1))
    return nodes


def _limits(nodes: list[Node], u: Fraction) -> tuple[Fraction | None, Fraction | None]:
    """The limits of a chain from the left and from the right, where it has them."""
    left = right = None
    for (x, y, _), (z, t, _) in pairwise(nodes):
        if x < z:
            value = y + (u - x) * (t - y) / (z - x)
            left = value if x < u <= z else left
            right = value if x <= u < z else right
    return left, right


def _list_heights(a: list[Node], b: list[Node], o: Node, side: int) -> list[Fraction]:
    """The limits that `walk_heights` is to give, by what it says of them, once each in a row."""
    x, y = Fraction(o[0], o[2]), Fraction(o[1], o[2])
    found = []
    for u in sorted({Fraction(p[0]) for p in a} | {x - p[0] for p in b}):
        (a_left, a_right), (b_left, b_right) = _limits(a, u), _limits(b, x - u)
        beside = {1: (a_right, b_right), -1: (a_left, b_left), 0: (None, None)}[side]
        for p, q in ((a_left, b_right), beside, (a_right, b_left)):
            if p is not None and q is not None:
                found.append(p + q - y)
    return [height for height, _ in groupby(found)]


_steps = st.lists(st.tuples(st.integers(0, 2), st.integers(-2, 2)), min_size=1, max_size=5)


@given(
    _steps,
    _steps,
    st.tuples(st.integers(-1, 16), st.integers(-3, 3), st.integers(1, 2)),
    st.sampled_from([-1, 0, 1]),
)
@example([(1, 0)], [(1, 0)], (0, 0, 1), 1)
@example([(1, 0)], [(1, 0)], (0, 0, 1), 0)
@example([(1, 0)], [(1, 0)], (2, 0, 1), -1)
@example([(1, 0)], [(1, 0)], (2, 0, 1), 0)
@example([(1, 0), (1, 1)], [(1, 0), (0, 1), (1, 0)], (2, 0, 1), 0)
@example([(1, 0), (1, 1), (1, 0)], [(1, 0), (0, -1), (1, 0)], (2, 0, 1), 0)
def test_heights_are_the_limits_of_a_sum(one: Steps, other: Steps, o: Node, side: int) -> None:
    """Pairs of limits: if both chains jump, two different intervals give one side only."""
    a, b = _take_steps(one), _take_steps(other)
    chains = _chain(a), _chain(b)
    found = [Fraction(*height) for height in walk_heights(*chains, o, side)]
    expected = _list_heights(a, b, o, side)
    if put_longer_first(*chains) != chains:
        expected = _list_heights(b, a, o, side)
    assert [height for height, _ in groupby(found)] == expected


@pytest.mark.parametrize(
    ("nodes", "convex"),
    [
        ([(0, 0), (1, 0), (0, 1)], True),
        ([(0, 0), (2, 0), (2, 1), (0, 1)], True),
        ([(0, 0), (2, 1), (4, 0), (4, 3), (0, 3)], False),
    ],
)
def test_a_loop_knows_whether_it_is_convex(nodes: Steps, convex: bool) -> None:
    loop = MonotoneLoop([(x, y, 1) for x, y in nodes], "loop", NodeFrame((1, 0), 1))
    assert loop.is_convex == convex
    turned = loop.turn_half()
    assert turned.halves == (loop.halves[1], loop.halves[0])
    assert turned.nodes == [(-x, -y, 1) for x, y in nodes]


def _slope(line: tuple[int, int, int], at_infinity: int) -> Fraction:
    """Steeper than any other where it is vertical, down before a corner and up after it."""
    return Fraction(-line[0], line[1]) if line[1] else Fraction(at_infinity * 10**9)


@given(_steps, _steps)
@example([(1, 0), (0, -1), (1, 0)], [(1, 0), (0, -2), (1, 0)])
@example([(1, 1), (0, -1), (1, 0)], [(1, 1), (0, -1), (1, 1), (0, 2), (1, 0)])
def test_corners_with_more_than_one_slope_in_common(one: Steps, other: Steps) -> None:
    """At a fall the slopes begin with minus infinity, and before a rise they end with infinity."""
    chains = [_chain(_without_straight(_take_steps(steps))) for steps in (one, other)]
    corners = [[corner for run in chain.runs for corner in run] for chain in chains]
    expected = {
        (a[0], b[0])
        for a in corners[0]
        for b in corners[1]
        if max(_slope(a[2], -1), _slope(b[2], -1)) < min(_slope(a[3], 1), _slope(b[3], 1))
    }
    assert {(a[0], b[0]) for a, b in corners_with_common_slopes(*chains)} == expected


def _without_straight(nodes: list[Node]) -> list[Node]:
    kept = nodes[:1]
    for p, q in pairwise(nodes[1:]):
        if turn(line_through(kept[-1], p), line_through(p, q)):
            kept.append(p)
    return [*kept, nodes[-1]]
