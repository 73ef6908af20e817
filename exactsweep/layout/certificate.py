"""Certificates of layouts; see `check/CERTIFICATES.md`.

The proof of a valid layout consists of convex pieces, and a separating normal for each pair of
pieces with close boxes. The proof of a fault is a point.

(1) Rings with the interior on the left bound a shape if their winding number is 0 or 1 everywhere.
    The winding number of a point is the number of upward minus downward edges to its right; an edge
    includes its lower end, but not its upper one. At a point on an edge, this is the winding number
    to the right of the edge. Each face is to the right of some edge.
"""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import accumulate, chain, pairwise
from typing import Any

from exactsweep.evidence.certificate import HEADER
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.convex import IntVertex
from exactsweep.geometry.near import find_near
from exactsweep.geometry.region import Region
from exactsweep.geometry.turn import TURN_BITS
from exactsweep.geometry.vectors import intersect, orientation
from exactsweep.layout.board import Board
from exactsweep.layout.clearance import find_clearance, is_rounded, measure_gap
from exactsweep.layout.fault import Fault
from exactsweep.layout.layout import LayoutPart
from exactsweep.layout.nearest import find_gap
from exactsweep.layout.pieces import bound_piece, find_normal
from exactsweep.layout.reading import LayoutError
from exactsweep.layout.solid import LatticeBox, LatticeForm, RoundedForm, Solid, share_scale
from exactsweep.layout.verdict import MAX_BITS, find_witness
from exactsweep.numbers.digits import to_plain
from exactsweep.numbers.number import Fit, Point

_PieceRings = list[list[Point]] | None
_LEAST = 3  # vertices of a ring in a certificate


def write_certificate(board: Board, faults: Sequence[Fault]) -> dict[str, Any]:
    """Return the certificate of a layout as plain JSON data.

    Raises:
        LayoutError: no fault has a proof, because all are undecided or due to rings that only
            touch; or a ring has fewer than three vertices.
    """
    parts = (part for part in board.layout.parts if not part.pieces)
    rings = (ring for part in parts for ring in (part.exterior, *part.holes))
    if any(len(drop_repeated(ring)) < _LEAST for ring in rings):
        raise LayoutError("a ring has fewer than three vertices, so there is no certificate")
    bits = TURN_BITS
    while True:
        found = _prove_faults(board, faults, bits) if faults else _prove_valid(board, bits)
        if found is not None or bits >= MAX_BITS:
            break
        bits *= 2
    if not found:
        raise LayoutError("no fault of the layout can be proved, so there is no certificate")
    return to_plain(
        {
            **HEADER,
            "claim": "layout",
            "layout": board.layout.to_json(),
            "valid": not faults,
            "turns": [placement.turn.near(bits)[:2] for placement in board.layout.placements],
            "faults" if faults else "proof": found,
        }
    )


def _prove_valid(board: Board, bits: int) -> dict[str, Any] | None:
    apart: list[list[Any]] = []
    for entry in chain(_separate_placements(board, bits), _separate_obstacles(board, bits)):
        if entry is None:
            return None
        apart.append(entry)
    forms = [board.base(part.id) for part in board.layout.parts]
    is_polygon = isinstance(board.layout.container, Region)
    return {
        "frame": [*map(Fraction, board.frame)] if is_polygon else None,
        "pieces": [*(_list_pieces(form, scale) for scale, form in forms), *_list_outside(board)],
        "apart": apart,
    }


def _separate_placements(board: Board, bits: int) -> Iterator[list[Any] | None]:
    """Yield an entry for each pair of close placements, or for each close pair of their pieces."""
    spacing = board.layout.spacing
    for k, j in board.list_near(spacing):
        a, b = share_scale(board.solid(k, bits), board.solid(j, bits))
        distance = (spacing + a.slack + b.slack) * a.scale
        if _are_apart(a.box, b.box, distance):
            continue
        if isinstance(a.form, LatticeForm) and isinstance(b.form, LatticeForm):
            ours, theirs = a.form.hull, b.form.hull
            normal = find_normal(_shift(ours, a), _shift(theirs, b), distance)
            if normal is not None:
                yield [k, -1, j, -1, *map(str, normal)]
                continue
        for i, h, found in _separate_pieces(a, b, distance):
            yield found and [k, i, j, h, *map(str, found)]


def _separate_obstacles(board: Board, bits: int) -> Iterator[list[Any] | None]:
    """Yield an entry for each piece of an obstacle and each close piece of a placement."""
    names = _name_obstacles(board)
    for k, defects in board.find_defects(board.greatest_margin).items():
        outside = () if board.is_open else (0,)
        for wall in (*outside, *defects):
            a, b = share_scale(board.obstacles[wall], board.solid(k, bits))
            distance = (board.required(wall) + a.slack + b.slack) * a.scale
            name, first = names[wall]
            for i, h, found in _separate_pieces(a, b, distance):
                yield found and [name, first + i, k, h, *map(str, found)]


def _name_obstacles(board: Board) -> list[tuple[int, int]]:
    number = _count_outside(board)
    counts = (len(wall.form.pieces) for wall in board.obstacles[: number - 1])
    # The outside of the container, including its holes, is -1; defect k is -2 - k.
    outside = [(-1, first) for first in accumulate(counts, initial=0)]
    return outside + [(-2 - k, 0) for k in range(len(board.obstacles) - number)]


def _count_outside(board: Board) -> int:
    return board.first_defect + len(board.holes)


def _separate_pieces(
    a: Solid, b: Solid, distance: Fraction
) -> Iterator[tuple[int, int, IntVertex | None]]:
    """Yield the pairs of pieces that need a normal, with the normal if found."""
    theirs = [
        (h, piece, radius, box)
        for h, (piece, radius) in enumerate(b.rounded)
        if not _are_apart(a.box, box := bound_piece(piece, radius), distance)
    ]
    for i, (one, own) in enumerate(a.rounded):
        bounds = bound_piece(one, own)
        if not _are_apart(bounds, b.box, distance):
            for h, other, radius, box in theirs:
                if not _are_apart(bounds, box, distance):
                    yield i, h, find_normal(one, other, distance + own + radius)


def _shift(ring: Sequence[IntVertex], by: Solid) -> list[IntVertex]:
    return [(x + by.x, y + by.y) for x, y in ring]


def _are_apart(one: LatticeBox, other: LatticeBox, distance: Fraction) -> bool:
    left, right, low, high = one
    west, east, south, north = other
    return (
        west - right >= distance
        or left - east >= distance
        or south - high >= distance
        or low - north >= distance
    )


def _prove_faults(board: Board, faults: Sequence[Fault], bits: int) -> list[dict[str, Any]] | None:
    """Find a point for each fault; return None if the rotations are not precise enough."""
    proved: list[dict[str, Any]] = []
    for fault in faults:
        if fault.kind in ("missing", "surplus", "turn", "mirror"):
            entry = {"kind": fault.kind, "part": fault.part}
            if entry not in proved:
                proved.append(entry)
        elif fault.kind == "shape":
            assert fault.part is not None
            point = find_misfit(board.layout.part_by_id[fault.part])
            if point is not None:
                proved.append({"kind": "shape", "part": fault.part, "point": point})
        elif fault.kind != "undecided":
            point = _find_point(board, fault, bits)
            if point is not None:
                first = _count_outside(board)
                wall = -1 if fault.wall < first else first - fault.wall - 2
                bodies = [*fault.placements, wall][:2]
                proved.append({"kind": fault.kind, "placements": bodies, "point": point})
            elif bits < MAX_BITS:
                return None
    return proved


def _find_point(board: Board, fault: Fault, bits: int) -> Point | None:
    a, b = fault.find_pair(bits)
    if fault.kind == "too close":
        assert fault.required is not None
        room = fault.required - a.slack - b.slack
        if room <= 0:
            return None
        if is_rounded(a, b):
            near = find_clearance(a, b, room)
            found = measure_gap(a, b, near) if near and near.is_below(room) else None
        else:
            found = find_gap(a, b, room * room)
        if found is None:
            return None
        p, q = found.points
        return Point((p.x + q.x) / 2, (p.y + q.y) / 2)
    return find_witness(a, b)


def _list_outside(board: Board) -> list[_PieceRings]:
    number = _count_outside(board)
    pieces = [_list_pieces(wall.form, wall.scale) for wall in board.obstacles]
    outside = [piece for wall in pieces[:number] for piece in wall or ()]
    return [outside or None, *pieces[number:]]


def _list_pieces(form: LatticeForm | RoundedForm, scale: int) -> _PieceRings:
    """Return the pieces of a polygon; None for a rounded form, whose pieces are in the layout."""
    if not isinstance(form, LatticeForm):
        return None
    return [[Point(Fraction(x) / scale, Fraction(y) / scale) for x, y in p] for p in form.pieces]


def find_misfit(part: LayoutPart) -> Point | None:
    """Find a point with a winding number other than 0 or 1; None if rings only touch."""
    edges: list[Fit] = []
    for k, ring in enumerate((part.exterior, *part.holes)):
        points = drop_repeated(ring)
        if (find_doubled_area(points) > 0) != (k == 0):
            points.reverse()
        edges += pairwise((*points, points[0]))
    tried = (p for p in _list_inner(edges) if _wind(edges, p) not in (0, 1))
    return next(tried, None)


def drop_repeated(ring: Sequence[Point]) -> list[Point]:
    return [p for k, p in enumerate(ring) if p != ring[k - 1]]


def _list_inner(edges: Sequence[Fit]) -> Iterator[Point]:
    meetings = [{*edge} for edge in edges]
    boxes = [(min(a.x, b.x), max(a.x, b.x), min(a.y, b.y), max(a.y, b.y)) for a, b in edges]
    for k, j in find_near(boxes):
        common = [Point(Fraction(x), Fraction(y)) for x, y in intersect(edges[k], edges[j])]
        meetings[k].update(common)
        meetings[j].update(common)
    for (a, b), points in zip(edges, meetings, strict=True):
        if a.y != b.y:
            for p, q in pairwise(sorted(points)):
                yield Point((p.x + q.x) / 2, (p.y + q.y) / 2)


def _wind(edges: Sequence[Fit], z: Point) -> int:
    up = sum(a.y <= z.y < b.y and orientation(a, b, z) > 0 for a, b in edges)
    return up - sum(b.y <= z.y < a.y and orientation(a, b, z) < 0 for a, b in edges)
