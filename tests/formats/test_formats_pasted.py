"""Pasted vertices, instances of nesting programs, and formats that are rejected by name."""

import json
import re
from fractions import Fraction

import pytest

from exactsweep.formats import FormatError, parse_polygon, parse_polygons, parse_regions

TRIANGLE = [
    "(0,0), (2,0), (0,3)",
    "[(0, 0), (2, 0), (0, 3),]",
    "{{0,0},{2,0},{0,3}};",
    "{ {0, 0}, {2, 0}, {0, 3} }",
    "0 0\n2 0\n0 3\n",
    "0, 0\n2, 0\n0, 3",
    "3 0 0 2 0 0 3",
    '{"points": [[0, 0], [2, 0], [0, 3]]}',
    '{"polygon": [[0, 0], [2, 0], [0, 3]]}',
]


@pytest.mark.parametrize("text", TRIANGLE)
def test_pasted_vertices_are_read(text: str) -> None:
    assert parse_polygon(text).area == 3


def test_several_pasted_polygons_are_read() -> None:
    found = parse_polygons("0 0\n1 0\n0 1\n\n5 5\n7 5\n5 7\n")
    assert [part.polygon.area for part in found] == [Fraction(1, 2), 2]
    assert len(parse_polygons("3 0 0 1 0 0 1 4 0 0 1 0 1 1 0 1")) == 2
    with pytest.raises(FormatError, match="expected one pair of numbers"):
        parse_polygons("3 0 0 1 0")


@pytest.mark.parametrize(
    ("text", "name"),
    [
        ("G21\nG90\nG0 X0 Y0", "G-code"),
        ("%\nO100\nG0 X1", "G-code"),
        ("; made by hand\nG1 X0", "G-code"),
        ("IN;SP1;PU0,0;", "HPGL"),
        ("ISO-10303-21;\nHEADER;", "STEP"),
        ("%PDF-1.4", "PDF"),
        ("<!DOCTYPE html><html></html>", "HTML"),
    ],
)
def test_other_formats_are_rejected_by_name(text: str, name: str) -> None:
    with pytest.raises(FormatError, match=f"^{name} is not supported; "):
        parse_polygons(text)


def test_rows_with_sizes_are_rectangles() -> None:
    found = parse_polygons("x,y,width,height\n1,2,4,3\n5,5,1,1\n")
    assert [[*map(int, part.polygon.bounds)] for part in found] == [[1, 2, 5, 5], [5, 5, 6, 6]]
    named = parse_polygons("TYPE,ID,COPIES,BIN,X,Y,LX,LY\nITEM,7,1,0,0,0,2,3\n")
    assert [(part.name, int(part.polygon.area)) for part in named] == [("7", 6)]


@pytest.mark.parametrize("column", ["deg", "Angle (rad)", "rotation", "radius", "flipped"])
def test_a_table_of_placements_is_not_a_polygon(column: str) -> None:
    text = f"n,x,y,{column}\n3,0,0,1\n3,1,0,1\n3,0,1,1\n"
    said = f"a table of placements, because of the column '{column.lower()}'; 'exactsweep layout"
    for table in (text, text.replace(",", "\t"), text.replace(",", ";")):
        with pytest.raises(FormatError, match=re.escape(said)):
            parse_polygons(table)


@pytest.mark.parametrize(
    "table",
    [
        "part,center_x,center_y,angle_deg\n0,0,0,1\n0,3,0,1\n0,0,3,5\n",
        '[{"x": 0, "y": 0, "deg": 1}, {"x": 3, "y": 0, "deg": 1}]',
        '{"trees": [{"x": 0, "y": 0, "deg": 1}, {"x": 3, "y": 0, "deg": 1}]}',
    ],
)
def test_other_tables_of_placements_name_the_command(table: str) -> None:
    with pytest.raises(FormatError, match="'exactsweep layout FILE --part OUTLINE' judges"):
        parse_polygons(table)


def test_open_wkt_rings_are_closed_with_a_note() -> None:
    found = parse_polygons("POLYGON ((0 0, 4 0, 4 4, 0 4))")
    assert found[0].polygon.area == 16
    assert found.notes == ["1 open ring closed, the first at line 1, column 10"]


def test_parts_of_instances_are_read() -> None:
    shape = {"type": "simple_polygon", "data": [[0, 0], [2, 0], [0, 2]]}
    instance = {"name": "own", "items": [{"id": 4, "demand": 2, "shape": shape}], "strip_height": 9}
    (part,) = parse_polygons(json.dumps(instance))
    assert (part.name, int(part.polygon.area)) == ("4", 2)
    circle = {"type": "circle", "radius": 1}
    types = {"bin_types": [{"type": "rectangle", "width": 4, "height": 4}], "item_types": [circle]}
    (disc,) = parse_regions(json.dumps(types))
    assert disc.error == Fraction(1, 1000)
    assert 3.13 < disc.region.area < 3.15


def test_esicup_pieces_are_read() -> None:
    corners = [(0, 0), (0, 4), (3, 0)]
    segments = "".join(f'<segment x0="{x}" y0="{y}"/>' for x, y in corners)
    component = '<component idPolygon="p" xOffset="1" yOffset="0"/>'
    text = (
        f'<nesting xmlns="http://globalnest.fe.up.pt/nesting"><piece id="a">{component}</piece>'
        f'<piece id="b">{component * 2}</piece><polygon id="p"><lines>{segments}</lines></polygon>'
        "</nesting>"
    )
    found = parse_polygons(text)
    assert [(part.name, int(part.polygon.area)) for part in found] == [("a", 6)]
    assert not found.coordinates.y_down
    assert found.left_out == ["piece 'b': expected one component, found 2"]


def draw_lwpolyline(layer: str, height: str) -> str:
    corners = "".join(f"10\n{x}\n20\n{y}\n" for x, y in [(0, 0), (4, 0), (4, 4)])
    return f"0\nLWPOLYLINE\n8\n{layer}\n70\n1\n{corners}210\n0\n220\n0\n230\n{height}\n"


def test_layer_names_may_look_like_an_index() -> None:
    drawn = draw_lwpolyline("cut", "1") + draw_lwpolyline("0", "2.5")
    text = f"0\nSECTION\n2\nENTITIES\n{drawn}0\nENDSEC\n0\nEOF\n"
    found = parse_polygons(text)
    assert [part.layer for part in found] == ["cut", "0"]
    assert parse_polygon(text, "layer:0") == parse_polygon(text, "1")


def test_a_missing_radius_equals_the_given_one() -> None:
    text = '<svg><rect width="160" height="80" rx="40"/><ellipse rx="10"/></svg>'
    stadium, disc = parse_regions(text, tolerance="1/1000")
    assert abs(float(stadium.region.area) - (12800 - (4 - 3.141592653589793) * 1600)) < 0.3
    assert abs(float(disc.region.area) - 314.159265) < 0.05
