"""Certificates of layouts, as `check/CERTIFICATES.md` describes them.

The judge's faults are the claim. The checker also needs convex pieces, a normal for each pair of
pieces whose boxes are not far enough apart, and a witness for each fault.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import accumulate, chain, combinations, pairwise
from typing import Any

from exactsweep.evidence.certificate import HEADER
from exactsweep.geometry.convex import ConvexRing
from exactsweep.geometry.edges import touch
from exactsweep.geometry.grid import IntVertex
from exactsweep.geometry.turn import TURN_BITS
from exactsweep.geometry.vectors import minus, turn
from exactsweep.layout.board import Board
from exactsweep.layout.fault import Fault
from exactsweep.layout.layout import LayoutPart
from exactsweep.layout.nearest import find_gap
from exactsweep.layout.normals import find_normal
from exactsweep.layout.pieces import bound_piece
from exactsweep.layout.reading import LayoutError
from exactsweep.layout.solid import LatticeBox, Solid, share_scale
from exactsweep.layout.verdict import MOST_BITS, find_witness
from exactsweep.numbers.digits import to_plain
from exactsweep.numbers.number import Point


def write_certificate(board: Board, faults: Sequence[Fault]) -> dict[str, Any]:
    """Write the certificate of a layout.

    Args:
        board: the solids of the layout.
        faults: the faults that the judge found; none for a valid layout.

    Returns:
        Plain JSON data.

    Raises:
        LayoutError: no fault has a proof, because all are undecided, or holes outside their part.

    Cost: O(k) searches for a normal, for k pairs of pieces whose boxes are not far enough apart.
    """
    bits = TURN_BITS
    while True:
        proof = _prove_faults(board, faults, bits) if faults else _prove_valid(board, bits)
        if proof is not None or bits >= MOST_BITS:
            break
        bits *= 2
    if not proof:
        raise LayoutError("nothing that is wrong with the layout has a proof: no certificate")
    certificate = {
        **HEADER,
        "kind": "layout",
        "layout": board.layout.to_json(),
        "valid": not faults,
        "turns": [placement.turn.near(bits)[:2] for placement in board.layout.placements],
        "frame": [*map(Fraction, board.frame)],
    }
    return to_plain(certificate | proof)


def _prove_valid(board: Board, bits: int) -> dict[str, Any] | None:
    """Find the pieces and normals; None if the turns are not near enough."""
    apart: list[list[Any]] = []
    for entry in chain(_part_placements(board, bits), _part_container(board, bits)):
        if entry is None:
            return None
        apart.append(entry)
    return {
        "pieces": [_list_pieces(board, part) for part in board.layout.parts],
        "outside": _list_outside(board),
        "apart": apart,
        "faults": [],
    }


def _part_placements(board: Board, bits: int) -> Iterator[list[Any] | None]:
    """Make an entry for each near pair of placements, or for each near pair of their pieces."""
    spacing = board.layout.spacing
    for k, j in board.list_near(spacing):
        a, b = share_scale(board.solid(k, bits), board.solid(j, bits))
        distance = (spacing + a.slack + b.slack) * a.scale
        if _are_apart(a.box, b.box, distance):
            continue
        ours, theirs = a.form.hull, b.form.hull
        normal = find_normal(_shift(ours, a), _shift(theirs, b), distance)
        if normal is not None:
            yield [k, -1, j, -1, *map(str, normal)]
            continue
        for i, h, found in _part_pieces(a, b, distance):
            yield found and [k, i, j, h, *map(str, found)]


def _part_container(board: Board, bits: int) -> Iterator[list[Any] | None]:
    """Make an entry for each piece of the outside and each near piece of a placement."""
    first = [0, *accumulate(len(wall.form.pieces) for wall in board.around)]
    for k, defects in board.find_defects(board.layout.margin).items():
        for wall in (0, *defects):
            a, b = share_scale(board.around[wall], board.solid(k, bits))
            distance = (board.layout.margin + b.slack) * a.scale
            for i, h, found in _part_pieces(a, b, distance):
                yield found and [-1, first[wall] + i, k, h, *map(str, found)]


def _part_pieces(
    a: Solid, b: Solid, distance: Fraction
) -> Iterator[tuple[int, int, IntVertex | None]]:
    """Find the pairs of pieces that need a normal, with the normal, if there is one."""
    theirs = [
        (h, piece, box)
        for h, piece in enumerate(b.pieces)
        if not _are_apart(a.box, box := bound_piece(piece), distance)
    ]
    for i, one in enumerate(a.pieces):
        bounds = bound_piece(one)
        if not _are_apart(bounds, b.box, distance):
            for h, other, box in theirs:
                if not _are_apart(bounds, box, distance):
                    yield i, h, find_normal(one, other, distance)


def _shift(ring: Sequence[IntVertex], by: Solid) -> list[IntVertex]:
    return [(x + by.x, y + by.y) for x, y in ring]


def _are_apart(one: LatticeBox, other: LatticeBox, distance: Fraction) -> bool:
    """Decide whether two boxes are a distance apart in x or in y."""
    left, right, low, high = one
    west, east, south, north = other
    return (
        west - right >= distance
        or left - east >= distance
        or south - high >= distance
        or low - north >= distance
    )


def _prove_faults(board: Board, faults: Sequence[Fault], bits: int) -> dict[str, Any] | None:
    """Find the witnesses of the faults; None if the turns are not near enough for one."""
    proved: list[dict[str, Any]] = []
    parts: set[str] = set()
    for fault in faults:
        if fault.kind in ("missing", "surplus", "turn", "mirror"):
            entry = {"kind": fault.kind, "part": fault.part}
            if entry not in proved:
                proved.append(entry)
        elif fault.kind == "shape":
            assert fault.part is not None
            edges = _find_clash(board.layout.part_by_id[fault.part])
            if edges is not None:
                proved.append({"kind": "shape", "part": fault.part, "edges": edges})
        elif fault.kind != "undecided":
            witness = _find_proof(board, fault, bits)
            if witness is not None:
                proved.append(witness)
                parts.update(board.layout.placements[k].part for k in fault.placements)
            elif bits < MOST_BITS:
                return None
    walled = any(len(entry.get("placements", ())) == 1 for entry in proved)
    pieces = [_list_pieces(board, p) if p.id in parts else None for p in board.layout.parts]
    outside = _list_outside(board) if walled else None
    return {"pieces": pieces, "outside": outside, "apart": [], "faults": proved} if proved else None


def _find_proof(board: Board, fault: Fault, bits: int) -> dict[str, Any] | None:
    """Find the witness of an overlap, of a part outside, or of a gap that is too small."""
    a, b = fault.find_pair(bits)
    alone = len(fault.placements) == 1
    first = sum(len(wall.form.pieces) for wall in board.around[: fault.wall]) if alone else 0
    if fault.kind == "too close":
        gap = board.layout.margin if alone else board.layout.spacing
        room = gap - a.slack - b.slack
        found = find_gap(a, b, room * room) if room > 0 else None
        if found is None:
            return None
        points = found.points
        i, j = _find_piece(a, points[0]), _find_piece(b, points[1])
    else:
        witness = find_witness(a, b)
        if witness is None:
            return None
        points, (i, j) = (witness.point, witness.point), witness.pieces
    return {
        "kind": fault.kind,
        "placements": list(fault.placements),
        "pieces": [i, first + j],
        "points": points,
    }


def _find_piece(solid: Solid, point: Point) -> int:
    """Find a piece with a point inside or on its boundary, and return its number."""
    x, y = point.x * solid.scale, point.y * solid.scale
    return next(
        k
        for k, piece in enumerate(solid.pieces)
        if all(turn(a, b, (x, y)) >= 0 for a, b in pairwise((*piece, piece[0])))
    )


def _find_clash(part: LayoutPart) -> list[list[int]] | None:
    """Find two edges of a ring that meet, or two edges of different rings that cross."""
    rings = [
        list(pairwise((*ring, ring[0])))
        for ring in (
            [p for k, p in enumerate(r) if p != r[k - 1]] for r in (part.exterior, *part.holes)
        )
        if len(ring) > 2
    ]
    if len(rings) <= len(part.holes):
        return None
    for r, edges in enumerate(rings):
        for (i, one), (k, other) in combinations(enumerate(edges), 2):
            if k - i in (1, len(edges) - 1):
                (a, b), (_, c) = (one, other) if k - i == 1 else (other, one)
                (ux, uy), (vx, vy) = minus(a, b), minus(c, b)
                clash = ux * vy == uy * vx and ux * vx + uy * vy > 0
            else:
                clash = touch(*one, *other) != []
            if clash:
                return [[r, i], [r, k]]
    for (r, edges), (s, others) in combinations(enumerate(rings), 2):
        for i, (a, b) in enumerate(edges):
            for k, (p, q) in enumerate(others):
                if turn(a, b, p) * turn(a, b, q) < 0 and turn(p, q, a) * turn(p, q, b) < 0:
                    return [[r, i], [s, k]]
    return None


def _list_pieces(board: Board, part: LayoutPart) -> list[list[Point]]:
    assert part.region is not None
    scale, form = board.base(part.id)
    return _leave(form.pieces, scale)


def _list_outside(board: Board) -> list[list[Point]]:
    return [ring for wall in board.around for ring in _leave(wall.form.pieces, wall.scale)]


def _leave(pieces: Sequence[ConvexRing], scale: int) -> list[list[Point]]:
    return [[Point(Fraction(x) / scale, Fraction(y) / scale) for x, y in p] for p in pieces]
