"""Paths: accepted input, and equality."""

import copy
import pickle
from fractions import Fraction
from typing import Any

import pytest
import shapely

from exactsweep import NumberError, Point, PolygonError, Polyline


def test_points_are_exact_and_equal_neighbors_count_once() -> None:
    path = Polyline([(0, 0), ("0.5", 0.25), ("1/2", "1/4"), (0, 0)])
    assert path.points == (
        Point(Fraction(0), Fraction(0)),
        Point(Fraction(1, 2), Fraction(1, 4)),
        Point(Fraction(0), Fraction(0)),
    )
    assert not path.closed
    assert len(Polyline([(0, 0), (1, 0), (1, 1), (0, 0)], closed=True)) == 3
    assert len(Polyline([(3, 4), (3, 4)])) == 1


def test_paths_are_values() -> None:
    path: Any = Polyline([(0, 0), (2, 1)])
    third = Polyline([(Fraction(1, 3), -2)], closed=True)
    assert eval(repr(third)) == third
    assert path == Polyline(path) == Polyline([[0, "0"], (2.0, 1)])
    assert hash(path) == hash(Polyline(path))
    assert path != Polyline(path, closed=True) != Polyline([(2, 1), (0, 0)])
    assert path != [(0, 0), (2, 1)]
    for one in (pickle.loads(pickle.dumps(path)), copy.deepcopy(path)):
        assert one == path
    assert eval(repr(path)) == path
    with pytest.raises(AttributeError, match="cannot assign"):
        path.closed = True


def test_lines_and_points_of_shapely_are_paths() -> None:
    assert Polyline(shapely.Point(1, 2)) == Polyline([(1, 2)])
    assert Polyline(shapely.LineString([(0, 0), (1, 2)])) == Polyline([(0, 0), (1, 2)])
    ring = shapely.LinearRing([(0, 0), (1, 0), (0, 1)])
    assert Polyline(ring, closed=True) == Polyline([(0, 0), (1, 0), (0, 1)], closed=True)
    with pytest.raises(PolygonError, match="a Polygon is not a path"):
        Polyline(shapely.box(0, 0, 1, 1))


def test_dicts_of_geojson_are_paths() -> None:
    line: dict[str, Any] = {"type": "LineString", "coordinates": [[0, 0], [1, 2]]}
    assert Polyline(line) == Polyline([(0, 0), (1, 2)])
    assert Polyline({"type": "Feature", "geometry": line}) == Polyline(line)
    assert Polyline({"type": "Point", "coordinates": [1, 2]}) == Polyline([(1, 2)])
    high: Any = {**line, "coordinates": [[0, 0, 9], [1, 2, 9]]}
    with pytest.warns(UserWarning, match="Z coordinates are dropped"):
        assert Polyline(high) == Polyline(line)
    wrong: Any
    for wrong, match in (
        ({"type": "LineString"}, "a LineString without coordinates"),
        ({"type": "Polygon", "coordinates": []}, "a Polygon is not a path"),
        ({(0, 0): (1, 1)}, "dict is not a sequence of vertices"),
    ):
        with pytest.raises(PolygonError, match=match):
            Polyline(wrong)


def test_objects_other_than_paths_are_rejected() -> None:
    with pytest.raises(PolygonError, match="at least one point"):
        Polyline([])
    with pytest.raises(NumberError, match="vertex 1"):
        Polyline([(0, 0), (1, float("nan"))])
    with pytest.raises(PolygonError, match="set"):
        Polyline({(0, 0), (1, 1)})
