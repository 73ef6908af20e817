"""Certificates of layouts as claims for the checker in Coq."""

from __future__ import annotations

from fractions import Fraction
from itertools import chain, product
from math import ceil, lcm
from typing import Any

from exactsweep.check.fault_claims import claim_fault
from exactsweep.check.figures import (
    Figure,
    PlacedPart,
    move_ring,
    place,
    read_figure,
    read_move,
    read_rotation,
    record,
)
from exactsweep.check.terms import (
    SEGMENTS,
    CoqClaim,
    Nat,
    RationalPoint,
    Record,
    Some,
    TheoremError,
    find_unit,
    read_ring,
    scale,
)

SLACK = 2**40  # errors of rotations are rounded up to multiples of 1 / (SLACK * denominator)


class _LayoutTerms:
    """The layout of a certificate."""

    def __init__(self, c: Any) -> None:
        given, self.parts = c["layout"], c["layout"]["parts"]
        first, defects = given.get("container"), given.get("defects") or []
        self.index = {part["id"]: k for k, part in enumerate(self.parts)}
        if len(self.index) != len(self.parts):
            raise TheoremError("two parts have one id")
        self.drawn = [*map(read_figure, self.parts)]
        sheet = Figure([], [], Fraction(0)) if first is None else read_figure(first)
        self.sheet = sheet if sheet.rings() else None
        self.allowed = [*map(_allowed, self.parts)]
        pairs = zip(given["placements"], c["turns"], strict=True)
        self.moves = [read_move(*pair, self.index, self.drawn, self.allowed) for pair in pairs]
        self.placed = [place(move, self.drawn[move.kind]) for move in self.moves]
        self.gaps = {key: Fraction(given.get(key) or 0) for key in ("spacing", "margin")}
        own = (e.get("spacing") for e in defects)
        far = [self.gaps["margin"] if e is None else Fraction(e) for e in own]
        self.obstacles = [*zip(map(read_figure, defects), far, strict=True)]

    def term(self, slacks: list[Fraction]) -> Record:
        """Return the layout as a term; rational replacements of allowed rotations are allowed."""
        moves = self.moves
        used = [[m for m in moves if m.kind == k and m.is_allowed] for k in range(len(self.parts))]
        kinds = zip(self.parts, self.drawn, self.allowed, used, strict=True)
        placed = [m.term(slack) for m, slack in zip(moves, slacks, strict=True)]
        found: dict[str, Any] = {"sheet": Some(self.sheet.term()) if self.sheet else None}
        found |= {"obstacles": [(e.term(), far) for e, far in self.obstacles]}
        return record(
            {**found, "kinds": [_part(*e) for e in kinds], "placements": placed, **self.gaps}
        )


def claim_layout(c: Any) -> CoqClaim:
    """Return the claim of a certificate of a layout, valid or with faults.

    Raises TheoremError if a valid layout has a rotation that is not allowed, or a rounded container
    whose radius is less than the errors, radii and margin of its parts; if two parts have the same
    id; or if a rounded piece is not convex.
    """
    found = _LayoutTerms(c)
    return _valid(found, c["proof"]) if c["valid"] is True else _faulty(found, c["faults"])


def _faulty(found: _LayoutTerms, faults: Any) -> CoqClaim:
    beyond = (found.sheet, found.gaps["margin"]) if found.sheet else None
    placed = [(e, found.gaps["spacing"]) for e in found.placed]
    bodies = [*placed, *found.obstacles[::-1], beyond]
    claims = [claim_fault(e, found.index, bodies) for e in faults]
    layout = found.term([move.slack for move in found.moves])
    statement: dict[str, tuple[str, Any]] = {"layout": ("Statements.layout", layout)}
    statement["faults"] = ("list Statements.fault", [term for term, _ in claims])
    return CoqClaim("faults", statement, {"points": (SEGMENTS, [points for _, points in claims])})


def _valid(found: _LayoutTerms, proof: Any) -> CoqClaim:
    if not all(move.is_allowed for move in found.moves):
        raise TheoremError("a placement has a rotation that is not allowed")
    sheet = found.sheet or Figure([], [], Fraction(0))
    for (points, radius), body in product(sheet.rounded, found.placed):
        least = max((r for _, r in body.rounded), default=Fraction(0)) + body.error
        if len(points) > 1 and radius < least + found.gaps["margin"] + sheet.error:
            raise TheoremError("a container with a smaller radius than its parts need")
    cut = [_pieces(e) for e in proof["pieces"]]
    outside, *cut_obstacles = map(_pieces, proof["outside"])
    pieces = [[move_ring(m.motion, ring) for ring in cut[m.kind]] for m in found.moves]
    frame = [Fraction(n) for n in proof.get("frame") or [0] * 4]
    # Placed figures have the radii and the own errors of drawn ones.
    every = [*found.drawn, *(e for e, _ in found.obstacles), sheet]
    numbers = [*found.gaps.values(), *(distance for _, distance in found.obstacles), *frame]
    numbers += chain(*(e.numbers() for e in every))
    rings = [*chain(*(e.rings() for e in [*found.placed, *every]))]
    rings += chain(*pieces, *cut, *cut_obstacles)
    unit = find_unit(*rings, *outside, [(n, n) for n in numbers])
    unit *= SLACK if any(move.slack for move in found.moves) else 1
    layout = found.term([Fraction(ceil(move.slack * unit), unit) for move in found.moves])
    evidence = {"Layout.denominator": unit, "Layout.part_pieces": [scale(e, unit) for e in pieces]}
    evidence |= {"Layout.kind_pieces": [scale(e, unit) for e in cut]}
    evidence |= {"Layout.obstacle_pieces": [scale(e, unit) for e in cut_obstacles]}
    evidence |= {"Layout.outside_pieces": scale(outside, unit)}
    evidence |= {"Layout.frame": tuple(int(n * unit) for n in frame)}
    normals = [(*key, _whole(x, y)) for *key, x, y in proof["apart"]]
    known = {"evidence": ("certificate", Record(evidence)), "entries": ("list entry", normals)}
    return CoqClaim("layout", {"layout": ("Statements.layout", layout)}, known)


def _pieces(items: Any) -> list[list[RationalPoint]]:
    return [read_ring(e) for e in items or []]


def _allowed(part: Any) -> list[Any]:
    """Return the rotations allowed, without and with mirroring, or None for any."""
    turns = part.get("turns")
    other = turns if part.get("mirrored_turns") is None else part["mirrored_turns"]
    return [None if e is None else [*map(read_rotation, e)] for e in (turns, other)]


def _part(part: Any, drawn: Figure, allowed: list[Any], used: list[PlacedPart]) -> Record:
    demand, known = part.get("demand"), ("rotations", "mirrored_rotations")
    rules = {"demand": None if demand is None else Some(Nat(demand))}
    for is_mirrored, (name, turns) in enumerate(zip(known, allowed, strict=True)):
        own = [(c, s) for flag, c, s, _ in (m.motion for m in used) if flag == is_mirrored]
        rational = [e for e in turns or () if type(e) is tuple]
        rules[name] = None if turns is None else Some([*dict.fromkeys(rational + own)])
    return record({"form": drawn.term(), **rules, "may_mirror": part.get("mirrored") is not False})


def _whole(x: str, y: str) -> tuple[int, int]:
    unit = lcm(Fraction(x).denominator, Fraction(y).denominator)
    return int(Fraction(x) * unit), int(Fraction(y) * unit)
