"""Certificates: true ones are proved, whoever wrote them, and false ones are not."""

import copy
import json
import random
from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
from families import random_pair
from hypothesis import example, given, settings
from hypothesis import strategies as st
from strategies import Kind, Ring, monotone_rings, pairs
from tampering import Certificate, changes, report, tamper

from exactsweep import Point, Polygon, sweep
from exactsweep.check import (
    classify,
    point_in_polygon,
    reference_exact_fits,
    reference_loops,
    verify,
)
from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import heights
from exactsweep.check.loop import Frame, Loop
from exactsweep.check.sums import check_sum_within
from exactsweep.direction import is_monotone
from exactsweep.number import format_fraction

Vertices = tuple[Point, ...]

UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLOT = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
WIDE_SLOT = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)]
VALLEY = [(0, 0), (4, 0), (4, 3), (2, 1), (0, 3)]


# --- A producer of certificates from the definition, by brute force -----------------------------


def certificate_of(
    g: Polygon, d: Polygon, loops: tuple[Vertices, Vertices, Vertices] | None = None
) -> Certificate:
    """The certificate of a pair, or one that gives other loops with all evidence that there is."""
    trajectory, inner, outer = loops or reference_loops(g, d)
    certificate: Certificate = {
        "format": "exactsweep certificate",
        "version": 1,
        "generatrix": _texts(g.vertices),
        "directrix": _texts(d.vertices),
        "kind": "MM" if not g.is_convex else "CC" if d.is_convex else "CM",
        "direction": [1, 0],
        "reference": ["0", "0"],
        "trajectory": _texts(trajectory),
        "inner": _texts(inner),
        "outer": _texts(outer),
        "area": format_fraction(Polygon(outer).area - Polygon(inner).area),
        "exact_fits": [_texts(fit) for fit in reference_exact_fits(g, d)],
        "contacts": [_contacts(g, d, edge) for edge in _edges(trajectory)],
    }
    features = [[kind, k] for k in range(len(g)) for kind in ("vertex", "edge")]
    positions = [[kind, k] for k in range(len(trajectory)) for kind in ("vertex", "edge")]
    for loop, edges in (("inner", inner), ("outer", outer)):
        certificate[f"{loop}_drawn"] = [
            [
                [position, feature]
                for position in positions
                for feature in features
                if _share(edge, _sums(trajectory, position, g.vertices, feature, 1))
            ]
            for edge in _edges(edges)
        ]
    return certificate


def _replace_trajectory(
    certificate: Certificate, g: Polygon, d: Polygon, trajectory: Vertices
) -> None:
    """Put in another one with all contacts that there are, and leave out what depends on it."""
    certificate["trajectory"] = _texts(trajectory)
    certificate["contacts"] = [_contacts(g, d, edge) for edge in _edges(trajectory)]
    for loop in ("inner", "outer"):
        certificate[f"{loop}_drawn"] = [[] for _ in certificate[loop]]


def _contacts(g: Polygon, d: Polygon, edge: Vertices) -> list[list[Any]]:
    found: list[list[Any]] = []
    for event in ("EE", "EV", "VE"):
        of_g, of_d = ("edge" if letter == "E" else "vertex" for letter in event)
        for i in range(len(g)):
            for j in range(len(d)):
                sums = _sums(d.vertices, [of_d, j], g.vertices, [of_g, i], -1)
                # The EE pairs whose segments would include that of an EV or VE pair.
                if event == "EE":
                    wider = []
                elif event == "EV":
                    wider = [["EE", i, b % len(d)] for b in (j - 1, j)]
                else:
                    wider = [["EE", a % len(g), j] for a in (i - 1, i)]
                if _share(edge, sums) and not any(contact in found for contact in wider):
                    found.append([event, i, j])
    return sorted(found)


def _sums(one: Vertices, feature: list[Any], other: Vertices, of: list[Any], sign: int) -> Vertices:
    return tuple(
        Point(p.x + sign * q.x, p.y + sign * q.y)
        for p in _ends(one, *feature)
        for q in _ends(other, *of)
    )


def _ends(loop: Vertices, kind: str, k: int) -> Vertices:
    return (loop[k], loop[(k + 1) % len(loop)]) if kind == "edge" else (loop[k],)


def _share(edge: Vertices, sums: Vertices) -> bool:
    """Whether all points are on the line of an edge, and more than a point of it between them."""
    (px, py), (qx, qy) = edge
    if any((qx - px) * (y - py) != (qy - py) * (x - px) for x, y in sums):
        return False
    return max(min(edge), min(sums)) < min(max(edge), max(sums))


def _edges(loop: Vertices) -> Iterator[Vertices]:
    return pairwise((*loop, loop[0]))


def _texts(points: Vertices) -> list[list[str]]:
    return [[format_fraction(c) for c in point] for point in points]


# --- True certificates ---------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["CC", "CM", "MM"])
@settings(deadline=None, max_examples=60)
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


@settings(deadline=None, max_examples=25)
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


@settings(deadline=None, max_examples=60)
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
        _replace_trajectory(certificate, g, d, walked)
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
    _replace_trajectory(certificate, g, d, filled)
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


@settings(deadline=None, max_examples=80)
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


FRAME = Frame((1, 0), 1)


def _loop(vertices: Vertices) -> Loop:
    return Loop(FRAME.enter(vertices, Point(Fraction(0), Fraction(0))), "loop", FRAME)


@settings(deadline=None, max_examples=80)
@given(monotone_rings(), monotone_rings())
def test_least_height_is_the_limit_of_the_sum(first: Ring, second: Ring) -> None:
    a, b = Polygon(first), Polygon(second)
    true = reference_loops(b.reflected(), a).trajectory
    halves = (_loop(vertices).halves for vertices in (a.vertices, b.vertices, true))
    for of_a, of_b, of_sum in zip(*halves, strict=True):
        for edge in of_sum.edges:
            for node, side in ((edge.left, 1), (edge.right, -1)):
                assert min(height for height, _ in heights(of_a, of_b, node, side)) == 0


@settings(deadline=None, max_examples=500)
@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=3, max_size=7))
@example([(0, 1), (2, 0), (0, 0), (1, 2)])
@example([(0, 0), (1, 0), (1, 2), (2, 2), (2, 4), (1, 4), (1, 1), (0, 1)])
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
    for edge in _edges(loop):
        stops = {*edge, *(m for other in _edges(q.vertices) for m in _meeting(edge, other))}
        parts = [((a.x + b.x) / 2, (a.y + b.y) / 2) for a, b in pairwise(sorted(stops))]
        if any(point_in_polygon(p, q) < 0 for p in [*stops, *parts]):
            return False
    return True


# --- Not certificates ----------------------------------------------------------------------------

NESTED: list[Any] = []
for _ in range(10**5):
    NESTED = [NESTED]

JUNK = [
    *(None, True, False, 0, 1, -1, 10**5000, 0.5, float("nan"), float("inf"), b"1", (1, 0), {1, 2}),
    *("", "0", "1e9999999999", "1/0", "2/4", "-0", "nan", "0.5", " 1", "\ud800", "9" * 10**6),
    *([], {}, [[]], [[], []], [None] * 3, ["0", "0"], [["0", "0"]] * 3, [["0"] * 2] * 2),
    *([[0, 0], [1, 0], [0, 1]], [[["EV", 0, 0]]], [True, False], [10**5000, 1], object()),
    *(NESTED, {"a": NESTED}, [NESTED, NESTED]),
]


def _places(value: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """Every place in nested lists and dicts, the first and last two entries of each list."""
    yield path
    if isinstance(value, dict):
        for key in value:
            yield from _places(value[key], (*path, key))
    if isinstance(value, list):
        for k in sorted({0, 1, len(value) - 1} & set(range(len(value)))):
            yield from _places(value[k], (*path, k))


def _with(value: Any, path: tuple[Any, ...], junk: Any) -> Any:
    if not path:
        return junk
    changed = value.copy()
    changed[path[0]] = _with(value[path[0]], path[1:], junk)
    return changed


def test_junk_is_refused_with_a_reason() -> None:
    certificate = sweep(UNIT, SLOT).certificate()
    for path in _places(certificate):
        for junk in JUNK:
            changed = _with(certificate, path, junk)
            result = verify(changed)
            if result.proved:
                assert type(junk) in (str, int, list)
                assert changed == certificate, path
            else:
                assert 0 < len(result.reason) < 200


@pytest.mark.parametrize(
    ("key", "value", "reason"),
    [
        ("format", "x", "format is not 'exactsweep certificate'"),
        ("version", True, "version is not 1"),
        ("kind", "MC", "kind is not CC, CM or MM"),
        ("kind", "MM", "kind: it is CM, not MM"),
        ("direction", [2, 0], "direction: not primitive"),
        ("direction", [1, 0.0], "direction: not a pair of integers"),
        ("direction", [0, 1], "directrix: not monotone to the direction, it turns back again at"),
        ("generatrix", [["0", "0"]], "generatrix: fewer than three vertices"),
        ("directrix", "0", "directrix: a str, not a list"),
        ("inner", [["0", "0"], ["1", 0], ["0", "1"]], "inner[1][1]: a int, not a number"),
        ("outer", [["0", "0"], ["2/4", "0"], ["0", "1"]], "outer[1][0]: not a number in lowest"),
        ("trajectory", [["0", "0"], ["-1", "0"], ["0", "1"]], "trajectory: not canonical, its"),
        ("contacts", [], "contacts: 0 lists for a loop of"),
        ("area", "1e-3", "area: not a number in lowest terms"),
        ("area", "1", "area: it is not that of the outer loop minus that of the inner one"),
        ("exact_fits", [], "exact_fits: one is missing"),
    ],
)
def test_reason_names_the_place(key: str, value: Any, reason: str) -> None:
    certificate = {**sweep(UNIT, SLOT).certificate(), key: value}
    result = verify(certificate)
    assert not result.proved
    assert result.reason.startswith(reason)


def test_reasons_for_evidence_name_the_edge() -> None:
    certificate = sweep(UNIT, VALLEY).certificate()
    seen = set()
    for seed in range(5):
        for _, changed in changes(certificate, random.Random(seed)):
            seen.add(verify(changed).reason.split("[")[0])
    assert {"contacts", "inner_drawn", "outer_drawn", "exact_fits"} <= seen


def test_loop_that_meets_itself_is_refused() -> None:
    certificate = sweep(UNIT, VALLEY).certificate()
    pinched = [["0", "0"], ["2", "1"], ["4", "0"], ["4", "3"], ["2", "1"], ["0", "3"]]
    result = verify({**certificate, "directrix": pinched})
    assert result.reason == "directrix: not simple and counter-clockwise"


def test_many_edges_are_refused_at_once() -> None:
    loop = [[str(k), str(k * k)] for k in range(10**4)] + [["0", str(10**8)]]
    loop.sort(key=lambda point: point != ["0", "0"])
    certificate = {**sweep(UNIT, VALLEY).certificate(), "generatrix": loop, "directrix": loop}
    assert verify(certificate).reason == (
        "too large: to check it would take more than 100000000 steps"
    )


def test_common_denominator_out_of_hand_is_refused_at_once() -> None:
    parabola = [[str(k), f"1/{10**1000 + k}"] for k in range(1, 10**3)]
    certificate = {**sweep(UNIT, VALLEY).certificate(), "directrix": [["0", "0"], *parabola]}
    assert verify(certificate).reason == (
        "too large: a common denominator has more than 400000 bits"
    )


def test_more_steps_may_be_allowed() -> None:
    certificate = sweep(UNIT, VALLEY).certificate()
    assert verify(certificate, max_steps=10).reason == (
        "too large: to check it would take more than 10 steps"
    )
    assert verify(certificate, max_steps=10**4).proved


def test_verify_leaves_the_certificate_alone() -> None:
    certificate = sweep(UNIT, SLOT).certificate()
    before = copy.deepcopy(certificate)
    assert verify(certificate).proved
    assert certificate == before
