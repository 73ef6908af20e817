"""DXF in: the closed outlines of lines and polylines, and of arcs on request.

ezdxf divides the text into sections and entities and leaves the numbers as the text that they are,
so that decimals are read exactly.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Sequence
from fractions import Fraction
from functools import partial
from itertools import pairwise

from exactsweep.formats.curved.affine import IDENTITY
from exactsweep.formats.curved.curves import chord_arc_center, flatten_arc
from exactsweep.formats.curved.dxf_arc import Arc, Joints, make_arc
from exactsweep.formats.curved.dxf_entity import Entity, read_entities
from exactsweep.formats.curved.dxf_join import Piece, join
from exactsweep.formats.decimals import required_tolerance
from exactsweep.formats.error import FormatError
from exactsweep.formats.outline import Outline
from exactsweep.geometry.point import Point

# Notes, dimensions and frames, which draw no outline.
_NOTES = {"TEXT", "MTEXT", "ATTDEF", "ATTRIB", "DIMENSION", "LEADER", "MULTILEADER", "TOLERANCE"}
_NOTES |= {"POINT", "VIEWPORT", "IMAGE", "WIPEOUT"}
_Vertices = Callable[[], Sequence[Point]]
_CLOSED, _NOT_PLAIN = 1, 2 | 4 | 8 | 16 | 64


def parse_dxf(text: str, tolerance: Fraction | None) -> list[Outline]:
    """Find the closed outlines of a DXF text.

    Args:
        text: an ASCII DXF file.
        tolerance: how far lines may be from the arcs that they replace, and ends of arcs from
            the ends that they are joined to; None to refuse arcs.

    Returns:
        list of Outline, in order: closed polylines, circles, and lines, open polylines and arcs of
        one layer whose ends meet. What draws something else is an Outline that refuses.

    Raises:
        FormatError: not DXF.

    Cost: linear in the length of the text.
    """
    found: list[tuple[int, Outline]] = []
    pieces: defaultdict[str, list[Piece]] = defaultdict(list)
    arcs: defaultdict[str, list[tuple[Entity, Arc]]] = defaultdict(list)
    for entity in read_entities(text):
        if entity.kind in _NOTES or entity.is_on_paper:
            continue
        try:
            made = _read(entity, tolerance)
        except ValueError as error:
            refused = Outline.refused(f"{entity.place}: {error}", layer=entity.layer)
            found.append((entity.line, refused))
            continue
        if isinstance(made, Piece):
            pieces[entity.layer].append(made)
        elif isinstance(made, Arc):
            arcs[entity.layer].append((entity, made))
        else:
            found.append((entity.line, Outline(entity.place, made, layer=entity.layer)))
    for layer, curved in arcs.items():
        assert tolerance is not None
        joints = Joints((end for piece in pieces[layer] for end in piece.ends), tolerance)
        for entity, arc in curved:
            try:
                ends = joints.nearest(arc.start), joints.nearest(arc.end)
                if ends[0] == ends[1]:
                    raise FormatError("the arc is shorter than the tolerance")
                points = partial(arc.flattened, *ends, tolerance)
                pieces[layer].append(Piece(entity.line, entity.place, ends, points))
            except FormatError as error:
                refused = Outline.refused(f"{entity.place}: {error}", layer=layer)
                found.append((entity.line, refused))
    for layer, lines in pieces.items():
        found += join(sorted(lines), layer)
    return [outline for _, outline in sorted(found, key=lambda pair: pair[0])]


def _read(entity: Entity, tolerance: Fraction | None) -> Piece | Arc | _Vertices:
    """Read an open line, an arc, or whatever is closed."""
    if entity.kind not in ("LINE", "LWPOLYLINE", "POLYLINE", "ARC", "CIRCLE"):
        raise FormatError("neither a line, a polyline, an arc nor a circle")
    entity.require_flat()
    if entity.kind == "LINE":
        ends = entity.point(10), entity.point(11)
        return Piece(entity.line, entity.place, ends, partial(list, ends))
    if entity.kind.endswith("POLYLINE"):
        return _read_polyline(entity, tolerance)
    allowed = required_tolerance(tolerance)
    center, radius = entity.point(10), entity.number(40)
    if radius <= 0:
        raise FormatError("the radius is not positive")
    angles = (Fraction(0), Fraction(0))
    if entity.kind == "ARC":
        angles = entity.number(50), entity.number(51)
    if (angles[0] - angles[1]) % 360 == 0:
        start = Point(center.x + radius, center.y)
        return partial(flatten_arc, center, start, start, True, IDENTITY, allowed)
    return make_arc(center, radius, *angles, allowed)


def _read_polyline(entity: Entity, tolerance: Fraction | None) -> Piece | _Vertices:
    if entity.kind == "LWPOLYLINE":
        corners = entity.corners()
    elif entity.flags() & _NOT_PLAIN:
        raise FormatError("a fitted curve, a line in space or a mesh")
    else:
        corners = entity.vertex_corners()
    if len(corners) < 2:
        raise FormatError(f"{len(corners)} vertices")
    first, last = corners[0][0], corners[-1][0]
    if entity.flags() & _CLOSED:
        corners.append((first, Fraction(0)))
    points = partial(_points, entity.place, corners, tolerance)
    if entity.flags() & _CLOSED or first == last:
        return points
    return Piece(entity.line, entity.place, (first, last), points)


def _points(
    place: str, corners: Sequence[tuple[Point, Fraction]], tolerance: Fraction | None
) -> list[Point]:
    """Go along a polyline; a bulge is the tangent of a fourth of the angle of an arc."""
    found: list[Point] = []
    for (start, bulge), (end, _) in pairwise(corners):
        found.append(start)
        if bulge and start != end:
            try:
                allowed = required_tolerance(tolerance)
                center = chord_arc_center(start, end, (1 - bulge * bulge) / (2 * bulge))
                found += flatten_arc(center, start, end, bulge > 0, IDENTITY, allowed)[1:-1]
            except FormatError as error:
                raise FormatError(f"{place}: {error}") from None
    return [*found, corners[-1][0]]
