"""Areas between regions, distances of loops, and walks along both: laws and known answers."""

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from strategies import points, simple_rings
from tiers import examples

from exactsweep import Point, Polygon
from exactsweep.check.location import locate
from exactsweep.conform.judge.closeness import are_close
from exactsweep.conform.judge.region import (
    RegionError,
    add_areas,
    find_differences,
    find_simplest,
    measure_distance,
)

Ring = Sequence[Point]

SQUARE = points((0, 0), (4, 0), (4, 4), (0, 4))
patient = examples(25)


def any_rings() -> st.SearchStrategy[Ring]:
    """Arbitrary rings: self-crossing, retracing, with repeated vertices."""
    coordinates = st.integers(0, 6).map(Fraction) | st.fractions(0, 6, max_denominator=3)
    return st.lists(st.builds(Point, coordinates, coordinates), min_size=1, max_size=7)


def polygons() -> st.SearchStrategy[Ring]:
    return simple_rings().map(lambda ring: Polygon(ring).vertices)


def apart(one: Sequence[Ring], other: Sequence[Ring]) -> Fraction:
    return add_areas(find_differences(one, other))


@patient
@given(any_rings(), any_rings())
def test_the_area_does_not_depend_on_the_direction_of_the_slabs(one: Ring, other: Ring) -> None:
    turned = [[Point(y - x, x + y) for x, y in ring] for ring in (one, other)]
    assert apart(turned[:1], turned[1:]) == 2 * apart([one], [other])


@patient
@given(any_rings(), any_rings(), any_rings())
def test_differences_are_a_metric_of_regions(one: Ring, two: Ring, three: Ring) -> None:
    assert apart([one], [one[::-1]]) == 0
    assert apart([one], [two]) == apart([two], [one])
    assert apart([one], [three]) <= apart([one], [two]) + apart([two], [three])
    # The rings of both together enclose the symmetric difference.
    assert apart([one, two], []) == apart([one], [two])


@patient
@given(any_rings(), any_rings())
def test_points_of_a_cell_are_in_exactly_its_region(one: Ring, other: Ring) -> None:
    for cell in find_differences([one], [other]):
        for point in cell.points():
            assert (locate(point, one) > 0) is cell.first
            assert (locate(point, other) > 0) is not cell.first


@patient
@given(polygons(), polygons())
def test_areas_of_simple_polygons_add_up(one: Ring, other: Ring) -> None:
    cells = list(find_differences([one], [other]))
    first, second = (add_areas(c for c in cells if c.first is side) for side in (True, False))
    assert Polygon(one).area - first == Polygon(other).area - second


@patient
@given(polygons(), polygons())
def test_areas_are_those_of_another_exact_program(one: Ring, other: Ring) -> None:
    rene = pytest.importorskip("rene.exact")
    numbers = pytest.importorskip("rithm.fraction")

    def number(value: Fraction) -> Any:
        return numbers.Fraction(value.numerator, value.denominator)

    def region(ring: Ring) -> Any:
        return rene.Polygon(rene.Contour([rene.Point(number(x), number(y)) for x, y in ring]), [])

    def area_of(found: Any) -> Fraction:
        if isinstance(found, rene.Empty):
            return Fraction(0)
        parts = found.polygons if isinstance(found, rene.Multipolygon) else [found]
        rings = [(ring, sign) for p in parts for ring, sign in _signed(p)]
        return sum((sign * _area(ring) for ring, sign in rings), Fraction(0))

    assert apart([one], [other]) == area_of(region(one) ^ region(other))


def _signed(polygon: Any) -> list[tuple[list[tuple[Fraction, Fraction]], int]]:
    found = []
    for contour, sign in ((polygon.border, 1), *((hole, -1) for hole in polygon.holes)):
        ratios = [[(c.numerator, c.denominator) for c in (p.x, p.y)] for p in contour.vertices]
        ring = [(Fraction(int(a), int(b)), Fraction(int(c), int(d))) for (a, b), (c, d) in ratios]
        found.append((ring, sign))
    return found


def _area(ring: list[tuple[Fraction, Fraction]]) -> Fraction:
    terms = (a * d - c * b for (a, b), (c, d) in pairwise([*ring, ring[0]]))
    return abs(sum(terms, Fraction(0))) / 2


def test_rings_with_too_many_crossings_are_rejected(monkeypatch: pytest.MonkeyPatch) -> None:
    comb = [Point(Fraction(x), Fraction(9 * (x % 2))) for x in range(20)]
    turned = [Point(2 * y, x / 2) for x, y in comb]
    cells = list(find_differences([comb], [turned]))
    assert add_areas(cells) > 0
    monkeypatch.setattr("exactsweep.conform.judge.region.MAX_WORK", 1000)
    with pytest.raises(RegionError, match="to measure"):
        list(find_differences([comb], [turned]))


@given(st.fractions(max_denominator=50), st.fractions(max_denominator=50))
def test_the_simplest_rational_has_the_least_denominator(p: Fraction, q: Fraction) -> None:
    low, high = sorted((p, q))
    found = find_simplest(low, high)
    assert low <= found <= high
    for denominator in range(1, found.denominator):
        assert -(-low * denominator // 1) > high * denominator // 1


@patient
@given(polygons(), polygons())
def test_the_distance_is_a_maximum_over_vertices(one: Ring, other: Ring) -> None:
    found = [
        min(find_distance(p, (ring[k - 1], q)) for k, q in enumerate(ring))
        for points, ring in ((one, other), (other, one))
        for p in points
    ]
    assert measure_distance([one], [other]) == max(found)


def find_distance(p: Point, edge: tuple[Point, Point]) -> Fraction:
    """Return the squared distance of a point from a segment."""
    a, b = edge
    dx, dy = b.x - a.x, b.y - a.y
    t = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy)
    t = min(max(t, Fraction(0)), Fraction(1))
    return (a.x + t * dx - p.x) ** 2 + (a.y + t * dy - p.y) ** 2


@patient
@given(polygons(), polygons())
def test_the_distance_is_symmetric_and_zero_for_one_loop(one: Ring, other: Ring) -> None:
    assert measure_distance([one], [other]) == measure_distance([other], [one])
    assert measure_distance([one], [[*one, one[0], *one]]) == 0


@pytest.mark.parametrize(
    ("ring", "squared"),
    [
        (points((0, 0), (4, 0), (4, 4), (0, 4)), "0"),
        (points((1, 0), (5, 0), (5, 4), (1, 4)), "1"),
        # Half the diagonal of the missing corner.
        (points((2, 0), (4, 0), (4, 4), (0, 4), (0, 2)), "2"),
        # A notch of depth 1.
        (points((0, 0), (4, 0), (4, 4), (2, 3), (0, 4)), "1"),
        # The tip of a notch in a line of thirds.
        (points((0, 0), (4, 0), (4, 4), ("7/3", "11/3"), (0, 4)), "1/9"),
    ],
)
def test_distances_by_hand(ring: Ring, squared: str) -> None:
    assert measure_distance([SQUARE], [ring]) == Fraction(squared)


@examples(12)
@given(polygons(), st.data())
def test_a_loop_whose_vertices_are_moved_is_close(ring: Ring, data: st.DataObject) -> None:
    small = st.fractions(Fraction(-9, 10), Fraction(9, 10), max_denominator=10)
    moved = [Point(x + data.draw(small), y + data.draw(small)) for x, y in ring]
    k = data.draw(st.integers(0, len(moved) - 1))
    turned = [*moved[k:], *moved[:k]]
    for other in (turned, turned[::-1]):
        assert are_close([ring], [other], Fraction(1))
        assert are_close([other], [ring], Fraction(1))
    assert are_close([ring], [[ring[0], *ring, ring[-1]]], Fraction(1, 10**9))
    far = [Point(x + 2, y) for x, y in moved]
    assert not are_close([ring], [far], Fraction(1))


@patient
@given(polygons(), polygons(), st.fractions(Fraction(1, 9), 9, max_denominator=9))
def test_close_regions_are_close_at_sampled_points(one: Ring, other: Ring, bound: Fraction) -> None:
    """The definition, tested at points of the boundaries and of the trapezoids between them."""
    if not are_close([one], [other], bound):
        return
    for ring, target in ((one, other), (other, one)):
        for a, b in pairwise([*ring, ring[0]]):
            for k in range(8):
                share = Fraction(k, 8)
                p = Point(a.x + share * (b.x - a.x), a.y + share * (b.y - a.y))
                assert measure(p, target) < bound
    for cell in find_differences([one], [other]):
        for p in cell.points():
            assert min(measure(p, one), measure(p, other)) < bound / 2


def measure(p: Point, ring: Ring) -> Fraction:
    """Return the distance of a point from a ring in the maximum norm."""
    return min(measure_edge(p, a, b) for a, b in pairwise([*ring, ring[0]]))


def measure_edge(p: Point, a: Point, b: Point) -> Fraction:
    """Convex along an edge, so minimal at an end or where two differences are equal."""
    (u, v), (x, y) = (b.x - a.x, b.y - a.y), (a.x - p.x, a.y - p.y)
    lines = ((u, x), (v, y), (u - v, x - y), (u + v, x + y))
    shares = (-start / step for step, start in lines if step)
    places = [Fraction(0), Fraction(1), *(t for t in shares if 0 < t < 1)]
    return min(max(abs(x + t * u), abs(y + t * v)) for t in places)


@pytest.mark.parametrize(
    ("ring", "bound", "found"),
    [
        # A corner cut by one in x and in y; its midpoint is at distance 1/2 from both edges.
        (points((1, 0), (4, 0), (4, 4), (0, 4), (0, 1)), "1/2", False),
        (points((1, 0), (4, 0), (4, 4), (0, 4), (0, 1)), "101/100", True),
        # The bound itself is too far.
        (points((-1, 0), (4, 0), (4, 4), (0, 4)), "1", False),
        (points((-1, 0), (4, 0), (4, 4), (0, 4)), "1001/1000", True),
        # A narrow deep slot, and a narrow shallow one.
        (points((0, 0), (4, 0), (4, 4), (2, 4), (2, 1), ("19/10", 4), (0, 4)), "1", False),
        (points((0, 0), (4, 0), (4, 4), (2, 4), (2, "7/2"), ("19/10", 4), (0, 4)), "1", True),
        # The reverse orientation; three repeated points; and two, which enclose nothing.
        (SQUARE[::-1], "1", True),
        (SQUARE * 3, "1", True),
        (SQUARE * 2, "1", False),
    ],
)
def test_closeness_by_hand(ring: Ring, bound: str, found: bool) -> None:
    assert are_close([SQUARE], [ring], Fraction(bound)) is found


def test_a_long_edge_may_be_off_by_nearly_the_bound() -> None:
    """The difference is wider than half the bound."""
    far = 10**9
    long = points((0, 0), (far, 0), (far, far), (0, far))
    moved = [Point(x + 1, y - 1) for x, y in long]
    assert are_close([long], [moved], Fraction(101, 100))
    assert not are_close([long], [moved], Fraction(1))
    slanted = points((0, 0), (far, 3 * far), (-far, far))
    moved = [Point(x - 1, y + 1) for x, y in slanted]
    assert are_close([slanted], [moved], Fraction(5, 4))


def test_a_long_thin_spike_may_be_off_by_nearly_the_bound() -> None:
    """Repeated halving would need the hexagons of hundreds of short edges."""
    spike = points((0, 1000), (1, 0), (2, 1000))
    moved = points(("-9/10", 1000), ("19/10", "-9/10"), ("29/10", "9991/10"))
    assert are_close([spike], [moved], Fraction(1))
    assert not are_close([spike], [moved], Fraction(9, 10))


def test_a_whisker_of_a_rounded_ring_counts_as_its_boundary() -> None:
    """Rounding turns the notch into a line traced in both directions."""
    notched = points((0, 0), (9, 0), (9, 9), (1, 9), (1, 3), (0, 8))
    rounded = points((0, 0), (9, 0), (9, 9), (0, 9), (0, 3), (0, 8))
    for pair in ((notched, rounded), (rounded, notched)):
        assert are_close(pair[:1], pair[1:], Fraction(101, 100))


def test_a_band_along_the_boundary_is_not_the_region() -> None:
    """Its whole boundary is near the other one; its interior is not."""
    e = Fraction(1, 100)
    inner = points((e, e), (4 - e, e), (4 - e, 4 - e), (e, 4 - e))
    assert not are_close([SQUARE], [SQUARE, inner], Fraction(1, 10))
    assert are_close([SQUARE], [SQUARE, inner], Fraction(5))


def test_a_difference_along_a_wall_of_pieces_is_thin() -> None:
    """No single edge is near the whole difference."""
    wall = points(*((Fraction(k % 2, 100), k) for k in range(5)))
    straight = points((Fraction(1, 200), 0), (9, 0), (9, 4), (Fraction(1, 200), 4))
    ragged = [*points((9, 0), (9, 4)), *wall[::-1]]
    assert are_close([straight], [ragged], Fraction(1, 50))
    assert not are_close([straight], [ragged], Fraction(1, 300))


def test_a_difference_of_too_many_parts_is_not_close(monkeypatch: pytest.MonkeyPatch) -> None:
    ripple = [Point(Fraction(x), Fraction(x % 2)) for x in range(40)]
    ring = [*ripple, Point(Fraction(40), Fraction(9)), Point(Fraction(-1), Fraction(9))]
    moved = [Point(x, y + Fraction(1, 9)) for x, y in ring]
    assert are_close([ring], [moved], Fraction(1, 8))
    monkeypatch.setattr("exactsweep.conform.judge.region.MAX_WORK", 10)
    assert not are_close([ring], [moved], Fraction(1, 8))
