"""Part files as CAD programs and drawing programs write them, each with what is in it.

A drawing has at most two options, and either the areas of its regions, in order, or the reason for
which it is refused. The shapes are small; what differs is how programs write them.
"""

import io
from collections.abc import Callable, Sequence
from itertools import pairwise
from math import cos, pi, radians, sin, sqrt
from typing import Any, NamedTuple

import ezdxf.filemanagement as files
from ezdxf.document import Drawing as Document
from ezdxf.math import fit_points_to_cad_cv

SQUARE = [(0, 0), (40, 0), (40, 40), (0, 40)]
PLATE = [(0, 0), (60, 0), (60, 30), (40, 30), (40, 10), (20, 10), (20, 30), (0, 30)]
FINE = ("--flatten", "0.001")


class Drawing(NamedTuple):
    """A file.

    Attributes:
        name: with its ending.
        text: what is in it.
        areas: of its regions, in order; () if it is refused.
        options: at most two, with their values.
        reason: the reason of the refusal, or the report of omissions.
    """

    name: str
    text: str
    areas: tuple[float, ...]
    options: tuple[str, ...] = ()
    reason: str = ""


def every_drawing() -> list[Drawing]:
    """Return all sixty."""
    return [*svg_drawings(), *dxf_drawings()]


def _svg(body: str, attributes: str = 'width="100mm" height="100mm" viewBox="0 0 100 100"') -> str:
    spaces = (
        'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        'xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd"'
    )
    head = '<?xml version="1.0" encoding="UTF-8" standalone="no"?>\n'
    return f'{head}<svg {attributes} version="1.1" {spaces}>\n{body}\n</svg>\n'


def _layer(body: str, label: str = "Layer 1", transform: str = "") -> str:
    moved = f' transform="{transform}"' if transform else ""
    return (
        f'<g inkscape:label="{label}" inkscape:groupmode="layer" id="{label.lower()}"{moved}>'
        f"{body}</g>"
    )


def svg_drawings() -> list[Drawing]:
    """Return thirty SVG documents."""
    circle = pi * 100
    named_view = '<sodipodi:namedview id="base" pagecolor="#fff" inkscape:zoom="1"/><defs id="d"/>'
    square = '<path d="M 0,0 H 40 V 40 H 0 Z" id="part" style="fill:none;stroke:#000"/>'
    segments = "".join(
        f'<line x1="{a}" y1="{b}" x2="{c}" y2="{d}" stroke="black" stroke-width="0.1"/>'
        for (a, b), (c, d) in zip(PLATE, [*PLATE[1:], PLATE[0]], strict=True)
    )
    entity = '<!DOCTYPE svg [<!ENTITY ns_svg "http://www.w3.org/2000/svg">]>'
    round_slot = (
        '<path d="M 10,0 L 30,0" fill="none"/><path d="M 30,0 A 10,10 0 0 1 30,20" fill="none"/>'
        '<path d="M 30,20 L 10,20" fill="none"/><path d="M 10,20 A 10 10 0 0 1 10,0" fill="none"/>'
    )
    gaps = (
        '<polyline points="0,0 40.0000004,0 40,40" fill="none"/>'
        '<polyline points="40.0000001,39.9999997 0,40 0,0.0000003" fill="none"/>'
    )
    ellipse = pi * 20 * 10
    found = [
        ("inkscape-rect", _svg(named_view + _layer('<rect id="r1" width="40" height="30" x="5" '
            'y="5" style="fill:#00f"/>')), (1200,), ()),
        ("inkscape-relative-path", _svg(named_view + _layer(
            '<path style="fill:none" d="m 10,10 40,0 0,20 -40,0 z" id="path1"/>')), (800,), ()),
        ("inkscape-curves", _svg(_layer('<path id="blob" d="m 0,0 c 0,10 10,10 10,0 0,-10 '
            '-10,-10 -10,0 z" sodipodi:nodetypes="ccc"/>')), (120,), FINE),
        ("inkscape-hole", _svg(_layer('<path style="fill-rule:evenodd" id="ring" '
            'd="M 0,0 H 40 V 40 H 0 Z M 10,10 V 30 H 30 V 10 Z"/>')), (1200,), ()),
        ("inkscape-clone-turned", _svg(_layer('<rect id="r" width="20" height="10"/>'
            '<use x="0" y="0" xlink:href="#r" id="use1" transform="rotate(30,5,5)"/>')),
            (200, 200), FINE),
        ("inkscape-groups", _svg(_layer(f'<g transform="matrix(1.5 0 0 1.5 3 4)">{square}</g>',
            transform="translate(-10,-20)")), (3600,), ()),
        ("inkscape-circle-path", _svg(_layer('<path id="c" sodipodi:type="arc" d="m 30,20 a 10,10 '
            '0 0 1 -10,10 10,10 0 0 1 -10,-10 10,10 0 0 1 10,-10 10,10 0 0 1 10,10 z"/>')),
            (circle,), FINE),
        ("inkscape-layers", _svg(_layer(square, "Cut") + _layer('<text x="3" y="9">Part 1</text>'
            '<path d="M 0,0 L 9,9" id="fold"/>', "Fold")), (1600,), (),
            "path 'fold': the end (0,0) meets no other end exactly"),
        ("inkscape-turned-group", _svg(_layer(square, transform="rotate(-12.5)")), (1600,), FINE),
        ("inkscape-millimetres", _svg(square, 'width="4in" height="4in" viewBox="0 0 101.6 101.6"'),
            (1600,), ("--unit", "mm")),
        ("illustrator-polygon", _svg('<style type="text/css">.st0{fill:#FFF;stroke:#000}</style>'
            '<polygon class="st0" points="0,0 40,0 40,40 0,40 "/>', 'id="Layer_1" x="0px" y="0px" '
            'viewBox="0 0 100 100" style="enable-background:new 0 0 100 100;"'), (1600,), ()),
        ("illustrator-curves", _svg('<path class="st0" d="M0,0C0,0,0,10,5,10S10,0,10,0v-5H0V0z"/>',
            'id="Ebene_1" x="0px" y="0px" viewBox="0 0 100 100"'), (130,), FINE),
        ("illustrator-switch", _svg('<switch><foreignObject requiredExtensions="http://ns.adobe'
            f'.com/AdobeIllustrator/10.0/" x="0" y="0" width="1" height="1"/><g>{square}</g>'
            "</switch>"), (1600,), ()),
        ("illustrator-compound", _svg('<path d="M0,0h40v40H0V0z M10,10v20h20V10H10z M50,0h9v9h-9V0z'
            '"/>'), (1200, 81), ()),
        ("illustrator-symbol", _svg('<symbol id="s" viewBox="0 0 10 10"><rect width="10" '
            'height="10"/></symbol><use xlink:href="#s" width="20" height="20" x="3" y="4"/><use '
            'xlink:href="#s" width="40" height="20" transform="matrix(1 0 0 -1 9 9)"/>'),
            (400, 400), ()),
        ("illustrator-entities", entity + _svg(square).partition("\n")[2].replace(
            '"http://www.w3.org/2000/svg"', '"&ns_svg;"'), (1600,), ()),
        ("coreldraw", _svg('<defs><style><![CDATA[.fil0 {fill:none;fill-rule:evenodd}]]></style>'
            '</defs><g id="Ebene_x0020_1"><polygon class="fil0" points="0,0 40,0 40,40 0,40"/></g>',
            'xml:space="preserve" width="210mm" height="297mm" viewBox="0 0 21000 29700"'),
            (1600,), ()),
        ("coreldraw-centimetres", _svg('<polygon points="0,0 1000,0 1000,1000 0,1000"/>',
            'width="210mm" height="297mm" viewBox="0 0 21000 29700"'), (1,), ("--unit", "cm")),
        ("librecad", _svg(_layer(segments)), (1400,), ()),
        ("librecad-arcs", _svg(_layer(round_slot)), (400 + circle,), FINE),
        ("qcad-gaps", _svg(gaps), (1600,), ("--join", "1e-6")),
        ("freecad", _svg('<g id="Body" transform="translate(0,50) scale(1,-1)"><path d="M 0 0 L 40 '
            '0 L 40 40 L 0 40 L 0 0 "/></g>'), (1600,), ()),
        ("freecad-ellipse", _svg('<path d="M 20 0 A 20 10 30 0 1 -20 0 A 20 10 30 0 1 20 0" '
            'transform="scale(1 1)"/>'), (_turned_ellipse(20, 10, 30, 20),), FINE),
        ("openscad", _svg('<title>OpenSCAD Model</title><path d="M 0,-0 L 40,-0 L 40,-40 L 0,-40 z '
            'M 10,-10 L 10,-30 L 30,-30 L 30,-10 z" stroke="black" fill="lightgray"/>'),
            (1200,), ()),
        ("onshape-nested", _svg('<svg x="10" y="10" width="50" height="50" viewBox="0 0 100 100">'
            f"{square}</svg>"), (400,), ()),
        ("fusion", _svg('<g fill="none" stroke="#000" transform="scale(10 -10)">'
            '<path d="M0 0L4 0"/><path d="M4 0L4 4"/><path d="M4 4L0 4"/><path d="M0 4L0 0"/><path '
            'd="M3 2A1 1 0 1 0 1 2A1 1 0 1 0 3 2"/></g>'), (1600 - circle,),
            ("--flatten", "0.001", "--nested")),
        ("affinity", _svg('<g transform="matrix(1,0,0,1,-20,-20)"><g transform="matrix(0.5,0,0,0.5,'
            f'10,10)">{square}</g></g>', 'width="100%" height="100%" viewBox="0 0 100 100"'),
            (400,), ()),
        ("matplotlib", _svg('<defs><clipPath id="p"><rect width="9" height="9"/></clipPath><path '
            'id="m" d="M 0 3 L 3 0 L -3 0 z"/></defs><g clip-path="url(#p)"><use xlink:href="#m" '
            'x="10" y="20"/><use xlink:href="#m" x="30" y="20"/></g>'), (9, 9), ()),
        ("figma", _svg('<rect x="0.5" y="0.5" width="40" height="30" rx="5" fill="#D9D9D9"/>'
            '<mask id="k"><rect width="9" height="9"/></mask>'), (1200 - 100 + 25 * pi,), FINE),
        ("cricut", _svg('<ellipse cx="50" cy="50" rx="20" ry="10" transform="rotate(33 50 50)"/>'),
            (ellipse,), FINE),
    ]  # fmt: skip
    return [Drawing(f"{name}.svg", *rest) for name, *rest in found]  # type: ignore[arg-type]


def _turned_ellipse(a: float, b: float, degrees: float, x: float) -> float:
    """The area of an ellipse of this shape through (x, 0) and (-x, 0)."""
    turn = radians(degrees)
    grow = max(1.0, (x * cos(turn) / a) ** 2 + (x * sin(turn) / b) ** 2)
    return pi * a * b * grow


def _dxf(draw: Callable[[Document], object], version: str = "R2010", unit: int = 0) -> str:
    document = files.new(version)
    document.units = unit
    draw(document)
    text = io.StringIO()
    document.write(text)
    return text.getvalue()


def _twice(d: Document) -> None:
    _lines(d.modelspace(), SQUARE)
    _lines(d.modelspace(), SQUARE[::-1])


def _lines(space: Any, corners: Sequence[tuple[float, float]], **attributes: Any) -> None:
    for k, start in enumerate(corners):
        ends = [start, corners[(k + 1) % len(corners)]]
        space.add_line(*ends[:: 1 if k % 2 else -1], dxfattribs=attributes)


def _tags(*tags: tuple[int, object]) -> str:
    around = [(0, "SECTION"), (2, "ENTITIES"), *tags, (0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:>3}\r\n{value}\r\n" for code, value in around)


def dxf_drawings() -> list[Drawing]:
    """Return thirty DXF files."""
    circle = pi * 100
    found = [
        ("r12-lines", _dxf(lambda d: _lines(d.modelspace(), PLATE), "R12"), (1400,), ()),
        ("r12-polyline", _dxf(lambda d: d.modelspace().add_polyline2d(PLATE, close=True), "R12"),
            (1400,), ()),
        ("r12-bulges", _dxf(_r12_bulges, "R12"), (400 + circle,), FINE),
        ("r12-by-hand", _tags(*[tag for a, b in zip(SQUARE, SQUARE[1:] + SQUARE[:1], strict=True)
            for tag in ((0, "LINE"), (8, "0"), (10, a[0]), (20, f"{a[1]:.6f}"), (30, "0.0"),
            (11, b[0]), (21, f"{b[1]:.6f}"), (31, "0.0"))]), (1600,), ()),
        ("r12-block-turned", _dxf(_block(rotation=30), "R12"), (1600,), FINE),
        ("r2000-block-mirrored", _dxf(_block(xscale=-1, yscale=2), "R2000"), (3200,), ()),
        ("r2000-blocks-nested", _dxf(_nested_blocks, "R2000"), (1600 * 4 - circle * 4,),
            ("--flatten", "0.001", "--nested")),
        ("r2000-rows-and-columns", _dxf(_block(row_count=2, column_count=3, row_spacing=50,
            column_spacing=50), "R2000"), (1600,) * 6, ()),
        ("r2000-elevated", _dxf(lambda d: d.modelspace().add_lwpolyline(SQUARE, close=True,
            dxfattribs={"elevation": 12.5}), "R2000"), (1600,), ()),
        ("r2000-mirrored", _dxf(lambda d: d.modelspace().add_lwpolyline(PLATE, close=True,
            dxfattribs={"extrusion": (0, 0, -1)}), "R2000"), (1400,), ()),
        ("r2000-mirrored-arcs", _dxf(_mirrored_slot, "R2000"), (400 + circle,), FINE),
        ("r2000-ellipse", _dxf(lambda d: d.modelspace().add_ellipse((5, 5), (20, 10), 0.5),
            "R2000"), (pi * 500 / 2,), FINE),
        ("r2000-half-ellipse", _dxf(_half_ellipse, "R2000"), (pi * 400 * 0.5 / 2,), FINE),
        ("r2010-spline", _dxf(_closed_spline), (_spline_area(),), FINE),
        ("r2010-spline-and-line", _dxf(_spline_and_line), (240,), FINE),
        ("r2010-rational-spline", _dxf(_rational_circle), (circle,), FINE),
        ("r2010-fit-points", _dxf(_fit_points), (1200 + _fitted_area(),), FINE),
        ("r12-spline-fitted", _tags(*_spline_fitted()), (500,), ()),
        ("r2010-in-space", _dxf(lambda d: d.modelspace().add_polyline3d(
            [(x, y, 5) for x, y in SQUARE], close=True)), (1600,), ()),
        ("r2010-gaps", _dxf(_gaps), (1600,), ("--join", "1e-6")),
        ("r2010-twice", _dxf(_twice), (1600,), ()),
        ("r2010-inches", _dxf(lambda d: d.modelspace().add_lwpolyline(
            [(0, 0), (1, 0), (1, 1), (0, 1)], close=True), unit=1), (645.16,), ("--unit", "mm")),
        ("r2010-noted", _dxf(_noted, unit=4), (1600,), ()),
        ("r2010-layers", _dxf(_layers), (1600,), (), "LINE: the end (0,0) meets no other end"),
        ("r2010-holes", _dxf(_holes), (1600 - 2 * pi * 16,), ("--flatten", "0.001", "--nested")),
        ("r2010-donut", _dxf(lambda d: d.modelspace().add_lwpolyline([(0, 0, 0, 0, 1),
            (20, 0, 0, 0, 1)], close=True)), (circle,), FINE),
        ("r2010-hatched", _dxf(_hatched), (1600,), (), "HATCH: no outline"),
        ("r2010-tangent-arcs", _dxf(_slot_turned), (400 + circle,), FINE),
        ("r2010-ray", _dxf(lambda d: d.modelspace().add_ray((0, 0), (1, 0))), (), (),
            "RAY: no outline"),
        ("r2010-in-a-plane-of-its-own", _dxf(lambda d: d.modelspace().add_lwpolyline(SQUARE,
            close=True, dxfattribs={"extrusion": (0, 1, 1)})), (), (),
            "drawn in a plane of its own"),
    ]  # fmt: skip
    return [Drawing(f"{name}.dxf", *rest) for name, *rest in found]  # type: ignore[arg-type]


def _r12_bulges(d: Document) -> None:
    corners = [(0, 0, 0), (20, 0, 1), (20, 20, 0), (0, 20, 1)]
    d.modelspace().add_polyline2d(corners, format="xyb", close=True)


def _block(**insert: Any) -> Callable[[Document], None]:
    def draw(d: Document) -> None:
        part = d.blocks.new("PART", base_point=(5, 5))
        part.add_lwpolyline(SQUARE, close=True) if d.dxfversion > "AC1009" else (
            part.add_polyline2d(SQUARE, close=True)
        )
        d.modelspace().add_blockref("PART", (100, 50), dxfattribs={"layer": "cut", **insert})

    return draw


def _nested_blocks(d: Document) -> None:
    hole = d.blocks.new("HOLE")
    hole.add_circle((0, 0), 10)
    part = d.blocks.new("PLATE")
    part.add_lwpolyline(SQUARE, close=True)
    part.add_blockref("HOLE", (20, 20))
    d.modelspace().add_blockref(
        "PLATE", (7, 7), dxfattribs={"xscale": 2, "yscale": 2, "rotation": 37.5, "layer": "cut"}
    )


def _mirrored_slot(d: Document) -> None:
    space = d.modelspace()
    mirrored = {"extrusion": (0, 0, -1)}
    space.add_line((-10, 0), (-30, 0))
    space.add_arc((30, 10), 10, 270, 90, dxfattribs=mirrored)
    space.add_line((-30, 20), (-10, 20))
    space.add_arc((10, 10), 10, 90, 270, dxfattribs=mirrored)


def _half_ellipse(d: Document) -> None:
    d.modelspace().add_ellipse((0, 0), (20, 0), 0.5, 0, pi)
    d.modelspace().add_line((-20, 0), (20, 0))


def _closed_spline(d: Document) -> None:
    spline = d.modelspace().add_spline(degree=3)
    points = [(0, 0, 0), (40, 0, 0), (40, 40, 0), (0, 40, 0)]
    spline.control_points = [*points, *points[:3]]
    spline.knots = list(range(11))
    spline.closed = True


def _spline_area() -> float:
    """Of the closed uniform cubic spline around a square of side 40, by many points of it."""
    corners = [(0, 0), (40, 0), (40, 40), (0, 40)]
    points = []
    for k in range(4):
        p = [corners[(k + j) % 4] for j in range(4)]
        for step in range(1000):
            t = step / 1000
            w = ((1 - t) ** 3, 3 * t**3 - 6 * t**2 + 4, -3 * t**3 + 3 * t**2 + 3 * t + 1, t**3)
            points.append(
                tuple(sum(c * q[i] for c, q in zip(w, p, strict=True)) / 6 for i in (0, 1))
            )
    turned = zip(points, points[1:] + points[:1], strict=True)
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in turned) / 2


def _spline_and_line(d: Document) -> None:
    spline = d.modelspace().add_spline(degree=3)
    spline.control_points = [(0, 0, 0), (0, 20, 0), (20, 20, 0), (20, 0, 0)]
    spline.knots = [0, 0, 0, 0, 1, 1, 1, 1]
    d.modelspace().add_line((20, 0), (0, 0))


def _rational_circle(d: Document) -> None:
    spline = d.modelspace().add_spline(degree=2)
    ring = [(10, 0), (10, 10), (0, 10), (-10, 10), (-10, 0), (-10, -10), (0, -10), (10, -10)]
    spline.control_points = [(x, y, 0) for x, y in [*ring, ring[0]]]
    spline.knots = [0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4]
    spline.weights = [1, sqrt(0.5)] * 4 + [1]


def _fit_points(d: Document) -> None:
    d.modelspace().add_spline(fit_points=[(40, 30), (20, 40), (0, 30)])
    d.modelspace().add_lwpolyline([(0, 30), (0, 0), (40, 0), (40, 30)])


def _fitted_area() -> float:
    """The area between the spline and the line that its ends are on, by ezdxf."""
    spline = fit_points_to_cad_cv([(40, 30), (20, 40), (0, 30)])
    points = list(pairwise(spline.flattening(1e-5)))
    return float(sum(a.x * b.y - a.y * b.x for a, b in points)) / 2 - 600


def _spline_fitted() -> list[tuple[int, object]]:
    """A POLYLINE with the vertices that the program made of its frame."""
    tags: list[tuple[int, object]] = [(0, "POLYLINE"), (8, "0"), (66, 1), (70, 1 | 4), (75, 6)]
    corners = [(0, 0, 16), (30, 0, 16), (30, 30, 16), (0, 30, 16)]
    corners += [(5, 0, 8), (25, 0, 8), (30, 10, 8), (25, 20, 8), (5, 20, 8), (0, 10, 8)]
    for x, y, flags in corners:
        tags += [(0, "VERTEX"), (8, "0"), (10, x), (20, y), (30, 0), (70, flags)]
    return [*tags, (0, "SEQEND"), (8, "0")]


def _gaps(d: Document) -> None:
    space = d.modelspace()
    space.add_line((0, 0), (40, 1e-12))
    space.add_line((40 + 1e-9, 0), (40, 40 - 3e-7))
    space.add_lwpolyline([(40, 40), (0, 40), (2e-7, 3e-7)])


def _noted(d: Document) -> None:
    space = d.modelspace()
    space.add_lwpolyline(SQUARE, close=True)
    space.add_text("PART 7", dxfattribs={"layer": "notes"}).set_placement((3, 3))
    space.add_linear_dim(base=(0, -9), p1=(0, 0), p2=(40, 0)).render()
    space.add_mtext("steel")
    space.add_point((1, 1))


def _layers(d: Document) -> None:
    d.modelspace().add_lwpolyline(SQUARE, close=True, dxfattribs={"layer": "cut"})
    d.modelspace().add_line((0, 0), (40, 40), dxfattribs={"layer": "fold"})


def _holes(d: Document) -> None:
    space = d.modelspace()
    space.add_lwpolyline(SQUARE, close=True)
    for x in (10, 30):
        space.add_circle((x, 20), 4)


def _hatched(d: Document) -> None:
    d.modelspace().add_lwpolyline(SQUARE, close=True)
    d.modelspace().add_hatch().paths.add_polyline_path(SQUARE, is_closed=True)


def _slot_turned(d: Document) -> None:
    """A slot turned by 30 degrees, its ends as binary floats that miss each other."""
    c, s = cos(pi / 6), sin(pi / 6)
    one, other = (0.0, 0.0), (20 * c, 20 * s)
    space = d.modelspace()
    space.add_line((10 * s, -10 * c), (20 * c + 10 * s, 20 * s - 10 * c))
    space.add_arc(other, 10, -60, 120)
    space.add_line((20 * c - 10 * s, 20 * s + 10 * c), (-10 * s, 10 * c))
    space.add_arc(one, 10, 120, 300)
