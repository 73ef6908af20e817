"""Certificates of layouts as claims for the checker in Coq."""

from __future__ import annotations

from fractions import Fraction
from itertools import chain
from math import ceil, lcm
from typing import Any, NamedTuple

from exactsweep.check.standalone import AXES, rotation_error
from exactsweep.check.terms import (
    CoqClaim,
    Nat,
    RationalPoint,
    Record,
    Some,
    TheoremError,
    find_unit,
    read_points,
    read_ring,
    read_rings,
    scale,
)

SLACK = 2**40  # errors of rotations are rounded up to multiples of 1 / (SLACK * denominator)


def _rotation(turn: Any) -> Any:
    """Return cosine and sine, or degrees where these are irrational."""
    if type(turn) is list:
        return Fraction(turn[0]), Fraction(turn[1])
    degrees = Fraction("0" if turn is None else turn) % 360
    return degrees if degrees % 90 else tuple(map(Fraction, AXES[int(degrees) // 90]))


def claim_layout(c: Any) -> CoqClaim:
    """Return the claim of a certificate of a valid layout.

    Raises:
        TheoremError: the layout has faults, a rotation that is not allowed, or a rounded container
            other than a disc; or two parts have one id.
    """
    if c["valid"] is not True:
        raise TheoremError("a layout with faults has no theorem")
    given, proof = c["layout"], c["proof"]
    parts, solids = given["parts"], [given.get("container"), *(given.get("defects") or [])]
    index = {part["id"]: k for k, part in enumerate(parts)}
    if len(index) != len(parts):
        raise TheoremError("two parts have one id")
    drawn, cut = [*map(_figure, parts)], [_pieces(e) for e in proof["pieces"]]
    has_sheet = solids[0] is not None and solids[0].get("pieces") != []
    sheet, obstacles = _figure(solids[0]) if has_sheet else None, [*map(_figure, solids[1:])]
    if sheet and sheet.rounded and len(sheet.points()) != 1:
        raise TheoremError("a rounded container other than a disc has no theorem")
    outside, *cut_obstacles = map(_pieces, proof["outside"])
    allowed = [_allowed(part) for part in parts]
    moves = [
        _moved(*one, index, drawn, allowed)
        for one in zip(given["placements"], c["turns"], strict=True)
    ]
    used = [[motion for j, motion, _ in moves if j == k] for k in range(len(parts))]
    placed = [_placed(motion, drawn[k]) for k, motion, _ in moves]
    pieces = [[_move(motion, ring) for ring in cut[k]] for k, motion, _ in moves]
    frame = [Fraction(n) for n in proof.get("frame") or [0] * 4]
    gaps = {key: Fraction(given.get(key) or 0) for key in ("spacing", "margin")}
    own = [e.get("spacing") for e in solids[1:]]
    distances = [gaps["margin"] if e is None else Fraction(e) for e in own]
    every = [*placed, *drawn, *obstacles, *([sheet] if sheet else [])]
    points = [ring for one in every for ring in one.rings()]
    numbers = [*gaps.values(), *distances, *frame, *(n for one in every for n in one.numbers())]
    rings = [*points, *chain(*pieces, *cut, *cut_obstacles), *outside]
    unit = find_unit(*rings, [(n, n) for n in numbers]) * (
        SLACK if any(s for *_, s in moves) else 1
    )
    layout = {
        "sheet": Some(sheet.term()) if sheet else None,
        "obstacles": [(e.term(), d) for e, d in zip(obstacles, distances, strict=True)],
        "kinds": [_part(*one) for one in zip(parts, drawn, allowed, used, strict=True)],
        "placements": [_placement(k, to, Fraction(ceil(e * unit), unit)) for k, to, e in moves],
        **gaps,
    }
    found = {"Layout.denominator": unit, "Layout.part_pieces": [scale(e, unit) for e in pieces]}
    found |= {"Layout.kind_pieces": [scale(e, unit) for e in cut]}
    found |= {"Layout.obstacle_pieces": [scale(e, unit) for e in cut_obstacles]}
    found |= {"Layout.outside_pieces": scale(outside, unit)}
    found |= {"Layout.frame": tuple(int(n * unit) for n in frame)}
    normals = [(*key, _whole(x, y)) for *key, x, y in proof["apart"]]
    evidence = {"evidence": ("certificate", Record(found)), "entries": ("list entry", normals)}
    return CoqClaim("layout", {"layout": ("Statements.layout", _record(layout))}, evidence)


class _Figure(NamedTuple):
    """A shape: its rings, or else its rounded pieces (points and radius), and its error."""

    outline: list[list[RationalPoint]]
    rounded: list[tuple[list[RationalPoint], Fraction]]
    error: Fraction

    def points(self) -> list[RationalPoint]:
        return [*chain(*self.rings())]

    def rings(self) -> list[list[RationalPoint]]:
        return self.outline + [points for points, _ in self.rounded]

    def numbers(self) -> list[Fraction]:
        return [self.error, *(radius for _, radius in self.rounded)]

    def term(self) -> Record:
        return _record(self._asdict())


def _record(fields: dict[str, Any]) -> Record:
    return Record({f"Statements.{key}": value for key, value in fields.items()})


def _figure(item: Any) -> _Figure:
    error = Fraction(item.get("error") or 0)
    if item.get("pieces") is None:
        return _Figure(read_rings(item), [], error)
    if item.get("exterior") is not None or item.get("holes"):
        raise TheoremError("a shape with rings and pieces")
    rounded = [(read_points(e["points"]), Fraction(e.get("radius") or 0)) for e in item["pieces"]]
    return _Figure([], rounded, error)


def _pieces(items: Any) -> list[list[RationalPoint]]:
    return [read_ring(e) for e in items or []]


def _moved(item: Any, turn: Any, index: Any, drawn: Any, allowed: Any) -> tuple[int, Any, Fraction]:
    """Return the part, the motion and the error of the rotation of a placement."""
    k, asked, to = index[item["part"]], _rotation(item.get("turn")), _rotation(turn)
    slack, is_mirrored = Fraction(0), item.get("mirrored") is True
    turns = allowed[k][is_mirrored]
    if turns is not None and asked not in turns:
        raise TheoremError("a placement has a rotation that is not allowed")
    if asked != to:
        if type(asked) is not Fraction:
            raise TheoremError("an entry of turns is not the rotation of its placement")
        slack = max(abs(x) + abs(y) for x, y in drawn[k].points()) * rotation_error(to, asked)
    return k, (is_mirrored, *to, read_points([item["move"]])[0]), slack


def _placed(motion: Any, figure: _Figure) -> _Figure:
    rounded = [(_move(motion, points), radius) for points, radius in figure.rounded]
    return _Figure([_move(motion, ring) for ring in figure.outline], rounded, figure.error)


def _move(motion: Any, ring: list[RationalPoint]) -> list[RationalPoint]:
    flag, c, s, (u, v) = motion
    points = [(-x if flag else x, y) for x, y in (ring[::-1] if flag else ring)]
    return [(c * x - s * y + u, s * x + c * y + v) for x, y in points]


def _allowed(part: Any) -> list[Any]:
    """Return the rotations allowed, without and with mirroring, or None for any."""
    turns = part.get("turns")
    other = turns if part.get("mirrored_turns") is None else part["mirrored_turns"]
    return [None if e is None else [*map(_rotation, e)] for e in (turns, other)]


def _part(part: Any, drawn: _Figure, allowed: list[Any], used: list[Any]) -> Record:
    """Return a part. Rational rotations that stand for irrational ones are allowed, too."""
    demand, known = part.get("demand"), ("rotations", "mirrored_rotations")
    rules = {"demand": None if demand is None else Some(Nat(demand))}
    for is_mirrored, (name, turns) in enumerate(zip(known, allowed, strict=True)):
        own = [(c, s) for flag, c, s, _ in used if flag == is_mirrored]
        rational = [e for e in turns or () if type(e) is tuple]
        rules[name] = None if turns is None else Some([*dict.fromkeys(rational + own)])
    return _record({"form": drawn.term(), **rules, "may_mirror": part.get("mirrored") is not False})


def _placement(kind: int, motion: Any, slack: Fraction) -> Record:
    names = ("mirrored", "cosine", "sine", "shift")
    by_motion = _record(dict(zip(names, motion, strict=True)))
    return _record({"kind": Nat(kind), "by_motion": by_motion, "slack": slack})


def _whole(x: str, y: str) -> tuple[int, int]:
    """Return a normal as two integers."""
    unit = lcm(Fraction(x).denominator, Fraction(y).denominator)
    return int(Fraction(x) * unit), int(Fraction(y) * unit)
