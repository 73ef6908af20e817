"""DXF in: the closed outlines of lines and polylines, and of curves on request.

Decimals are read exactly, and blocks are placed exactly wherever their angles allow it.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import partial
from itertools import pairwise

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.curved.affine import Affine, make_affine, make_scaling, make_shift
from exactsweep.formats.curved.arc import Arc, make_arc, to_degrees
from exactsweep.formats.curved.curves import (
    find_arc_center,
    flatten_arc,
    place_points,
)
from exactsweep.formats.curved.dxf_block import Blocks, PlacedEntity
from exactsweep.formats.curved.dxf_entity import Entity, read_drawing
from exactsweep.formats.curved.join import OpenLine, gather
from exactsweep.formats.curved.spline import Spline
from exactsweep.formats.error import FormatError, OrnamentError
from exactsweep.formats.reading import Reading
from exactsweep.numbers.error import name_refusals
from exactsweep.numbers.number import Point, make_points

# Entities without an outline: fillings, which repeat one, and lines without an end.
_ORNAMENTS = {"HATCH", "XLINE", "RAY"}
_CLOSED, _IN_SPACE, _MESH = 1, 8, 16 | 64
_FULL, _ZERO = Fraction(360), Fraction(0)
_ALL, _INNER = slice(None), slice(1, -1)
_PointReader = Callable[[], Sequence[Point]]
_Drawn = OpenLine | _PointReader
"""An open line, whose inner points are all of its points yet; or a reader of a closed one."""


def parse_dxf(text: str, reading: Reading) -> list[Candidate]:
    """Find the closed outlines of a DXF text.

    Args:
        text: an ASCII DXF file.
        reading: has the tolerance of curves, the distance of ends that are joined, and the unit.

    Returns:
        list of Candidate, in order: closed polylines, circles, ellipses, splines, and open lines of
        one layer whose ends meet. Entities that draw anything else are Candidates that refuse.

    Raises:
        FormatError: not DXF; no unit where one is wanted; blocks that draw too much.

    Cost: linear in the length of the text, and in what blocks draw.
    """
    drawing = read_drawing(text)
    scale = reading.scale(drawing.unit)
    image = make_scaling(scale, scale)
    blocks = Blocks(drawing, reading)
    placed = (one for entity in drawing.entities for one in blocks.place(entity, image))
    return gather((drawn for one in placed for drawn in _draw_run(one, reading)), reading)


def _draw_run(placed: PlacedEntity, reading: Reading) -> list[Candidate | OpenLine]:
    if placed.entity.kind == "LINE" and placed.entity.count > 1 and not placed.image.off:
        with suppress(ValueError):
            return _draw_lines(placed, reading)
    # If one of a run is refused, each by itself has its own reason.
    return [_draw(placed._replace(entity=one), reading) for one in placed.entity.split()]


def _draw_lines(placed: PlacedEntity, reading: Reading) -> list[Candidate | OpenLine]:
    """Draw a run of lines as chains, each line starting at the end of the one before."""
    entity, count = placed.entity, placed.entity.count
    reading.require_level(entity.take(30, 31, default="0"))
    xs, ys = entity.take(10, 11), entity.take(20, 21)
    drawn: list[Candidate | OpenLine] = []
    for numbers in _find_chains(xs, ys, count):
        ends = [*numbers, count + numbers[-1]]
        points = make_points([xs[k] for k in ends], [ys[k] for k in ends])
        chain = place_points(points, placed.image, reading)
        split = partial(_split, placed, numbers, chain)
        if len(numbers) > 2:
            first = placed.place(numbers[0])
            drawn.append(OpenLine(first, chain, layer=placed.layer, split=split))
        else:
            drawn += split()
    return drawn


def _find_chains(
    xs: Sequence[Fraction], ys: Sequence[Fraction], count: int
) -> Sequence[Sequence[int]]:
    """Find the chains of lines by the coordinates of their starts, then of their ends."""
    breaks = [
        k for k in range(1, count) if (xs[k], ys[k]) != (xs[count + k - 1], ys[count + k - 1])
    ]
    if 2 * len(breaks) <= count:
        return [range(i, k) for i, k in pairwise([0, *breaks, count])]
    # Equal texts are one number, whose id is hashed in a tenth of the time of a Fraction.
    places = [*zip(map(id, xs), map(id, ys), strict=True)]
    at = {start: k for k, start in enumerate(places[:count])}
    chains: list[list[int]] = []
    left = [True] * count
    for first in range(count):
        chain: list[int] = []
        k: int | None = first
        while k is not None and left[k]:
            left[k] = False
            chain.append(k)
            k = at.get(places[count + k])
        # Lines that are not a closed outline stay in order, each by itself.
        chains += [chain] if chain and k == first else ([n] for n in chain)
    return sorted(chains)


def _split(placed: PlacedEntity, numbers: Sequence[int], chain: Sequence[Point]) -> list[OpenLine]:
    return [
        OpenLine(placed.place(k), ends, layer=placed.layer)
        for k, ends in zip(numbers, pairwise(chain), strict=True)
    ]


def _draw(placed: PlacedEntity, reading: Reading) -> Candidate | OpenLine:
    place, layer, kind = placed.place(), placed.layer, placed.entity.kind
    try:
        if placed.fault:
            raise FormatError(placed.fault)
        if kind in _ORNAMENTS:
            raise OrnamentError("no outline")
        if kind not in _READERS:
            raise FormatError("no line, polyline, arc, circle, ellipse, spline or block")
        drawn = _READERS[kind](placed.entity, placed.image, reading)
        is_curved = placed.image.off or placed.entity.is_curved
    except ValueError as error:
        is_ornament = isinstance(error, OrnamentError)
        return Candidate.refused(f"{place}: {error}", layer=layer, ornament=is_ornament)
    bound = reading.error if is_curved else _ZERO
    if not isinstance(drawn, OpenLine):
        vertices = partial(_name_place, place, drawn, _ALL)
        return Candidate(place, vertices, layer=layer, error=bound)
    inner = partial(_name_place, place, drawn.inner, _INNER) if drawn.shape else tuple
    return drawn._replace(place=place, inner=inner, layer=layer, error=bound)


def _name_place(place: str, points: _PointReader, part: slice) -> Sequence[Point]:
    with name_refusals(place):
        return points()[part]


def _read_line(entity: Entity, image: Affine, reading: Reading) -> _Drawn:
    reading.require_level(entity.take(30, 31, default="0"))
    x, y, u, v = entity.take(10, 20, 11, 21)
    return _open([Point(x, y), Point(u, v)], [], image, reading)


def _read_polyline(entity: Entity, image: Affine, reading: Reading) -> _Drawn:
    if entity.kind == "LWPOLYLINE":
        points, bulges = entity.corners()
    elif entity.flags() & _MESH:
        raise FormatError("a mesh")
    else:
        points, bulges = entity.vertex_corners(reading)
    if entity.kind == "LWPOLYLINE" or not entity.flags() & _IN_SPACE:
        image = image @ entity.plane
    if all(point == points[0] for point in points):
        raise OrnamentError("a point")
    if entity.flags() & _CLOSED:
        points.append(points[0])
    elif points[0] != points[-1]:
        return _open(points, bulges, image, reading)
    return partial(_follow, points, bulges, image, reading)


def _open(
    points: Sequence[Point], bulges: Sequence[Fraction], image: Affine, reading: Reading
) -> _Drawn:
    first, last = place_points([points[0], points[-1]], image, reading)
    if len(points) == 2 and not any(bulges[:1]):
        return OpenLine("", (first, last), is_exact=not image.off)
    vertices = partial(_follow, points, bulges, image, reading)
    return OpenLine("", (first, last), vertices, (*points, *bulges), not image.off)


def _follow(
    points: Sequence[Point], bulges: Sequence[Fraction], image: Affine, reading: Reading
) -> list[Point]:
    """Go along a polyline; a bulge is the tangent of a fourth of the angle of an arc."""
    placed = place_points(points, image, reading)
    if not any(bulges):
        return placed
    found: list[Point] = []
    for k, (start, end) in enumerate(pairwise(points)):
        found.append(placed[k])
        bulge = bulges[k]
        if bulge and start != end:
            center = find_arc_center(start, end, (1 - bulge * bulge) / (2 * bulge))
            found += flatten_arc(center, start, end, bulge > 0, image, reading)[1:-1]
    return [*found, placed[-1]]


def _read_circle(entity: Entity, image: Affine, reading: Reading) -> _Drawn:
    reading.allow_curve()
    center, radius = entity.point(10), entity.number(40)
    if radius <= 0:
        raise FormatError("the radius is not positive")
    image = image @ entity.plane @ make_shift(*center) @ make_scaling(radius, radius)
    if entity.kind == "CIRCLE":
        return _turn(image, _ZERO, _FULL, reading)
    return _turn(image, entity.number(50), entity.number(51), reading)


def _read_ellipse(entity: Entity, image: Affine, reading: Reading) -> _Drawn:
    reading.allow_curve()
    reading.require_level([_ZERO, entity.number(31, "0")])
    center, (x, y), ratio = entity.point(10), entity.point(11), entity.number(40)
    if not (x or y) or not ratio:
        raise FormatError("an axis has no length")
    if entity.plane.a < 0:
        ratio = -ratio
    image = image @ make_affine(x, y, -ratio * y, ratio * x, *center)
    start, end = (to_degrees(entity.number(code, "0")) for code in (41, 42))
    return _turn(image, start, end, reading)


def _turn(image: Affine, start: Fraction, end: Fraction, reading: Reading) -> _Drawn:
    """Draw the image of an arc of the unit circle, or all of it where no gap can be seen."""
    span = (end - start) % _FULL
    gap = min(span, _FULL - span) / 50  # no less than in radians
    seen = 16 * gap * (1 + sum(map(abs, image[:4]))) > reading.allow_curve()
    if start == end or (abs(end - start) > _FULL / 2 and not seen):
        first = Point(Fraction(1), _ZERO)
        return partial(Arc(image, first, first).flatten, reading)
    arc = make_arc(image, start, end, reading)
    if arc.start == arc.end and span < _FULL / 2:
        # Rounded it is one point, from which an arc would run all the way around.
        return OpenLine("", arc.ends, is_exact=False)
    return OpenLine("", arc.ends, partial(arc.flatten, reading), arc, is_exact=False)


def _read_spline(entity: Entity, image: Affine, reading: Reading) -> _Drawn:
    reading.allow_curve()
    points = entity.points(10)
    reading.require_level(entity.numbers(30 if points else 31))
    if points:
        weights = entity.numbers(41)
        plain = weights if any(weight != 1 for weight in weights) else []
        spline = Spline(int(entity.number(71)), points, entity.numbers(40), plain)
    else:
        spline = Spline.through(entity.points(11))
    spline.require_sound()
    pieces = [piece for piece, _ in spline.pieces()]
    first, last = place_points([pieces[0][0], pieces[-1][-1]], image, reading)
    vertices = partial(spline.flatten, image, reading)
    if first == last:
        return vertices
    return OpenLine("", (first, last), vertices, tuple(spline.points), not image.off)


def _read_solid(entity: Entity, image: Affine, reading: Reading) -> _Drawn:
    """Read a filled triangle or quadrangle, whose last two corners are the wrong way round."""
    reading.require_level(entity.take(30, 31, 32, 33, default="0"))
    codes = (10, 11, 13, 12) if entity.numbers(13) else (10, 11, 12)
    corners = [entity.point(code) for code in (*codes, 10)]
    return partial(_follow, corners, [], image @ entity.plane, reading)


_READERS: dict[str, Callable[[Entity, Affine, Reading], _Drawn]] = {
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
