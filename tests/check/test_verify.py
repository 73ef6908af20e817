"""Certificates: true ones are proved, whoever wrote them, and false ones are not."""

import json
import random
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise, product
from typing import Any

import pytest
from families import random_pair
from hypothesis import example, given, settings
from hypothesis import strategies as st
from producer import (
    SLOT,
    UNIT,
    VALLEY,
    WIDE_SLOT,
    Vertices,
    certificate_of,
    edges,
    replace_trajectory,
)
from small_pairs import convex
from strategies import Kind, Ring, monotone_rings, pairs
from tampering import report, tamper

from exactsweep import Point, Polygon, sweep
from exactsweep.check import (
    classify,
    point_in_polygon,
    reference_loops,
    sums,
    verify,
)
from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import walk_heights
from exactsweep.check.loop import MonotoneLoop, NodeFrame
from exactsweep.check.sums import check_sum_within, corners_with_common_slopes
from exactsweep.geometry.direction import is_monotone


@pytest.mark.parametrize("kind", ["CC", "CM", "MM"])
@settings(max_examples=60)
@given(data=st.data())
def test_certificate_of_a_sweep_is_proved(kind: Kind, data: st.DataObject) -> None:
    generatrix, directrix = data.draw(pairs(kind))
    certificate = sweep(generatrix, directrix, reference=(3, "-1/7")).certificate()
    assert verify(json.loads(json.dumps(certificate))) == (True, "proved", None)


def test_certificate_is_proved_in_every_shared_direction() -> None:
    for number in range(150):
        pair = random_pair(random.Random(number))
        s = sweep(pair.generatrix, pair.directrix, direction=pair.direction)
        assert verify(s.certificate()) == (True, "proved", None), number


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


@settings(max_examples=80)
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


@settings(max_examples=25)
@given(pairs("CM") | pairs("MM"))
def test_certificate_from_the_definition_is_proved(pair: tuple[Polygon, Polygon]) -> None:
    """Its lists of drawings are complete; those of `sweep` may be shorter."""
    if len(pair[0]) * len(pair[1]) <= 100:
        certificate = certificate_of(*pair)
        assert verify(certificate) == (True, "proved", None)
        ours = sweep(*pair, direction=(1, 0)).certificate()
        assert ours.keys() == certificate.keys()
        for key in certificate.keys() - {"inner_drawn", "outer_drawn"}:
            assert ours[key] == certificate[key], key


def test_certificate_by_hand() -> None:
    square = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
    certificate = {
        "format": "exactsweep certificate",
        "version": 1,
        "generatrix": square,
        "directrix": square,
        "kind": "CC",
        "direction": [1, 0],
        "reference": ["0", "0"],
        "trajectory": [["-1", "-1"], ["1", "-1"], ["1", "1"], ["-1", "1"]],
        "inner": square,
        "outer": [["-1", "-1"], ["2", "-1"], ["2", "2"], ["-1", "2"]],
        "area": "8",
        "exact_fits": [],
        "contacts": [[["EE", 2, 0]], [["EE", 3, 1]], [["EE", 0, 2]], [["EE", 1, 3]]],
        "inner_drawn": [[[["edge", k], ["edge", (k + 2) % 4]]] for k in range(4)],
        "outer_drawn": [[[["edge", k], ["edge", k]]] for k in range(4)],
    }
    assert verify(certificate) == (True, "proved", None)


# --- False ones ----------------------------------------------------------------------------------


def test_tampering_is_caught() -> None:
    rng = random.Random(1)
    drawn = [random_pair(rng) for _ in range(50)]
    certificates = [sweep(pair.generatrix, pair.directrix).certificate() for pair in drawn]
    certificates.append(sweep(UNIT, SLOT).certificate())
    tried, missed = tamper(certificates, rng)
    print(report(tried, missed))
    assert missed == []
    assert len(tried) > 50


@settings(max_examples=60)
@given(st.integers(0, 10**6))
def test_false_trajectory_of_true_segments_is_refused(seed: int) -> None:
    """Any walk along sums of features has contacts all along; only the lowest one is right."""
    rng = random.Random(seed)
    g, d = (_zigzag(rng) for _ in range(2))
    true = reference_loops(g, d)
    lower = _walk_along_sums(rng, g, d)
    split = true.trajectory.index(max(true.trajectory))
    walked = Polygon([*lower, *true.trajectory[split + 1 :]]).vertices
    certificate = sweep(g, d, direction=(1, 0)).certificate()
    if walked != true.trajectory:
        replace_trajectory(certificate, g, d, walked)
    result = verify(certificate)
    assert result.proved == (walked == true.trajectory)
    if not result.proved and "G overlaps D" in result.reason:
        assert classify(d, g, result.witness or (0, 0)).verdict == "OVERLAP"
    if not result.proved and "is outside" in result.reason:
        assert point_in_polygon(result.witness or (0, 0), walked) == -1


def _zigzag(rng: random.Random) -> Polygon:
    """No vertical edges, and every edge steeper or flatter than any other, nearly always."""
    xs = sorted(rng.sample(range(1, 100), 4))
    bottom, top = (
        [(x, sign * rng.randint(1, 100)) for x in rng.sample(xs, rng.randint(1, 3))]
        for sign in (-1, 1)
    )
    return Polygon([(0, 0), *sorted(bottom), (100, rng.randint(0, 1)), *sorted(top)[::-1]])


def _walk_along_sums(rng: random.Random, g: Polygon, d: Polygon) -> list[Point]:
    """From the left end of D + I(G) to its right end, turning at random where segments meet."""
    bottom, inverse = (_bottom(polygon.vertices) for polygon in (d, g.reflected()))
    segments = [
        (Point(p.x + w.x, p.y + w.y), Point(q.x + w.x, q.y + w.y))
        for chain, other in ((bottom, inverse), (inverse, bottom))
        for p, q in pairwise(chain)
        for w in other
    ]
    walk = [Point(bottom[0].x + inverse[0].x, bottom[0].y + inverse[0].y)]
    while onward := [s for s in segments if s[0].x <= walk[-1].x < s[1].x and _on(walk[-1], s)]:
        here = rng.choice(onward)
        meetings = [here[1], *(m for s in segments for m in _meeting(here, s))]
        walk.append(min(m for m in meetings if m.x > walk[-1].x))
    return walk


def _bottom(loop: Vertices) -> Vertices:
    """The loop has no vertical edge at either end."""
    return loop[: loop.index(max(loop)) + 1]


def _on(p: Point, segment: Vertices) -> bool:
    (ax, ay), (bx, by) = segment
    return (bx - ax) * (p.y - ay) == (by - ay) * (p.x - ax)


def _meeting(one: Vertices, other: Vertices) -> Iterator[Point]:
    """The point in which two edges meet that are not parallel."""
    (ax, ay), (bx, by) = one
    (cx, cy), (dx, dy) = other
    det = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
    if det:
        share = ((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx)) / det
        meeting = Point(ax + share * (bx - ax), ay + share * (by - ay))
        if all(min(edge) <= meeting <= max(edge) for edge in (one, other)):
            yield meeting


def test_edge_without_contact_is_refused() -> None:
    """The valley filled up: nothing touches along the new edge, and none is said to."""
    g, d = Polygon(UNIT), Polygon(VALLEY)
    certificate = sweep(g, d).certificate()
    filled = Polygon([(-1, -1), (4, -1), (4, 3), (-1, 3)]).vertices
    replace_trajectory(certificate, g, d, filled)
    assert verify(certificate) == (
        False,
        "contacts[2]: nothing that is listed draws all of the edge",
        Point(Fraction(3, 2), Fraction(3)),
    )


def test_drawing_beside_its_edge_is_refused() -> None:
    """Both walls of the slot end at one height; what draws one top does not draw the other."""
    certificate = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], WIDE_SLOT).certificate()
    tops = [k for k, (_, y) in enumerate(certificate["inner"]) if y == "3"]
    one, other = (certificate["inner_drawn"][k] for k in tops[::2])
    other.append(one[0])
    result = verify(certificate)
    assert result.reason.startswith(f"inner_drawn[{tops[2]}]: generatrix")
    assert result.reason.endswith("draws no part of the edge")


def test_loop_drawn_inside_the_swept_area_is_not_the_outer_one() -> None:
    """The path of one vertex of G is drawn all along, but other vertices pass outside."""
    certificate = sweep(UNIT, VALLEY).certificate()
    certificate["outer"] = certificate["trajectory"]
    certificate["outer_drawn"] = [[[["edge", k], ["vertex", 0]]] for k in range(7)]
    result = verify(certificate)
    assert result == (
        False,
        "outer: with G at trajectory vertex 1 its vertex 1 is outside",
        Point(Fraction(5), Fraction(-1)),
    )


def test_undercut_must_be_closed() -> None:
    """A trajectory and outer loop that are right, and D itself given as the inner loop."""
    g, d = Polygon([(0, 0), (2, 0), (2, 2), (0, 2)]), Polygon(SLOT)
    true = reference_loops(g, d)
    assert true.inner != d.vertices
    for inner in (d.vertices, true.outer):
        certificate = certificate_of(g, d, (true.trajectory, inner, true.outer))
        assert verify(certificate).reason.startswith("inner")


def test_place_that_is_reached_is_outside_the_inner_loop() -> None:
    """The valley filled up all over; a small enough G comes down into it."""
    g, d = Polygon(UNIT), Polygon(VALLEY)
    true = reference_loops(g, d)
    filled = Polygon([(0, 0), (4, 0), (4, 3), (0, 3)]).vertices
    certificate = certificate_of(g, d, (true.trajectory, filled, true.outer))
    assert verify(certificate).reason.startswith("inner")


@settings(max_examples=80)
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


FRAME = NodeFrame((1, 0), 1)


def _loop(vertices: Vertices) -> MonotoneLoop:
    return MonotoneLoop(FRAME.enter(vertices, Point(Fraction(0), Fraction(0))), "loop", FRAME)


@settings(max_examples=80)
@given(monotone_rings(), monotone_rings())
def test_least_height_is_the_limit_of_the_sum(first: Ring, second: Ring) -> None:
    a, b = Polygon(first), Polygon(second)
    true = reference_loops(b.reflected(), a).trajectory
    halves = (_loop(vertices).halves for vertices in (a.vertices, b.vertices, true))
    for of_a, of_b, of_sum in zip(*halves, strict=True):
        for left, right, _ in of_sum.edges:
            for node, side in ((left, 1), (right, -1)):
                assert min(height for height, _ in walk_heights(of_a, of_b, node, side)) == 0


@settings(max_examples=500)
@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=3, max_size=7))
@example([(0, 1), (2, 0), (0, 0), (1, 2)])
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
    """Whether all of a loop is in Q: its vertices, the points where it meets edges of Q, and a
    point of each part between.
    """
    for edge in edges(loop):
        stops = {*edge, *(m for other in edges(q.vertices) for m in _meeting(edge, other))}
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
