"""Polygons and Regions as sequences and as sets; affine maps; conversion to other libraries."""

import copy
import json
import pickle
from collections.abc import Callable
from fractions import Fraction
from itertools import chain
from types import SimpleNamespace
from typing import Any

import pytest
import shapely
import shapely.geometry
import strategies
from hypothesis import given
from hypothesis import strategies as st
from polyominoes import polyominoes, region

from exactsweep import Point, Polygon, PolygonError, Region
from exactsweep.check.location import point_in_polygon
from exactsweep.geometry.point_set import AffineMap
from exactsweep.geometry.region import AnyPolygon

PLATE = Region(
    [(0, 0), (9, 0), (9, 9), (0, 9)], [[(5, 5), (8, 5), (5, 8)], [(1, 1), (3, 1), (1, 2)]]
)
TRIPLES = [(3, 4), (-4, 3), (5, -12), ("3/5", "4/5"), (Fraction(20, 7), 3)]
SHAPES = strategies.simple_polygons() | polyominoes().map(region)


def turns() -> st.SearchStrategy[Any]:
    return st.sampled_from([0, 90, 180, 270, -90, 450, "90", *TRIPLES])


def given_features(shape: AnyPolygon) -> dict[tuple[str, int], set[Point]]:
    """Return the vertices and edges by their numbers in the input."""
    found: dict[tuple[str, int], set[Point]] = {}
    first = 0
    for ring in shape.rings:
        for k, vertex in enumerate(ring):
            found["vertex", shape.vertex_index(first + k)] = {vertex}
            found["edge", shape.edge_index(first + k)] = {vertex, ring[(k + 1) % len(ring)]}
        first += len(ring)
    return found


def affine(*places: list[Point]) -> Callable[[Point], Point]:
    """Return the affine map defined by three points, not collinear, and their images."""
    (p,), (q,), (r,), (a,), (b,), (c,) = places
    ux, uy, vx, vy = q.x - p.x, q.y - p.y, r.x - p.x, r.y - p.y
    area = ux * vy - uy * vx

    def mapped(point: Point) -> Point:
        x, y = point.x - p.x, point.y - p.y
        m, n = (x * vy - y * vx) / area, (ux * y - uy * x) / area
        return Point(
            a.x + m * (b.x - a.x) + n * (c.x - a.x), a.y + m * (b.y - a.y) + n * (c.y - a.y)
        )

    return mapped


@given(SHAPES)
def test_a_shape_is_the_sequence_of_its_vertices(shape: AnyPolygon) -> None:
    assert list(shape) == list(shape.vertices) == [shape[k] for k in range(len(shape))]
    assert shape[-1] == shape.vertices[-1]
    assert shape[1:3] == shape.vertices[1:3]
    for x, y in shape:
        assert (x, y) in shape
    with pytest.raises(IndexError):
        shape[len(shape)]


@given(SHAPES, strategies.translations(), st.data())
def test_contained_points_match_the_definition(
    shape: AnyPolygon, point: tuple[Fraction, Fraction], data: st.DataObject
) -> None:
    k = data.draw(st.integers(0, len(shape.rings[0]) - 1))
    (ax, ay), (bx, by) = shape.rings[0][k - 1], shape.rings[0][k]
    aside = ((ax + bx) / 2, (ay + by) / 2)
    low, high = shape.bounding_box
    middle = ((low.x + high.x) / 2, (low.y + high.y) / 2)
    for asked in (point, aside, middle, (ax, by)):
        where = point_in_polygon(asked, shape)
        assert shape.contains(asked) == (asked in shape) == (where >= 0)
        assert shape.contains(asked, strictly=True) == (where > 0)


@given(SHAPES, turns(), st.sampled_from([1, -2, "1/3", (2, "-1/2")]), strategies.translations())
def test_a_map_keeps_the_numbering_of_features(
    shape: AnyPolygon, turn: Any, factor: Any, center: tuple[Fraction, Fraction]
) -> None:
    axis = turn if isinstance(turn, tuple) else (1, 2)
    images = [
        shape.rotated(turn, center),
        shape.scaled(factor, center),
        shape.mirrored(axis, center),
        shape.reflected(center),
        shape.translated(center),
    ]
    before = given_features(shape)
    for image in images:
        after = given_features(image)
        assert after.keys() == before.keys()
        names = [("vertex", shape.vertex_index(k)) for k in (0, 1, len(shape.rings[0]) - 1)]
        mapped = affine(*([*features[name]] for features in (before, after) for name in names))
        for name, places in before.items():
            assert {mapped(place) for place in places} == after[name]
        exterior, *holes = ([*map(mapped, ring)] for ring in shape.rings)
        assert Region(image) == Region(exterior, holes)


@given(SHAPES, turns(), strategies.translations())
def test_rotations_and_reflections_are_invertible(
    shape: AnyPolygon, turn: Any, center: tuple[Fraction, Fraction]
) -> None:
    turned = shape.rotated(turn, center)
    assert turned.area == shape.area
    mirrored = turned.mirrored((0, 1), center)
    assert mirrored.rotated(turn, center).mirrored((0, 1), center) == shape
    assert shape.rotated(180, center) == shape.reflected(center) == shape.scaled(-1, center)
    assert shape.rotated((0, 7)) == shape.rotated(90)
    assert shape.mirrored((1, 0)).mirrored((0, 1)) == shape.reflected()


def test_maps_are_about_the_origin_by_default() -> None:
    corners = [(1, 1), (3, 1), (1, 2)]
    triangle = Polygon(corners)
    for image, expected in [
        (triangle.rotated(0), corners),
        (triangle.rotated(90), [(-y, x) for x, y in corners]),
        (triangle.rotated(180), [(-x, -y) for x, y in corners]),
        (triangle.rotated(270), [(y, -x) for x, y in corners]),
        (triangle.rotated(-90), [(y, -x) for x, y in corners]),
        (triangle.scaled(2), [(2 * x, 2 * y) for x, y in corners]),
        (triangle.scaled((2, -3)), [(2 * x, -3 * y) for x, y in corners]),
        (triangle.reflected(), [(-x, -y) for x, y in corners]),
        (triangle.mirrored(), [(-x, y) for x, y in corners]),
        (triangle.mirrored((1, 0)), [(x, -y) for x, y in corners]),
    ]:
        assert image == Polygon(expected)


def test_unrelated_denominators_are_mapped_exactly() -> None:
    long = [Fraction(1, 10**3000 + k) for k in (7, 9, 33)]
    zero = Fraction(0)
    corners = [(5 + long[0], zero), (9 + zero, long[1]), (zero, 7 + long[2])]
    polygon = Polygon(corners)
    assert polygon.lattice()[0] == 1
    moved = polygon.translated(("1/3", "2/3"))
    assert moved == Polygon([(x + Fraction(1, 3), y + Fraction(2, 3)) for x, y in corners])
    assert moved.lattice() == (1, moved.vertices)
    turned = polygon.rotated(90)
    assert turned == Polygon([(-y, x) for x, y in corners])
    assert turned.lattice() == (1, turned.vertices)


@given(SHAPES)
def test_the_interface_of_other_libraries_loses_nothing(shape: AnyPolygon) -> None:
    source: Any = SimpleNamespace(__geo_interface__=shape.__geo_interface__)
    feature: Any = SimpleNamespace(
        __geo_interface__={"type": "Feature", "geometry": shape.__geo_interface__}
    )
    assert Region(source) == Region(feature) == Region(shape)
    if isinstance(shape, Polygon):
        assert Polygon(source) == shape
    rings = shape.__geo_interface__["coordinates"]
    assert all(ring[0] == ring[-1] for ring in rings)


def test_shapes_round_trip_through_shapely() -> None:
    hollow = shapely.geometry.shape(PLATE)
    assert hollow.area == PLATE.area == Fraction(151, 2)
    assert shapely.is_ccw(hollow.exterior)
    assert not any(map(shapely.is_ccw, hollow.interiors))
    assert Region(hollow) == PLATE
    assert Polygon(hollow.exterior) == PLATE.exterior
    thirds = Polygon([(0, 0), ("1/3", 0), (0, "1/2")])
    assert shapely.geometry.shape(thirds).area == pytest.approx(1 / 12)
    assert json.dumps(PLATE.__geo_interface__).startswith('{"type": "Polygon", "coordinates": [[[0')
    with pytest.raises(TypeError, match="Fraction"):
        json.dumps(thirds.__geo_interface__)


@pytest.mark.parametrize(
    ("shape", "message"),
    [
        (shapely.box(0, 0, 9, 9) - shapely.box(1, 1, 2, 2), "the polygon has holes; use a Region"),
        (shapely.LineString([(0, 0), (1, 1), (2, 0)]), "a LineString is not a polygon"),
        (shapely.MultiPolygon([shapely.box(0, 0, 1, 1)]), "a MultiPolygon is not a polygon"),
        (shapely.Polygon(), "the polygon is empty"),
        (PLATE, "the polygon has holes; use a Region"),
        *(
            (
                SimpleNamespace(__geo_interface__={"type": "Polygon", "coordinates": source}),
                "a Polygon without rings is not a polygon",
            )
            for source in (None, 5, [5], [[(0, 0), (1, 0), (0, 1)], None], {0: [(0, 0)]})
        ),
    ],
)
def test_foreign_objects_other_than_polygons_are_rejected(shape: Any, message: str) -> None:
    with pytest.raises(PolygonError, match=message):
        Polygon(shape)


def test_a_copy_of_a_region_keeps_the_numbers_of_the_input() -> None:
    assert PLATE.holes[0].vertices[0] == strategies.points((1, 1))[0]
    assert PLATE.vertex_index(4) == 7
    for twin in (copy.copy(PLATE), copy.deepcopy(PLATE), pickle.loads(pickle.dumps(PLATE))):
        assert twin == PLATE
        assert given_features(twin) == given_features(PLATE)


def test_exact_floats_are_floats_in_geojson() -> None:
    x, y, z = Fraction(1, 2), Fraction(1, 3), Fraction(10**400 + 1, 2)
    (ring,) = Polygon([(0, 0), (x, 0), (y, z)]).__geo_interface__["coordinates"]
    assert [*map(repr, chain.from_iterable(ring))] == [*map(repr, [0, 0, 0.5, 0, y, z, 0, 0])]


def test_a_map_about_a_point_fixes_it() -> None:
    a, b, c, d, x, y = map(Fraction, (2, 3, 5, 7, 11, 13))
    moved = AffineMap(a, b, c, d).about((x, y))
    assert moved[:4] == (a, b, c, d)
    assert (a * x + b * y + moved.dx, c * x + d * y + moved.dy) == (x, y)
