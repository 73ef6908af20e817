"""Polygons with holes are written so that they come back whole."""

import json
import xml.etree.ElementTree
from fractions import Fraction

import pytest
import shapely
from cells import Holed, shape_of
from hypothesis import given
from hypothesis import strategies as st
from shapes import SHEARS, cell_sets
from tiers import examples

from exactsweep import Region
from exactsweep.formats import (
    FormatError,
    NamedPolygon,
    NamedRegion,
    format_polygons,
    from_shapely,
    parse_region,
    parse_regions,
    round_regions,
    to_shapely,
)

HOLDING = ("json", "wkt", "geojson", "svg")
PLATE = Region([(0, 0), (4, 0), (4, 4), (0, 4)], [[(1, 1), (2, 1), (1, 2)]])
THIRD = Region(PLATE.exterior, [[(1, 1), ("4/3", 1), (1, 2)]])


@st.composite
def regions(draw: st.DrawFn, scales: tuple[Fraction, ...]) -> Region:
    """Polyominoes, many with holes and with rings that touch, sheared and scaled."""
    shape: Holed = shape_of(draw(cell_sets()))
    shape = shape.mapped(draw(st.sampled_from(SHEARS)), draw(st.sampled_from(scales)))
    return Region(shape.exterior, shape.holes)


DECIMAL = (Fraction(1), Fraction(3, 8), Fraction(10**30), Fraction(1, 10**30))
names = st.none() | st.sampled_from(["a", "b&<", "7"])


@examples(60)
@given(regions((*DECIMAL, Fraction(2, 3))), names)
def test_exact_json_comes_back_whole(region: Region, name: str | None) -> None:
    named = NamedRegion(region, name)
    assert parse_regions(format_polygons([named], "json")) == [named]
    assert parse_regions(format_polygons([named, named], "json")) == [named, named]


@pytest.mark.parametrize("form", HOLDING)
@examples(60)
@given(region=regions(DECIMAL), name=names)
def test_decimals_come_back_whole(form: str, region: Region, name: str | None) -> None:
    assert parse_region(format_polygons([region], form)) == region
    named = NamedRegion(region, None if form == "wkt" else name)
    other = NamedRegion(Region([(0, 0), (1, 0), (0, 1)]))
    assert parse_regions(format_polygons([named, other], form)) == [named, other]


@examples(60)
@given(regions(DECIMAL[:2]))
def test_holes_of_svg_do_not_depend_on_the_fill_rule(region: Region) -> None:
    text = format_polygons([region], "svg")
    assert parse_region(text.replace("evenodd", "nonzero")) == region


@examples(60)
@given(regions(DECIMAL[:2]))
def test_shapely_has_the_same_region(region: Region) -> None:
    made = to_shapely(region)
    assert made.is_valid
    assert Fraction(made.area) == region.area
    back = from_shapely(made)
    assert back == (region if region.holes else region.exterior)
    # shapely reads the same region from the text.
    for text, read in (("wkt", shapely.from_wkt), ("geojson", shapely.from_geojson)):
        assert read(format_polygons([region], text)).equals(made)


def test_what_is_written() -> None:
    assert json.loads(format_polygons([PLATE], "json")) == {
        "exterior": [["0", "0"], ["4", "0"], ["4", "4"], ["0", "4"]],
        "holes": [[["1", "1"], ["2", "1"], ["1", "2"]]],
    }
    assert format_polygons([PLATE], "wkt") == (
        "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1))\n"
    )
    ring = json.loads(format_polygons([PLATE], "geojson"))["geometry"]["coordinates"][1]
    # RFC 7946, 3.1.6: interior rings are clockwise.
    assert ring == [[1, 2], [2, 1], [1, 1], [1, 2]]
    drawing = xml.etree.ElementTree.fromstring(format_polygons([NamedRegion(PLATE, "p")], "svg"))
    assert drawing[0].attrib == {
        "id": "p", "fill-rule": "evenodd", "d": "M0,0 4,0 4,4 0,4z M1,2 2,1 1,1z",
    }  # fmt: skip


def test_without_holes_nothing_is_written_otherwise() -> None:
    for form in (*HOLDING, "dxf"):
        assert format_polygons([Region(PLATE.exterior)], form) == format_polygons(
            [PLATE.exterior], form
        )
        named = NamedRegion(Region(PLATE.exterior), "n", "l")
        assert format_polygons([named], form) == format_polygons(
            [NamedPolygon(PLATE.exterior, "n", "l")], form
        )


@pytest.mark.parametrize("form", ["wkt", "geojson", "svg", "dxf"])
def test_what_a_hole_cannot_be_is_named(form: str) -> None:
    message = "hole 0, vertex 1: 4/3 is not a finite decimal"
    with pytest.raises(FormatError, match=f"^polygon 1, {message}"):
        format_polygons([PLATE, THIRD], form)
    with pytest.raises(FormatError, match=f"^n, {message}"):
        format_polygons([NamedRegion(THIRD, "n")], form)
    with pytest.raises(FormatError, match=r"^hole 0, vertex 1: 4/3 is not a float"):
        to_shapely(THIRD)


def test_holes_are_rounded() -> None:
    (part,), changes = round_regions([NamedRegion(THIRD, "n")], 1, lambda one: "closest")
    assert (changes.changed, changes.left_out) == (1, 0)
    assert Fraction(1, 30) <= changes.distance < Fraction(1, 29)
    assert part == NamedRegion(Region(PLATE.exterior, [[(1, 1), ("1.3", 1), (1, 2)]]), "n")
    thin = NamedRegion(Region(PLATE.exterior, [[(1, 1), ("1.3", 1), ("1.3", "1.2")]]))
    with pytest.raises(ValueError, match=r"^rounded to 0 places: hole 0: "):
        round_regions([thin], 0, lambda one: "closest")
