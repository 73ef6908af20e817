"""Verdicts on layouts in files; curves are flattened more finely where undecided.

(1) Of the shapes in an undecided fault, only those with the greatest error are flattened again. A
    part has one error, so all of its curves become finer.
(2) A tenth of the error needs about 10^(1/2) times as many vertices, so the last flattening costs
    more than all others. A budget limits the total number of vertices; the cheapest faults come
    first, and faults beyond the budget stay undecided.
(3) Until the budget is spent, only placements of undecided faults are judged again.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from exactsweep.formats import FormatError, show_path
from exactsweep.numbers.error import prefix_errors
from exactsweep.words import spell_out

if TYPE_CHECKING:
    from exactsweep.formats.layouts import FoundLayout
    from exactsweep.formats.node import Data
    from exactsweep.layout import Fault, Judgement

# The budget of a layout: the number of vertices of all finer shapes.
MAX_VERTICES = 50_000
# The factor on the error, a bound on the factor on the vertices, and the maximum number of rounds.
_FINER, _GROWTH, _MAX_ROUNDS = Fraction(1, 10), 4, 12

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
    """Judge a layout with finer curves in its undecided parts."""
    shapes, budget, undecided = _list_shapes(found.data), MAX_VERTICES, judgement
    data = found.data
    finer: dict[_ShapeName, Data] = {}
    for _ in range(_MAX_ROUNDS):
        faults = [f for f in undecided.faults if f.kind == "undecided" and f.error]
        chosen = _choose(faults, undecided, shapes, budget)
        improved = {
            name: shape
            for name, shape in _flatten(found, chosen)
            if _read_error(shape) < _read_error(shapes[name])
        }
        if not improved:
            break
        finer |= improved
        shapes |= improved
        budget -= sum(map(_count_vertices, improved.values()))
        placed = sorted({k for fault in faults for k in fault.placements})
        data = {**data, "placements": [data["placements"][k] for k in placed]}
        names = {one["part"] for one in data["placements"]}
        data["parts"] = [part for part in found.data["parts"] if part["id"] in names]
        undecided = judge_found(found._replace(data=_replace_shapes(data, finer)), gaps, title)
    whole = found.data["placements"], found.data["parts"]
    if not finer or [*map(len, whole)] == [len(data["placements"]), len(data["parts"])]:
        return undecided
    return judge_found(found._replace(data=_replace_shapes(found.data, finer)), gaps, title)


def judge_finely(found: FoundLayout, gaps: Mapping[str, str], title: str) -> Judgement:
    return refine_curves(found, judge_found(found, gaps, title), gaps, title)


def _choose(
    faults: Iterable[Fault], judgement: Judgement, shapes: Mapping[_ShapeName, Data], budget: int
) -> dict[_ShapeName, Fraction]:
    """Choose the shapes to flatten again, with their tolerances, by (1) and (2)."""
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
        budget -= sum(costs[name] for name in need if name not in chosen)
        if budget < 0:
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


class LayoutRow(NamedTuple):
    """A row of the table of several layouts.

    For an unreadable file, `verdict` is the error and `valid` is None. `worst` is the depth of the
    worst fault, or the minimum distance in a valid layout. `unchecked` lists rules not judged.
    """

    name: str
    verdict: str
    valid: bool | None
    placements: int = 0
    worst: str = ""
    notes: Sequence[str] = ()
    accepted: bool = False
    unchecked: Sequence[str] = ()


def list_notes(found: FoundLayout, judgement: Judgement) -> list[str]:
    """List the notes of the reader, and conventions that would explain the faults."""
    from exactsweep.layout.diagnose import diagnose, find_radians

    guesses = diagnose(judgement)
    if not any("radians" in guess for guess in guesses):
        guesses += find_radians(judgement.layout)
    return [*map(spell_out, found.notes), *guesses]


def judge_file(
    path: str,
    read: Callable[[], Sequence[FoundLayout]],
    gaps: Mapping[str, str],
    accept: Fraction | None = None,
) -> list[LayoutRow]:
    """Judge the layouts in a file; an unreadable file also gets a row."""
    rows = []
    try:
        for found in read():
            name = f"{show_path(path)}, {found.name}" if found.name else show_path(path)
            rows.append(_sum_up(name, found, judge_finely(found, gaps, name), accept))
    except ValueError as error:
        rows.append(LayoutRow(show_path(path), str(error), None))
    return rows


def _sum_up(
    name: str, found: FoundLayout, judgement: Judgement, accept: Fraction | None
) -> LayoutRow:
    from exactsweep.layout.report import ReportContext, rank_faults
    from exactsweep.layout.report.table import describe_fault, list_measures
    from exactsweep.text.report import approximate, take_root

    context = ReportContext(found.unchecked, found.places, found.unit, accept)
    ranked = rank_faults(judgement, accepted=accept)
    facts = list_measures(judgement, ranked, context)
    worst, nearest = "", judgement.distance
    if ranked:
        worst = describe_fault(judgement, ranked[0], context, repaired=False)[1]
        if not worst and ranked[0].fault.kind == "outside":
            worst = "no free position at this rotation"
    elif nearest is not None:
        worst = f"{context.add_unit(approximate(take_root(nearest.square)))} apart"
    return LayoutRow(
        name,
        facts["verdict"],
        judgement.valid,
        len(judgement.layout.placements),
        worst,
        [*map(spell_out, found.notes)],
        accepted=all(one.accepted for one in ranked),
        unchecked=found.unchecked,
    )


def write_rows(rows: Sequence[LayoutRow], terminal_width: int | None) -> str:
    from exactsweep.text.report import lay_out, make_table

    table = make_table(("layout", "placements", "verdict", "worst or nearest"), {"placements"})
    for row in rows:
        placements = "" if row.valid is None else str(row.placements)
        table.add_row(row.name, placements, row.verdict, row.worst)
    valid = sum(bool(row.valid) or row.accepted for row in rows)
    notes = [f"note: {row.name}: {note}\n" for row in rows for note in row.notes]
    return lay_out([table], terminal_width) + "".join(notes) + f"{valid} of {len(rows)} valid\n"
