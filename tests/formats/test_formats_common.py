"""Variants written by other programs, and limits of readers."""

import csv
from fractions import Fraction
from itertools import pairwise
from unittest.mock import patch

import pytest
import shapely
from ezdxf.math import fit_points_to_cad_cv
from hypothesis import given, settings
from hypothesis import strategies as st
from test_formats_dxf import dxf, polyline

from exactsweep import Point, Polygon, limits
from exactsweep.formats import (
    FORMATS,
    FormatError,
    NamedPolygon,
    format_polygons,
    parse_polygon,
    parse_polygons,
    parse_regions,
    parts_from_shapely,
)
from exactsweep.formats import csv as formats_csv
from exactsweep.formats.curved.affine import IDENTITY
from exactsweep.formats.curved.spline import Spline
from exactsweep.formats.parsing import measure_written
from exactsweep.formats.reading import Reading
from exactsweep.formats.size import ELEMENT

UNIT = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])


def test_entities_beyond_the_limit_are_rejected() -> None:
    text = f'<!DOCTYPE svg [<!ENTITY a "{"x" * 200}">]><svg>{"&a;" * 100_000}</svg>'
    with pytest.raises(FormatError, match="the entity 'a' expands to more than 16 MiB"):
        parse_polygons(text)


def test_shapely_geometries_are_parts() -> None:
    plate = shapely.box(0, 0, 4, 4) - shapely.box(1, 1, 2, 2)
    several = shapely.MultiPolygon([plate, shapely.box(5, 0, 6, 1)])
    assert [part.region.area for part in parts_from_shapely(several)] == [15, 1]
    mixed = shapely.GeometryCollection([several, shapely.Point(0, 0), shapely.box(0, 0, 1, 1)])
    found = parts_from_shapely([mixed, several])
    assert [part.region.area for part in found] == [15, 1, 1, 15, 1]
    assert found.left_out == ["Point is not a shapely polygon"]

    class GeoSeries(dict[int, object]):
        """Like a series of geopandas, with a `geom_type`."""

        geom_type = ("MultiPolygon",)

    named = parts_from_shapely(GeoSeries({7: several}))
    assert [part.name for part in named] == ["7", "7"]
    with pytest.raises(FormatError, match="Point is not a shapely polygon"):
        parts_from_shapely([shapely.Point(0, 0)])


coordinates = st.integers(-50, 50).map(float)


@given(st.lists(st.tuples(coordinates, coordinates), min_size=2, max_size=12))
@settings(max_examples=60)
def test_interpolating_splines_agree_with_ezdxf(points: list[tuple[float, float]]) -> None:
    distinct = [p for p, q in zip(points, [None, *points], strict=False) if p != q]
    if len(distinct) < 2:
        return
    spline = Spline.through([Point(Fraction(x), Fraction(y)) for x, y in points])
    spline.validate()
    ours = [(float(p.x), float(p.y)) for piece, _ in spline.pieces() for p in piece]
    theirs = [
        (v.x, v.y) for piece in fit_points_to_cad_cv(distinct).bezier_decomposition() for v in piece
    ]
    for (a, b), (c, d) in zip(ours, theirs, strict=True):
        assert abs(a - c) + abs(b - d) < 1e-6


def test_interpolating_splines_need_linear_memory() -> None:
    """A full matrix took 6 GB."""
    points = [Point(Fraction(k), Fraction(k * k % 17)) for k in range(16_000)]
    assert len(Spline.through(points).points) == 3 * 16_000 - 2


def test_bezier_pieces_of_high_degree_lie_on_the_curve() -> None:
    controls = [Point(Fraction(k), Fraction(k * k % 7)) for k in range(14)]
    knots = [Fraction(k) for k in [0] * 12 + [2, 5] + [6] * 12]
    spline = Spline(11, controls, knots)
    spline.validate()
    pieces = [points for points, _ in spline.pieces()]
    assert pieces[0][0] == controls[0]
    assert pieces[-1][-1] == controls[-1]
    for one, other in pairwise(pieces):
        assert one[-1] == other[0]
    # The same curve in weights that are all 1.
    weighted = Spline(11, controls, knots, [Fraction(2)] * 14)
    assert [points for points, _ in weighted.pieces()] == pieces
    assert len(spline.draw(IDENTITY).flatten(Reading("1/100"))) > 10


def test_names_of_invalid_utf_8_are_rejected() -> None:
    with pytest.raises(FormatError, match=r"the name 'left\\udcff' is not valid UTF-8"):
        format_polygons([NamedPolygon(UNIT, "left\udcff")], "csv")


def test_tables_are_charged_by_line() -> None:
    assert measure_written("id,x,y\na,0,0\na,1,0\na,0,1\n") == 4 * 16
    assert measure_written("x,y\n0,0\n1,0\n0,1\n") == 4 * 16
    assert measure_written("<svg>" + "<g/>" * 9) == 10 * ELEMENT


@pytest.mark.parametrize(
    "text",
    [
        *(format_polygons([NamedPolygon(UNIT, "a")] * 2, form) for form in FORMATS),
        dxf(*([polyline((0, 0), (1, 0), (0, 1))] * 5)),
    ],
)
def test_text_fits_its_measured_limit(text: str) -> None:
    with limits(max_mib=measure_written(text) / 2**20):
        assert parse_regions(text)


def test_csv_readers_in_other_threads_keep_their_limit() -> None:
    before = csv.field_size_limit()
    held: list[int] = []
    with patch.object(formats_csv, "_parse", lambda text: held.append(csv.field_size_limit())):
        for length in (3, before + 1):
            formats_csv.parse_csv(length * "1")
    assert [*held, csv.field_size_limit()] == [before, before + 1, before]


@pytest.mark.parametrize("corners", ["0,0 {},0 0,1", "-1,0 {},0 0,1", "1,0 -{},0 0,1"])
def test_coordinates_that_are_too_long_are_rejected(corners: str) -> None:
    """The limit is 32 times that of a number, and 7 digits more."""
    shape = f'<polygon points="{corners.format("9" * 19)}"/>'
    group = "<g transform='scale(1e19)'>"
    scaled = {n: f"<svg>{group * n}{shape}{'</g>' * n}</svg>" for n in (33, 34)}
    with limits(max_digits=20):
        assert parse_polygon(scaled[33])
        with pytest.raises(FormatError, match=r"has more than 647 digits \(max_digits\)$"):
            parse_polygon(scaled[34])
