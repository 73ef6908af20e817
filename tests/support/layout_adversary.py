"""An adversary against certificates of layouts: `python -m tests.falsify --layouts`.

It translates, rotates or mirrors one placement, or changes a number, and lets the finder add the
pieces and witnesses; if no normal separates two pieces, it writes the best one.
"""

from __future__ import annotations

import json
from collections.abc import Iterator
from fractions import Fraction
from random import Random
from typing import Any
from unittest.mock import patch

from random_layouts import draw_layout
from tampering import put

from exactsweep.layout import Layout, LayoutError, judge_layout
from exactsweep.layout import certificate as finder
from exactsweep.layout.board import Board
from exactsweep.layout.pieces import find_normal

Certificate = dict[str, Any]
MOST = 5  # placements


def draw_layouts(rng: Random) -> Iterator[Certificate]:
    """Draw certificates of two layouts that differ in one placement or number."""
    layout = draw_layout(rng).layout
    while len(layout.placements) > MOST:
        layout = draw_layout(rng).layout
    for data in (layout.to_json(), disturb(layout.to_json(), rng)):
        try:
            yield json.loads(json.dumps(judge_layout(Layout.from_json(data)).certificate()))
        except LayoutError:  # all pairs are undecided
            continue


def disturb(data: dict[str, Any], rng: Random) -> dict[str, Any]:
    """Change one placement of a layout, or a number."""
    changed: dict[str, Any] = json.loads(json.dumps(data))
    one, other = (rng.choice(changed["placements"]) for _ in range(2))
    kind = rng.choice(["move", "move", "move", "take", "turn", "mirrored", "gap"])
    if kind == "move":
        part = rng.choice(changed["parts"])
        (ax, ay), (bx, by) = (map(Fraction, rng.choice(part["exterior"])) for _ in range(2))
        share = rng.choice([Fraction(1), Fraction(1, 2), Fraction(-1, 10**9), Fraction(1, 10**40)])
        step = share * (ax - bx), share * (ay - by)
        one["move"] = [str(Fraction(c) + d) for c, d in zip(one["move"], step, strict=True)]
    elif kind == "gap":
        name = rng.choice(["spacing", "margin"])
        most = rng.choice([Fraction(1), Fraction(1, 10**9), Fraction(2)])
        changed[name] = str(Fraction(changed.get(name) or 0) + most)
    else:
        key = {"take": "move", "turn": "turn", "mirrored": "mirrored"}[kind]
        one[key] = not one.get(key) if kind == "mirrored" else other[key]
    return changed


def refill(certificate: Certificate, rng: Random) -> tuple[str, Certificate]:
    """Disturb a layout, and let the finder prove validity or the old faults."""
    board = Board(Layout.from_json(disturb(certificate["layout"], rng)))
    faults = judge_layout(Layout.from_json(certificate["layout"])).faults
    claimed = () if rng.random() < 0.7 else faults
    with patch.object(finder, "find_normal", invent_normal):
        found = finder.write_certificate(board, claimed)
    name = "old faults" if claimed else "claimed to be valid"
    return f"layout: {name}", json.loads(json.dumps(found))


def invent_normal(one: Any, other: Any, distance: Fraction) -> tuple[int, int]:
    """Find a separating normal, or the one with the smallest deficit."""
    found = find_normal(one, other, distance)
    if found is not None:
        return found
    (ax, ay), (bx, by) = (
        [sum(c) * len(o) for c in zip(*r, strict=True)] for r, o in ((one, other), (other, one))
    )
    return (bx - ax, by - ay) if (ax, ay) != (bx, by) else (1, 0)


def is_true_layout(certificate: Certificate, _: object) -> bool:
    """Decide whether the judge agrees with the verdict and the listed faults."""
    data = _leave_out_null(certificate["layout"])
    try:
        judgement = judge_layout(Layout.from_json(data))
    except LayoutError as error:
        if certificate["valid"] or not str(error).startswith("container"):
            return False
        # The reader rejects a container that crosses itself. The checker treats it as the set with
        # winding number 1, and faults between parts do not depend on it.
        room = [[str(x), str(y)] for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))]
        others = [f for f in certificate["faults"] if -1 not in f.get("placements", ())]
        changed = put(certificate, ("layout", "container"), {"exterior": room})
        return not others or is_true_layout({**changed, "faults": others}, _)
    if certificate["valid"]:
        return judgement.valid
    # The judge compares no part with a fault of shape; the checker uses its winding number.
    shapeless = {k for fault in judgement.faults if fault.kind == "shape" for k in fault.placements}
    pairs = {(fault.kind, frozenset(fault.placements)) for fault in judgement.faults}
    pairs |= {("too close", on) for kind, on in pairs if kind in ("overlap", "outside")}
    rules = {(f.kind, f.part) for f in judgement.faults}
    return not judgement.valid and all(
        shapeless & {*fault["placements"]}
        or (fault["kind"], frozenset(k for k in fault["placements"] if k >= 0)) in pairs
        if "placements" in fault
        else (fault["kind"], fault["part"]) in rules
        for fault in certificate["faults"]
    )


def _leave_out_null(item: Any) -> Any:
    """Drop nulls, which the checker accepts and the reader of layouts rejects."""
    if type(item) is dict:
        return {key: _leave_out_null(value) for key, value in item.items() if value is not None}
    return [*map(_leave_out_null, item)] if type(item) is list else item
