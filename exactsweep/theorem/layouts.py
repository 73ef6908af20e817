"""Layouts in certificates as terms for Coq."""

from __future__ import annotations

from fractions import Fraction
from math import ceil, inf
from typing import Any

from exactsweep.check.standalone import JUDGED, WORK, find_bodies, read, rotation, rotation_error
from exactsweep.theorem.readers import RationalRing, read_rational, read_ring, read_shape
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
    find_bodies(read("", {**c, "proof": None}, JUDGED))  # the proof is for Coq
    given, distances = c["layout"], {}
    container, parts = given.get("container"), {part["id"]: part for part in given["parts"]}
    for key in ("spacing", "margin"):
        distances[key] = read_rational(given.get(key) or "0")
    defects = [
        (_figure(e), read_rational(e.get("spacing") or given.get("margin") or "0"))
        for e in given.get("defects") or []
    ]
    is_open = container is None or container.get("pieces") == []
    placed = zip(given["placements"], c["turns"], strict=True)
    return {
        "sheet": option(None if is_open else _figure(container)),
        "obstacles": defects,
        "kinds": [*map(_part, parts.values())],
        "placements": [_placement(e, to, parts) for e, to in placed],
        **distances,
    }


def _figure(item: Any) -> dict[str, Any]:
    pieces = item.get("pieces")
    rings = {"exterior": item.get("exterior"), "holes": item.get("holes")}
    rounded = [
        (read_ring(e["points"]), read_rational(e.get("radius") or "0")) for e in pieces or []
    ]
    outline = read_shape(rings) if pieces is None else []
    error = read_rational(item.get("error") or "0")
    return {"outline": outline, "rounded": rounded, "error": error}


def _part(part: Any) -> dict[str, Any]:
    demand, turns, others = (part.get(key) for key in ("demand", "turns", "mirrored_turns"))
    others = turns if others is None else others
    return {
        "form": _figure(part),
        "demand": option(None if demand is None else Number(demand, "N")),
        "rotations": option(None if turns is None else [*map(_rotation, turns)]),
        "mirrored_rotations": option(None if others is None else [*map(_rotation, others)]),
        "may_mirror": part.get("mirrored") is not False,
    }


def _rotation(item: Any) -> Constructor:
    found = rotation("turn", item)
    if type(found) is tuple:
        return Constructor(0, "Statements.Rational", tuple(map(Fraction, found)))
    return Constructor(1, "Statements.Degrees", (Fraction(found),))


def _placement(item: Any, turn: Any, parts: dict[str, Any]) -> dict[str, Any]:
    asked, to = (rotation("turn", e) for e in (item.get("turn") or "0", turn))
    cosine, sine = map(Fraction, to)
    degrees, slack = None, Fraction(0)
    if asked != to:
        degrees, figure = Fraction(asked), _figure(parts[item["part"]])
        rings = [*figure["outline"], *(points for points, _ in figure["rounded"])]
        reach = max(abs(x) + abs(y) for points in rings for x, y in points)
        slack = _round_up(reach * rotation_error(to, asked))
    (shift,) = read_ring([item["move"]])
    names = ("mirrored", "cosine", "sine", "shift")
    by = dict(zip(names, (item.get("mirrored") is True, cosine, sine, shift), strict=True))
    kind = Number([*parts].index(item["part"]))
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
