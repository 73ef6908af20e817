"""Common spellings of other programs, some of them once refused or too slow."""

from fractions import Fraction
from itertools import pairwise

import pytest
import shapely
from ezdxf.math import fit_points_to_cad_cv
from hypothesis import given, settings
from hypothesis import strategies as st
from test_formats_dxf import dxf, polyline

from exactsweep import Point, Polygon, PolygonError, Region, limits
from exactsweep.formats import (
    FORMATS,
    FormatError,
    NamedPolygon,
    format_polygons,
    from_wkt,
    parse_polygon,
    parse_polygons,
    parse_regions,
    parts_from_shapely,
)
from exactsweep.formats.curved.affine import IDENTITY
from exactsweep.formats.curved.spline import Spline
from exactsweep.formats.parsing import measure_written
from exactsweep.formats.reading import Reading

UNIT = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
RING = "((0 0, 1 0, 1 1, 0 1, 0 0))"


def test_short_entities_are_names() -> None:
    text = (
        '<!DOCTYPE svg [<!ENTITY ns_svg "http://www.w3.org/2000/svg"><!ENTITY one "1">]>'
        '<svg xmlns="&ns_svg;"><rect width="&one;" height="&one;"/></svg>'
    )
    assert parse_polygon(text) == UNIT


@pytest.mark.parametrize(
    "declared", ['<!ENTITY a "b"><!ENTITY b "&a;">', f'<!ENTITY b "{"x" * 201}">']
)
def test_entities_that_could_grow_are_refused(declared: str) -> None:
    with pytest.raises(FormatError, match="declares the entity 'b', which is not expanded"):
        parse_polygons(f"<!DOCTYPE svg [{declared}]><svg>&b;</svg>")


def test_entities_that_draw_too_much_are_refused() -> None:
    text = f'<!DOCTYPE svg [<!ENTITY a "{"x" * 200}">]><svg>{"&a;" * 100_000}</svg>'
    with pytest.raises(FormatError, match="the entity 'a' draws more than 16 MiB"):
        parse_polygons(text)


def test_percentages_are_of_the_view_around() -> None:
    view = 'x="10%" width="50%" height="50%" viewBox="0 0 10 10"'
    inner = f'<svg {view}><rect width="100%" height="1"/>'
    (part,) = parse_polygons(f"<svg viewBox='0 0 40 20'>{inner}</svg></svg>")
    # A view of 20 by 10 at x = 4, in which the smaller scale, 1, leaves 5 at either side.
    assert part.polygon == Polygon([(9, 0), (19, 0), (19, 1), (9, 1)])
    (whole,) = parse_polygons("<svg width='6' height='8'><rect width='50%' height='25%'/></svg>")
    assert whole.polygon == UNIT.scaled((3, 2))
    with pytest.raises(FormatError, match="width: a percentage of what is not given"):
        parse_polygon("<svg width='100%'><rect width='50%' height='1'/></svg>")
    with pytest.raises(FormatError, match="r: a percentage"):
        parse_polygon("<svg viewBox='0 0 3 4'><circle r='50%'/></svg>", tolerance=1)


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("POLYGON Z ((0 0 5, 1 0 5, 1 1 5, 0 1 5, 0 0 5))", 1),
        (f"SRID=4326;POLYGON {RING}", 1),
        (f"GEOMETRYCOLLECTION (POLYGON {RING}, MULTIPOLYGON ({RING}, {RING}))", 3),
        (f"geometrycollection(polygon {RING}, GEOMETRYCOLLECTION(POLYGON {RING}))", 2),
        (f"id;WKT\n7;POLYGON {RING}", 1),
        (f'geometry,name\n"POLYGON {RING}",a\n"MULTIPOLYGON ({RING},{RING})",b', 3),
        ("x;y\n0,0;0\n1,0;0\n1;1,0\n0;1", 1),
        ("0,0;0,0\n1,0;0,0\n1,0;1,0\n0,0;1,0\n", 1),
    ],
)
def test_common_texts_are_read(text: str, number: int) -> None:
    assert [part.polygon for part in parse_polygons(text)] == [UNIT] * number


def test_decimal_commas_are_exact() -> None:
    text = "name;x;y\na;0,1;0\na;2,5;-1,25\na;1e1;3"
    (part,) = parse_polygons(text)
    assert part.name == "a"
    assert part.polygon == Polygon([("0.1", 0), ("2.5", "-1.25"), (10, 3)])


def test_tables_of_wkt_name_polygons_and_rows() -> None:
    rows = f'name,wkt\na,"POLYGON {RING}"\nb,"POLYGON ((0 0, 1 0, 0 0))"\nc,"POINT (1 2)"\nd,no\n'
    found = parse_polygons(rows)
    assert [part.name for part in found] == ["a"]
    assert [reason.partition(":")[0] for reason in found.left_out] == ["line 3", "line 4", "line 5"]


def test_a_column_that_is_there_twice_is_refused() -> None:
    with pytest.raises(FormatError, match=r"^line 1: two columns 'x'$"):
        parse_polygons("x,y,X\n0,0,0\n1,0,0\n0,1,0\n")


def test_geometries_of_shapely_are_parts() -> None:
    plate = shapely.box(0, 0, 4, 4) - shapely.box(1, 1, 2, 2)
    several = shapely.MultiPolygon([plate, shapely.box(5, 0, 6, 1)])
    assert [part.region.area for part in parts_from_shapely(several)] == [15, 1]
    mixed = shapely.GeometryCollection([several, shapely.Point(0, 0), shapely.box(0, 0, 1, 1)])
    found = parts_from_shapely([mixed, several])
    assert [part.region.area for part in found] == [15, 1, 1, 15, 1]
    assert found.left_out == ["Point is not a polygon of shapely"]

    class GeoSeries(dict[int, object]):
        """A series of geopandas has a type, too."""

        geom_type = ("MultiPolygon",)

    named = parts_from_shapely(GeoSeries({7: several}))
    assert [part.name for part in named] == ["7", "7"]
    with pytest.raises(FormatError, match="Point is not a polygon"):
        parts_from_shapely([shapely.Point(0, 0)])


def test_from_wkt_reads_one_polygon() -> None:
    assert from_wkt(f"POLYGON {RING}") == UNIT
    holed = from_wkt("POLYGON ((0 0, 9 0, 0 9, 0 0), (1 1, 2 1, 1 2, 1 1))")
    assert isinstance(holed, Region)
    with pytest.raises(FormatError, match="holds 2 polygons"):
        from_wkt(f"POLYGON {RING} POLYGON {RING}")
    with pytest.raises(PolygonError):
        from_wkt("POLYGON ((0 0, 1 1, 2 2, 0 0))")


@pytest.mark.parametrize(("radius", "tolerance"), [("1e4000", 1), (1, "1e-700")])
def test_curves_beyond_floats_are_refused(radius: object, tolerance: object) -> None:
    circle = f'<circle r="{radius}"/>'
    parts = parse_polygons(f'<svg>{circle}<rect width="1" height="1"/></svg>', tolerance)
    assert [part.polygon for part in parts] == [UNIT]
    assert "would become more than 10**12 lines" in parts.left_out[0]


coordinates = st.integers(-50, 50).map(float)


@given(st.lists(st.tuples(coordinates, coordinates), min_size=2, max_size=12))
@settings(max_examples=60)
def test_splines_through_points_are_those_of_ezdxf(points: list[tuple[float, float]]) -> None:
    distinct = [p for p, q in zip(points, [None, *points], strict=False) if p != q]
    if len(distinct) < 2:
        return
    spline = Spline.through([Point(Fraction(x), Fraction(y)) for x, y in points])
    spline.require_sound()
    ours = [(float(p.x), float(p.y)) for piece, _ in spline.pieces() for p in piece]
    theirs = [
        (v.x, v.y) for piece in fit_points_to_cad_cv(distinct).bezier_decomposition() for v in piece
    ]
    for (a, b), (c, d) in zip(ours, theirs, strict=True):
        assert abs(a - c) + abs(b - d) < 1e-6


def test_splines_take_memory_as_their_points() -> None:
    """With a matrix of all points, these took 6 GB."""
    points = [Point(Fraction(k), Fraction(k * k % 17)) for k in range(16_000)]
    assert len(Spline.through(points).points) == 3 * 16_000 - 2


def test_pieces_of_high_degree_are_values_of_the_curve() -> None:
    controls = [Point(Fraction(k), Fraction(k * k % 7)) for k in range(14)]
    knots = [Fraction(k) for k in [0] * 12 + [2, 5] + [6] * 12]
    spline = Spline(11, controls, knots)
    spline.require_sound()
    pieces = [points for points, _ in spline.pieces()]
    assert pieces[0][0] == controls[0]
    assert pieces[-1][-1] == controls[-1]
    for one, other in pairwise(pieces):
        assert one[-1] == other[0]
    # The same curve in weights that are all 1.
    weighted = Spline(11, controls, knots, [Fraction(2)] * 14)
    assert [points for points, _ in weighted.pieces()] == pieces
    assert len(spline.flatten(IDENTITY, Reading("1/100"))) > 10


def test_names_that_are_no_utf_8_are_named() -> None:
    with pytest.raises(FormatError, match=r"the name 'left\\udcff' is no UTF-8"):
        format_polygons([NamedPolygon(UNIT, "left\udcff")], "csv")


def test_a_table_counts_for_its_lines() -> None:
    assert measure_written("id,x,y\na,0,0\na,1,0\na,0,1\n") == 4 * 16


@pytest.mark.parametrize(
    "text",
    [
        *(format_polygons([NamedPolygon(UNIT, "a")] * 2, form) for form in FORMATS),
        dxf(*([polyline((0, 0), (1, 0), (0, 1))] * 5)),
    ],
)
def test_a_text_is_read_where_what_it_counts_for_is_allowed(text: str) -> None:
    with limits(max_mib=measure_written(text) / 2**20):
        assert parse_regions(text)
