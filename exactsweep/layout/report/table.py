"""A judged layout as text, with facts and a table of its faults, or as JSON."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any

from exactsweep.formats.exact_json import write_json
from exactsweep.layout.fault import Fault
from exactsweep.layout.judge import Judgement
from exactsweep.layout.report.worst import WorstFirst, rank_faults
from exactsweep.numbers.digits import abridge, format_fraction
from exactsweep.numbers.number import Point
from exactsweep.text.report import approximate, lay_out, list_facts, make_table, take_root
from exactsweep.text.results import write_object
from exactsweep.words import count, spell_out

_MOST_LISTED = 30


def report_layout(
    judgement: Judgement,
    ranked: Sequence[WorstFirst] | None = None,
    terminal_width: int | None = None,
    *,
    notes: Iterable[str] = (),
    everything: bool = False,
) -> str:
    """Describe a judged layout: its faults, the worst first, or the least distance of parts.

    Args:
        judgement: a Judgement.
        ranked: its faults as `rank_faults` sorts them, if the caller has them.
        terminal_width: the width of the terminal in columns; None for plain text.
        notes: further remarks.
        everything: whether to list all faults.

    Returns:
        Lines of text.

    Cost: that of `rank_faults` and of `Judgement.distance`.

    Example:
        >>> from exactsweep.layout import Layout, judge_layout
        >>> tile = {"id": "tile", "exterior": [[0, 0], [1, 0], [1, 1], [0, 1]]}
        >>> layout = Layout.from_json({
        ...     "container": {"exterior": [[0, 0], [2, 0], [2, 1], [0, 1]]},
        ...     "parts": [tile],
        ...     "placements": [{"part": "tile", "turn": 0, "move": [x, 0]} for x in (0, "0.9")],
        ... })
        >>> print(report_layout(judge_layout(layout)), end="")
        verdict     not valid: 1 overlap
        placements  2 of 1 part
        density     1
        contacts    0
        <BLANKLINE>
        fault    where    how bad   witness      repaired by
        overlap  0 and 1  0.1 deep  (0.95, 0.5)  moving 1 by (0.1, 0)
    """
    ranked = rank_faults(judgement) if ranked is None else ranked
    layout = judgement.layout
    facts = {
        "verdict": write_verdict(judgement),
        "placements": f"{len(layout.placements)} of {count(len(layout.parts), 'part')}",
        "density": _about(approximate(judgement.density), abridge(judgement.density)),
        "contacts": str(len(judgement.contacts)),
    }
    if layout.greatest_error:
        facts["curves"] = tell_error(layout.greatest_error)
    nearest = judgement.distance
    if nearest is not None and not (judgement.faults or judgement.contacts):
        first, second = nearest.placements
        root = approximate(take_root(nearest.square))
        facts["nearest"] = f"placements {first} and {second}, {root} apart"
    tables = [list_facts(facts, max(map(len, facts)))]
    if ranked:
        listed = make_table(("fault", "where", "how bad", "witness", "repaired by"))
        for one in ranked if everything else ranked[:_MOST_LISTED]:
            listed.add_row(one.fault.kind, *tell_fault(one))
        tables.append(listed)
    text = lay_out(tables, terminal_width)
    if len(ranked) > _MOST_LISTED and not everything:
        text += f"... {len(ranked) - _MOST_LISTED} more (--all)\n"
    return text + "".join(f"note: {note}\n" for note in notes)


def tell_error(error: Fraction) -> str:
    """Say how near lines are to curves, and what the verdict is about."""
    return f"judged as curves; drawn as lines within {approximate(error, up=True)} of them"


def write_verdict(judgement: Judgement) -> str:
    """Write that a layout is valid, or count its faults of each kind."""
    kinds = Counter(fault.kind for fault in judgement.faults)
    if not kinds:
        return "valid"
    plain = {"overlap", "turn", "shape"}
    said = [
        count(number, kind) if kind in plain else f"{number} {kind}"
        for kind, number in kinds.items()
    ]
    if set(kinds) == {"undecided"}:
        return ", ".join(said)
    return f"not valid: {', '.join(said)}"


def tell_fault(one: WorstFirst) -> tuple[str, str, str, str]:
    """Describe a fault: the place, the measure, the witness and the repair, in rounded numbers."""
    fault = one.fault
    bad, repair = fault.reason, ""
    if fault.distance_squared is not None:
        bad = f"{approximate(take_root(fault.distance_squared))} apart"
    elif one.square is not None and fault.move is not None:
        bad = f"{approximate(take_root(one.square))} deep"
        repair = f"moving {fault.placements[-1]} by {_write_about(fault.move)}"
    elif fault.kind == "outside":
        bad = "fits nowhere as it is turned"
    elif fault.number:
        bad = count(fault.number, "placement")
    places, bad = spell_out(_name_places(fault)), spell_out(bad)
    return places, bad, " ".join(map(_write_about, fault.points)), repair


def _name_places(fault: Fault) -> str:
    placed = " and ".join(map(str, fault.placements))
    if fault.part is not None and len(fault.placements) != 1:
        return f"part {fault.part}"
    return f"{placed} (part {fault.part})" if fault.part is not None else placed


def write_layout_json(judgement: Judgement, notes: Iterable[str] = ()) -> str:
    """Write a judgement as JSON: the verdict, faults, contacts, density and the nearest pair.

    Args:
        judgement: a Judgement.
        notes: further remarks.

    Returns:
        One object. Placements have ints as numbers; all other numbers are strings that
        `to_fraction` reads.

    Cost: that of `rank_faults` and of `Judgement.distance`.
    """
    nearest = judgement.distance
    data: dict[str, Any] = {
        "valid": judgement.valid,
        "faults": [one.fault.to_json() for one in rank_faults(judgement)],
        "contacts": [list(pair) for pair in judgement.contacts],
        "density": judgement.density,
        "distance_squared": None if nearest is None else format_fraction(nearest.square),
        "nearest": None if nearest is None else list(nearest.placements),
        "notes": list(notes),
    }
    error = judgement.layout.greatest_error
    data |= {"error": error} if error else {}
    return write_object({name: write_json(value) for name, value in data.items()})


def _write_about(point: Point) -> str:
    return f"({', '.join(map(approximate, point))})"


def _about(rounded: str, exact: str) -> str:
    return exact if rounded == exact else f"{rounded}, exactly {exact}"
