import io
from fractions import Fraction
from functools import partial
from itertools import chain, pairwise
from pathlib import Path
from random import Random

import ezdxf.filemanagement as files
import pytest
import strategies
from ezdxf.entities.polyline import Polyline
from ezdxf.layouts.layout import Modelspace
from hypothesis import given
from hypothesis import strategies as st
from linear import count_calls
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


@pytest.mark.parametrize("count", [1, 2, 3])
def test_an_invalid_number_is_named(count: int) -> None:
    lines = [line(0, 0, 2, k) for k in range(count - 1)]
    with pytest.raises(FormatError, match="'x'"):
        parse_polygons(dxf(*lines, line(2, 0, "x", 2)))


@pytest.mark.parametrize("code", [30, 31, 32, 33])
def test_corners_of_a_solid_have_equal_heights(code: int) -> None:
    corners = [(10, 0), (20, 0), (11, 2), (21, 0), (12, 0), (22, 2), (13, 2), (23, 2)]
    flat, bent = (dxf([(0, "SOLID"), *corners, (code, z)]) for z in (0, 1))
    assert parse_polygon(flat) == SQUARE
    with pytest.raises(FormatError):
        parse_polygon(bent)


@given(st.data(), strategies.simple_rings(), strategies.simple_rings())
def test_lines_form_their_polygons_in_any_order_and_direction(
    data: st.DataObject, one: strategies.Ring, other: strategies.Ring
) -> None:
    rings = [one, [(x + 10**6, y) for x, y in other]]
    lines = [(*ring[k - 1], *p) for ring in rings for k, p in enumerate(ring)]
    # A file that begins inside a ring has two chains of it.
    first = data.draw(st.integers(0, len(lines)))
    lines = lines[first:] + lines[:first]
    if data.draw(st.booleans()):
        lines = data.draw(st.permutations(lines))
    turned = st.lists(st.booleans(), min_size=len(lines), max_size=len(lines))
    ends = [
        (c, d, a, b) if turn else (a, b, c, d)
        for (a, b, c, d), turn in zip(
            lines, data.draw(turned | st.just([False] * len(lines))), strict=True
        )
    ]
    found = [named.polygon for named in parse_polygons(dxf(*(line(*end) for end in ends)))]
    assert sorted(found, key=str) == sorted(map(Polygon, rings), key=str)


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
def test_ezdxf_drawings_are_read(draw: object) -> None:
    assert parse_polygon(written(draw)) == SQUARE
    assert parse_polygon(written(draw).replace("\n", "\r\n")) == SQUARE


def test_paper_space_is_not_read() -> None:
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


def test_old_code_pages_are_read_and_binary_files_rejected(tmp_path: Path) -> None:
    path = tmp_path / "old.dxf"
    text = dxf([(0, "LWPOLYLINE"), (8, "Außen"), *polyline((0, 0), (1, 0), (0, 1))[1:]])
    path.write_text(text, encoding="cp1252")
    assert read_polygon(f"{path}#Außen").area == Fraction(1, 2)
    path.write_bytes(b"AutoCAD Binary DXF\r\n\x1a\x00\x00")
    with pytest.raises(FormatError, match=r"a binary DXF file; save it as ASCII DXF$"):
        read_polygons(str(path))


@examples(40)
@given(strategies.simple_polygons())
def test_ezdxf_reads_written_drawings(polygon: Polygon) -> None:
    whole = Polygon(polygon.lattice()[1])
    if max(abs(c) for v in whole.vertices for c in v) > 2**50:
        return
    document = files.read(io.StringIO(format_polygons([whole], "dxf")))
    assert not document.audit().has_errors
    (entity,) = document.modelspace().query("POLYLINE")
    assert isinstance(entity, Polyline)
    assert entity.is_closed
    assert [tuple(v.dxf.location)[:2] for v in entity.vertices] == list(whole.vertices)


def test_rejected_entities_of_a_block_hide_no_others() -> None:
    """The error is reported, and the next polygon is read."""

    def draw(space: Modelspace) -> None:
        assert space.doc
        block = space.doc.blocks.new("part")
        block.add_text("label")
        block.add_lwpolyline(CORNERS, close=True)
        space.add_blockref("part", (0, 0))

    assert parse_polygon(written(draw)) == SQUARE


def test_nested_sections_are_rejected() -> None:
    start = "0\nSECTION\n2\n"
    text = f"{start}HEADER\n{start}ENTITIES\n0\nENDSEC\n0\nEOF\n"
    with pytest.raises(FormatError, match="missing ENDSEC tag"):
        parse_polygons(text)


@pytest.mark.parametrize("turn", [1, 119, 121, 179])
def test_a_very_short_arc_is_not_a_circle(turn: int) -> None:
    arc: Tags = [(0, "ARC"), (10, 0), (20, 0), (40, "0.01"), (50, 7), (51, 7 + turn)]
    with pytest.raises(FormatError, match="ARC: dropped 1 line"):
        parse_polygons(dxf(arc), tolerance=1)


@pytest.mark.parametrize("turned", [False, True])
def test_a_thin_outline_with_joined_ends_is_kept(turned: bool) -> None:
    corners: list[tuple[object, ...]] = [(0, 0), (10, 0), (10, "0.03"), (0, "0.001")]
    thin = polyline(*(corner[::-1] if turned else corner for corner in corners), flags=0)
    (part,) = parse_polygons(dxf(thin), join="0.01")
    assert part.polygon.area == Fraction("0.15")


def draw_outlines(shapes: list[list[tuple[int, int]]], point: str = "") -> list[Tags]:
    """Lines of adjacent outlines, in order; `point` completes the text of each first x."""
    return [
        line(f"{a + 9 * k}{point}", b, c + 9 * k, d)
        for k, shape in enumerate(shapes)
        for (a, b), (c, d) in pairwise([*shape, shape[0]])
    ]


@examples(60)
@given(
    st.lists(st.lists(st.tuples(st.integers(0, 4), st.integers(0, 4)), min_size=1, max_size=5)),
    st.randoms(use_true_random=False),
    st.sampled_from(["", ".0"]),
)
def test_lines_of_several_outlines_are_independent(
    shapes: list[list[tuple[int, int]]], random: Random, point: str
) -> None:
    lines = draw_outlines([CORNERS, *shapes], point)
    random.shuffle(lines)
    together, alone = (
        parse_polygons(dxf(*entities))
        for entities in (lines, chain.from_iterable((one, [(0, "TEXT")]) for one in lines))
    )
    assert [part.polygon for part in together] == [part.polygon for part in alone]


def test_cost_does_not_depend_on_the_order_of_lines() -> None:
    lines = draw_outlines([CORNERS] * 100)
    in_order, shuffled = (
        count_calls(partial(parse_polygons, dxf(*entities)))
        for entities in (lines, Random(1).sample(lines, len(lines)))
    )
    assert shuffled < 1.3 * in_order
