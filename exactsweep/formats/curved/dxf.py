"""Reader of DXF: lines, polylines, curves and blocks."""

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.curved.affine import Affine, make_affine, scale_axes, translate
from exactsweep.formats.curved.arc import make_arc, make_rotation, to_degrees
from exactsweep.formats.curved.curves import find_arc_center, make_round_arc
from exactsweep.formats.curved.dxf_entity import FROZEN, Drawing, Entity, read_drawing
from exactsweep.formats.curved.join import OpenLine, draw_outline, join_layers
from exactsweep.formats.curved.path import CURVED, Path, default_tolerance, draw_circle, draw_lines
from exactsweep.formats.curved.spline import Spline
from exactsweep.formats.error import FormatError, OrnamentError
from exactsweep.formats.reading import MAX_COPIES, Reading
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import Point

MAX_DEPTH = 32  # of nested blocks
# Entities that draw no outline.
_ANNOTATIONS = {
    "TEXT",
    "MTEXT",
    "ATTDEF",
    "ATTRIB",
    "DIMENSION",
    "LEADER",
    "MULTILEADER",
    "TOLERANCE",
}
_ANNOTATIONS |= {"POINT", "VIEWPORT", "IMAGE", "WIPEOUT"}
_ORNAMENTS = {"HATCH", "XLINE", "RAY"}  # fills and infinite lines
_CLOSED, _IN_SPACE, _MESH = 1, 8, 16 | 64
_ROUND = {"ARC", "ELLIPSE"}  # entities with irrational ends
_FULL, _ZERO = Fraction(360), Fraction(0)


class PlacedEntity(NamedTuple):
    entity: Entity
    image: Affine  # the map from the entity to the drawing
    layer: str  # "0" inside a block is replaced by the layer of the INSERT
    around: str = ""  # the locations of the INSERTs that draw it, for messages
    fault: str = ""  # why an INSERT cannot be drawn

    @property
    def place(self) -> str:
        return f"{self.around}{self.entity.place}"


class Blocks:
    def __init__(self, drawing: Drawing, reading: Reading) -> None:
        self.drawing, self.blocks, self.reading = drawing, drawing.blocks, reading
        # Cached maps of each INSERT, by line.
        self._maps: dict[int, list[Affine]] = {}

    def place(self, entity: Entity, image: Affine) -> Iterator[PlacedEntity]:
        """Yield an entity, or the entities that an INSERT draws; count hidden ones."""
        return self._place(PlacedEntity(entity, image, entity.layer), ())

    def _is_hidden(self, placed: PlacedEntity) -> bool:
        layer = placed.layer.upper()
        reason = self.drawing.hidden.get(layer, "")
        # If the layer of the INSERT is off, entities on other layers are still visible.
        if placed.entity.kind == "INSERT" and reason != FROZEN:
            reason = ""
        if layer in self.drawing.unplotted and placed.entity.kind != "INSERT":
            self.reading.notes[f"the layer {quote(placed.layer)} does not plot, but is read"] = None
        on_layer = reason and f"on the layer {quote(placed.layer)}, which is {reason}"
        what = placed.entity.hidden or on_layer
        return bool(what) and self.reading.skip_hidden(f"{placed.entity.kind} {what}")

    def _place(self, placed: PlacedEntity, around: tuple[str, ...]) -> Iterator[PlacedEntity]:
        if around:
            self.reading.charge_copies(1, placed.entity.size, "blocks expand to", "entities")
        if placed.entity.kind in _ANNOTATIONS or self._is_hidden(placed):
            return
        if placed.entity.kind != "INSERT":
            yield placed
            return
        try:
            name = placed.entity.name.upper()
            images = self._images(placed, name, around)
        except ValueError as error:
            yield placed._replace(fault=str(error))
            return
        _, *members = self.blocks[name]
        for image in images:
            for entity in members:
                layer = placed.layer if entity.layer == "0" else entity.layer
                inner = PlacedEntity(entity, image, layer, f"{placed.place}: ")
                yield from self._place(inner, (*around, name))

    def _images(self, placed: PlacedEntity, name: str, around: tuple[str, ...]) -> list[Affine]:
        insert = placed.entity
        if name not in self.blocks:
            raise FormatError(f"there is no block {quote(insert.name)}")
        if name in around:
            raise FormatError(f"block {quote(insert.name)} contains itself")
        if len(around) == MAX_DEPTH:
            raise FormatError(f"nested in more than {MAX_DEPTH} blocks")
        if insert.line not in self._maps:
            self._maps[insert.line] = self._own_maps(insert, self.blocks[name])
        return [placed.image @ own for own in self._maps[insert.line]]

    def _own_maps(self, insert: Entity, block: list[Entity]) -> list[Affine]:
        columns, rows = (max(1, int(insert.number(code, "1"))) for code in (70, 71))
        # Count copies of an empty block, too.
        drawn = len(block) - 1 or 1
        if columns * rows * drawn > MAX_COPIES:
            raise FormatError(f"expands to more than {MAX_COPIES:,} entities")
        turn = make_rotation(insert.number(50, "0"))
        position, base = insert.point(10), block[0].point(10)
        scale = scale_axes(insert.number(41, "1"), insert.number(42, "1"))
        outer = insert.plane @ translate(*position) @ turn
        own = scale @ translate(-base.x, -base.y)
        step = insert.number(44, "0"), insert.number(45, "0")
        return [
            outer @ translate(i * step[0], j * step[1]) @ own
            for j in range(rows)
            for i in range(columns)
        ]


def parse_dxf(text: str, reading: Reading) -> list[Candidate]:
    drawing = read_drawing(text)
    scale = reading.scale(drawing.unit)
    image = scale_axes(scale, scale)
    blocks = Blocks(drawing, reading)
    placed = (one for entity in drawing.entities for one in blocks.place(entity, image))
    return join_layers((_draw(one, reading) for one in placed), reading)


def _draw(placed: PlacedEntity, reading: Reading) -> Candidate | OpenLine:
    kind, shape = placed.entity.kind, Candidate(placed.place, list, layer=placed.layer)
    try:
        if placed.fault:
            raise FormatError(placed.fault)
        if kind in _ORNAMENTS:
            raise OrnamentError("no outline")
        if kind not in _READERS:
            raise FormatError("not a line, polyline, arc, circle, ellipse, spline or block")
        path = _READERS[kind](placed.entity, placed.image, reading)
    except ValueError as error:
        is_ornament = isinstance(error, OrnamentError)
        return shape.rejected(f"{shape.place}: {error}", ornament=is_ornament)
    if path.is_closed and (len(path.points) > 2 or path.curves):
        return draw_outline(path, shape, reading)
    return OpenLine.from_path(shape, path, is_exact=not placed.image.error and kind not in _ROUND)


def _read_line(entity: Entity, image: Affine, reading: Reading) -> Path:
    reading.require_planar(entity.values(30, 31, default="0"))
    x, y, u, v = entity.values(10, 20, 11, 21)
    return draw_lines([Point(x, y), Point(u, v)], image)


def _read_polyline(entity: Entity, image: Affine, reading: Reading) -> Path:
    if entity.kind == "LWPOLYLINE":
        points, bulges = entity.corners()
    elif entity.flags() & _MESH:
        raise FormatError("meshes are not supported")
    else:
        points, bulges = entity.vertex_corners(reading)
    if entity.kind == "LWPOLYLINE" or not entity.flags() & _IN_SPACE:
        image = image @ entity.plane
    if all(point == points[0] for point in points):
        raise OrnamentError("a single point")
    if entity.flags() & _CLOSED:
        points.append(points[0])
    return _follow(points, bulges, image)


def _follow(points: Sequence[Point], bulges: Sequence[Fraction], image: Affine) -> Path:
    """Draw a polyline; a bulge is the tangent of a quarter of an arc's angle."""
    path = draw_lines(points, image)
    if any(bulges):
        for k, (start, end) in enumerate(pairwise(points)):
            bulge = bulges[k]
            if bulge and start != end:
                center = find_arc_center(start, end, (1 - bulge * bulge) / (2 * bulge))
                path.curves[k] = make_round_arc(center, start, end, image, left=bulge > 0)
    return path


def _read_circle(entity: Entity, image: Affine, reading: Reading) -> Path:
    center, radius = entity.point(10), entity.number(40)
    if radius <= 0:
        raise FormatError("the radius is not positive")
    image = image @ entity.plane @ translate(*center) @ scale_axes(radius, radius)
    if entity.kind == "CIRCLE":
        return draw_circle(image)
    return _draw_arc(image, entity.number(50), entity.number(51), reading)


def _read_ellipse(entity: Entity, image: Affine, reading: Reading) -> Path:
    reading.require_planar([_ZERO, entity.number(31, "0")])
    center, (x, y), ratio = entity.point(10), entity.point(11), entity.number(40)
    if not (x or y) or not ratio:
        raise FormatError("an axis has length zero")
    if entity.plane.a < 0:
        ratio = -ratio
    image = image @ make_affine(x, y, -ratio * y, ratio * x, *center)
    start, end = (to_degrees(entity.number(code, "0")) for code in (41, 42))
    return _draw_arc(image, start, end, reading)


def _draw_arc(image: Affine, start: Fraction, end: Fraction, reading: Reading) -> Path:
    """Draw the image of an arc of the unit circle, or the whole circle if the gap is invisible."""
    span = (end - start) % _FULL
    gap = min(span, _FULL - span) / 50  # an upper bound in radians
    size = Fraction(sum(map(abs, image[:4])))
    seen = 16 * gap * (1 + size) > (reading.tolerance or default_tolerance(size, CURVED))
    if start == end or (abs(end - start) > _FULL / 2 and not seen):
        return draw_circle(image)
    return make_arc(image, start, end)


def _read_spline(entity: Entity, image: Affine, reading: Reading) -> Path:
    points = entity.points(10)
    reading.require_planar(entity.numbers(30 if points else 31))
    if points:
        weights = entity.numbers(41)
        plain = weights if any(weight != 1 for weight in weights) else []
        spline = Spline(int(entity.number(71)), points, entity.numbers(40), plain)
    else:
        spline = Spline.through(entity.points(11))
    spline.validate()
    return spline.draw(image)


def _read_solid(entity: Entity, image: Affine, reading: Reading) -> Path:
    """Read a filled triangle or quadrilateral; DXF swaps the last two corners."""
    reading.require_planar(entity.values(30, 31, 32, 33, default="0"))
    codes = (10, 11, 13, 12) if entity.numbers(13) else (10, 11, 12)
    return draw_lines([entity.point(code) for code in (*codes, 10)], image @ entity.plane)


_READERS: dict[str, Callable[[Entity, Affine, Reading], Path]] = {
    "LINE": _read_line,
    "LWPOLYLINE": _read_polyline,
    "POLYLINE": _read_polyline,
    "ARC": _read_circle,
    "CIRCLE": _read_circle,
    "ELLIPSE": _read_ellipse,
    "SPLINE": _read_spline,
    "SOLID": _read_solid,
    "TRACE": _read_solid,
}
