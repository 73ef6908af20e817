"""Sums of monotone loops that are held by a loop, and what such a loop is."""

import random
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise, product
from typing import Any

import pytest
from hypothesis import example, given
from hypothesis import strategies as st
from producer import Vertices, edges, find_meetings
from small_pairs import convex
from strategies import Ring, monotone_rings
from tiers import examples

from exactsweep import Point, Polygon
from exactsweep.check import point_in_polygon, reference_loops, sums
from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import walk_heights
from exactsweep.check.loop import MonotoneLoop, NodeFrame
from exactsweep.check.sums import check_sum_within, corners_with_common_slopes, count_steps
from exactsweep.geometry.direction import is_monotone

FRAME = NodeFrame((1, 0), 1)


def _loop(vertices: Vertices) -> MonotoneLoop:
    return MonotoneLoop(FRAME.enter(vertices, Point(Fraction(0), Fraction(0))), "loop", FRAME)


def test_sums_of_convex_loops_are_within_if_those_with_common_slopes_are() -> None:
    """All sums of corners against those that the lemma asks for: far fewer."""
    rng, frame, origin = random.Random(4), NodeFrame((1, 0), 1), Point(Fraction(0), Fraction(0))
    counts = {True: 0, False: 0}
    for _ in range(1000):
        k, dx, dy = rng.choice([1, 1, 2, 3, 4]), rng.randint(-4, 3), rng.randint(-4, 3)
        around, first, second = (Polygon(convex(rng)[0]) for _ in range(3))
        around = Polygon([(k * x + dx, k * y + dy) for x, y in around.vertices])
        loops = [
            MonotoneLoop(frame.enter(p.vertices, origin), "", frame)
            for p in (around, first, second)
        ]
        for chain, a, b in zip(*(loop.halves for loop in loops), strict=True):
            (a_run,), (b_run,) = a.runs, b.runs
            every, some = (
                all(
                    chain.holds((px + qx, py + qy, 1))
                    for (_, (px, py, _), *_), (_, (qx, qy, _), *_) in sums
                )
                for sums in (product(a_run, b_run), corners_with_common_slopes(a, b))
            )
            assert every == some
            counts[every] += 1
            assert len([*corners_with_common_slopes(a, b)]) < len(a_run) + len(b_run)
    assert min(counts.values()) > 100


@examples(80)
@given(monotone_rings(), monotone_rings())
def test_convex_corners_of_a_sum_are_sums_of_corners_with_common_slopes(
    first: Ring, second: Ring
) -> None:
    a, b = Polygon(first), Polygon(second)
    true = reference_loops(b.reflected(), a).trajectory
    halves = (_loop(vertices).halves for vertices in (a.vertices, b.vertices, true))
    for of_a, of_b, of_sum in zip(*halves, strict=True):
        sums = {
            (px + qx, py + qy)
            for (_, (px, py, _), *_), (_, (qx, qy, _), *_) in corners_with_common_slopes(of_a, of_b)
        }
        assert {node[:2] for run in of_sum.runs for _, node, _, _ in run} <= sums


@examples(80)
@given(st.data())
def test_sum_within_agrees_with_the_definition(data: st.DataObject) -> None:
    """The lemma: of Q, which is A + B with a vertex moved, dropped, or a notch cut in."""
    a, b = (Polygon(data.draw(monotone_rings())) for _ in range(2))
    true = reference_loops(b.reflected(), a).trajectory
    changed = list(true)
    for _ in range(data.draw(st.integers(0, 2))):
        k = data.draw(st.integers(0, len(changed) - 1))
        x, y = changed[k]
        by = Fraction(data.draw(st.integers(-3, 3)), 2)
        there = changed[(k + 1) % len(changed)]
        middle = (x + there.x) / 2, (y + there.y) / 2
        changed[k : k + 1] = data.draw(
            st.sampled_from(
                [
                    [Point(x + by, y)],
                    [Point(x, y + by)],
                    [Point(x, y), Point(middle[0], middle[1] + by)],
                    [Point(x, y), Point(*middle), Point(middle[0], middle[1] + by)],
                    [],
                ]
            )
        )
    try:
        q = Polygon(changed)
        loops = [_loop(p.vertices) for p in (q, a, b)]
    except ValueError:
        return
    if _holds(q, true):
        check_sum_within(loops[0], loops[1], loops[2], FRAME, "outside", "inside")
        return
    with pytest.raises(CertificateError) as found:
        check_sum_within(loops[0], loops[1], loops[2], FRAME, "outside", "inside")
    witness = found.value.witness
    assert witness is not None
    where = point_in_polygon(witness, q), point_in_polygon(witness, true)
    assert where == (0, 1) if str(found.value) == "inside" else where[0] == -1 <= where[1]


def test_witness_beside_a_corner_on_a_wall_of_the_sum() -> None:
    """At x = 2 the sum drops from 4 to 0; a corner of Q on that wall is not inside the sum."""
    a = Polygon([(0, 4), (1, 4), (1, 0), (2, 8), (2, 20), (0, 20)])
    q = Polygon([(0, 0), (2, 0), (2, 3), (4, 3), (4, 40), (0, 40)])
    outer, part = _loop(q.vertices), _loop(a.vertices)
    with pytest.raises(CertificateError, match="inside 2") as found:
        check_sum_within(outer, part, part, FRAME, "outside {} {}", "inside {}")
    # It has to be nearer than 3/8, on the edge of length 2: not its half, nor its quarter.
    assert found.value.witness == Point(2 + Fraction(2, 16), Fraction(3))


def test_witness_half_way_along_an_edge() -> None:
    """Right of x = 2 the sum rises from 0 with slope 1, below the edge of length 2 at y = 3."""
    a = Polygon([(0, 4), (1, 4), (1, 0), (3, 2), (3, 20), (0, 20)])
    q = Polygon([(0, 0), (2, 0), (2, 3), (4, 3), (4, -9), (7, -9), (7, 40), (0, 40)])
    with pytest.raises(CertificateError, match="inside 2") as found:
        check_sum_within(
            _loop(q.vertices),
            *(_loop(a.vertices),) * 2,
            FRAME,
            "outside {} {}",
            "inside {}",
        )
    assert found.value.witness == Point(Fraction(3), Fraction(3))


def test_witness_beside_a_corner_from_above() -> None:
    """The last one turned by half a turn: at the upper chains."""
    a = Polygon([(0, -4), (-1, -4), (-1, 0), (-2, -8), (-2, -20), (0, -20)])
    q = Polygon([(0, 0), (-2, 0), (-2, -3), (-4, -3), (-4, -40), (0, -40)])
    outer, part = _loop(q.vertices), _loop(a.vertices)
    with pytest.raises(CertificateError, match="inside") as found:
        check_sum_within(outer, part, part, FRAME, "outside {} {}", "inside {}")
    assert found.value.witness == Point(-2 - Fraction(2, 16), Fraction(-3))


def test_witness_beside_a_corner_on_a_wall_on_the_other_side() -> None:
    """The last one in the mirror."""
    a = Polygon([(0, 4), (-1, 4), (-1, 0), (-2, 8), (-2, 20), (0, 20)])
    q = Polygon([(0, 0), (-2, 0), (-2, 3), (-4, 3), (-4, 40), (0, 40)])
    outer, part = _loop(q.vertices), _loop(a.vertices)
    with pytest.raises(CertificateError, match="inside 1") as found:
        check_sum_within(outer, part, part, FRAME, "outside {} {}", "inside {}")
    assert found.value.witness == Point(-2 - Fraction(2, 16), Fraction(3))


def test_few_edges_are_walked_along_at_each_corner() -> None:
    """At each of some hundred corners a triangle is over few edges of a comb of 200."""
    comb = Polygon([*((k, k % 2) for k in range(201)), (200, 9), (0, 9)])
    part = Polygon([(0, 0), (2, 1), (0, 1)])
    outer = Polygon(reference_loops(part.reflected(), comb).trajectory)
    steps = count_steps(_loop(outer.vertices), _loop(comb.vertices), _loop(part.vertices))
    # Below, 101 runs of one corner with 2 corners, and one run with 101; above, 2 and 2. At 100
    # concave corners one edge of the triangle, and 2 of the comb, but for one at the end.
    assert steps == 202 + 101 + 4 + 100 + 199


@pytest.mark.parametrize("by", [1, 5, -3])
def test_edges_over_a_part_count_wherever_it_is(by: int) -> None:
    """A part of two edges below and above, 5 wide: of the comb, the edges that end under it."""
    comb = Polygon([*((k, k % 2) for k in range(21)), (20, 9), (0, 9)])
    part = Polygon([(by, 0), (by + 1, -4), (by + 5, 0), (by + 1, 1)])
    outer = Polygon([*((k, k % 2) for k in range(by - 1, by + 26)), (by + 25, 30), (by - 1, 30)])
    loops = [_loop(p.vertices) for p in (outer, comb, part)]
    # Below, 11 runs of one corner with one of three, above one of two with one of three.
    runs = 11 * 3 + 11 + 2 + 3
    concave = [x for x, y in outer.vertices[1:] if y == 1]
    under = [sum(x - by - 5 <= end < x - by for end in range(1, 21)) for x in concave]
    assert count_steps(*loops) == runs + sum(under) + 2 * len(concave)


def test_a_witness_very_near_to_a_corner_is_found_in_few_steps(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Right of x = 2 the sum is below 3 for 10**-3000 at most: 10,000 halvings, or few of these."""
    thin = Fraction(1, 10**3000)
    a = Polygon([(0, 4), (1, 4), (1, 0), (1 + thin, 8), (2, 8), (2, 20), (0, 20)])
    q = Polygon([(0, 0), (2, 0), (2, 3), (4, 3), (4, 40), (0, 40)])
    scale = 10**3000
    frame = NodeFrame((1, 0), scale)
    outer, part = (
        MonotoneLoop(frame.enter(p.vertices, Point(Fraction(0), Fraction(0))), "loop", frame)
        for p in (q, a)
    )
    walks = 0

    def count(*arguments: Any) -> Iterator[tuple[int, int]]:
        nonlocal walks
        walks += 1
        return walk_heights(*arguments)

    monkeypatch.setattr(sums, "walk_heights", count)
    with pytest.raises(CertificateError, match="inside 2") as found:
        check_sum_within(outer, part, part, frame, "outside {} {}", "inside {}")
    witness = found.value.witness
    assert witness is not None
    assert 2 < witness.x < 2 + thin
    assert witness.y == 3
    assert walks < 30


@examples(80)
@given(monotone_rings(), monotone_rings())
def test_least_height_is_the_limit_of_the_sum(first: Ring, second: Ring) -> None:
    a, b = Polygon(first), Polygon(second)
    true = reference_loops(b.reflected(), a).trajectory
    halves = (_loop(vertices).halves for vertices in (a.vertices, b.vertices, true))
    for of_a, of_b, of_sum in zip(*halves, strict=True):
        for left, right, _ in of_sum.edges:
            for node, side in ((left, 1), (right, -1)):
                assert min(height for height, _ in walk_heights(of_a, of_b, node, side)) == 0


@examples(500)
@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=3, max_size=7))
@example([(0, 1), (2, 0), (0, 0), (1, 2)])
@example([(0, 0), (0, 1), (2, 0), (2, 1)])
@example([(0, 0), (2, 1), (2, 0), (0, 1)])
@example([(0, 0), (1, 3), (2, 0), (3, 2), (0, 2)])
@example([(0, 0), (1, 0), (1, 2), (2, 2), (2, 4), (1, 4), (1, 1), (0, 1)])
@example([(0, 2), (1, 2), (1, 0), (2, 0), (2, 1), (1, 1), (1, 4), (0, 4)])
@example([(2, 1), (1, 1), (1, 4), (0, 4), (0, 2), (1, 2), (1, 0), (2, 0)])
def test_loop_is_what_a_canonical_monotone_polygon_is(ring: list[tuple[int, int]]) -> None:
    start = ring.index(min(ring))
    vertices = tuple(Point(Fraction(x), Fraction(y)) for x, y in ring[start:] + ring[:start])
    try:
        polygon = Polygon(vertices)
        good = polygon.vertices == vertices and is_monotone(polygon, (1, 0))
    except ValueError:
        good = False
    if good:
        assert _loop(vertices).nodes == [(*map(int, vertex), 1) for vertex in vertices]
    else:
        with pytest.raises(CertificateError):
            _loop(vertices)


def _holds(q: Polygon, loop: Vertices) -> bool:
    """Decide whether a loop is in Q: its vertices, the points where it meets edges of Q, and a
    point of each part between.
    """
    for edge in edges(loop):
        stops = {*edge, *(m for other in edges(q.vertices) for m in find_meetings(edge, other))}
        parts = [((a.x + b.x) / 2, (a.y + b.y) / 2) for a, b in pairwise(sorted(stops))]
        if any(point_in_polygon(p, q) < 0 for p in [*stops, *parts]):
            return False
    return True


@pytest.mark.parametrize(
    ("ring", "reason"),
    [
        ([(0, 0), (1, 0), (1, 0), (0, 1)], "loop: not canonical, the next vertex repeats vertex 1"),
        (
            [(0, 0), (1, 0), (3, 0), (0, 1)],
            "loop: not canonical, the boundary does not turn",
        ),
        ([(0, 0), (3, 0), (1, 1), (3, 2), (2, 1)], "loop: not monotone to the direction, it turns"),
    ],
)
def test_what_is_no_monotone_loop_is_named(ring: list[tuple[int, int]], reason: str) -> None:
    with pytest.raises(CertificateError) as found:
        _loop(tuple(Point(Fraction(x), Fraction(y)) for x, y in ring))
    assert found.value.args[0].startswith(reason)


@pytest.mark.parametrize("side", [-1, 0, 1])
def test_beside_a_sum_there_are_no_heights(side: int) -> None:
    comb = Polygon([*((k, k % 2) for k in range(9)), (8, 9), (0, 9)])
    part = Polygon([(0, 0), (2, 1), (0, 1)])
    for a, b in product(_loop(comb.vertices).halves, _loop(part.vertices).halves):
        for x in (-100, 100):
            assert list(walk_heights(a, b, (x, 0, 1), side)) == []
