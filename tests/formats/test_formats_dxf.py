import io
import re
from fractions import Fraction
from pathlib import Path

import ezdxf.filemanagement as files
import pytest
import strategies
from ezdxf.entities.polyline import Polyline
from ezdxf.layouts.layout import Modelspace
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.formats import (
    FormatError,
    format_polygons,
    parse_polygon,
    parse_polygons,
    read_polygon,
    read_polygons,
)
from exactsweep.numbers.point import Point

SQUARE = Polygon([(0, 0), (2, 0), (2, 2), (0, 2)])
CORNERS = [(0, 0), (2, 0), (2, 2), (0, 2)]
Tags = list[tuple[int, object]]


def dxf(*entities: Tags) -> str:
    tags: Tags = [(0, "SECTION"), (2, "ENTITIES")]
    tags += [tag for entity in entities for tag in entity]
    tags += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:>3}\n{value}\n" for code, value in tags)


def line(a: object, b: object, c: object, d: object, *more: tuple[int, object]) -> Tags:
    return [(0, "LINE"), *more, (10, a), (20, b), (11, c), (21, d)]


def arc(x: object, y: object, r: object, start: object, end: object) -> Tags:
    return [(0, "ARC"), (10, x), (20, y), (40, r), (50, start), (51, end)]


def polyline(*corners: tuple[object, ...], flags: int = 1) -> Tags:
    tags: Tags = [(0, "LWPOLYLINE"), (90, len(corners)), (70, flags)]
    for x, y, *bulge in corners:
        tags += [(10, x), (20, y), *((42, b) for b in bulge)]
    return tags


def written(draw: object) -> str:
    """Write with ezdxf a drawing made by a function of its model space."""
    document = files.new("R2010")
    draw(document.modelspace())  # type: ignore[operator]
    text = io.StringIO()
    document.write(text)
    return text.getvalue()


def as_lines(space: Modelspace) -> None:
    for k in (2, 0, 3, 1):
        ends = [CORNERS[k], CORNERS[(k + 1) % 4]]
        space.add_line(*ends[:: 1 if k % 2 else -1])


@pytest.mark.parametrize(
    "draw",
    [
        lambda space: space.add_lwpolyline(CORNERS, close=True),
        lambda space: space.add_lwpolyline([*CORNERS, (0, 0)]),
        lambda space: space.add_polyline2d(CORNERS, close=True),
        as_lines,
        lambda space: (space.add_lwpolyline(CORNERS), space.add_line((0, 0), (0, 2))),
        lambda space: (space.add_polyline2d(CORNERS[:3]), space.add_lwpolyline(
            [CORNERS[k] for k in (0, 3, 2)]
        )),
        lambda space: (
            space.add_text("a part"), space.add_point((9, 9)), space.add_mtext("x"),
            space.add_lwpolyline(CORNERS, close=True),
        ),
    ],
    ids=range(7),
)  # fmt: skip
def test_drawings_of_ezdxf_are_read(draw: object) -> None:
    assert parse_polygon(written(draw)) == SQUARE
    assert parse_polygon(written(draw).replace("\n", "\r\n")) == SQUARE


def test_what_is_on_paper_is_not_read() -> None:
    document = files.new()
    document.layout("Layout1").add_line((0, 0), (1, 1))
    document.modelspace().add_lwpolyline(CORNERS, close=True)
    text = io.StringIO()
    document.write(text)
    assert parse_polygon(text.getvalue()) == SQUARE


@examples(40)
@given(strategies.simple_polygons(), st.randoms(use_true_random=False))
def test_lines_in_any_order_are_joined_exactly(polygon: Polygon, random: object) -> None:
    points = [(f"{x}e-7", f"{y}e-7") for x, y in polygon.lattice()[1]]
    lines = []
    for a, b in zip(points, [*points[1:], points[0]], strict=True):
        first, last = (a, b) if random.random() < 0.5 else (b, a)  # type: ignore[attr-defined]
        lines.append(line(*first, *last))
    random.shuffle(lines)  # type: ignore[attr-defined]
    expected = Polygon([(Fraction(x, 10**7), Fraction(y, 10**7)) for x, y in polygon.lattice()[1]])
    assert parse_polygon(dxf(*lines)) == expected


def test_decimals_are_not_rounded_to_floats() -> None:
    long = "0.1000000000000000000000000000000000001"
    text = dxf(polyline((0, 0), (long, 0), (0, "+1.E0")))
    assert parse_polygon(text).vertices[1] == Point(Fraction(long), Fraction(0))


def test_outlines_are_chosen_by_layer_or_index() -> None:
    def draw(space: Modelspace) -> None:
        space.add_lwpolyline(CORNERS, close=True, dxfattribs={"layer": "cut"})
        space.add_line((0, 0), (1, 1), dxfattribs={"layer": "fold"})
        for x in (10, 20):
            corners = [(x, 0), (x + 1, 0), (x, 1)]
            space.add_lwpolyline(corners, close=True, dxfattribs={"layer": "two"})

    text = written(draw)
    assert parse_polygon(text, "cut") == parse_polygon(text, "0") == SQUARE
    assert parse_polygon(text, "2").area == Fraction(1, 2)
    message = "2 polygons have the layer 'two'; choose one by index: #2, #3"
    with pytest.raises(FormatError, match=f"^{message}$"):
        parse_polygon(text, "two")
    with pytest.raises(FormatError, match=r"LINE: the end \(0,0\) meets no other end exactly \("):
        parse_polygon(text, "fold")
    with pytest.raises(
        FormatError, match=r"holds 3 polygons; .* as in FILE#cut: #0 'cut', #2 'two"
    ):
        parse_polygon(text)
    found = parse_polygons(text.replace("\nLINE\n", "\nTEXT\n"))
    assert [part.layer for part in found] == ["cut", "two", "two"]


def test_layers_keep_apart() -> None:
    first = [line(0, 0, 1, 0), line(1, 0, 0, 1), line(0, 1, 0, 0)]
    second = [[(0, "LINE"), (8, "b"), *tags[1:]] for tags in first]
    assert len(parse_polygons(dxf(*first, *second))) == 2


def test_arcs_are_joined_within_the_tolerance() -> None:
    # A slot whose ends are rounded to six decimals, turned by 30 degrees.
    slot = dxf(
        line("-0.5", "0.866025", "8.160254", "5.866025"),
        arc("8.660254", 5, 1, -60, 120),
        line("9.160254", "4.133975", "0.5", "-0.866025"),
        arc(0, 0, 1, 120, 300),
    )
    polygon = parse_polygon(slot, tolerance="1e-4")
    assert polygon.is_convex
    assert abs(float(polygon.area) - 20 - 3.14159265) < 1e-3
    with pytest.raises(FormatError, match="meets no other end exactly"):
        parse_polygon(slot, "1", tolerance="1e-7")
    with pytest.raises(FormatError, match=r"LINE: the end \(1/1000,0\) meets no other end exactly"):
        parse_polygon(dxf(line("0.001", 0, 0, 0), arc(1, 0, 1, 0, 180)), tolerance=1)


def test_bulges_and_circles_are_read_as_lines() -> None:
    rounded = dxf(polyline((0, 0), (2, 0, 1), (2, 2), (0, 2, 1)))
    assert abs(float(parse_polygon(rounded, tolerance="1e-6").area) - 7.14159265) < 1e-4
    circle = dxf([(0, "CIRCLE"), (10, 5), (20, 5), (40, 2)])
    assert abs(float(parse_polygon(circle, tolerance="1e-6").area) - 12.5663706) < 1e-4
    full = dxf(arc(5, 5, 2, 90, 450))
    assert parse_polygon(full, tolerance="1e-3") == parse_polygon(circle, tolerance="1e-3")
    whole = dxf(polyline((0, 0, 1), (2, 0, 1)))
    assert abs(float(parse_polygon(whole, tolerance="1e-6").area) - 3.14159265) < 1e-4


REFUSED = {
    dxf(arc(0, 0, 1, 0, 90)): "line 6: ARC: a curve, which is read only with a tolerance",
    dxf([(0, "CIRCLE"), (40, 1)]): "line 6: CIRCLE: a curve, which is read only with",
    dxf(polyline((0, 0, "0.5"), (1, 0), (0, 1))): "line 6: LWPOLYLINE: a curve, which is read only",
    dxf(polyline((0, 0))): "line 6: LWPOLYLINE: a point",
    dxf(polyline((0, 0), (1, 1), (2, 2))): "line 6: LWPOLYLINE: zero area",
    dxf([(0, "SPLINE")]): "line 6: SPLINE: a curve, which is read only with a tolerance",
    dxf([(0, "INSERT")]): "line 6: INSERT: group 2 is missing",
    dxf([(0, "a\tb")]): "line 6: 'a\\tb': no line, polyline, arc, ",
    dxf([(0, "LINE"), (10, 0)]): "line 6: LINE: group 20 is missing",
    dxf(line(0, 0, 1, 0, (30, 5))): "line 6: LINE: not level: its points are at",
    dxf([*polyline((0, 0)), (230, "0.5")]): "line 6: LWPOLYLINE: drawn in a plane of its own",
    dxf(line(0, 0, "x", 0)): "line 6: LINE: group 11: 'x' is not a decimal number",
    dxf(line(0, 0, "1e9999", 0)): "line 6: LINE: group 11: '1e9999' has more than 4300 digits",
    dxf([(0, "POLYLINE"), (70, 16)]): "line 6: POLYLINE: a mesh",
    dxf([(0, "POLYLINE"), (70, 1), (0, "VERTEX"), (10, 0)]): "line 6: POLYLINE: line 10: VERTEX",
    dxf(line(0, 0, 1, 0), line(1, 0, 0, 0)): "line 6: LINE: the end (0,0) meets no other end",
    dxf(*[line(0, 0, k, 1) for k in range(3)]): "line 6: LINE: the end (0,0) is one of 3 that meet",
    dxf(): "holds no polygon",
    dxf().replace("0\nEOF", "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF"): (
        "not DXF: line 8: a second section 'ENTITIES'"
    ),
    "0\nSECTION\n2\nHEADER\n0\nENDSEC\n0\nEOF\n": "holds no polygon",
    "0\nSECTION\n2\nENTITIES\n0\nEOF\n": "not DXF: missing ENDSEC tag",
    "0\nSECTION\n2\nENTITIES\n0\nENDSEC\n": "not DXF: missing EOF tag",
    "0\nSECTION\n0\nENDSEC\n0\nEOF\n": "not DXF: line 2: a section without a name",
    "0\nSECTION\nx\ny\n": "not DXF: line 3: 'x' is no group code",
    "999\n\x07\n0\nSECTION\n\x07\n": "not DXF: line 5: '\\x07' is no group code",
}


@pytest.mark.parametrize(("text", "message"), REFUSED.items(), ids=range(len(REFUSED)))
def test_refusals_name_place_and_reason(text: str, message: str) -> None:
    with pytest.raises(ValueError, match=f"^{re.escape(message)}") as caught:
        parse_polygon(text)
    assert str(caught.value).isprintable()
    assert len(str(caught.value)) < 200


@pytest.mark.parametrize(
    ("entity", "message"),
    [
        (arc(0, 0, 0, 0, 90), "the radius is not positive"),
        (arc(0, 0, "1e-9", 0, 90), "ARC: 1 line vanished, shorter than ends may be apart"),
        (
            arc(0, 0, "1e30", 0, 90),
            r"ARC: a curve would become more than 10\*\*12 lines",
        ),
    ],
)
def test_arcs_that_cannot_be_lines_are_refused(entity: Tags, message: str) -> None:
    with pytest.raises(FormatError, match=message):
        parse_polygon(dxf(entity, line("1e30", 0, 0, "1e30")), tolerance=1)


def test_old_code_pages_and_binary_files(tmp_path: Path) -> None:
    path = tmp_path / "old.dxf"
    text = dxf([(0, "LWPOLYLINE"), (8, "Außen"), *polyline((0, 0), (1, 0), (0, 1))[1:]])
    path.write_text(text, encoding="cp1252")
    assert read_polygon(f"{path}#Außen").area == Fraction(1, 2)
    path.write_bytes(b"AutoCAD Binary DXF\r\n\x1a\x00\x00")
    with pytest.raises(FormatError, match=r"a binary DXF file; save it as ASCII DXF$"):
        read_polygons(str(path))


@examples(40)
@given(strategies.simple_polygons())
def test_what_is_written_is_a_drawing_to_ezdxf(polygon: Polygon) -> None:
    whole = Polygon(polygon.lattice()[1])
    if max(abs(c) for v in whole.vertices for c in v) > 2**50:
        return
    document = files.read(io.StringIO(format_polygons([whole], "dxf")))
    assert not document.audit().has_errors
    (entity,) = document.modelspace().query("POLYLINE")
    assert isinstance(entity, Polyline)
    assert entity.is_closed
    assert [tuple(v.dxf.location)[:2] for v in entity.vertices] == list(whole.vertices)


def test_what_is_refused_in_a_block_does_not_hide_what_comes_after() -> None:
    """The refusal is reported, and the polygon after it is read."""

    def draw(space: Modelspace) -> None:
        assert space.doc
        block = space.doc.blocks.new("part")
        block.add_text("label")
        block.add_lwpolyline(CORNERS, close=True)
        space.add_blockref("part", (0, 0))

    assert parse_polygon(written(draw)) == SQUARE
