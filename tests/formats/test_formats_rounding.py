"""Rounded regions provably grow or shrink on any grid, within a distance."""

from fractions import Fraction

import pytest
import strategies
from hypothesis import example, given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Point, Polygon, Region
from exactsweep.check import classify
from exactsweep.formats import FormatError
from exactsweep.formats.rounding import MAX_PLACES, Rounded, contains, round_region

fewer = examples(60)
SQUARE = [(0, 0), (9, 0), (9, 9), (0, 9)]


def turned(polygon: Polygon, divisor: int) -> Region:
    """Rotate and divide a polygon, so that it lies on no grid."""
    points = polygon.lattice()[1]
    return Region(
        [(Fraction(3 * x - 4 * y, divisor), Fraction(4 * x + 3 * y, divisor)) for x, y in points]
    )


@fewer
@given(strategies.simple_polygons(), st.sampled_from([7, 30, 333, 10**6 + 3]), st.integers(0, 2))
def test_regions_provably_grow_and_shrink(polygon: Polygon, divisor: int, places: int) -> None:
    region = turned(polygon, divisor)
    grown, shrunk = (round_region(region, places, side) for side in ("outward", "inward"))
    assert grown.region is not None
    assert contains(grown.region, region)
    for found in (grown.region, shrunk.region):
        if found is not None:
            assert all((c * 10**places).denominator == 1 for v in found.vertices for c in v)
    if shrunk.region is not None:
        assert contains(region, shrunk.region)
        assert round_region(shrunk.region, places, "inward") == Rounded(
            (shrunk.region,), Fraction(0)
        )


@fewer
@given(strategies.simple_polygons(), strategies.simple_polygons())
def test_a_container_has_all_points_of_its_content(one: Polygon, other: Polygon) -> None:
    a, b = Region(one), Region(other)
    if contains(a, b):
        assert a.area >= b.area
        assert all(classify(a, tiny(v), (0, 0)).verdict != "FREE" for v in b.vertices)
    assert contains(a, a)


def tiny(v: Point) -> Polygon:
    by = Fraction(1, 10**6)
    return Polygon([(v.x - by, v.y - by), (v.x + by, v.y - by), (v.x, v.y + by)])


@fewer
@given(strategies.simple_polygons(), st.integers(0, 3))
@example(Polygon([(0, 0), (1, 0), (0, 1)]), 0)
def test_the_distance_between_old_and_new_rings_is_bounded(polygon: Polygon, places: int) -> None:
    region = turned(polygon, 77)
    found = round_region(region, places, "outward")
    assert found.region is not None
    for ring, other in ((region, found.region), (found.region, region)):
        for p in ring.exterior.vertices:
            edges = [(other.vertices[k - 1], other.vertices[k]) for k in range(len(other))]
            nearest = min(square_to_edge(p, *edge) for edge in edges)
            assert nearest <= found.distance**2


def test_the_hull_of_all_cells_is_the_last_resort(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("exactsweep.formats.rounding._is_proved", lambda *rings: False)
    region = Region([("0.5", "0.5"), ("3.5", 1), (4, "4.5"), (2, 2)])
    found = round_region(region, 0, "outward")
    assert found.region == Region([(0, 0), (1, 0), (4, 1), (4, 5), (0, 1)])
    assert contains(found.region, region)
    assert found.distance == Fraction(3, 2)


def square_to_edge(p: Point, a: Point, b: Point) -> Fraction:
    u, v, x, y = b.x - a.x, b.y - a.y, p.x - a.x, p.y - a.y
    t = min(max((u * x + v * y) / (u * u + v * v), Fraction(0)), Fraction(1))
    return (x - t * u) ** 2 + (y - t * v) ** 2


@pytest.mark.parametrize("places", [-1, MAX_PLACES + 1])
def test_places_beyond_the_limits_are_rejected(places: int) -> None:
    with pytest.raises(
        FormatError, match=f"^decimal places must be between 0 and 4000, not {places}$"
    ):
        round_region(Region(SQUARE), places, "closest")


@pytest.mark.parametrize("places", [0, MAX_PLACES])
def test_places_at_the_limits_are_allowed(places: int) -> None:
    assert round_region(Region(SQUARE), places, "closest").region == Region(SQUARE)


@fewer
@given(st.lists(st.tuples(*[st.integers(1, 18)] * 2), min_size=1, max_size=9, unique=True))
@example([(9, 10), (10, 9), (11, 10), (10, 11)])
@example([(9, 9), (10, 9), (11, 9), (9, 10), (11, 10), (9, 11), (10, 11), (11, 11)])
def test_free_regions_provably_shrink_where_holes_meet(corners: list[tuple[int, int]]) -> None:
    plate = [(0, 0), (20, 0), (20, 20), (0, 20)]
    low, high = Fraction(1, 300), Fraction(299, 300)
    square = [(low, low), (high, low), (high, high), (low, high)]
    region = Region(plate, [[(x + i, y + j) for x, y in square] for i, j in corners])
    found = round_region(region, 0, "inward")
    # Each hole grows to the cell around it.
    assert sum(part.area for part in found.regions) == 400 - len(corners)
    for part in found.regions:
        assert contains(region, part)
        assert all(c.denominator == 1 for v in part.vertices for c in v)


def test_holes_that_grow_out_of_a_region_cut_it() -> None:
    bar = Region(
        [(0, 0), (9, 0), (9, 3), (0, 3)],
        [[("4.5", "0.1"), ("4.6", "0.1"), ("4.6", "2.9"), ("4.5", "2.9")]],
    )
    left, right = round_region(bar, 0, "inward").regions
    assert (left, right) == (
        Region([(0, 0), (4, 0), (4, 3), (0, 3)]),
        Region([(5, 0), (9, 0), (9, 3), (5, 3)]),
    )
    with pytest.raises(FormatError, match="leaves 2 regions"):
        _ = round_region(bar, 0, "inward").region
