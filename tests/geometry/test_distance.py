"""Distances of shapes, compared with all pairs of edges and with known answers."""

from fractions import Fraction
from itertools import product

import pytest
from cells import Holed
from hypothesis import given
from shapes import shape_pairs
from strategies import points, translations
from tiers import examples

from exactsweep import Point, PolygonError, Region, distance_squared
from exactsweep.check import classify, point_in_polygon

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]


def squared(p: Point, q: Point) -> Fraction:
    return (p.x - q.x) ** 2 + (p.y - q.y) ** 2


def edges(shape: Region) -> list[tuple[Point, Point]]:
    return [(ring[k - 1], p) for ring in shape.rings for k, p in enumerate(ring)]


def from_edge(p: Point, a: Point, b: Point) -> Fraction:
    """Return the squared distance of a point from a segment."""
    dx, dy = b.x - a.x, b.y - a.y
    along = ((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy)
    along = min(max(along, Fraction(0)), Fraction(1))
    return squared(p, Point(a.x + along * dx, a.y + along * dy))


def by_all_pairs(one: Region, other: Region) -> Fraction:
    """Compute the squared distance of disjoint shapes by the definition."""
    return min(
        from_edge(p, *side)
        for shape, sides in ((one, edges(other)), (other, edges(one)))
        for p, side in product(shape.vertices, sides)
    )


def region(shape: Holed) -> Region:
    return Region(shape.exterior, shape.holes)


@examples(60)
@given(shape_pairs(), translations())
def test_the_distance_is_the_minimum_over_pairs_of_edges(
    pair: tuple[Holed, Holed], by: tuple[Fraction, Fraction]
) -> None:
    one, other = region(pair[0]), region(pair[1]).translated(by)
    value, (p, q) = distance_squared(one, other)
    assert value == squared(p, q)
    assert point_in_polygon(p, one) >= 0 <= point_in_polygon(q, other)
    apart = classify(one, other, (0, 0)).verdict == "FREE"
    assert value == (by_all_pairs(one, other) if apart else 0)
    assert distance_squared(other, one).value == value


@pytest.mark.parametrize(
    ("other", "value", "nearest"),
    [
        # A corner before an edge, a corner before a corner, parallel edges.
        ([(2, -1), (3, 0), (2, 3)], 1, None),
        ([(4, 5), (6, 5), (6, 6)], 25, points((1, 1), (4, 5))),
        ([(1, 3), (4, 0), (4, 3)], 2, points((1, 1), (2, 2))),
        # A common corner, overlapping edges, edges in the same direction, a crossing.
        ([(1, 1), (2, 1), (2, 2)], 0, points((1, 1), (1, 1))),
        ([(1, "1/2"), (2, 0), (2, 3)], 0, points((1, "1/2"), (1, "1/2"))),
        ([(0, 0), (1, 0), (1, 3), (0, 3)], 0, None),
        ([("1/2", -1), (3, -1), ("1/2", 3)], 0, None),
        ([(-1, -1), (5, 3), (-1, 4)], 0, None),
        ([(2, "1/3"), (-1, "2/3"), (-1, "1/2")], 0, None),
        # One contains the other.
        ([(-9, -9), (9, -9), (9, 9), (-9, 9)], 0, None),
        ([("1/4", "1/4"), ("1/2", "1/4"), ("1/4", "1/2")], 0, None),
        ([("4/5", "3/4"), ("5/6", "3/4"), ("4/5", "5/6")], 0, None),
    ],
)
def test_known_distances(
    other: list[tuple[object, object]], value: int, nearest: tuple[Point, ...] | None
) -> None:
    found = distance_squared(SQUARE, other)
    assert found.value == value
    if nearest is not None:
        assert found.points == nearest
    p, q = found.points
    assert squared(p, q) == value
    assert point_in_polygon(p, Region(SQUARE)) >= 0 <= point_in_polygon(q, Region(other))


def test_a_shape_in_a_hole_does_not_meet_the_shape_around_it() -> None:
    around = Region([(-9, -9), (9, -9), (9, 9), (-9, 9)], [[(-2, -3), (5, -3), (5, 5), (-2, 5)]])
    assert distance_squared(around, SQUARE).value == 4
    assert distance_squared(SQUARE, around).value == 4


def test_coordinates_without_a_common_lattice() -> None:
    one = [(0, 0), (Fraction(1, 2**5001), 0), (0, 1)]
    other = [(3, 0), (4, 0), (3, Fraction(1, 3**3500))]
    assert distance_squared(one, other).value == (3 - Fraction(1, 2**5001)) ** 2


def test_errors_name_the_argument() -> None:
    with pytest.raises(PolygonError, match=r"^b: "):
        distance_squared(SQUARE, [(0, 0), (1, 1)])


def test_distant_edges_are_not_compared(monkeypatch: pytest.MonkeyPatch) -> None:
    # Two adjacent combs: 400 edges each, of which few are opened.
    from exactsweep.geometry import distance

    def comb(left: int, right: int) -> list[tuple[int, int]]:
        teeth = ((right if k % 2 else left + 1, 2 * k) for k in range(401))
        return [*teeth, (left, 800), (left, 0)]

    asked = 0
    measure = distance._measure_boxes

    def counted(*boxes: distance._EdgeBox) -> object:
        nonlocal asked
        asked += 1
        return measure(*boxes)

    monkeypatch.setattr(distance, "_measure_boxes", counted)
    assert distance_squared(comb(0, 40), [(100 - x, y + 9) for x, y in comb(0, 40)]).value > 0
    assert asked < 10_000
