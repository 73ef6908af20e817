import json
import re
from fractions import Fraction
from pathlib import Path

import pytest
import strategies
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon, limits, sweep
from exactsweep.cli.pair import DIRECTRIX, GENERATRIX
from exactsweep.formats import (
    FormatError,
    parse_polygon,
    read_polygon,
)
from exactsweep.text.results import sweep_to_json

POLYGONS = Path(__file__).parents[1] / "support" / "polygons"
TRIANGLE = Polygon([(0, 0), (1, 0), ("0.1", "1000")])


@pytest.mark.parametrize(
    ("name", "polygon"),
    [("house.json", GENERATRIX), ("notch.wkt", DIRECTRIX), ("notch.geojson", DIRECTRIX)],
)
def test_files_hold_the_built_in_example(name: str, polygon: Polygon) -> None:
    assert read_polygon(str(POLYGONS / name)) == polygon


@pytest.mark.parametrize(
    "text",
    [
        '[[0,0],[1,0],["0.1","1e3"]]',
        "[[0, 0], [1, 0], [0.1, 1E+3], [0, 0]]",
        ' \n{"vertices": [[-0, 0.0], [1e0, 0], ["1/10", "2000/2"]], "unit": null}',
        '{"type": "Polygon", "coordinates": [[[0,0],[1,0],[0.1,1000],[0,0]]]}',
        '{"geometry": {"coordinates": [[[0,0],[1,0],[0.1,1e3],[0,0]]], "type": "Polygon"},'
        ' "type": "Feature", "properties": {}}',
        "POLYGON ((0 0, 1 0, 0.1 1000, 0 0))",
        "polygon((0 0,1 0,0.1 1e3,0 0))",
        "\n Polygon\n(\t( +0 -0. , 01. 0 , .1 1E+3 , 0 0.0 ) )\n",
    ],
)
def test_notation_does_not_matter(text: str) -> None:
    assert parse_polygon(text) == TRIANGLE


def scientific(value: Fraction) -> str:
    """Write a finite decimal as an integer with an exponent."""
    places = 0
    while (value * 10**places).denominator != 1:
        places += 1
    return f"{int(value * 10**places)}e-{places}"


@given(strategies.simple_polygons(), st.integers(-40, 40), st.sampled_from([1, 2, 125, 1024]))
def test_wkt_is_read_exactly(polygon: Polygon, exponent: int, divisor: int) -> None:
    factor = Fraction(10) ** exponent / divisor
    ring = [(factor * x, factor * y) for x, y in polygon.lattice()[1]]
    written = ", ".join(f"{scientific(x)} {scientific(y)}" for x, y in [*ring, ring[0]])
    assert parse_polygon(f"POLYGON (({written}))") == Polygon(ring)


@given(strategies.pairs("CM"), strategies.translations())
@examples(50)
def test_json_of_a_sweep_holds_everything(
    pair: tuple[Polygon, Polygon], reference: tuple[Fraction, Fraction]
) -> None:
    result = sweep(*pair, reference=reference)
    document = json.loads(sweep_to_json(result))
    for name in ("generatrix", "directrix", "trajectory", "inner", "outer"):
        # The polygons are canonical in the file, too.
        assert Polygon(document.pop(name)).vertices == getattr(result, name).vertices
    assert document == {
        "kind": result.kind,
        "direction": [*result.solution.frame.direction],
        "reference": [str(coordinate) for coordinate in reference],
        "area": str(result.area),
    }


NUMBER = "is not a number such as 3, -7/2, 0.125 or 1e-3"
RING = '{"type": "Polygon", "coordinates": %s}'

REFUSED = {
    # No format at all.
    "": "empty",
    " \n\t": "empty",
    "3": "starts with '3': neither JSON, GeoJSON, WKT, CSV, SVG nor DXF",
    '"x"': "starts with '\"': neither JSON, GeoJSON, WKT, CSV, SVG nor DXF",
    "\x00\x00": "starts with '\\x00': neither JSON, GeoJSON, WKT, CSV, SVG nor DXF",
    "0": "starts with '0': neither JSON, GeoJSON, WKT, CSV, SVG nor DXF",
    "<svg/>": "holds no polygon",
    # JSON syntax.
    "[[0, 0], [1, 0]\n [0, 1]]": "line 2, column 2: not JSON: Expecting ',' delimiter",
    "[[0, 0], [1, 0], [0, 1]": "line 1, column 24: not JSON: Expecting ',' delimiter",
    "[[0, 0], [1, 0], [0, 01]]": "line 1, column 23: not JSON: Expecting ',' delimiter",
    "[[0, 0]] x": "line 1, column 10: not JSON: Extra data",
    "{'vertices': []}": "line 1, column 2: not JSON: Expecting property name",
    '{"vertices": [], "vertices": []}': "the name 'vertices' is twice in one object",
    "[" * 100_000: "nested too deeply",
    '{"a":' * 100_000: "nested too deeply",
    "[" * 100_000 + "]" * 100_000: "nested too deeply",
    # JSON content.
    "{}": '$ has neither "vertices" nor "polygons" nor, as in GeoJSON, a "type"',
    '{"polygons": 1}': "$.polygons is '1', not a list of polygons",
    '{"polygons": [{}]}': '$.polygons[0] has no "vertices"',
    '{"polygons": [{"id": [], "vertices": 1}]}': "$.polygons[0].id is a list, not a string or",
    '{"polygons": [[[0, 0], [1, 1], [2, 2]]]}': "$.polygons[0]: zero area",
    '{"polygons": []}': "holds no polygon",
    '{"vertices": {}}': "$.vertices is an object, not a list of vertices",
    '{"vertices": null}': "$.vertices is null, not a list of vertices",
    "[[0, 0], 7, [0, 1]]": "$[1] is '7', not a pair of numbers",
    '[[0, 0], "7", [0, 1]]': "$[1] is '7', not a pair of numbers",
    "[[0, 0], [1], [0, 1]]": "$[1] has 1 coordinates, not 2",
    "[[0, 0], [1, 2, 3], [0, 1]]": "$[1] has 3 coordinates, not 2",
    "[[[0, 0], [1, 2]]]": "$[0]: fewer than three distinct vertices: 2 among",
    '{"vertices": [[0, 0], [1, true], [0, 1]]}': "$.vertices[1][1] is true, not a number",
    "[[0, 0], [1, null], [0, 1]]": "$[1][1] is null, not a number",
    "[[0, 0], [1, {}], [0, 1]]": "$[1][1] is an object, not a number",
    "[[0, 0], [NaN, 0], [0, 1]]": f"$[1][0]: 'NaN' {NUMBER}",
    "[[0, 0], [-Infinity, 0], [0, 1]]": f"$[1][0]: '-Infinity' {NUMBER}",
    '[[0, 0], ["1\\n2", 0], [0, 1]]': f"$[1][0]: '1\\n2' {NUMBER}",
    '[[0, 0], ["\\ud800", 0], [0, 1]]': f"$[1][0]: '\\ud800' {NUMBER}",
    '[[0, 0], ["1/0", 0], [0, 1]]': "$[1][0]: '1/0' has a zero denominator",
    "[[0, 0], [1e999999999, 0], [0, 1]]": (
        "$[1][0]: '1e999999999' has more than 4300 digits (max_digits)"
    ),
    f"[[0, 0], [{'7' * 137_608}, 0], [0, 1]]": (
        f"$[1][0]: '{'7' * 36}... has more than 137607 digits (max_digits)"
    ),
    # GeoJSON.
    '{"type": "Point", "coordinates": [0, 0]}': "$.type is 'Point', not 'Polygon'",
    '{"type": "FeatureCollection"}': "$.features is null, not a list",
    '{"type": null}': "$.type is null, not 'Polygon'",
    '{"type": "Feature"}': "$.geometry is null, not a Polygon",
    '{"type": "Feature", "geometry": {"type": "LineString"}}': (
        "$.geometry.type is 'LineString', not 'Polygon'"
    ),
    '{"type": "Feature", "geometry": {"type": "MultiPolygon"}}': (
        "$.geometry.coordinates is null, not a list"
    ),
    '{"type": "FeatureCollection", "features": [{"type": "Feature"}]}': (
        "$.features[0].geometry is null, not a Polygon"
    ),
    '{"type": "Feature", "id": {}, "geometry": null}': "$.id is an object, not a string or",
    '{"type": "GeometryCollection", "geometries": [' * 101: "line 1, column 4647: not JSON",
    '{"type": "GeometryCollection", "geometries": [' * 102 + "]}" * 102: "nested too deeply",
    '{"type": "Polygon"}': "$.coordinates is null, not a list of rings",
    RING % "[]": "$.coordinates is empty",
    RING % "[[]]": "$.coordinates[0] is empty",
    RING % "[[], []]": "$.coordinates[1]: an inner ring: with it, this is a Region, no Polygon",
    RING % "[[[0, 0], [1, 0, 5, 6]]]": "$.coordinates[0][1] has 4 coordinates, not 2",
    RING % "[[[0, 0], [1, 0], [0, 1]]]": (
        "$.coordinates[0] is not closed: the last vertex must repeat the first"
    ),
    # WKT.
    "null": "line 1, column 1: 'null' is neither POLYGON nor MULTIPOLYGON",
    "POLYGONZ ((0 0 0))": "line 1, column 1: 'POLYGONZ' is neither POLYGON nor",
    "SRID=x;POLYGON ((0 0))": "line 1, column 1: 'SRID=x;POLYGON' is neither POLYGON nor",
    "MULTIPOLYGON (((0 0)))": "fewer than three distinct vertices: 1 among the 1 given",
    "MULTIPOLYGON (((0 0)),)": "line 1, column 23: ')' instead of '('",
    "POLYGON ((0 0, 1 0, 0 0))\nCIRCLE (0 0)": "line 2, column 1: 'CIRCLE' is neither POLYGON",
    "POLYGON Z ((0 0 0, 1 0 1))": "line 1, column 24: Z is not the same all along",
    "POLYGON zm ((0 0 0))": "line 1, column 9: M coordinates cannot be swept",
    "POLYGON EMPTY": "line 1, column 9: the polygon is empty",
    "POLYGON": "line 1, column 8: the end instead of '('",
    "POLYGON (0 0, 1 0)": "line 1, column 10: '0' instead of '('",
    "POLYGON (())": "line 1, column 11: ')' instead of a number",
    "POLYGON ((0 0, 1 0,\n  x 0))": "line 2, column 3: 'x' instead of a number",
    "POLYGON ((0 0, 1 0, nan 0))": "line 1, column 21: 'nan' instead of a number",
    "POLYGON ((0 0, 1/2 0, 0 1, 0 0))": "line 1, column 16: '1/2' instead of a number",
    "POLYGON ((0 0, 1.2.3 0))": "line 1, column 16: '1.2.3' instead of a number",
    "POLYGON ((0 0, 1 0": "line 1, column 19: the end instead of ')'",
    "POLYGON ((0 0, 1 0 3, 0 1, 0 0))": (
        "line 1, column 20: Z is not the same all along, and cannot be swept"
    ),
    "POLYGON ((0 0, 1, 0 1))": "line 1, column 17: ',' instead of a number",
    "POLYGON ((0 0, 1 0, 0 1))": (
        "line 1, column 10: the ring is not closed: its last vertex must repeat the first"
    ),
    "POLYGON ((0 0, 9 0, 0 9, 0 0),\n(1 1, 2 1, 1 2, 1 1))": (
        "line 2, column 1: an inner ring: with it, this is a Region, no Polygon"
    ),
    "POLYGON ((0 0, 1 0, 0 1, 0 0)) 7": "line 1, column 32: '7' after the end of the polygon",
    "POLYGON ((0 0, 1e5000 0, 0 1, 0 0))": (
        "line 1, column 16: '1e5000' has more than 4300 digits (max_digits)"
    ),
    # Polygons.
    "[]": "fewer than three distinct vertices: 0 among the 0 given",
    "[[0, 0], [1, 0]]": "fewer than three distinct vertices: 2 among the 2 given",
    "[[0, 0], [1, 0], [2, 0]]": "zero area: all vertices lie on one line",
    "POLYGON ((0 0, 4 4, 4 0, 0 4, 0 0))": "the boundary crosses itself: edges 0 and 2 cross",
}


@pytest.mark.parametrize(("text", "message"), REFUSED.items(), ids=range(len(REFUSED)))
def test_refusals_name_place_and_reason(text: str, message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}") as caught:
        parse_polygon(text)
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 200


@given(st.text(alphabet="[]{}(),:\"'POLYGNtypevrics0123456789.eE+-/ \n\x00é", max_size=30))
def test_any_text_is_read_or_refused(text: str) -> None:
    try:
        message = str(parse_polygon(text))
    except ValueError as error:
        message = str(error)
    assert message.isprintable()


def test_limits_apply_to_files(tmp_path: Path) -> None:
    (tmp_path / "long.json").write_text("[[0, 0], [1e5000, 0], [0, 1]]")
    with limits(max_digits=5001):
        assert read_polygon(str(tmp_path / "long.json")).area == Fraction(10**5000, 2)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "empty"),
        (b"[[0, 0], [1, \xff]]", "not UTF-8 text: invalid start byte at byte 13"),
        ("[[0, 0], [1, 0]]".encode("utf-16"), "UTF-16 text; save it as UTF-8"),
        (b" " * (2**24 + 1), "more than 16 MiB (max_mib)"),
        (b"\x89PNG\r\n", "not UTF-8 text: invalid start byte at byte 0"),
    ],
    ids=["empty", "latin", "utf-16", "enormous", "png"],
)
def test_refused_files_are_named(tmp_path: Path, content: bytes, message: str) -> None:
    path = tmp_path / "bad file.json"
    path.write_bytes(content)
    with pytest.raises(FormatError, match=f"^{re.escape(f'{path}: {message}')}$"):
        read_polygon(str(path))


def test_a_byte_order_mark_is_ignored(tmp_path: Path) -> None:
    path = tmp_path / "marked.json"
    path.write_text("[[0, 0], [1, 0], [0, 1]]", encoding="utf-8-sig")
    assert read_polygon(str(path)) == Polygon([(0, 0), (1, 0), (0, 1)])
