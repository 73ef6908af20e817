"""Finer flattening of curves where the verdict on a layout is undecided.

(1) Only the shapes of an undecided fault are flattened again, those with the greatest error of the
    fault. A part has one error, so all of its curves become finer.
(2) A tenth of the error needs about 10^(1/2) times the vertices, so the last flattening costs more
    than all before it. A budget of vertices bounds their sum; the cheapest faults come first. What
    exceeds it stays undecided.
(3) Until the budget ends, only placements of undecided faults are judged again.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from exactsweep.formats import FormatError
from exactsweep.numbers.error import prefix_errors

if TYPE_CHECKING:
    from exactsweep.formats.layouts import FoundLayout
    from exactsweep.formats.node import Data
    from exactsweep.layout import Fault, Judgement

MOST_VERTICES = 50_000
"""The budget of a layout: vertices of all finer shapes together."""

# The factor on the error, a bound on that on the vertices, and the maximum number of times.
_FINER, _GROWTH, _MOST_FINER = Fraction(1, 10), 4, 12

_ShapeName = str | None
"""The id of a part; None for the container."""


def judge_found(found: FoundLayout, gaps: Mapping[str, str], title: str) -> Judgement:
    """Judge a layout with the curves as flattened by its reader."""
    from exactsweep.layout import Layout, judge_layout

    with prefix_errors(title):
        layout = Layout.from_json({**found.data, **gaps})
    return judge_layout(layout)


def refine_curves(
    found: FoundLayout, judgement: Judgement, gaps: Mapping[str, str], title: str
) -> Judgement:
    """Judge a layout with finer curves in its undecided parts; return the judgement.

    Cost: that of flattening and judging MOST_VERTICES vertices, and of a judgement.
    """
    shapes, room, unsure = _list_shapes(found.data), MOST_VERTICES, judgement
    data = found.data
    finer: dict[_ShapeName, Data] = {}
    for _ in range(_MOST_FINER):
        faults = [f for f in unsure.faults if f.kind == "undecided" and f.error]
        chosen = _choose(faults, unsure, shapes, room)
        improved = {
            name: shape
            for name, shape in _flatten(found, chosen)
            if _read_error(shape) < _read_error(shapes[name])
        }
        if not improved:
            break
        finer |= improved
        shapes |= improved
        room -= sum(map(_count_vertices, improved.values()))
        placed = sorted({k for fault in faults for k in fault.placements})
        data = {**data, "placements": [data["placements"][k] for k in placed]}
        names = {one["part"] for one in data["placements"]}
        data["parts"] = [part for part in found.data["parts"] if part["id"] in names]
        unsure = judge_found(found._replace(data=_replace_shapes(data, finer)), gaps, title)
    whole = found.data["placements"], found.data["parts"]
    if not finer or [*map(len, whole)] == [len(data["placements"]), len(data["parts"])]:
        return unsure
    return judge_found(found._replace(data=_replace_shapes(found.data, finer)), gaps, title)


def judge_finely(found: FoundLayout, gaps: Mapping[str, str], title: str) -> Judgement:
    """Judge a layout; flatten the curves of undecided parts more finely, up to a budget."""
    return refine_curves(found, judge_found(found, gaps, title), gaps, title)


def _choose(
    faults: Iterable[Fault], judgement: Judgement, shapes: Mapping[_ShapeName, Data], room: int
) -> dict[_ShapeName, Fraction]:
    """Choose the shapes to be flattened again, with their tolerances, by (1) and (2)."""
    needs = []
    for fault in faults:
        names: set[_ShapeName] = {judgement.layout.placements[k].part for k in fault.placements}
        names |= {None} if len(fault.placements) == 1 and None in shapes else set()
        errors = {name: _read_error(shapes[name]) for name in names}
        tolerance = max(errors.values()) * _FINER
        needs.append({name: tolerance for name, error in errors.items() if error > tolerance})
    costs = {name: _GROWTH * _count_vertices(shapes[name]) for need in needs for name in need}
    chosen: dict[_ShapeName, Fraction] = {}
    for need in sorted(needs, key=lambda need: sum(costs[name] for name in need)):
        room -= sum(costs[name] for name in need if name not in chosen)
        if room < 0:
            break
        for name, tolerance in need.items():
            chosen[name] = min(tolerance, chosen.get(name, tolerance))
    return chosen


def _flatten(
    found: FoundLayout, chosen: Mapping[_ShapeName, Fraction]
) -> list[tuple[_ShapeName, Data]]:
    """Flatten shapes at their tolerances; skip those with too many lines."""
    assert found.flatten is not None or not chosen
    shapes: list[tuple[_ShapeName, Data]] = []
    for tolerance in sorted({*chosen.values()}, reverse=True):
        names: Collection[_ShapeName] = {name for name in chosen if chosen[name] == tolerance}
        try:
            shapes += found.flatten(names, tolerance).items()  # type: ignore[misc]
        except FormatError:
            # Too many lines.
            break
    return shapes


def _list_shapes(data: Data) -> dict[_ShapeName, Data]:
    container = {None: data["container"]} if data.get("container") else {}
    return {**container, **{part["id"]: part for part in data["parts"]}}


def _replace_shapes(data: Data, finer: Mapping[_ShapeName, Data]) -> Data:
    parts = [{**part, **finer.get(part["id"], {})} for part in data["parts"]]
    container = {"container": finer[None]} if None in finer else {}
    return {**data, "parts": parts, **container}


def _read_error(shape: Data) -> Fraction:
    return Fraction(shape.get("error", 0))


def _count_vertices(shape: Data) -> int:
    rings = [shape.get("exterior", ()), *shape.get("holes", ())]
    pieces = [piece["points"] for piece in shape.get("pieces", ())]
    return sum(map(len, (*rings, *pieces)))
