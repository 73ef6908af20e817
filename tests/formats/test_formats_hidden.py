"""Hidden geometry is no part; ornaments lose no file; reports list what is left out."""

from collections.abc import Callable
from fractions import Fraction
from io import StringIO
from pathlib import Path
from typing import Any

import ezdxf.filemanagement as files
import pytest
from command import refusal, run
from ezdxf.document import Drawing as Document

from exactsweep.formats import FormatError, parse_polygon, parse_polygons, parse_regions

SQUARE = [(0, 0), (40, 0), (40, 40), (0, 40)]
HOLE = [(10, 10), (13, 10), (13, 13), (10, 13)]


def dxf(draw: Callable[[Document], object]) -> str:
    document = files.new("R2010")
    document.units = 0
    draw(document)
    text = StringIO()
    document.write(text)
    return text.getvalue()


def outline(space: Any, corners: list[tuple[int, int]], **attributes: Any) -> None:
    space.add_lwpolyline(corners, close=True, dxfattribs=attributes)


def lines(space: Any, corners: list[tuple[int, int]], **attributes: Any) -> None:
    for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
        space.add_line(start, end, dxfattribs=attributes)


def hidden(d: Document) -> None:
    space = d.modelspace()
    outline(space, SQUARE, layer="cut")
    for name, change in (("off", "off"), ("frozen", "freeze"), ("guide", None)):
        layer = d.layers.add(name)
        if change:
            getattr(layer, change)()
        layer.dxf.plot = name != "guide"
        outline(space, SQUARE, layer=name)
    outline(space, SQUARE, layer="DEFPOINTS")
    outline(space, HOLE, layer="cut", invisible=1)
    outline(d.paperspace(), HOLE, layer="cut")
    block = d.blocks.new("PART")
    outline(block, HOLE)
    outline(block, HOLE, layer="cut")
    for name in ("off", "frozen"):
        space.add_blockref("PART", (0, 0), dxfattribs={"layer": name})


def test_hidden_entities_of_dxf_are_counted_and_no_parts() -> None:
    parts = parse_polygons(dxf(hidden))
    # A block on a layer that is off shows what it draws on others; on a frozen one, nothing.
    assert [part.layer for part in parts] == ["cut", "guide", "cut"]
    assert [part.polygon.area for part in parts] == [1600, 1600, 9]
    assert parts.left_out == [
        "hidden: 2 LWPOLYLINE on the layer 'off', which is off (--hidden)",
        "hidden: 1 LWPOLYLINE on the layer 'frozen', which is frozen (--hidden)",
        "hidden: 1 LWPOLYLINE on the layer 'DEFPOINTS', which is for the points of dimensions "
        "(--hidden)",
        "hidden: 1 LWPOLYLINE made invisible (--hidden)",
        "hidden: 1 INSERT on the layer 'frozen', which is frozen (--hidden)",
        "hidden: 1 LWPOLYLINE in paper space (--hidden)",
    ]
    assert parts.notes == ["the layer 'guide' does not plot, and is read"]
    everything = parse_polygons(dxf(hidden), hidden=True)
    assert len(everything) == 11
    assert everything.left_out == []


SVG = """<svg xmlns="http://www.w3.org/2000/svg"><style>
/* .part{display:none} */ @media print { .part, rect { display: none } }
.cls-1, #by-id {display:none} .cls-2{visibility:hidden;fill:none}
</style><defs><rect id="spare" width="1" height="1"/><rect id="used" width="2" height="2"/>
<clipPath><rect width="8" height="8"/></clipPath></defs>
<rect class="part" id="part" width="9" height="9"/><use href="#used"/>
<rect class="other cls-1" width="3" height="3"/><rect id="by-id" width="3" height="3"/>
<g display="none"><rect width="4" height="4"/></g>
<rect style="display : none" width="5" height="5"/>
<g class="cls-2"><rect width="6" height="6"/><rect style="visibility:visible" width="7" height="7"/>
</g></svg>"""


def test_commands_tell_what_is_hidden(tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    path.write_text(SVG)
    done = run("nfp", f"{path}#part", f"{path}#part")
    assert "left out: " in done.stderr
    assert "hidden: 1 g with display none (--hidden)" in done.stderr
    assert run("convert", str(path), "--hidden", "--to", "wkt").stdout.count("POLYGON") == 9


def test_holes_may_be_on_another_layer(tmp_path: Path) -> None:
    def draw(d: Document) -> None:
        outline(d.modelspace(), SQUARE, layer="IV_OUTER_PROFILE")
        outline(d.modelspace(), HOLE, layer="IV_INTERIOR_PROFILES")
        outline(d.modelspace(), [(1, 1), (2, 1), (1, 2)], layer="MARKS")

    text = dxf(draw)
    sizes: dict[bool | str, list[object]] = {
        True: [1600, 9, Fraction(1, 2)],
        "all": [1600 - 9 - Fraction(1, 2)],
        "IV_OUTER_PROFILE,IV_INTERIOR_PROFILES": [1591, Fraction(1, 2)],
    }
    for nested, areas in sizes.items():
        assert [p.region.area for p in parse_regions(text, nested=nested)] == areas
    with pytest.raises(FormatError, match=r"nothing is on a layer 'MARK'; did you mean 'MARKS'"):
        parse_regions(text, nested="MARK,MARKS")
    path = tmp_path / "a.dxf"
    path.write_text(text)
    for nested, areas in sizes.items():
        word = [] if nested is True else [str(nested)]
        done = run("convert", "--nested", *word, str(path), "--to", "json")
        assert [p.region.area for p in parse_regions(done.stdout)] == areas


def ornaments(d: Document) -> None:
    space = d.modelspace()
    outline(space, SQUARE)
    outline(space, HOLE)
    space.add_hatch().paths.add_polyline_path(SQUARE, is_closed=True)
    space.add_line((0, 20), (40, 20))
    space.add_xline((0, 0), (1, 1))
    space.add_ray((0, 0), (1, 1))
    space.add_lwpolyline([(5, 5), (5, 5)])


def test_ornaments_lose_no_file() -> None:
    text = dxf(ornaments)
    (part,) = parse_regions(text, nested=True)
    assert part.region.area == 1591
    parts = parse_polygons(text)
    assert len(parts) == 2
    assert len(parts.left_out) == 5
    kinds = [reason.split(": ")[1] for reason in parts.left_out]
    assert kinds == ["HATCH", "LINE", "XLINE", "RAY", "LWPOLYLINE"]


def test_heights_within_the_distance_are_level() -> None:
    def draw(d: Document) -> None:
        space = d.modelspace()
        corners = [(x, y, 1e-16 * k) for k, (x, y) in enumerate(SQUARE)]
        for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
            space.add_line(start, end)
        space.add_polyline3d(corners, close=True)

    with pytest.raises(FormatError, match=r"different heights \(--join allows a distance\)"):
        parse_polygons(dxf(draw))
    assert [p.polygon.area for p in parse_polygons(dxf(draw), join="1e-9")] == [1600, 1600]


def test_no_outline_vanishes_in_joints(tmp_path: Path) -> None:
    def draw(d: Document) -> None:
        lines(d.modelspace(), SQUARE)
        lines(d.modelspace(), HOLE)

    path = tmp_path / "plate.dxf"
    path.write_text(dxf(draw))
    done = run("convert", str(path), "--join", "5", "--to", "wkt")
    assert done.stdout == "POLYGON ((0 0, 40 0, 40 40, 0 40, 0 0))\n"
    assert "LINE: 4 lines vanished, shorter than ends may be apart" in done.stderr
    refused = refusal(run("convert", str(path), "--join=5", "--nested", "--to=wkt"))
    assert "4 lines vanished" in refused
    # With a distance between side and diagonal, the hole falls together to one line.
    assert "with all of their layer" in refusal(
        run("convert", str(path), "--join=4", "--nested", "--to=wkt")
    )
    (part,) = parse_regions(path.read_text(), join=1, nested=True)
    assert part.region.area == 1591


@pytest.mark.parametrize(
    "sheet",
    ["{" * 9999, "}" * 9999, "/*" * 9999, "@" * 9999 + "{", "@a{" * 9999, "rect{}rect{fill:red"],
)
def test_broken_style_sheets_hide_nothing(sheet: str) -> None:
    text = f"<svg><style>{sheet}</style><rect width='2' height='2'/></svg>"
    assert parse_polygon(text).area == 4
