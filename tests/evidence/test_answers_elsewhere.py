"""Answers in shapely and numpy, as formatted numbers, and as read-only values."""

import pickle
import subprocess
import sys
import warnings
from fractions import Fraction
from typing import Any

import numpy
import pytest
import shapely
from hypothesis import given
from polyominoes import polyominoes, region
from shapely.geometry import shape

import exactsweep
from exactsweep import (
    Polygon,
    PolygonError,
    Polyline,
    Region,
    free_positions,
    inner_fit_polygon,
    no_fit_polygon,
    overlap,
    sweep,
)
from exactsweep.formats import FormatError, from_shapely, to_shapely
from exactsweep.layout import Layout, LayoutError

UNIT = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
CAVE = [(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (3, 3), (3, 2), (4, 2), (4, 4), (0, 4)]
PLATE = Region([(0, 0), (9, 0), (9, 3), (0, 3)], [[(4, 1), (5, 1), (5, 2), (4, 2)]])


@given(polyominoes().map(region), polyominoes().map(region))
def test_the_area_of_an_answer_is_the_same_in_shapely(a: Region, b: Region) -> None:
    for answer in (no_fit_polygon(a, b), sweep(a, b), inner_fit_polygon(a, b)):
        made = to_shapely(answer, nearest=True)
        assert made.area == pytest.approx(float(answer.area))
        assert made.equals(shape(answer))


def test_exact_fits_become_lines_and_points() -> None:
    found = to_shapely(no_fit_polygon(CAVE, UNIT))
    assert [part.wkt for part in found.geoms] == [
        "POLYGON ((-1 -1, 4 -1, 4 4, -1 4, -1 -1), (1 1, 1 2, 2 2, 2 1, 1 1))",
        "LINESTRING (2 1, 4 1)",
    ]
    fits = to_shapely(inner_fit_polygon(PLATE, UNIT.scaled(3)))
    assert [part.wkt for part in fits.geoms] == ["LINESTRING (0 0, 1 0)", "LINESTRING (5 0, 6 0)"]
    assert to_shapely(inner_fit_polygon(UNIT, UNIT)).wkt == "GEOMETRYCOLLECTION (POINT (0 0))"


def test_an_answer_without_exact_fits_is_a_polygon() -> None:
    assert to_shapely(no_fit_polygon(UNIT, UNIT)).wkt == "POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))"
    assert Region(no_fit_polygon(UNIT, UNIT)).area == 4  # type: ignore[arg-type]
    free = free_positions(UNIT.scaled(4), [UNIT], UNIT)
    assert to_shapely(free).geom_type == "MultiPolygon"
    assert to_shapely(inner_fit_polygon(UNIT, UNIT.scaled(2))).is_empty
    around = to_shapely(sweep(UNIT, UNIT))
    assert (len(around.interiors), around.area) == (1, 8)


def test_paths_and_layouts_become_geometries() -> None:
    assert to_shapely(Polyline([(0, 0), (1, 0)])).wkt == "LINESTRING (0 0, 1 0)"
    assert to_shapely(Polyline([(1, 2)])).wkt == "POINT (1 2)"
    ring = Polyline([(0, 0), (1, 0), (0, 1)], closed=True)
    assert Polyline(to_shapely(ring), closed=True) == ring
    square = [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]]
    data: dict[str, Any] = {
        "parts": [{"id": "tile", "exterior": square}],
        "placements": [{"part": "tile", "turn": "90", "move": ["2", "0"]}],
    }
    assert to_shapely(Layout.from_json(data)).geoms[0].bounds == (1, 0, 2, 1)
    data["parts"][0]["exterior"] = [["0", "0"], ["1", "1"], ["1", "0"], ["0", "1"]]
    with pytest.raises(LayoutError, match="part 'tile': the boundary crosses itself"):
        to_shapely(Layout.from_json(data))


def test_a_coordinate_that_is_not_a_float_is_named() -> None:
    third = no_fit_polygon(UNIT, UNIT.translated(("1/3", 0)))
    with pytest.raises(FormatError, match=r"^vertex 0: -4/3 is not a float; nearest=True rounds"):
        to_shapely(Polygon(third.exterior))
    with pytest.raises(FormatError, match=r"^\(-4/3, -1\): -4/3 is not a float; nearest=True"):
        to_shapely(third)


def test_z_coordinates_are_dropped_with_a_warning_at_the_call() -> None:
    solid = shapely.Polygon([(0, 0, 5), (1, 0, 5), (0, 1, 5)])
    line = shapely.LineString([(0, 0, 5), (1, 0, 5)])
    for read, flat in ((Polygon, solid), (Region, solid), (Polyline, line), (from_shapely, solid)):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            read(flat)
        (warning,) = caught
        assert str(warning.message) == "Z coordinates are dropped: a sweep is planar"
        assert warning.filename == __file__


def test_arrays_of_shapes_have_a_row_for_each_vertex() -> None:
    assert numpy.asarray(UNIT, dtype=float).tolist() == [[0, 0], [1, 0], [1, 1], [0, 1]]
    assert numpy.asarray(PLATE).shape == (8, 2)


def test_areas_format_as_floats_and_stay_fractions() -> None:
    third = Polygon([(0, 0), ("2/3", 0), (0, 1)])
    o = overlap(third, third)
    for area in (third.area, Region(third).area, o.area, pickle.loads(pickle.dumps(third.area))):
        assert (area, repr(area), str(area)) == (Fraction(1, 3), "Fraction(1, 3)", "1/3")
    for area in (third.area, Region(third).area, o.area):
        assert f"{area:.3f}" == "0.333"
    for answer in (sweep(UNIT, UNIT), no_fit_polygon(UNIT, UNIT), inner_fit_polygon(PLATE, UNIT)):
        assert f"{answer.area:.1f}" == f"{float(answer.area):.1f}"


@pytest.mark.parametrize(
    ("answer", "name"),
    [
        (sweep(UNIT, UNIT), "reference"),
        (no_fit_polygon(UNIT, UNIT), "exterior"),
        (inner_fit_polygon(PLATE, UNIT), "placed"),
        (overlap(UNIT, UNIT), "a"),
    ],
)
def test_answers_are_read_only(answer: Any, name: str) -> None:
    before = getattr(answer, name)
    with pytest.raises(
        AttributeError, match=f"{name} cannot be set|cannot assign to field .{name}."
    ):
        setattr(answer, name, None)
    assert getattr(answer, name) == before
    twin = pickle.loads(pickle.dumps(answer))
    assert twin == answer
    assert getattr(twin, name) == before


def test_counts_in_the_repr_are_singular_for_one() -> None:
    assert repr(no_fit_polygon(CAVE, UNIT)).endswith("1 hole, 1 exact fit>")
    assert repr(inner_fit_polygon(UNIT, UNIT)).endswith("no regions, 1 exact fit>")


def test_a_single_placed_shape_is_rejected() -> None:
    with pytest.raises(PolygonError, match="placed is a single shape; give a list of shapes"):
        free_positions(UNIT, UNIT, UNIT)  # type: ignore[arg-type]


def test_public_packages_are_attributes() -> None:
    code = "import exactsweep as e; print(e.formats.__name__, e.check.verify.__name__)"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout == "exactsweep.formats verify\n"
    with pytest.raises(AttributeError, match="module 'exactsweep' has no attribute 'cli_'"):
        exactsweep.cli_  # type: ignore[attr-defined]  # noqa: B018
