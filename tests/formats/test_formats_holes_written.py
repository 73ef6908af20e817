"""Polygons with holes survive writing and reading."""

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
    NamedPolygon,
    NamedRegion,
    format_polygons,
    from_shapely,
    parse_region,
    parse_regions,
    to_shapely,
)

HOLDING = ("json", "wkt", "geojson", "svg")


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
def test_exact_json_round_trips(region: Region, name: str | None) -> None:
    named = NamedRegion(region, name)
    assert parse_regions(format_polygons([named], "json")) == [named]
    assert parse_regions(format_polygons([named, named], "json")) == [named, named]


@pytest.mark.parametrize("form", HOLDING)
@examples(60)
@given(region=regions(DECIMAL), name=names)
def test_decimals_round_trip(form: str, region: Region, name: str | None) -> None:
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


def test_polygons_and_regions_without_holes_are_written_alike() -> None:
    ring = Region([(0, 0), (4, 0), (0, 4)])
    for form in (*HOLDING, "dxf"):
        assert format_polygons([ring], form) == format_polygons([ring.exterior], form)
        named = [NamedRegion(ring, "n", "l")], [NamedPolygon(ring.exterior, "n", "l")]
        assert format_polygons(named[0], form) == format_polygons(named[1], form)
