"""Hidden geometry is skipped; ornaments do not reject a file; reports list omissions."""

from collections.abc import Callable
from io import StringIO
from pathlib import Path
from typing import Any

import ezdxf.filemanagement as files
import pytest
from command import run
from ezdxf.document import Drawing as Document

from exactsweep.formats import parse_polygon, parse_polygons

HOLE = [(10, 10), (13, 10), (13, 13), (10, 13)]
SQUARE = [(0, 0), (40, 0), (40, 40), (0, 40)]


def dxf(draw: Callable[[Document], object]) -> str:
    document = files.new("R2010")
    document.units = 0
    draw(document)
    text = StringIO()
    document.write(text)
    return text.getvalue()


def outline(space: Any, corners: list[tuple[int, int]], **attributes: Any) -> None:
    space.add_lwpolyline(corners, close=True, dxfattribs=attributes)


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


def test_hidden_dxf_entities_are_counted() -> None:
    parts = parse_polygons(dxf(hidden))
    # A block on a layer that is off still draws on other layers; on a frozen one, it draws nothing.
    assert [part.layer for part in parts] == ["cut", "guide", "cut"]
    assert [part.polygon.area for part in parts] == [1600, 1600, 9]
    assert parts.left_out == [
        "hidden: 2 LWPOLYLINE on the layer 'off', which is off (--hidden)",
        "hidden: 1 LWPOLYLINE on the layer 'frozen', which is frozen (--hidden)",
        "hidden: 1 LWPOLYLINE on the layer 'DEFPOINTS', which is for dimension points (--hidden)",
        "hidden: 1 LWPOLYLINE marked invisible (--hidden)",
        "hidden: 1 INSERT on the layer 'frozen', which is frozen (--hidden)",
        "hidden: 1 LWPOLYLINE in paper space (--hidden)",
    ]
    assert parts.notes == ["the layer 'guide' does not plot, but is read"]
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


def test_commands_count_hidden_elements(tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    path.write_text(SVG)
    done = run("nfp", f"{path}#part", f"{path}#part")
    assert "skipped: " in done.stderr
    assert "hidden: 1 g with display: none (--hidden)" in done.stderr
    hidden = [line for line in done.stderr.splitlines() if "hidden: " in line]
    swept = run("sweep", f"{path}#part", f"{path}#used").stderr.splitlines()
    assert [line for line in swept if "hidden: " in line] == hidden
    assert run("convert", str(path), "--hidden", "--to", "wkt").stdout.count("POLYGON") == 9


@pytest.mark.parametrize(
    ("shapes", "noted"),
    [
        ("<rect fill='none' width='2' height='2'/>", "a rect"),
        ("<g stroke='none' style='fill: transparent'><path d='M0 0h2v2z'/></g>", "a path"),
        ("<style>.bare{fill:none}</style><circle class='bare' r='2'/>", "a circle"),
        ("<rect id='a' fill='none' width='2' height='2'/><use href='#a' stroke='red'/>", "a rect"),
        ("<rect width='2' height='2'/>", ""),
        ("<rect fill='none' stroke='red' width='2' height='2'/>", ""),
        ("<g stroke='red'><rect fill='none' width='2' height='2'/></g>", ""),
        ("<style>rect{stroke:red}</style><rect fill='none' width='2' height='2'/>", ""),
        ("<defs><path id='a' fill='red' d='M0 0h2v2z'/></defs><use href='#a' fill='none'/>", ""),
    ],
)
def test_an_unpainted_shape_is_read_with_a_note(shapes: str, noted: str) -> None:
    parts = parse_polygons(f"<svg>{shapes}</svg>", tolerance="1/10")
    assert len(parts) == 1 + ("use" in shapes and bool(noted))
    assert parts.notes == ([f"{noted} with neither fill nor stroke is read"] if noted else [])


@pytest.mark.parametrize("element", ["title", "desc", "text", "rect"])
def test_only_style_elements_are_style_sheets(element: str) -> None:
    text = f"<svg><{element}>path{{display:none}}</{element}><path d='M0 0h2v2z'/></svg>"
    assert [part.polygon.area for part in parse_polygons(text)] == [2]


@pytest.mark.parametrize(
    "sheet",
    ["{" * 9999, "}" * 9999, "/*" * 9999, "@" * 9999 + "{", "@a{" * 9999, "rect{}rect{fill:red"],
)
def test_broken_style_sheets_hide_nothing(sheet: str) -> None:
    text = f"<svg><style>{sheet}</style><rect width='2' height='2'/></svg>"
    assert parse_polygon(text).area == 4
