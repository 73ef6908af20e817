"""Minkowski sums: known answers, laws, and the definition at single points."""

from collections import Counter
from fractions import Fraction
from itertools import pairwise, product
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes, region
from strategies import Ring, pairs, simple_rings
from tiers import examples

from exactsweep import Point, Polygon, PolygonError, Polyline, Region, minkowski_sum, no_fit_polygon
from exactsweep.check import point_in_polygon
from exactsweep.geometry.vectors import find_hull

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
Path = list[tuple[int, int]]
paths = st.lists(st.tuples(st.integers(-4, 4), st.integers(-4, 4)), min_size=1, max_size=6)


def box(left: int, low: int, right: int, high: int) -> list[tuple[int, int]]:
    return [(left, low), (right, low), (right, high), (left, high)]


def test_known_sums() -> None:
    assert minkowski_sum(SQUARE, SQUARE) == Region(box(0, 0, 4, 4))
    assert minkowski_sum(SQUARE, [(0, 0), (1, 0), (0, 1)]).area == 4 + 2 + 2 + Fraction(1, 2)
    # A frame, and squares smaller than its hole, equal to it and larger.
    frame = Region(box(0, 0, 6, 6), [box(2, 2, 4, 4)])
    assert minkowski_sum(frame, box(0, 0, 1, 1)) == Region(box(0, 0, 7, 7), [box(3, 3, 4, 4)])
    assert minkowski_sum(frame, SQUARE) == Region(box(0, 0, 8, 8))


@pytest.mark.parametrize(
    ("shape", "path", "corners", "area"),
    [
        ([(130, 150), (20, 40), (50, 60), (125, 100)], [(824, 627), (689, 555)], 6, 9255),
        (SQUARE, [(0, 0), (3, 0)], 4, 10),
        (SQUARE, [(5, 5)], 4, 4),
        (SQUARE, [(0, 0), (4, 0), (4, 4)], 6, 4 + 8 + 8),
        (SQUARE, [(0, 0), (3, 3), (0, 0)], 6, 4 + 12),
    ],
)
def test_known_sums_with_paths(shape: Path, path: Path, corners: int, area: Fraction | int) -> None:
    found = minkowski_sum(shape, Polyline(path))
    assert (len(found), found.area, found.holes) == (corners, area, ())
    assert minkowski_sum(Polyline(path), shape) == found


def test_a_path_around_leaves_a_hole() -> None:
    around = Polyline(box(0, 0, 9, 9), closed=True)
    assert minkowski_sum(SQUARE, around) == Region(box(0, 0, 11, 11), [box(2, 2, 9, 9)])
    # The open path leaves the same hole if the square closes the gap, and none otherwise.
    assert minkowski_sum(SQUARE, Polyline([*box(0, 0, 9, 9), (0, 2)])) == minkowski_sum(
        SQUARE, around
    )
    assert not minkowski_sum(SQUARE, Polyline([*box(0, 0, 9, 9), (0, 3)])).holes


def test_a_slot_as_wide_as_the_path_is_long_is_filled() -> None:
    """A fork, and a segment as long as its slot is wide: its positions in the slot are sums."""
    fork = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)]
    assert minkowski_sum(fork, Polyline([(0, 0), (2, 0)])) == Region(box(0, 0, 8, 6))
    narrower = minkowski_sum(fork, Polyline([(0, 0), (Fraction(3, 2), 0)]))
    assert narrower.area == Region(box(0, 0, 8, 6)).area - 3 - 2


def test_two_paths_have_no_sum() -> None:
    with pytest.raises(PolygonError, match="a and b are both paths"):
        minkowski_sum(Polyline([(0, 0)]), Polyline([(0, 0), (1, 1)]))
    with pytest.raises(PolygonError, match=r"^b: "):
        minkowski_sum(SQUARE, [(0, 0), (1, 1)])
    with pytest.raises(PolygonError, match=r"^b: "):
        minkowski_sum(Polyline([(0, 0)]), [(0, 0), (1, 1)])


@given(st.one_of(pairs("CC"), pairs("CM"), pairs("MM")))
@examples(30)
def test_sums_commute(pair: tuple[Polygon, Polygon]) -> None:
    a, b = pair
    assert minkowski_sum(a, b) == minkowski_sum(b, a)
    assert minkowski_sum(a, b).exterior == no_fit_polygon(a, b.reflected()).exterior


@given(polyominoes(9, 4), polyominoes(5, 3))
@examples(20)
def test_sums_of_cells_are_counted(a: Cells, b: Cells) -> None:
    matrix = (1, 0, 0, 1)
    cells = {
        (x + u + i, y + v + j) for (x, y), (u, v) in product(a, b) for i in (0, 1) for j in (0, 1)
    }
    assert minkowski_sum(region(a, matrix), region(b, matrix)).area == len(cells)


@given(simple_rings(), paths, st.booleans(), st.integers(-3, 3), st.integers(-3, 3))
@examples(20)
def test_sums_with_paths_move_with_both(d: Ring, path: Path, closed: bool, x: int, y: int) -> None:
    found = minkowski_sum(Polygon(d), Polyline(path, closed=closed))
    moved = Polyline([(u + x, v + y) for u, v in path], closed=closed)
    assert minkowski_sum(Polygon(d), moved) == found.translated((x, y))
    assert minkowski_sum(Polygon(d).translated((x, y)), Polyline(path, closed=closed)) == (
        found.translated((x, y))
    )
    assert Polyline(path[::-1], closed=closed) == Polyline(path, closed=closed) or (
        minkowski_sum(Polygon(d), Polyline(path[::-1], closed=closed)) == found
    )
    # A convex hull of sums is the sum of convex hulls.
    hull = find_hull(found.exterior.vertices)
    sums = [Point(p + u, q + v) for p, q in Polygon(d).vertices for u, v in path]
    assert hull == find_hull(sums)


def is_sum(p: Point, shape: Region, path: Polyline) -> bool:
    """Decide by the definition whether p - A and the path have a common point."""
    mirrored = shape.reflected().translated(p)
    rings = [mirrored.exterior.vertices, *(hole.vertices for hole in mirrored.holes)]

    def is_in(q: Point) -> bool:
        return point_in_polygon(q, mirrored.exterior) >= 0 and all(
            point_in_polygon(q, hole) <= 0 for hole in mirrored.holes
        )

    points = [*path.points, path.points[0]] if path.closed else [*path.points]
    if any(map(is_in, points)):
        return True
    edges = [edge for ring in rings for edge in pairwise((*ring, ring[0]))]
    return any(meet(step, edge) for step in pairwise(points) for edge in edges)


def meet(one: tuple[Point, Point], other: tuple[Point, Point]) -> bool:
    """Decide whether segments meet that do not begin or end inside the shape of the second one."""

    def side(a: Point, b: Point, c: Point) -> Fraction:
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)

    (a, b), (p, q) = one, other
    if max(a, b) < min(p, q) or max(p, q) < min(a, b):
        return False
    apart = side(a, b, p) * side(a, b, q), side(p, q, a) * side(p, q, b)
    if not any(apart) and side(a, b, p) == side(a, b, q) == 0:
        return True
    return max(apart) <= 0


def test_points_of_the_sum_match_the_definition() -> None:
    rng = Random(3)
    seen: Counter[tuple[bool, bool]] = Counter()
    plates = [
        Region(box(0, 0, 6, 6), [box(2, 2, 4, 4)]),
        Region(box(0, 0, 8, 8), [[(4, 0), (2, 5), (6, 5)]]),
        Region([(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)]),
        Region([(0, 0), (7, 2), (3, 3), (8, 8), (1, 5)]),
    ]
    for number in range(160):
        shape = plates[number % 4]
        size = rng.randint(1, 5)
        points = [(rng.randint(-4, 9), rng.randint(-4, 9)) for _ in range(size)]
        path = Polyline(points, closed=rng.random() < 0.4)
        found = minkowski_sum(shape, path)
        places = [
            Point(Fraction(rng.randint(-16, 60), 4), Fraction(rng.randint(-16, 60), 4))
            for _ in range(8)
        ]
        places += rng.sample(found.exterior.vertices, 2)
        places += [vertex for hole in found.holes for vertex in hole.vertices[:1]]
        for p in places:
            inside = is_sum(p, shape, path)
            expected = found.exterior.contains(p) or point_in_polygon(p, found.exterior) == 0
            expected = expected and not any(point_in_polygon(p, h) > 0 for h in found.holes)
            assert inside == expected, (shape, path, p)
            seen[inside, bool(found.holes)] += 1
    assert len(seen) == 4
    assert min(seen.values()) > 20
