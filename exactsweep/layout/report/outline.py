"""Outlines of rounded pieces in pictures: true arcs, or polygons that are fine near a point."""

from collections.abc import Iterable, Sequence
from fractions import Fraction
from itertools import chain
from math import ceil, hypot, log2

from exactsweep.canvas.window import Window
from exactsweep.geometry.turn import from_half_tangent
from exactsweep.geometry.vectors import find_hull
from exactsweep.layout.layout import Layout
from exactsweep.layout.rounded import RoundedPiece, bound_root
from exactsweep.numbers.number import Point, Vertex

_BITS, _STEPS, _COARSE, _BACK = 16, 16, Fraction(1, 64), 40


def place_pieces(layout: Layout, k: int) -> list[RoundedPiece]:
    placement = layout.placements[k]
    # Irrational rotations have errors up to 2**-64.
    (a, b, c, d), (dx, dy) = placement.rows(64), placement.move
    found = []
    for points, radius in layout.part_by_id[placement.part].pieces:
        moved = [Point(a * x + b * y + dx, c * x + d * y + dy) for x, y in points]
        found.append(RoundedPiece(tuple(find_hull(moved) or moved), radius))
    return found


def list_corners(pieces: Iterable[RoundedPiece]) -> list[Point]:
    return [*chain.from_iterable(piece.bounding_box for piece in pieces)]


def write_arcs(pieces: Iterable[RoundedPiece], window: Window) -> str:
    """Write rounded pieces as SVG path data, with an arc at each corner.

    >>> window = Window(*map(Fraction, (0, 0, 4, 4)), 4, 4)
    >>> write_arcs([RoundedPiece((Point(Fraction(2), Fraction(1)),), Fraction(1))], window)
    'M1.00 3.00A1.00 1.00 0 0 0 3.00 3.00A1.00 1.00 0 0 0 1.00 3.00Z'
    """
    sweep = 0 if window.top > window.bottom else 1
    return "".join(_write_piece(piece, window, sweep) for piece in pieces)


def _write_piece(piece: RoundedPiece, window: Window, sweep: int) -> str:
    points, r = piece
    across = float(r * window.width / (window.right - window.left))
    up = float(r * window.height / abs(window.top - window.bottom))
    normals = [Point(x / h, y / h) for x, y, h in map(_unit, points, (*points[1:], points[0]))]
    if len(points) == 1:
        normals = [Point(Fraction(1), Fraction(0)), Point(Fraction(-1), Fraction(0))]
        points = points * 2
    found = []
    for p, (ux, uy), (vx, vy) in zip(points, (normals[-1], *normals[:-1]), normals, strict=True):
        x, y = window.place((p.x + r * ux, p.y + r * uy))
        z, w = window.place((p.x + r * vx, p.y + r * vy))
        found.append(f"{x:.2f} {y:.2f}A{across:.2f} {up:.2f} 0 0 {sweep} {z:.2f} {w:.2f}")
    start, _, rest = found[0].partition("A")
    return (
        f"M{start}A{rest}"
        + "".join(
            f"A{one.partition('A')[2]}" if len(piece.points) == 1 else f"L{one}"
            for one in found[1:]
        )
        + "Z"
    )


def _unit(p: Point, q: Point) -> tuple[Fraction, Fraction, Fraction]:
    x, y = q.y - p.y, p.x - q.x
    return x, y, Fraction(hypot(x, y)) or Fraction(1)


def list_vertices(piece: RoundedPiece, center: Point, near: Fraction) -> Sequence[Vertex]:
    """Approximate a rounded piece by a polygon, most finely within `near` of a center."""
    points, r = piece
    if not r:
        return points
    found: list[Vertex] = []
    bits = _BITS + max(0, ceil(log2(r / near)))
    for k, p in enumerate(points):
        directions = [(center.x - p.x, center.y - p.y)]
        for q in (points[k - 1], points[(k + 1) % len(points)]):
            directions += [(q.y - p.y, p.x - q.x), (p.y - q.y, q.x - p.x)]
        for direction in [one for one in directions if any(one)] or [(Fraction(1), Fraction(0))]:
            u, v = _find_direction(*direction, bits)
            found += [
                (p.x + r * (u * c - v * s), p.y + r * (u * s + v * c))
                for c, s in _list_turns(near / r)
            ]
    return found if len(points) == 1 else find_hull(found)


def _find_direction(x: Fraction, y: Fraction, bits: int) -> Point:
    """Return a rational point on the unit circle within about 2**-bits of a direction."""
    length = bound_root(x * x + y * y, bits)[0]
    if x < 0:
        back = _find_direction(-x, -y, bits)
        return Point(-back.x, -back.y)
    # The tangent of half the angle, with few digits.
    t = Fraction(round(y / (x + length) * 2**bits), 2**bits)
    return from_half_tangent(t)


def _list_turns(share: Fraction) -> list[Point]:
    """List rational rotations, in fine steps up to `share` radians, then in coarse ones."""
    # A power of two keeps numbers short.
    fine = min(Fraction(1), Fraction(2) ** ceil(log2(share) + 1))
    tangents = [fine * k / (2 * _STEPS) for k in range(_STEPS + 1)]
    while tangents[-1] < _BACK:
        tangents.append(tangents[-1] * (4 if tangents[-1] < _COARSE else Fraction(5, 4)))
    return [from_half_tangent(t) for t in (*(-t for t in tangents[:0:-1]), *tangents)]
