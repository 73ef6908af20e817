"""`classify` compared with slabs between abscissas of vertices and crossings; known verdicts."""

from fractions import Fraction
from itertools import pairwise, product
from random import Random
from typing import Any

import pytest
import small_pairs
import strategies as own
from cells import Holed, doubled, shape_of, verdict_by_counting
from hypothesis import given, settings
from hypothesis import strategies as st
from shapes import Cells, cell_sets

from exactsweep import NumberError, Point, Polygon, PolygonError, Region
from exactsweep.check import Classification, classify, point_in_polygon
from exactsweep.corpus.generator.cells import move
from exactsweep.numbers.number import to_fraction

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
SLOT = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
#   ####       a corridor of width one that winds
#   #  #       inwards, with a free corridor of
#   # ##       width one beside it
#   #
#   #####
SPIRAL = [(0, 0), (5, 0), (5, 1), (1, 1), (1, 4), (3, 4), (3, 3), (2, 3), (2, 2), (4, 2), (4, 5)]
SPIRAL += [(0, 5)]
Edge = tuple[Point, Point]
# The slabs are slow by design.
patient = settings()
Case = tuple[Polygon, Polygon, tuple[Fraction, Fraction]]


def edges(polygon: Polygon) -> list[Edge]:
    v = polygon.vertices
    return list(zip(v, (*v[1:], v[0]), strict=True))


def turn(a: Point, b: Point, c: Point) -> Fraction:
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)


def common_points(e: Edge, f: Edge) -> list[Point]:
    """Return the ends of one edge that lie on the other, or the crossing."""
    found = [
        p
        for (a, b), ends in ((e, f), (f, e))
        for p in ends
        if turn(a, b, p) == 0 and min(a, b) <= p <= max(a, b)
    ]
    (a, b), (c, d) = e, f
    from_c, from_d = turn(a, b, c), turn(a, b, d)
    if from_c * from_d < 0 and turn(c, d, a) * turn(c, d, b) < 0:
        share = from_c / (from_c - from_d)
        found.append(Point(c.x + share * (d.x - c.x), c.y + share * (d.y - c.y)))
    return found


def spans(polygon: Polygon, x: Fraction) -> list[tuple[Fraction, Fraction]]:
    """Return the intervals of a polygon on a vertical line that meets no vertex."""
    heights = sorted(
        a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x)
        for a, b in edges(polygon)
        if (a.x < x) != (b.x < x)
    )
    return list(zip(heights[::2], heights[1::2], strict=True))


def verdict_by_slabs(d: Polygon, g: Polygon) -> str:
    meetings = [p for e, f in product(edges(d), edges(g)) for p in common_points(e, f)]
    cuts = sorted({p.x for p in (*d.vertices, *g.vertices, *meetings)})
    for left, right in pairwise(cuts):
        x = (left + right) / 2
        for a, b in product(spans(d, x), spans(g, x)):
            if max(a[0], b[0]) < min(a[1], b[1]):
                return "OVERLAP"
    return "CONTACT" if meetings else "FREE"


def check(d: Polygon, g: Polygon, t: tuple[object, object]) -> str:
    found = classify(d, g, t)
    moved = g.translated(t)
    assert found.verdict == verdict_by_slabs(d, moved)
    check_witness(d, g, t, found)
    return found.verdict


def check_witness(d: object, g: object, t: tuple[object, object], found: Classification) -> None:
    assert (found.witness is None) == (found.verdict == "FREE")
    if found.witness is not None:
        (x, y), (dx, dy) = found.witness, map(to_fraction, t)
        where = 1 if found.verdict == "OVERLAP" else 0
        assert point_in_polygon((x, y), d) == where
        assert point_in_polygon((x - dx, y - dy), g) == where


@st.composite
def touching(draw: st.DrawFn) -> Case:
    """Draw two polygons on one grid, usually with a vertex of one on a vertex of the other."""
    d, g = Polygon(draw(own.simple_rings())), Polygon(draw(own.simple_rings()))
    p, q = draw(st.sampled_from(d.vertices)), draw(st.sampled_from(g.vertices))
    step = st.sampled_from([Fraction(s) for s in ("0", "0", "0", "1", "-1", "1/2", "1e-30")])
    return d, g, (p.x - q.x + draw(step), p.y - q.y + draw(step))


@patient
@given(touching())
def test_verdicts_agree_with_slabs(case: Case) -> None:
    check(*case)


@patient
@given(touching())
def test_roles_can_be_exchanged(case: Case) -> None:
    d, g, (x, y) = case
    assert classify(d, g, (x, y)).verdict == classify(g, d, (-x, -y)).verdict


@patient
@given(own.simple_polygons())
def test_polygon_overlaps_itself(polygon: Polygon) -> None:
    assert check(polygon, polygon, (0, 0)) == "OVERLAP"


@patient
@given(own.simple_polygons(), own.translations())
def test_separate_polygons_are_free(polygon: Polygon, t: tuple[Fraction, Fraction]) -> None:
    low, high = polygon.bounding_box
    assert classify(polygon, polygon, (high.x - low.x + abs(t[0]) + 1, t[1])).verdict == "FREE"


TIP = [(0, 0), (1, -1), (1, 1)]
LARGE = [(-9, -9), (9, -9), (9, 9), (-9, 9)]
UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
KNOWN: dict[str, tuple[Any, Any, Any, str]] = {
    "corner on corner": (SQUARE, SQUARE, (2, 2), "CONTACT"),
    "side along side": (SQUARE, SQUARE, (2, 1), "CONTACT"),
    "beyond the corner": (SQUARE, SQUARE, (2, Fraction(3)), "FREE"),
    "hair": (SQUARE, SQUARE, (Fraction(2) - Fraction(1, 10**40), 0), "OVERLAP"),
    "tip on side": (SQUARE, TIP, (2, 1), "CONTACT"),
    "inner tip on side": (SQUARE, TIP, (1, 1), "OVERLAP"),
    "inscribed": (SQUARE, [(1, 0), (2, 1), (1, 2), (0, 1)], (0, 0), "OVERLAP"),
    "D holds G": (LARGE, SQUARE, (0, 0), "OVERLAP"),
    "G holds D": (SQUARE, LARGE, (0, 0), "OVERLAP"),
    "exact fit": (SLOT, UNIT, (1, 1), "CONTACT"),
    "plug": (SLOT, [(0, 0), (1, 0), (1, 9), (0, 9)], (1, 1), "CONTACT"),
    "too deep": (SLOT, UNIT, (1, "1/2"), "OVERLAP"),
    "slots shifted": (SLOT, SLOT, (1, 0), "OVERLAP"),
    "corridor": (SPIRAL, UNIT, (2, 1), "CONTACT"),
    "wall": (SPIRAL, [(0, 0), ("1/2", 0), ("1/2", 3)], ("1/4", "1/4"), "OVERLAP"),
    "inside": (SPIRAL, [(0, 0), ("1/4", 0), ("1/4", "1/4")], ("5/4", "5/4"), "FREE"),
}


@pytest.mark.parametrize("name", KNOWN)
def test_known_verdicts(name: str) -> None:
    d, g, t, verdict = KNOWN[name]
    assert check(Polygon(d), Polygon(g), t) == verdict


def test_interlocked_combs_touch_and_then_overlap() -> None:
    """Six teeth of width one in six gaps of width one."""
    up = [(0, -1), (13, -1), (13, 0)]
    for x in range(12, -1, -2):
        up += [(x + 1, 0), (x + 1, 3), (x, 3), (x, 0)]
    up = up[:2] + up[3:-1]
    comb = Polygon(up)
    other = comb.reflected((Fraction(13, 2), Fraction(3, 2)))
    assert check(comb, other, (1, 0)) == "CONTACT"
    assert check(comb, other, (1, 3)) == "CONTACT"
    assert check(comb, other, (1, 4)) == "FREE"
    assert check(comb, other, (Fraction(11, 10), 1)) == "OVERLAP"
    assert check(comb, other, (1, Fraction(-1, 10**9))) == "OVERLAP"


def test_invalid_input_is_rejected() -> None:
    with pytest.raises(PolygonError):
        classify([(0, 0), (1, 1)], SQUARE, (0, 0))
    with pytest.raises(NumberError):
        classify(SQUARE, SQUARE, (float("nan"), 0))


@patient
@given(own.simple_polygons(), st.data())
def test_location_follows_the_spans(polygon: Polygon, data: st.DataObject) -> None:
    corners = polygon.vertices
    p, q = data.draw(st.sampled_from(corners)), data.draw(st.sampled_from(corners))
    x, y = (p.x + q.x) / 2, (p.y + 2 * q.y) / 3
    on_edge = any(
        turn(a, b, Point(x, y)) == 0 and min(a, b) <= (x, y) <= max(a, b) for a, b in edges(polygon)
    )
    found = point_in_polygon((x, y), polygon)
    assert (found == 0) == on_edge
    if not on_edge and all(c.x != x for c in corners):
        assert (found == 1) == any(low < y < high for low, high in spans(polygon, x))


def test_every_vertex_and_midpoint_of_an_edge_is_on_the_boundary() -> None:
    for a, b in edges(Polygon(SPIRAL)):
        assert point_in_polygon(a, SPIRAL) == 0
        assert point_in_polygon(((a.x + b.x) / 2, (a.y + b.y) / 2), SPIRAL) == 0


# --- Shapes with holes ---------------------------------------------------------------------------


def box(x0: int, y0: int, x1: int, y1: int) -> Polygon:
    return Polygon([(x0, y0), (x1, y0), (x1, y1), (x0, y1)])


RING = Holed(box(0, 0, 4, 4), (box(1, 1, 3, 3),))
TWICE = Holed(box(0, 0, 8, 8), (box(2, 2, 6, 6),))
PINCHED = Holed(box(0, 0, 4, 4), (Polygon([(0, 2), (2, 1), (3, 2), (2, 3)]),))


WALL, THIN = (Holed(box(0, 0, 9, 9), (box(k, k, 9 - k, 9 - k),)) for k in (2, 1))
WITH_HOLES: dict[str, tuple[Any, Any, Any, str]] = {
    "G in a hole of D": (RING, box(0, 0, 1, 1), ("3/2", "3/2"), "FREE"),
    "G fills a hole of D": (RING, box(0, 0, 2, 2), (1, 1), "CONTACT"),
    "G too high in the hole": (RING, box(0, 0, 2, 2), (1, "11/10"), "OVERLAP"),
    "G over all": (RING, box(0, 0, 9, 9), (-1, -1), "OVERLAP"),
    "D in a hole of G": (box(0, 0, 1, 1), RING, ("-3/2", "-3/2"), "FREE"),
    "G is D": (RING, RING, (0, 0), "OVERLAP"),
    "ring that fills a ring": (TWICE, RING, (2, 2), "CONTACT"),
    "ring on a ring": (TWICE, RING, (4, 4), "OVERLAP"),
    "outside, corner on corner": (RING, box(0, 0, 4, 4), (4, 4), "CONTACT"),
    "around": (RING, Holed(box(0, 0, 6, 6), (box(1, 1, 5, 5),)), (-1, -1), "CONTACT"),
    "one inside the other along the exterior": (THIN, WALL, (0, 0), "OVERLAP"),
    "pinch": (PINCHED, [(0, 0), (1, "-1/2"), (1, "1/2")], (0, 2), "CONTACT"),
    "tips": (PINCHED, [(0, 0), (-1, "-1/2"), (-1, "1/2")], (0, 2), "CONTACT"),
    "tip next to a pinch": (PINCHED, [(0, 0), (1, 0), (1, 1)], (0, 2), "OVERLAP"),
    "pinched inside": (box(-9, -9, 9, 9), PINCHED, (0, 0), "OVERLAP"),
}


@pytest.mark.parametrize("name", WITH_HOLES)
def test_known_verdicts_with_holes(name: str) -> None:
    d, g, t, verdict = WITH_HOLES[name]
    found = classify(d, g, t)
    assert found.verdict == verdict
    check_witness(d, g, t, found)
    x, y = map(to_fraction, t)
    assert classify(g, d, (-x, -y)).verdict == verdict


@patient
@given(cell_sets(), cell_sets(), st.tuples(st.integers(-9, 9), st.integers(-9, 9)))
def test_verdicts_with_holes_agree_with_counting(
    d: Cells, g: Cells, twice: tuple[int, int]
) -> None:
    t = (Fraction(twice[0], 2), Fraction(twice[1], 2))
    shape, other = shape_of(d), shape_of(g)
    found = classify(shape, other, t)
    assert found.verdict == verdict_by_counting(doubled(d), move(doubled(g), twice))
    check_witness(shape, other, t, found)


@pytest.mark.parametrize("position", [5, (1,), "ab", None, (1, 2, 3)])
def test_a_position_must_be_a_pair(position: object) -> None:
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    with pytest.raises(PolygonError, match=r"^the position is "):
        classify(square, square, position)  # type: ignore[arg-type]


def test_witnesses_are_inside_both() -> None:
    """On a small grid, rays from a vertex often run along edges."""
    rng = Random(6)
    found = 0
    for number in range(60):
        pair = (small_pairs.draw_shapeless if number % 2 else small_pairs.draw)(rng)
        g, d = (Region(shape[0], shape[1:]) for shape in pair)
        for _ in range(6):
            (px, py), (qx, qy) = (rng.choice(rng.choice(shape)) for shape in pair)
            t = qx - px + rng.randint(0, 1), qy - py + rng.randint(0, 1)
            answer = classify(d, g, t)
            if answer.verdict == "OVERLAP":
                assert answer.witness is not None
                x, y = answer.witness
                for shape, place in ((d, (x, y)), (g, (x - t[0], y - t[1]))):
                    sides = [
                        point_in_polygon(place, ring) for ring in (shape.exterior, *shape.holes)
                    ]
                    assert sides == [1] + [-1] * len(shape.holes), (pair, t)
                found += 1
    assert found > 100


@pytest.mark.parametrize("hole", [[(2, 2), (8, 8), (8, 2)], [(2, 2), (2, 8), (8, 8)]])
def test_a_witness_is_not_on_an_edge_along_its_ray(hole: Any) -> None:
    """The ray is the diagonal, which continues along the hole: (1, 1) is halfway to the hole."""
    square = [(0, 0), (10, 0), (10, 10), (0, 10)]
    answer = classify(Region(square, [hole]), square, (0, 0))
    assert answer == Classification("OVERLAP", Point(Fraction(1), Fraction(1)))
