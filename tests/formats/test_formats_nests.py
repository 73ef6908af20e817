"""SVG of nesting programs: each part is placed as drawn, or the file is rejected."""

from __future__ import annotations

from fractions import Fraction
from typing import Any

import pytest
from linear import require_linear

from exactsweep.formats import FormatError
from exactsweep.formats.layouts import FoundLayout, parse_layouts
from exactsweep.layout import Layout, judge_layout

PART = '<path d="M0 0H2V2H0z"/>'
USE = '<use href="#item_0" transform="translate(1 1), rotate(0)"/>'
GROUP = f'<g transform="translate(5 1) rotate(0)">{PART}</g>'


def read_sparrow(items: str, attributes: str = "", **options: Any) -> FoundLayout:
    """Read an SVG as sparrow writes it."""
    return read(
        '<g id="container_0"><path d="M0 0H9V9H0z"/></g>'
        f'<g id="items"{attributes}><defs><g id="item_0">{PART}</g></defs>{items}</g>',
        **options,
    )


def read_nest(parts: str, **options: Any) -> FoundLayout:
    """Read an SVG as SVGnest writes it."""
    return read(f'<rect class="bin" width="9" height="9"/>{parts}', **options)


def read(drawn: str, **options: Any) -> FoundLayout:
    (found,) = parse_layouts(f"<svg>{drawn}</svg>", **options)
    return found


def test_items_are_not_moved_away_from_their_container() -> None:
    assert len(read_sparrow(USE).data["placements"]) == 1
    with pytest.raises(FormatError, match="g 'items': moved differently from the container"):
        read_sparrow(USE, ' transform="translate(99 0)"')


@pytest.mark.parametrize("read", [read_sparrow, read_nest])
@pytest.mark.parametrize(
    ("attribute", "reason"),
    [
        ('x="99"', r"expected translate\(\.\.\.\) rotate"),
        ('style="transform: translate(99px, 0)"', "transformations in a style"),
        ('transform-origin="9 9"', "transform-origin is not supported"),
    ],
)
def test_transformations_of_parts_are_read_or_rejected(
    read: Any, attribute: str, reason: str
) -> None:
    part = USE if read is read_sparrow else GROUP
    with pytest.raises(FormatError, match=reason):
        read(part.replace("transform", f"{attribute} transform", 1))


@pytest.mark.parametrize("stray", [PART, f"<g><g>{PART}</g></g>", f"<g>{USE}</g>"])
def test_a_shape_outside_all_parts_is_rejected(stray: str) -> None:
    with pytest.raises(FormatError, match="neither a sheet nor a placed part"):
        read_sparrow(USE + stray)
    with pytest.raises(FormatError, match="neither a sheet nor a placed part"):
        read(f'<g><rect class="bin" width="9" height="9"/>{GROUP}</g>{stray}')


@pytest.mark.parametrize("how", ['display="none"', 'class="off"', 'visibility="hidden"'])
def test_hidden_parts_of_sparrow_are_omitted(how: str) -> None:
    style = "<style>.off {display: none}</style>"
    hidden = USE.replace("<use", f"<use {how}")
    found = read_sparrow(style + hidden + USE)
    assert len(found.data["placements"]) == 1
    assert [note.startswith("hidden: 1 use ") for note in found.notes] == [True]
    assert len(read_sparrow(style + hidden + USE, hidden=True).data["placements"]) == 2


@pytest.mark.parametrize("how", ['display="none"', 'class="off"'])
def test_hidden_parts_of_svgnest_are_omitted(how: str) -> None:
    style = "<style>.off {display: none}</style>"
    found = read_nest(f"{style}{GROUP.replace('<g', f'<g {how}')}{GROUP}<g/>")
    assert len(found.data["placements"]) == 1
    assert found.notes == ("hidden: 1 g with display: none (--hidden)",)
    inside = read_nest(style + GROUP.replace(PART, PART.replace("<path", f"<path {how}") + PART))
    assert inside.data == read_nest(GROUP).data


def test_hidden_outlines_of_a_drawing_are_omitted_with_a_note() -> None:
    hidden = PART.replace("<path", '<path display="none"')
    drawn = f'<rect width="9" height="9"/>{PART}{hidden}'
    found = read(drawn)
    assert len(found.data["parts"]) == 1
    assert found.notes == ("hidden: 1 path with display: none (--hidden)",)
    assert len(read(drawn, hidden=True).data["parts"]) == 2


@pytest.mark.parametrize("unread", ['<circle r="x"/>', '<path fill="none" d="M1 1H3V3H2"/>'])
def test_an_unreadable_outline_rejects_the_layout(unread: str) -> None:
    with pytest.raises(FormatError, match=r"^line 1: (circle|path): "):
        read(f'<rect width="9" height="9"/>{PART}{unread}')
    ornament = read(f'<rect width="9" height="9"/>{PART}<line x2="3"/>')
    assert [note.startswith("skipped: line 1: line: ") for note in ornament.notes] == [True]


def test_a_sheet_lists_its_own_parts_only() -> None:
    sheet = '<g><rect class="bin" width="9" height="9"/><g transform="translate(1)">{}</g></g>'
    drawn = "".join(sheet.format(f'<path d="M0 0H{k}V1z"/>') for k in range(1, 5))
    found = parse_layouts(f"<svg>{drawn}</svg>")
    assert [[part["id"] for part in one.data["parts"]] for one in found] == [[k] for k in "0123"]


def test_a_drawing_of_one_outline_is_not_a_layout() -> None:
    with pytest.raises(FormatError, match=r"^only one outline found; a layout needs"):
        parse_layouts("[[0, 0], [2, 0], [2, 1]]")


def test_parts_inherit_the_fill_rule() -> None:
    holed = PART.replace("z", "zM.5 .5H1V1H.5z")
    nest = read_nest(f'<g fill-rule="evenodd" transform="translate(1 1)">{holed}</g>')
    use = USE.replace("<use", '<use style="fill-rule: evenodd"').replace("item_0", "item_1")
    sparrow = read_sparrow(f'<defs><g id="item_1">{holed}</g></defs>{use}')
    for found in (nest, sparrow):
        (part,) = found.data["parts"]
        assert part["holes"] == [[["1/2", "1/2"], ["1/2", "1"], ["1", "1"], ["1", "1/2"]]]


def test_the_first_of_two_items_with_one_id_counts() -> None:
    other = '<defs><g id="item_0"><path d="M0 0H1V1z"/></g></defs>'
    assert read_sparrow(other + USE).data == read_sparrow(USE).data


@pytest.mark.parametrize("read", [read_sparrow, read_nest])
def test_style_sheets_are_read_once_for_all_parts(read: Any) -> None:
    def read_many(n: int) -> None:
        style = "".join(f".c{k} {{display: inline}}" for k in range(n))
        part = USE if read is read_sparrow else GROUP
        assert len(read(f"<style>{style}</style>{part * n}").data["placements"]) == n

    require_linear(read_many, size=100)


def test_a_group_may_be_the_container_with_its_defects() -> None:
    found = read(
        '<g id="Plate"><rect id="edge" width="9" height="9"/><path d="M1 1h1v1z"/></g>'
        '<path id="part" d="M4 4h2v2z"/>',
        container="plate",
    )
    assert [part["id"] for part in found.data["parts"]] == ["part"]
    assert found.data["container"]["exterior"][2] == ["9", "9"]
    assert len(found.data["defects"]) == 1
    with pytest.raises(FormatError, match="no outline of the group 'pair' contains the others"):
        read(f'<g id="pair">{PART}<path d="M4 4h2v2z"/></g>', container="pair")


def test_artwork_around_a_part_may_not_be_a_hole() -> None:
    """Without the outline on the other layer, the inner part overlaps the outer one."""
    layer = '<g xmlns:i="http://www.inkscape.org/namespaces/inkscape" i:groupmode="layer" i:label='
    cut = f'{layer}"cut"><path id="a" d="M1 1H8V8H1z"/><path id="b" d="M3 3H4V4H3z"/></g>'
    art = f'{layer}"art"><path id="c" d="M2 2H6V6H2z"/></g>'
    found = read(f'<rect id="sheet" width="9" height="9"/>{cut}{art}')
    (doubt,) = found.unchecked
    assert "path 'c' on the layer 'art' is a hole of" in doubt
    assert "--ignore-layer art" in doubt
    inner = cut.replace('"cut"', '"art"')
    assert read(f'<rect id="sheet" width="9" height="9"/>{inner}{art}').unchecked == ()


def test_a_nest_in_a_single_unfilled_path_has_its_parts() -> None:
    lines = "M0 0h9v9h-9z M1 1h3v3h-3z M2 2h1v1h-1z M3.5 1h3v3h-3z"
    (found,) = parse_layouts(f'<svg><path fill="none" stroke="red" d="{lines}"/></svg>')
    assert [len(part.get("holes", [])) for part in found.data["parts"]] == [1, 0]
    (fault,) = judge_layout(Layout.from_json(found.data)).faults
    assert (fault.kind, fault.depth_squared) == ("overlap", Fraction(1, 4))
