"""Certificates: true ones are proved, whatever wrote them, and false ones are not."""

import json
import random
from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
from families import random_pair
from hypothesis import given
from hypothesis import strategies as st
from producer import (
    SLOT,
    UNIT,
    VALLEY,
    WIDE_SLOT,
    Vertices,
    certificate_of,
    find_meetings,
    replace_trajectory,
)
from strategies import Kind, pairs
from tampering import report, tamper
from tiers import examples

from exactsweep import Point, Polygon, sweep
from exactsweep.check import (
    classify,
    point_in_polygon,
    reference_loops,
    verify,
)


@pytest.mark.parametrize("kind", ["CC", "CM", "MM"])
@examples(60)
@given(data=st.data())
def test_certificate_of_a_sweep_is_proved(kind: Kind, data: st.DataObject) -> None:
    generatrix, directrix = data.draw(pairs(kind))
    certificate = sweep(generatrix, directrix, reference=(3, "-1/7")).certificate()
    assert verify(json.loads(json.dumps(certificate))) == (True, "proved", None)


def test_certificate_is_proved_in_every_shared_direction() -> None:
    for number in range(60):
        pair = random_pair(random.Random(number))
        s = sweep(pair.generatrix, pair.directrix, direction=pair.direction)
        assert verify(s.certificate()) == (True, "proved", None), number


@examples(25)
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
        "version": 2,
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


@pytest.mark.long
def test_tampering_is_caught() -> None:
    rng = random.Random(1)
    drawn = [random_pair(rng) for _ in range(50)]
    certificates = [sweep(pair.generatrix, pair.directrix).certificate() for pair in drawn]
    certificates.append(sweep(UNIT, SLOT).certificate())
    tried, missed = tamper(certificates, rng)
    print(report(tried, missed))
    assert missed == []
    assert len(tried) > 50


@examples(60)
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
    if not result.proved and "outside" in result.reason:
        assert result.witness
        assert classify(d, g, result.witness).verdict != "FREE"
        assert point_in_polygon(result.witness, walked) <= 0


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
        meetings = [here[1], *(m for s in segments for m in find_meetings(here, s))]
        walk.append(min(m for m in meetings if m.x > walk[-1].x))
    return walk


def _bottom(loop: Vertices) -> Vertices:
    """The loop has no vertical edge at either end."""
    return loop[: loop.index(max(loop)) + 1]


def _on(p: Point, segment: Vertices) -> bool:
    (ax, ay), (bx, by) = segment
    return (bx - ax) * (p.y - ay) == (by - ay) * (p.x - ax)


def test_edge_without_contact_is_refused() -> None:
    """The valley filled up: nothing touches along the new edge, and nothing is listed."""
    g, d = Polygon(UNIT), Polygon(VALLEY)
    certificate = sweep(g, d).certificate()
    filled = Polygon([(-1, -1), (4, -1), (4, 3), (-1, 3)]).vertices
    replace_trajectory(certificate, g, d, filled)
    assert verify(certificate) == (
        False,
        "contacts[2]: nothing that is listed draws all of the edge",
        Point(Fraction(4), Fraction(3)),
    )


def test_drawing_beside_its_edge_is_refused() -> None:
    """Both walls of the slot end at one height; what draws one top does not draw the other."""
    certificate = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], WIDE_SLOT).certificate()
    tops = [k for k, (_, y) in enumerate(certificate["inner"]) if y == "3"]
    one, other = (certificate["inner_drawn"][k] for k in tops[::2])
    other.append(one[0])
    result = verify(certificate)
    assert result.reason == f"inner_drawn[{tops[2]}]: a drawing is not along the edge"


def test_loop_drawn_inside_the_swept_area_is_not_the_outer_one() -> None:
    """The path of one vertex of G is drawn all along, but other vertices pass outside."""
    certificate = sweep(UNIT, VALLEY).certificate()
    certificate["outer"] = certificate["trajectory"]
    certificate["outer_drawn"] = [[[["edge", k], ["vertex", 0]]] for k in range(7)]
    result = verify(certificate)
    assert result == (
        False,
        "outer: outside it, at the witness or beside it, is area that is swept",
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


def test_a_trajectory_into_a_notch_that_only_the_tip_fits_into_is_refused() -> None:
    """All else is as it is for that trajectory: contacts, loops, what draws them, and the area."""
    g = Polygon([(-3, -2), (3, -2), (3, -1), ("1/8", -1), (0, 0), ("-1/8", -1), (-3, -1)])
    d = Polygon([(0, 0), (2, 0), (3, 3), (4, 0), (6, 0), (6, 4), (0, 4)])
    true = sweep(g, d)
    # The shoulders of G stop it at a height of 1; the tip goes on to (3, 3).
    assert {("7/3", "1"), ("11/3", "1")} < {(str(x), str(y)) for x, y in true.trajectory.vertices}
    mended: list[Any] = [p for p in true.trajectory.vertices if not (2 < p.x < 4 and p.y == 1)]
    after = next(k for k, p in enumerate(mended) if p == (4, 0))
    trajectory = Polygon([*mended[:after], (3, 3), *mended[after:]])
    # The parts of its inside that I(G) leaves: above the shoulders, and above the tip.
    inner = Polygon([(0, 2), ("8/3", 2), (3, 3), ("10/3", 2), (6, 2), (6, 4), (0, 4)])
    assert inner.area < d.area
    loops = trajectory.vertices, inner.vertices, true.outer.vertices
    found = verify(certificate_of(g, d, loops))
    assert found.reason == (
        "trajectory: outside it, at the witness or beside it, G overlaps or touches D"
    )
    assert found.witness == Point(Fraction(3), Fraction(3))


def test_one_step_may_be_taken() -> None:
    assert verify({}, max_steps=1).reason
