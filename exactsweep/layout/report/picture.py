"""Pictures of judged layouts: all parts, with faults in red and enlarged.

Coordinates are clipped and scaled exactly, and converted to floats last, so the enlargement shows
even an overlap of 10^-15 of the picture.
"""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from html import escape
from importlib.resources import files
from itertools import chain
from typing import NamedTuple

from exactsweep.canvas import style
from exactsweep.canvas.svg import write_path
from exactsweep.canvas.window import Window
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.region import Region
from exactsweep.layout.judge import Judgement
from exactsweep.layout.layout import Layout
from exactsweep.layout.pieces import clip
from exactsweep.layout.report.outline import list_corners, list_vertices, place_pieces, write_arcs
from exactsweep.layout.report.worst import NO_CONTEXT, ReportContext, WorstFirst, rank_faults
from exactsweep.layout.rounded import RoundedPiece
from exactsweep.numbers.number import Point, Vertex
from exactsweep.text.report import approximate, take_root
from exactsweep.words import count, spell_out

_WIDTH, _NARROW, _LEAST, _MOST = 960, 480, 160, 640
_MARGIN, _GAP, _LINE = 14, 20, 20
_MAX_ENLARGED, _MAX_LABELED = 12, 150
SIDE = 218  # of an enlarged square, in pixels
_ROUND = 3
_BITS = 64


def write_style() -> str:
    own = files("exactsweep.layout.report").joinpath("picture.css").read_text("utf-8")
    return style.write_style_sheet() + "\n" + own.replace("$fault", style.RED)


class Enlarged(NamedTuple):
    """An enlarged fault: its number from 1, a caption, and the SVG of a square of SIDE pixels."""

    number: int
    caption: str
    svg: str


def draw_layout(
    judgement: Judgement,
    ranked: Sequence[WorstFirst],
    title: str,
    *,
    y_down: bool = False,
    context: ReportContext = NO_CONTEXT,
) -> str:
    """Draw a layout as an SVG image, with its faults enlarged below; with `y_down`, Y points down.

    Raises:
        DrawError: a point is too far outside the picture.
    """
    width, height, main = draw_parts(judgement, ranked, y_down=y_down)
    panels = enlarge_faults(judgement, ranked, y_down=y_down, context=context)
    across = (width - 2 * _MARGIN + _GAP) // (SIDE + _GAP)
    drawn = []
    for k, panel in enumerate(panels):
        row, column = divmod(k, across)
        x, y = _MARGIN + column * (SIDE + _GAP), height + _GAP + row * (SIDE + _GAP + 2 * _LINE)
        first, _, rest = panel.caption.partition("; ")
        drawn.append(
            f'<svg x="{x}" y="{y}" width="{SIDE}" height="{SIDE}">{panel.svg}</svg>'
            f'<text x="{x}" y="{y + SIDE + 16}">{panel.number}: {escape(first)}</text>'
            f'<text x="{x}" y="{y + SIDE + 34}">{escape(rest)}</text>'
        )
    rows = -(-len(panels) // across)
    total = height + rows * (SIDE + _GAP + 2 * _LINE)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="layout" viewBox="0 0 {width} {total}" '
        f'width="{width}" height="{total}" role="img"><title>{escape(title)}</title>'
        f"<style>{write_style()}</style>"
        f'<rect class="paper" width="100%" height="100%"/>{main}{"".join(drawn)}</svg>\n'
    )


class LayoutPicture:
    """The picture of a Judgement in a notebook; faults are ranked and drawn when it is shown."""

    def __init__(self, judgement: Judgement) -> None:
        self.judgement = judgement

    def __repr__(self) -> str:
        return f"<LayoutPicture: {count(len(self.judgement.layout.placements), 'placement')}>"

    def _repr_svg_(self) -> str:
        return draw_layout(self.judgement, rank_faults(self.judgement), "a layout")


def draw_parts(
    judgement: Judgement, ranked: Sequence[WorstFirst], *, y_down: bool = False
) -> tuple[int, int, str]:
    """Draw container and placements, with faults in red; return width, height and SVG elements."""
    layout = judgement.layout
    placed = [place_shape(layout, k) for k in range(len(layout.placements))]
    around, defects = list_walls(layout)
    points = [point for shape in (around, *defects, *placed) for point in shape.list_corners()]
    if not points:
        return _WIDTH, _LEAST, ""
    (xs, ys) = zip(*points, strict=True)
    share = Fraction(max(ys) - min(ys)) / (max(xs) - min(xs))
    wide, high = _WIDTH - 2 * _MARGIN, _MOST - 2 * _MARGIN
    width = _WIDTH if share * wide <= high else max(_NARROW, round(high / share) + 2 * _MARGIN)
    height = min(_MOST, max(_LEAST, round(share * wide) + 2 * _MARGIN))
    window = Window.around(points, width, height, _MARGIN)
    if y_down:
        window = window.flipped()
    # Missing and surplus faults are not due to a single placement.
    bad = {k for one in ranked if not one.fault.number for k in one.fault.placements}
    drawn = [_draw("defect", shape, window) for shape in defects]
    for is_bad in (False, True):
        name = "bad" if is_bad else "part"
        drawn += [
            _draw(name, one, window, named=(k, layout.placements[k].part))
            for k, one in enumerate(placed)
            if (k in bad) == is_bad
        ]
    drawn.append(_draw("container", around, window))
    for one in [one for one in ranked if one.fault.points][:_MAX_ENLARGED]:
        x, y = window.place(one.fault.points[0])
        drawn.append(f'<circle class="mark" cx="{x:.1f}" cy="{y:.1f}" r="10"/>')
    labeled = range(len(placed)) if len(placed) <= _MAX_LABELED else sorted(bad)
    for k in labeled[:_MAX_LABELED]:
        if inner := find_inner_point(judgement, k) or next(iter(placed[k].list_corners()), None):
            x, y = window.place(inner)
            drawn.append(f'<text class="number" x="{x:.1f}" y="{y + 4.5:.1f}">{k}</text>')
    return width, height, "".join(drawn)


def enlarge_faults(
    judgement: Judgement,
    ranked: Sequence[WorstFirst],
    *,
    y_down: bool = False,
    context: ReportContext = NO_CONTEXT,
) -> list[Enlarged]:
    layout = judgement.layout
    found = []
    shown = [one for one in ranked if one.fault.points][:_MAX_ENLARGED]
    for number, one in enumerate(shown, 1):
        fault = one.fault
        points = fault.points
        move = fault.move
        sizes = [square for square in (one.square, fault.distance_squared) if square]
        placed = {k: place_shape(layout, k) for k in fault.placements}
        xs, ys = zip(*placed[fault.placements[-1]].list_corners(), strict=True)
        near = max(max(xs) - min(xs), max(ys) - min(ys)) or Fraction(1)
        near = min([near, *(_ROUND * take_root(square) for square in sizes)])
        (a, b), (c, d) = points[0], points[-1]
        center = Point((a + c) / 2, (b + d) / 2)
        low, high = (Point(center.x + by, center.y + by) for by in (-near, near))
        window = Window(*low, *high, SIDE, SIDE)
        if y_down:
            window = window.flipped()
        around, defects = list_walls(layout)
        shapes = [("defect", one) for one in defects]
        shapes += [("bad", one) for one in placed.values()]
        drawn = [
            _path(name, [_clip(ring, window) for ring in one.list_rings(center, near)], window)
            for name, one in (*shapes, ("container", around))
        ]
        if move is not None:
            end = Point(center.x + move.x, center.y + move.y)
            drawn.append(_path("way", [[center, end]], window, closed=False))
        for x, y in map(window.place, points):
            drawn.append(f'<circle class="mark" cx="{x:.1f}" cy="{y:.1f}" r="4"/>')
        drawn.append(f'<rect class="frame" x=".5" y=".5" width="{SIDE - 1}" height="{SIDE - 1}"/>')
        named = context.name_placements(judgement, fault)
        wide = context.add_unit(approximate(2 * near))
        caption = f"{fault.kind}, {named}; the picture is {wide} wide"
        found.append(Enlarged(number, caption, "".join(drawn)))
    return found


class DrawnShape(NamedTuple):
    rings: Sequence[Sequence[Point]] = ()
    pieces: Sequence[RoundedPiece] = ()

    def list_corners(self) -> list[Point]:
        return [*chain.from_iterable(self.rings), *list_corners(self.pieces)]

    def list_rings(self, center: Point, near: Fraction) -> list[Sequence[Vertex]]:
        """List the rings, and polygons for the pieces, finest within `near` of a center."""
        return [*self.rings, *(list_vertices(piece, center, near) for piece in self.pieces)]


def list_walls(layout: Layout) -> tuple[DrawnShape, list[DrawnShape]]:
    container = layout.container
    defects = [
        DrawnShape(one.shape.rings) if isinstance(one.shape, Region) else DrawnShape((), one.shape)
        for one in layout.defects
    ]
    if container is None:
        return DrawnShape(), defects
    if isinstance(container, RoundedPiece):
        return DrawnShape((), (container,)), defects
    exterior, *holes = container.rings
    return DrawnShape([exterior]), [DrawnShape([hole]) for hole in holes] + defects


def find_inner_point(judgement: Judgement, k: int) -> Point | None:
    """Return a point in the largest piece of a placed part; None if it is not simple."""
    if k not in judgement._board.placed:
        return None
    solid = judgement._board.solid(k)
    pieces = solid.pieces
    piece = pieces[0] if len(pieces) == 1 else max(pieces, key=find_doubled_area)
    xs, ys = zip(*piece, strict=True)
    return solid.to_point(Fraction(sum(xs), len(xs)), Fraction(sum(ys), len(ys)))


def place_shape(layout: Layout, k: int) -> DrawnShape:
    if layout.part_by_id[layout.placements[k].part].pieces:
        return DrawnShape((), place_pieces(layout, k))
    return DrawnShape(place_part(layout, k))


def place_part(layout: Layout, k: int) -> list[list[Point]]:
    placement = layout.placements[k]
    part = layout.part_by_id[placement.part]
    # Irrational rotations have errors up to 2**-64.
    (a, b, c, d), (dx, dy) = placement.rows(_BITS), placement.move
    return [
        [Point(a * x + b * y + dx, c * x + d * y + dy) for x, y in ring]
        for ring in (part.exterior, *part.holes)
    ]


def _path(
    name: str, rings: Iterable[Sequence[Vertex]], window: Window, *, closed: bool = True
) -> str:
    return _write(name, write_path((map(window.place, ring) for ring in rings), closed=closed))


def _draw(
    name: str, shape: DrawnShape, window: Window, named: tuple[int, str] | None = None
) -> str:
    data = write_path((map(window.place, ring) for ring in shape.rings), closed=True)
    return _write(name, data + write_arcs(shape.pieces, window), named)


def _write(name: str, data: str, named: tuple[int, str] | None = None) -> str:
    if not data:
        return ""
    if named is None:
        return f'<path class="{name}" d="{data}"/>'
    number, part = named
    title = escape(spell_out(f"{number} {part}".strip()))
    return (
        f'<path class="{name}" id="part-{number}" data-name="{title}" d="{data}">'
        f"<title>{title}</title></path>"
    )


def _clip(ring: Sequence[Vertex], window: Window) -> Sequence[Vertex]:
    """Clip a ring exactly, far enough outside a window to hide the cuts."""
    room = window.longest
    sides = (window.left, window.right), sorted((window.bottom, window.top))
    for axis, (low, high) in enumerate(sides):
        ring = [*clip(ring, [high + room - point[axis] for point in ring])]
        ring = [*clip(ring, [point[axis] - low + room for point in ring])]
    return ring
