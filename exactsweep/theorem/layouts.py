"""Layouts in certificates as terms for Coq."""

from __future__ import annotations

from fractions import Fraction
from math import ceil, inf
from typing import Any

from exactsweep.check.standalone import (
    JUDGED,
    WORK,
    find_bodies,
    place,
    read,
    rings_of,
    rotation_error,
)
from exactsweep.theorem.readers import RationalPoint, RationalRing, read_ring
from exactsweep.theorem.terms import Constructor, Number, TheoremError, option

BITS = 16  # precision of rotation errors, which are rounded up
FAULTS = {
    "missing": (0, "Missing"),
    "surplus": (1, "Surplus"),
    "mirror": (2, "Mirrored"),
    "turn": (3, "Rotated"),
    "shape": (4, "Not_simple"),
    "overlap": (5, "Overlapping"),
    "outside": (5, "Overlapping"),
    "too close": (6, "Too_close"),
}


def read_layout(c: Any) -> dict[str, Any]:
    """Read a layout; raise Refused if its form is wrong."""
    WORK.set([inf, 1.0])
    found = read("", {**c, "proof": None}, JUDGED)  # the proof is for Coq
    find_bodies(found)
    given, parts = found.layout, {part.id: part for part in found.layout.parts}
    far = [given.margin if e.spacing is None else e.spacing for e in given.defects]
    placed = zip(given.placements, found.turns, strict=True)
    return {
        "sheet": option(None if given.container.pieces == [] else _figure(given.container)),
        "obstacles": [*zip(map(_figure, given.defects), map(Fraction, far), strict=True)],
        "kinds": [*map(_part, given.parts)],
        "placements": [_placement(e, place(to), parts) for e, to in placed],
        "spacing": Fraction(given.spacing),
        "margin": Fraction(given.margin),
    }


def _figure(body: Any) -> dict[str, Any]:
    rings = rings_of(body) if body.pieces is None else []
    return {
        "outline": [[*map(place, points)] for points in rings],
        "rounded": [([*map(place, e.points)], Fraction(e.radius)) for e in body.pieces or ()],
        "error": Fraction(body.error),
    }


def _part(part: Any) -> dict[str, Any]:
    others = part.turns if part.mirrored_turns is None else part.mirrored_turns
    return {
        "form": _figure(part),
        "demand": option(None if part.demand is None else Number(part.demand, "N")),
        "rotations": _rotations(part.turns),
        "mirrored_rotations": _rotations(others),
        "may_mirror": part.mirrored,
    }


def _rotations(turns: Any) -> Constructor:
    return option(None if turns is None else [*map(_rotation, turns)])


def _rotation(turn: Any) -> Constructor:
    if type(turn) is tuple:
        return Constructor(0, "Statements.Rational", tuple(map(Fraction, turn)))
    return Constructor(1, "Statements.Degrees", (Fraction(turn),))


def _placement(item: Any, to: RationalPoint, parts: dict[str, Any]) -> dict[str, Any]:
    names, degrees, slack = ("mirrored", "cosine", "sine", "shift"), None, Fraction(0)
    if item.turn != to:
        degrees, figure = Fraction(item.turn), _figure(parts[item.part])
        rings = [*figure["outline"], *(points for points, _ in figure["rounded"])]
        reach = max(abs(x) + abs(y) for points in rings for x, y in points)
        slack = _round_up(reach * rotation_error(to, item.turn))
    by = dict(zip(names, (item.mirrored, *to, place(item.move)), strict=True))
    kind = Number([*parts].index(item.part))
    return {"kind": kind, "by_motion": by, "degrees": option(degrees), "slack": slack}


def _round_up(slack: Fraction) -> Fraction:
    unit = 1 << BITS + (slack.denominator // max(slack.numerator, 1)).bit_length()
    return Fraction(ceil(slack * unit), unit)


def read_normals(items: Any) -> list[Any]:
    """Read the normals of pieces that are apart."""
    return [(*key, *read_ring([[x, y]])) for *key, x, y in items]


def read_faults(c: Any) -> list[Constructor]:
    """Read the faults of a layout.

    Raises TheoremError for an overlap with an obstacle, or `outside` without one.
    """
    ids = [part["id"] for part in c["layout"]["parts"]]
    return [_fault(fault, fault["kind"], ids) for fault in c["faults"]]


def _fault(fault: Any, kind: str, ids: list[str]) -> Constructor:
    number, name = FAULTS[kind]
    if fault.get("placements") is None:
        return Constructor(number, f"Statements.{name}", (Number(ids.index(fault["part"])),))
    a, b = fault["placements"]
    if kind != "too close" and (kind == "outside") != (b < 0):
        raise TheoremError("a fault of kind 'overlap' with an obstacle, or 'outside' without one")
    body = Constructor(0, "Statements.Part", (Number(b),))
    if b < 0:
        body = Constructor(2, "Statements.Obstacle", (Number(-2 - b),))
    if b == -1:
        body = Constructor(1, "Statements.Beyond")
    return Constructor(number, f"Statements.{name}", (Number(a), body))


def read_points(faults: Any) -> RationalRing:
    """Read the points of faults; those without one get the origin."""
    return read_ring([fault.get("point") or ["0", "0"] for fault in faults])
