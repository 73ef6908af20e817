"""Several polygons in a file, round trips, and conversion."""

import math
import re
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path

import numpy
import pytest
import shapely
import strategies
from command import refusal, run
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import NumberError, Polygon, PolygonError, Region
from exactsweep.formats import (
    FORMATS,
    FormatError,
    NamedPolygon,
    NamedRegion,
    format_polygons,
    from_numpy,
    from_shapely,
    parse_polygon,
    parse_polygons,
    read_polygon,
    read_polygons,
    read_regions,
    round_regions,
    to_numpy,
    to_shapely,
)
from exactsweep.formats.exact_json import measure_file
from exactsweep.formats.folder import make_unique
from exactsweep.formats.parsing import measure_written

TRIANGLE = Polygon([(0, 0), (1, 0), (0, 1)])
DECIMALS = [form for form in FORMATS if form != "json"]
names = st.text("abc<>&'\" é#7", min_size=1, max_size=5).filter(lambda name: name == name.strip())
errors = st.fractions(0, 2, max_denominator=9)
parts = st.builds(NamedPolygon, strategies.simple_polygons(), names, st.none(), errors)
several = st.lists(parts, min_size=1, max_size=4)


@given(several)
@examples(40)
def test_exact_json_round_trips(polygons: list[NamedPolygon]) -> None:
    assert parse_polygons(format_polygons(polygons, "json")) == polygons


@pytest.mark.parametrize("form", DECIMALS)
@given(polygons=several, exponent=st.integers(-40, 40))
@examples(30)
def test_decimals_round_trip(form: str, polygons: Sequence[NamedPolygon], exponent: int) -> None:
    factor = Fraction(10) ** exponent
    scaled = [
        NamedPolygon(
            Polygon([(x * factor, y * factor) for x, y in polygon.lattice()[1]]),
            None if form == "wkt" else name,
            name if form == "dxf" else None,
        )
        for polygon, name, *_ in polygons
    ]
    if form == "dxf":
        scaled = [part._replace(name=None) for part in scaled]
    if form == "svg":
        # Two elements never have the same id.
        names = make_unique([part.name or "" for part in scaled])
        scaled = [part._replace(name=name) for part, name in zip(scaled, names, strict=True)]
    text = format_polygons(scaled, form)
    assert parse_polygons(text) == scaled
    assert [part.polygon.vertices for part in parse_polygons(text)] == [
        part.polygon.vertices for part in scaled
    ]


@pytest.mark.parametrize("form", DECIMALS)
def test_other_fractions_are_never_rounded_silently(form: str) -> None:
    third = NamedPolygon(Polygon([(0, 0), ("1/3", 0), (0, 1)]), "third")
    with pytest.raises(FormatError, match=r"^third, vertex 1: 1/3 is not a finite decimal, as "):
        format_polygons([NamedPolygon(TRIANGLE), third], form)
    with pytest.raises(FormatError, match=r"^polygon 0, vertex 1: 1/3 is not a finite decimal"):
        format_polygons([third.polygon], form)


def test_empty_lists_and_unknown_formats_are_rejected() -> None:
    with pytest.raises(FormatError, match=r"^no polygon to write$"):
        format_polygons([], "json")
    with pytest.raises(FormatError, match=r"^unknown format 'png'; choose from json, wkt, geojson"):
        format_polygons([TRIANGLE], "png")
    for form in ("svg", "dxf"):
        with pytest.raises(FormatError, match=r"^the name 'a\\nb' cannot be written in"):
            format_polygons([NamedPolygon(TRIANGLE, "a\nb")], form)


@given(strategies.simple_polygons(), st.integers(0, 6))
@examples(50)
def test_rounding_reports_its_changes(polygon: Polygon, places: int) -> None:
    named = NamedRegion(Region(polygon))
    try:
        (part,), (changed, distance, left_out) = round_regions(
            [named], places, lambda one: "closest"
        )
    except PolygonError:
        return
    assert distance**2 <= Fraction(1, 2 * 10 ** (2 * places)) * (1 + Fraction(1, 10**8))
    assert (changed == 0) == (distance == 0) == (part == named)
    assert left_out == 0
    for form in FORMATS:
        assert parse_polygon(format_polygons([part], form)) == part.region.exterior


def test_names_come_before_indices(tmp_path: Path) -> None:
    polygons = [NamedPolygon(TRIANGLE, "1"), NamedPolygon(TRIANGLE.translated((5, 0)), "x")]
    path = tmp_path / "parts.json"
    path.write_text(format_polygons(polygons, "json"))
    assert read_polygon(f"{path}#1") == TRIANGLE
    assert read_polygon(f"{path}#x") == polygons[1].polygon


def test_file_names_may_contain_a_number_sign(tmp_path: Path) -> None:
    path = tmp_path / "a#0"
    path.write_text(format_polygons([TRIANGLE], "wkt"))
    assert read_polygon(str(path)) == read_polygon(f"{path}#0") == TRIANGLE
    with pytest.raises(FormatError, match=r"/b: No such file or directory$"):
        read_polygon(str(tmp_path / "b#0"))


def test_polygon_names_may_contain_a_number_sign(tmp_path: Path) -> None:
    path = tmp_path / "a#b.json"
    moved = TRIANGLE.translated((5, 0))
    path.write_text(
        format_polygons([NamedPolygon(TRIANGLE, "x#y"), NamedPolygon(moved, "#")], "json")
    )
    assert read_polygon(f"{path}#x#y") == TRIANGLE
    assert read_polygon(f"{path}##") == moved
    with pytest.raises(FormatError, match=r"/none: No such file or directory$"):
        read_polygon(str(tmp_path / "none#x#y"))


@given(strategies.simple_polygons())
def test_arrays_of_fractions_round_trip(polygon: Polygon) -> None:
    assert from_numpy(to_numpy(polygon)) == polygon


@given(strategies.simple_polygons())
@examples(50)
def test_floats_round_trip_or_are_rejected(polygon: Polygon) -> None:
    exact = all(Fraction(float(c)) == c for vertex in polygon.vertices for c in vertex)
    if exact:
        assert from_shapely(to_shapely(polygon)) == polygon
        assert from_numpy(to_numpy(polygon, "float64")) == polygon
        return
    message = r"^vertex \d+: .* is not a float; nearest=True rounds$"
    with pytest.raises(FormatError, match=message):
        to_shapely(polygon)
    with pytest.raises(FormatError, match=message):
        to_numpy(polygon, "float64")
    rows = to_numpy(polygon, "float64", nearest=True).tolist()
    assert rows == [[float(x), float(y)] for x, y in polygon.vertices]


@pytest.mark.parametrize(
    ("geometry", "message"),
    [
        (shapely.Point(0, 0), "Point is not a shapely polygon"),
        ("POLYGON", "str is not a shapely polygon"),
        (shapely.Polygon(), "the polygon is empty"),
    ],
)
def test_other_geometries_are_rejected(geometry: object, message: str) -> None:
    with pytest.raises(FormatError, match=f"^{message}$"):
        from_shapely(geometry)


def test_other_arrays_are_rejected() -> None:
    with pytest.raises(FormatError, match=re.escape("the array has shape (2, 3), not (n, 2)")):
        from_numpy(numpy.zeros((2, 3)))
    with pytest.raises(NumberError, match=r"^vertex 0: .*nan.* is not a finite number$"):
        from_numpy(numpy.full((3, 2), math.nan))
    with pytest.raises(
        FormatError, match="dtype must be 'object', 'int64' or 'float64', not 'int8'"
    ):
        to_numpy(TRIANGLE, "int8")
    for x in ("1/2", 2**63, -(2**63) - 1):
        with pytest.raises(FormatError, match=r"^vertex \d: .* is not an int64$"):
            to_numpy(Polygon([(0, 0), (x, 0), (0, 1)]), "int64")
    ends = Polygon([(-(2**63), 0), (2**63 - 1, 0), (0, 1)])
    assert to_numpy(ends, "int64").tolist() == [[int(x), int(y)] for x, y in ends.vertices]
    with pytest.raises(FormatError, match="exceeds the float range"):
        to_shapely(Polygon([(0, 0), ("1e999", 0), (0, 1)]), nearest=True)


def test_files_are_converted(tmp_path: Path) -> None:
    source = tmp_path / "parts.json"
    polygons = [NamedPolygon(TRIANGLE, "a"), NamedPolygon(TRIANGLE.translated(("1/3", 0)), "b")]
    source.write_text(format_polygons(polygons, "json"))
    assert run("convert", str(source), "--to", "json").stdout == source.read_text()
    output = tmp_path / "parts.svg"
    message = refusal(run("convert", str(source), "-o", str(output)))
    assert message == (
        f"{source}: b, vertex 0: 1/3 is not a finite decimal, as SVG requires; "
        "use --to json, or --round"
    )
    done = run("convert", str(source), "--round", "3", "-o", str(output))
    assert (done.exit_code, done.stdout) == (0, "")
    assert done.stderr.splitlines() == [
        "Y axis flipped: up in the input, down in SVG",
        "rounded: 1 polygon, moved by at most 0.000333334",
    ]
    assert [part.name for part in read_polygons(str(output))] == ["a", "b"]
    done = run("convert", f"{source}#a", "--to", "wkt")
    assert done.output == "POLYGON ((0 0, 1 0, 0 1, 0 0))\n"
    circle = tmp_path / "circle.svg"
    circle.write_text("<svg><circle id='c' r='1'/></svg>")
    done = run("convert", str(circle), "--to", "dxf")
    assert "curves flattened within 0.001 (--flatten" in done.stderr
    done = run("convert", str(circle), "--to", "dxf", "--flatten", "1/100")
    assert parse_polygon(done.stdout, "c").area > 3
    assert run("convert", str(circle)).exit_code == 2
    assert run("sweep", str(circle), f"{source}#a", "--flatten", "0.1").exit_code == 0


@pytest.mark.parametrize("line", ['{"a": [[0, 1], [2, 3]], "b": 7}', f"[{'1,' * 500}1]"])
def test_a_file_of_records_has_the_size_of_its_text(line: str, tmp_path: Path) -> None:
    text = f"{line}\n" * 40
    path = tmp_path / "records"
    path.write_text(text)
    assert measure_file(str(path)) == measure_written(text)


def test_declared_xml_encodings_are_read(tmp_path: Path) -> None:
    file = tmp_path / "part.svg"
    text = (
        '<?xml version="1.0" encoding="ISO-8859-1"?><svg><rect id="é" width="2" height="1"/></svg>'
    )
    file.write_bytes(text.encode("latin-1"))
    assert [part.name for part in read_regions(str(file))] == ["é"]
    file.write_bytes(text.replace("ISO-8859-1", "ISO-8859-99").encode("latin-1"))
    with pytest.raises(FormatError, match="not UTF-8 text"):
        read_regions(str(file))
