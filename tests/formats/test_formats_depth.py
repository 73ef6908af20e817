"""Nesting of outlines, also of crossing parts; layers; and containers of layouts."""

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep.formats import FormatError, parse_regions
from exactsweep.formats.depth import nest_outlines
from exactsweep.formats.layouts import parse_layouts
from exactsweep.formats.parsing import parse_candidates
from exactsweep.numbers.number import Point

Box = tuple[int, int, int, int]
boxes = st.tuples(st.integers(0, 8), st.integers(0, 8), st.integers(1, 6), st.integers(1, 6)).map(
    lambda b: (b[0], b[1], b[0] + b[2], b[1] + b[3])
)


def write_svg(*rects: Any) -> str:
    """Draw boxes, optionally with attributes."""
    drawn = []
    for left, low, right, high, *rest in rects:
        size = f'x="{left}" y="{low}" width="{right - left}" height="{high - low}"'
        drawn.append(f"<rect {size} {' '.join(rest)}/>")
    lines = "\n".join(drawn)
    return f'<svg xmlns:i="http://www.inkscape.org/namespaces/inkscape">\n{lines}\n</svg>'


def layer(name: str, *rects: Any) -> str:
    body = write_svg(*rects).split("\n", 1)[1].removesuffix("</svg>")
    return f'<g i:groupmode="layer" i:label="{name}">{body}</g>'


def on_layers(*layers: str) -> str:
    head = '<svg xmlns:i="http://www.inkscape.org/namespaces/inkscape">'
    return f"{head}{''.join(layers)}</svg>"


def is_in(inner: Box, outer: Box) -> bool:
    return (
        outer[0] <= inner[0]
        and outer[1] <= inner[1]
        and inner[2] <= outer[2]
        and inner[3] <= outer[3]
    )


@examples(200)
@given(st.sets(boxes, min_size=1, max_size=7).map(sorted))
def test_outlines_are_nested_by_the_definition(rings: list[Box]) -> None:
    """The outlines around a ring must form a chain; otherwise it is ambiguous."""
    found = nest_outlines(parse_candidates(write_svg(*rings)))
    around = {b: [a for a in rings if a != b and is_in(b, a)] for b in rings}
    chained = {
        b: all(is_in(a, c) or is_in(c, a) for a in outer for c in outer)
        for b, outer in around.items()
    }
    assert len(found.ambiguous) == sum(not chained[b] for b in rings)
    exteriors = {b for b in rings if chained[b] and len(around[b]) % 2 == 0}

    def corners(points: Any) -> Box:
        xs, ys = zip(*points, strict=True)
        return min(xs), min(ys), max(xs), max(ys)

    assert {corners(one.vertices()) for one in found.outlines} == exteriors
    for one in found.outlines:
        own = corners(one.vertices())
        holes = {
            b
            for b in rings
            if chained[b]
            and len(around[b]) % 2
            and min(around[b], key=lambda a: (a[2] - a[0]) * (a[3] - a[1])) == own
        }
        assert {corners(hole.vertices()) for hole in one.holes()} == holes


def test_crossing_parts_keep_their_holes() -> None:
    text = write_svg((0, 0, 9, 9), (1, 1, 3, 3), (8, 0, 17, 9), (10, 1, 12, 3))
    found = parse_regions(text, nested=True)
    assert [len(one.region.holes) for one in found] == [1, 1]


def test_a_hole_in_two_crossing_parts_is_reported() -> None:
    text = write_svg((0, 0, 9, 9, 'id="a"'), (4, 0, 13, 9, 'id="b"'), (5, 1, 7, 3, 'id="h"'))
    found = parse_regions(text, nested=True)
    assert len(found) == 2
    (reason,) = found.left_out
    assert "rect 'h' is inside" in reason
    assert reason.endswith("which cross")
    sheet = write_svg((-1, -1, 20, 20, 'id="sheet"'))
    (layout,) = parse_layouts(sheet.replace("</svg>", text.split("\n", 1)[1]))
    assert len(layout.data["parts"]) == 2
    (unchecked,) = layout.unchecked
    assert "which cross (skipped)" in unchecked


def test_copies_of_a_part_keep_copies_of_its_hole() -> None:
    plate, hole = (0, 0, 9, 9), (1, 1, 3, 3)
    found = parse_regions(write_svg(plate, hole, plate, hole), nested=True)
    assert [len(one.region.holes) for one in found] == [1, 1]
    # A part that fills a hole exactly looks like the hole.
    found = parse_regions(write_svg(plate, hole, hole), nested=True)
    assert [len(one.region.holes) for one in found] == [1, 0]


def test_outlines_that_are_not_simple_are_not_nested() -> None:
    text = '<svg><rect id="sheet" width="9" height="9"/><path id="p" d="M1 1H4V4H1z"/></svg>'
    bow = text.replace("</svg>", '<path id="bow" d="M2 2L3 3V2L2 3z"/></svg>')
    (layout,) = parse_layouts(bow)
    assert [part["id"] for part in layout.data["parts"]][:1] == ["p"]


SHEET, PART = (0, 0, 9, 9), (1, 1, 3, 3)


def parts_of(text: str, **options: Any) -> list[str]:
    return [part["id"] for part in parse_layouts(text, **options)[0].data["parts"]]


@pytest.mark.parametrize(
    ("text", "options"),
    [
        (write_svg((*SHEET, 'id="s"'), (*PART, 'id="p"')), {}),
        (write_svg((*SHEET, 'id="Sheet 1"'), (-1, 1, 3, 3, 'id="p"')), {}),
        (write_svg((*SHEET, 'class="thick BIN"'), (-1, 1, 3, 3, 'id="p"')), {}),
        (write_svg((*SHEET, 'id="s"'), (-1, 1, 3, 3, 'id="p"')), {}),
        (write_svg((*SHEET, 'id="s"'), (*PART, 'id="p"')), {"container": "S"}),
        (on_layers(layer("Stock", SHEET), layer("cut", (-1, 1, 3, 3, 'id="p"'))), {}),
        (on_layers(layer("frame", (-5, -5, 20, 20)), layer("sheet", SHEET)), {"layers": ["SHEET"]}),
    ],
)
def test_the_container_is_found(text: str, options: dict[str, Any]) -> None:
    if "frame" in text:
        with pytest.raises(FormatError, match="only one outline found"):
            parse_layouts(text, **options)
    else:
        (layout,) = parse_layouts(text, **options)
        assert layout.data["container"]["exterior"][2] == ["9", "9"]
        assert parts_of(text, **options) == ["p"]


def test_other_outlines_on_the_layer_of_the_sheet_are_defects() -> None:
    text = on_layers(layer("sheet", SHEET, (8, 8, 11, 11)), layer("cut", (*PART, 'id="p"')))
    (layout,) = parse_layouts(text)
    assert [one["exterior"][0] for one in layout.data["defects"]] == [["8", "8"]]
    place = "on the layer or in the group of the container"
    assert f"1 outline {place} read as a defect" in layout.notes


def test_each_sheet_is_a_layout() -> None:
    sheets = layer("sheets", SHEET, (20, 0, 29, 9))
    text = on_layers(sheets, layer("cut", (*PART, 'id="p"'), (21, 1, 23, 3, 'id="q"')))
    with pytest.raises(FormatError, match="no outline contains all others"):
        parse_layouts(on_layers(layer("a", SHEET), layer("b", (20, 0, 29, 9))))
    first, second = parse_layouts(text.replace("sheets", "sheet"))
    assert (first.name, second.name) == ("sheet 0", "sheet 1")
    assert [[p["id"] for p in one.data["parts"]] for one in (first, second)] == [["p"], ["q"]]


def test_candidates_for_the_container_are_listed() -> None:
    text = write_svg((0, 0, 9, 9, 'id="a"'), (20, 0, 29, 9, 'id="b"'))
    with pytest.raises(FormatError, match=r"The largest are line 2: rect 'a', 9 x 9; line 3"):
        parse_layouts(text)
    with pytest.raises(FormatError, match="did you mean"):
        parse_layouts(text.replace("'a'", "'able'"), container="bb")


def test_layer_names_ignore_case() -> None:
    text = on_layers(layer("Cut", (*PART, 'id="p"')), layer("engrave", (4, 4, 5, 5)))
    assert [one.name for one in parse_regions(text, layers=["CUT"])] == ["p"]
    found = parse_regions(text, ignored_layers=["Engrave"])
    assert ([one.name for one in found], found.notes) == (
        ["p"],
        ["skipped: 1 shape on the layer 'engrave'"],
    )
    with pytest.raises(FormatError, match="no layer 'cuts'; did you mean 'Cut'"):
        parse_regions(text, layers=["cuts"])
    with pytest.raises(FormatError, match="layers is 'Cut', not a list of strings"):
        parse_regions(text, layers="Cut")


def test_errors_on_a_layer_suggest_ignoring_it() -> None:
    text = on_layers(layer("cut", SHEET, PART)).replace(
        "</g>", '<path fill="none" d="M5 5H6V6"/></g>'
    )
    with pytest.raises(FormatError, match=r"\(--ignore-layer cut skips its layer\)"):
        parse_layouts(text)


def test_points_stay_points() -> None:
    (one,) = nest_outlines(parse_candidates(write_svg(PART))).outlines
    assert all(isinstance(p, Point) for p in one.vertices())


@pytest.mark.parametrize("name", ["sheet", "0"])
def test_a_container_drawn_twice_is_one(name: str) -> None:
    (found,) = parse_layouts(on_layers(layer(name, SHEET, SHEET), layer("cut", PART)))
    assert len(found.data["parts"]) == 1
    assert "defects" not in found.data
    assert "skipped: 1 duplicate of the container" in found.notes


def test_a_part_as_large_as_the_container_is_a_part() -> None:
    (found,) = parse_layouts(on_layers(layer("sheet", SHEET), layer("cut", SHEET)))
    assert len(found.data["parts"]) == 1


NOTCHED = "0,0 4,0 2,2 4,4 0,4", "0,0 4,0 4,4 2,2 0,4"


@pytest.mark.parametrize(
    "other",
    [
        f'<polygon points="{NOTCHED[1]}"/>',
        '<path fill-rule="evenodd" d="M0 0L4 0L2 2L4 4L0 4zM.5 1h1v1h-1z"/>',
    ],
    ids=["same corners", "with a hole"],
)
def test_another_shape_with_the_vertices_of_the_container_is_not_a_copy(other: str) -> None:
    part = '<rect x="0.1" y="1" width="0.1" height="0.1"/>'
    text = f'<svg><polygon points="{NOTCHED[0]}"/>{other}{part}</svg>'
    (found,) = parse_layouts(text, container="0")
    assert not any("duplicate" in note for note in found.notes)
    assert {*NOTCHED[0].split()} <= {
        ",".join(vertex) for one in found.data["parts"] for vertex in one["exterior"]
    }
    with pytest.raises(FormatError, match="no outline contains all others"):
        parse_layouts(text)


@pytest.mark.parametrize(
    "around",
    [
        '<rect x="1" y="1" width="8" height="8"/><rect x="2" y="2" width="6" height="6"/>',
        '<path fill-rule="evenodd" d="M1 1h8v8h-8zM2 2h6v6h-6z"/>',
    ],
    ids=["two outlines", "one path"],
)
def test_an_open_shape_in_a_hole_may_be_a_part(around: str) -> None:
    sheet = '<rect width="20" height="20"/>'
    drawing = f'<svg>{sheet}{around}<polyline fill="none" points="%s"/></svg>'
    (found,) = parse_layouts(drawing % "1.2,3 1.5,4 1.2,5")
    assert found.unchecked == ("1 open shape on parts (line 1)",)
    with pytest.raises(FormatError, match=r"open end at \(3,3\)"):
        parse_layouts(drawing % "3,3 5,3 5,5 3,5 3,3.1")


def test_open_shapes_inside_a_part_are_engraving() -> None:
    line = '<path fill="none" d="M2.5 2.5h1v1"/>'
    engraving = layer("engrave", (2, 2, 6, 6)).replace("</g>", f"{line}</g>")
    (found,) = parse_layouts(
        on_layers(layer("sheet", SHEET), layer("cut", (1, 1, 8, 8)), engraving)
    )
    assert found.unchecked == ("1 open shape on parts (line 4)",)
    assert len(found.data["parts"][0]["holes"]) == 1
