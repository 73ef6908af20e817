"""Random layouts of discs, slots, rounded rectangles and polygons near contact, with verdicts.

Every part is convex: a hull with a radius, at a rational rotation, placed at a chosen distance from
an earlier part in the direction of a Pythagorean triple. Closed formulas in rational arithmetic,
independent of the judge, yield the true verdicts.
"""

from __future__ import annotations

from collections.abc import Sequence
from copy import deepcopy
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations, pairwise
from random import Random
from typing import Any

from checkers import is_proved
from rounded_pieces import TRIPLES, Rounded, Vertex, are_disjoint, find_nearest, square, write

from exactsweep.check.standalone import Refused, prove
from exactsweep.layout import Layout, judge_layout

HULLS = [
    [(0, 0)],
    [(0, 0)],
    [(0, 0), (4, 0)],
    [(0, 0), (3, 4)],
    [(0, 0), (3, 0), (3, 2), (0, 2)],
    [(-1, -1), (3, 0), (0, 2)],
]
TURNS: list[Any] = ["0", "90", "180", ["3/5", "4/5"], ["-5/13", "12/13"], ["7/25", "-24/25"]]
NEAR = [Fraction(0)] * 3 + [Fraction(s, 10**k) for s in (-1, 1) for k in (0, 3, 9, 15, 40)]
KINDS = {"overlap", "too close", "outside"}
_CHANGES, _MOVES = 5, 2

Faults = set[tuple[str, tuple[int, ...]]]


@dataclass
class Packing:
    """A layout of rounded pieces and polygons as plain JSON data."""

    data: dict[str, Any]
    verdict: str = ""


def draw_packing(rng: Random) -> Packing:
    parts = [draw_part(rng, k) for k in range(rng.randint(1, 4))]
    spacing = rng.choice([Fraction(0), Fraction(0), Fraction(1, 3)])
    placed: list[dict[str, Any]] = []
    data: dict[str, Any] = {"parts": parts, "placements": placed, "spacing": str(spacing)}
    is_neat = rng.random() < 0.6
    for _ in range(rng.randint(2, 9)):
        part = rng.choice(parts)
        one = {"part": part["id"], "turn": rng.choice(TURNS), "mirrored": rng.random() < 0.3}
        placed.append({**one, "move": ["0", "0"]})
        shape = place(data, len(placed) - 1)
        if len(placed) > 1:
            earlier = place(data, rng.randrange(len(placed) - 1))
            x, y, length = rng.choice(TRIPLES)
            total = shape.radius + earlier.radius + spacing + rng.choice(NEAR)
            sign = rng.choice([-1, 1])
            start, end = rng.choice(earlier.hull), rng.choice(shape.hull)
            share = sign * total / length
            by = start[0] + share * x - end[0], start[1] + share * y - end[1]
            placed[-1]["move"] = [str(c) for c in by]
            if is_neat and find_truth(data)[0]:
                placed.pop()
    shapes = [place(data, k) for k in range(len(placed))]
    walls = draw_container(rng, shapes)
    if not is_neat or not find_truth(data | walls)[0]:
        data |= walls
    return Packing(data)


def draw_part(rng: Random, k: int) -> dict[str, Any]:
    hull = rng.choice(HULLS)
    radius = Fraction(rng.randint(1, 9), rng.choice([1, 2, 3, 10]))
    if len(hull) > 2 and rng.random() < 0.5:
        return {"id": str(k), "exterior": write(hull)}
    return {"id": str(k), "pieces": [{"points": write(hull), "radius": str(radius)}]}


def draw_container(rng: Random, shapes: list[Rounded]) -> dict[str, Any]:
    """Draw a rectangle or disc that touches a part, almost or exactly, or is larger; or none."""
    left, low, right, high = bound(shapes)
    off, margin = rng.choice(NEAR), rng.choice([Fraction(0), Fraction(1, 7)])
    match rng.randrange(3):
        case 0:
            return {}
        case 1:
            left, low = left - margin - off, low - margin
            corners = [(left, low), (right + 1, low), (right + 1, high + 1), (left, high + 1)]
            return {"container": {"exterior": write(corners)}, "margin": str(margin)}
        case _:
            one = rng.choice(shapes)
            x, y, length = rng.choice(TRIPLES)
            reach = Fraction(rng.randint(0, 40))
            v = rng.choice(one.hull)
            center = v[0] + reach * x / length, v[1] + reach * y / length
            radius = max(reach + one.radius + margin + off, Fraction(1, 9))
            piece = {"points": write([center]), "radius": str(radius)}
            return {"container": {"pieces": [piece]}, "margin": str(margin)}


def bound(shapes: list[Rounded]) -> tuple[Fraction, Fraction, Fraction, Fraction]:
    return (
        min(x - one.radius for one in shapes for x, _ in one.hull),
        min(y - one.radius for one in shapes for _, y in one.hull),
        max(x + one.radius for one in shapes for x, _ in one.hull),
        max(y + one.radius for one in shapes for _, y in one.hull),
    )


def place(data: dict[str, Any], k: int) -> Rounded:
    """Return a placed part: mirrored, rotated, translated."""
    placement = data["placements"][k]
    part = next(one for one in data["parts"] if one["id"] == placement["part"])
    piece = part["pieces"][0] if "pieces" in part else {"points": part["exterior"], "radius": "0"}
    turn = placement["turn"]
    quarters = {"0": (1, 0), "90": (0, 1), "180": (-1, 0)}
    c, s = map(Fraction, quarters[turn] if isinstance(turn, str) else turn)
    u, v = map(Fraction, placement["move"])
    hull = []
    for x, y in ((Fraction(x), Fraction(y)) for x, y in piece["points"]):
        across = -x if placement["mirrored"] else x
        hull.append((c * across - s * y + u, s * across + c * y + v))
    return Rounded(hull[::-1] if placement["mirrored"] else hull, Fraction(piece["radius"]))


def find_truth(
    data: dict[str, Any], among: Sequence[int] | None = None
) -> tuple[Faults, set[tuple[int, int]]]:
    """Return the faults and the contacts of a layout, or of some placements."""
    numbers = range(len(data["placements"])) if among is None else among
    shapes = {k: place(data, k) for k in numbers}
    spacing, margin = Fraction(data["spacing"]), Fraction(data.get("margin", "0"))
    faults: Faults = set()
    contacts = set()
    for (k, one), (j, other) in combinations(shapes.items(), 2):
        relation = relate(one, other, spacing)
        if relation == "contact":
            contacts.add((k, j))
            relation = "too close" if spacing else ""
        if relation:
            faults.add((relation, (k, j)))
    container = data.get("container")
    for k, one in shapes.items():
        if container is not None and not is_within(one, container, Fraction(0)):
            faults.add(("outside", (k,)))
        elif container is not None and not is_within(one, container, margin):
            faults.add(("too close", (k,)))
    return faults, contacts


def relate(one: Rounded, other: Rounded, spacing: Fraction) -> str:
    radii = one.radius + other.radius
    if not are_disjoint(one, other):
        return "overlap" if radii or not do_touch(one.hull, other.hull) else "contact"
    apart = square(*find_nearest(one, other))
    if apart <= radii**2:
        return "overlap" if apart < radii**2 else "contact"
    return "too close" if apart < (radii + spacing) ** 2 else ""


def do_touch(one: list[Vertex], other: list[Vertex]) -> bool:
    """Return whether the line of an edge separates two polygons."""
    normals = [
        (b[1] - a[1], a[0] - b[0]) for hull in (one, other) for a, b in pairwise([*hull, hull[0]])
    ]
    normals += [(-x, -y) for x, y in normals]
    return any(
        max(x * p + y * q for p, q in one) <= min(x * p + y * q for p, q in other)
        for x, y in normals
    )


def is_within(one: Rounded, container: dict[str, Any], margin: Fraction) -> bool:
    if "pieces" in container:
        (piece,) = container["pieces"]
        ((x, y),) = piece["points"]
        room = Fraction(piece["radius"]) - one.radius - margin
        center = Fraction(x), Fraction(y)
        return room >= 0 and all(square(p, center) <= room**2 for p in one.hull)
    xs, ys = ([Fraction(p[axis]) for p in container["exterior"]] for axis in (0, 1))
    left, low, right, high = bound([one])
    return (
        left - min(xs) >= margin
        and max(xs) - right >= margin
        and low - min(ys) >= margin
        and max(ys) - high >= margin
    )


def compare_packing(packing: Packing, rng: Random, deep: bool) -> str:
    """Compare the judge with the truth, prove the certificate, and reject changed ones."""
    data = packing.data
    faults, contacts = find_truth(data)
    judgement = judge_layout(Layout.from_json(data))
    packing.verdict = "valid" if judgement.valid else "not valid"
    found = {(fault.kind, fault.placements) for fault in judgement.faults}
    if found != faults:
        return f"faults {sorted(found)}, not {sorted(faults)}"
    if {*judgement.contacts} != contacts:
        return f"contacts {judgement.contacts}, not {sorted(contacts)}"
    for fault in judgement.faults[:_MOVES]:
        if wrong := find_wrong_move(data, fault):
            return f"{fault}: {wrong}"
    certificate = judgement.certificate()
    if Layout.from_json(certificate["layout"]) != Layout.from_json(data):
        return "another layout in the certificate"
    try:
        prove(certificate)
    except Refused as refusal:
        return f"not proved: {refusal}"
    for _ in range(_CHANGES):
        changed = change(certificate, rng)
        if is_false(changed) and is_proved(changed):
            return f"a false certificate is proved: {changed}"
    return ""


def find_wrong_move(data: dict[str, Any], fault: Any) -> str:
    """Describe a move that does not repair a fault, or is not the shortest; "" if none."""
    if fault.move is None:
        return "" if len(fault.placements) == 1 else "no move"
    k = fault.placements[-1]
    trials = [(Fraction(1), True)]
    if len(fault.placements) > 1 and fault.clearance is not None:
        trials.append((1 - Fraction(1, 10**5), False))
    for share, is_free in trials:
        moved = deepcopy(data)
        x, y = map(Fraction, moved["placements"][k]["move"])
        by = x + share * fault.move.x, y + share * fault.move.y
        moved["placements"][k]["move"] = [str(c) for c in by]
        faults = find_truth(moved, fault.placements)[0]
        pairs = {(kind, on) for kind, on in faults if on == fault.placements}
        if (not pairs) is not is_free:
            return f"{share} of the move leaves {pairs}"
    return ""


def change(certificate: dict[str, Any], rng: Random) -> dict[str, Any]:
    """Change a number or a claim of a certificate."""
    found = deepcopy(certificate)
    layout = found["layout"]
    match rng.randrange(5):
        case 0:
            move = rng.choice(layout["placements"])["move"]
            axis = rng.randrange(2)
            move[axis] = str(Fraction(move[axis]) + rng.choice(NEAR[3:]))
        case 1:
            shape = rng.choice([*layout["parts"], layout.get("container", {})])
            for piece in shape.get("pieces", ()):
                more = rng.choice([Fraction(1, 10**9), Fraction(1, 100), Fraction(1)])
                piece["radius"] = str(abs(Fraction(piece["radius"]) + rng.choice([-1, 1]) * more))
        case 2:
            name = rng.choice(["spacing", "margin"])
            layout[name] = str(
                Fraction(layout[name]) + rng.choice([Fraction(1, 10**9), Fraction(1)])
            )
        case 3:
            claim = found.get("faults") or [{"kind": "overlap", "placements": [0, 1]}]
            fault = rng.choice(claim)
            fault["placements"] = [0, rng.randrange(-1, len(layout["placements"]))]
            fault["point"] = fault.get("point", ["0", "0"])
            found["faults"] = claim
            found["valid"] = False
            found.pop("proof", None)
        case _:
            turn = rng.choice(layout["placements"])
            turn["mirrored"] = not turn["mirrored"]
    return found


def is_false(certificate: dict[str, Any]) -> bool:
    """Return whether a certificate of this module contradicts the truth."""
    faults = find_truth(certificate["layout"])[0]
    if certificate["valid"]:
        return bool(faults)
    claimed = {
        (fault["kind"], tuple(k for k in fault["placements"] if k >= 0))
        for fault in certificate["faults"]
    }
    true = {(kind, tuple(on)) for kind, on in faults} | {("too close", on) for _, on in faults}
    return any((kind, tuple(sorted(on))) not in true for kind, on in claimed)
