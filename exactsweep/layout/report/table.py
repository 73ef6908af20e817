"""A judged layout as a text report or as JSON."""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from exactsweep.formats.exact_json import write_json
from exactsweep.layout.fault import FaultKind
from exactsweep.layout.judge import Judgement
from exactsweep.layout.report.worst import (
    MAX_MEASURED,
    NO_CONTEXT,
    ReportContext,
    WorstFirst,
    rank_faults,
)
from exactsweep.numbers.digits import abridge, find_magnitude, format_fraction
from exactsweep.numbers.number import Point
from exactsweep.text.report import approximate, lay_out, list_facts, make_table, take_root
from exactsweep.text.results import write_object
from exactsweep.words import count, spell_out

_MAX_LISTED = 30


def report_layout(
    judgement: Judgement,
    ranked: Sequence[WorstFirst] | None = None,
    terminal_width: int | None = None,
    *,
    notes: Iterable[str] = (),
    everything: bool = False,
    context: ReportContext = NO_CONTEXT,
) -> str:
    """Describe a judged layout: its faults, the worst first, or the nearest parts.

    `ranked` has the faults as sorted by `rank_faults`, if known. Without a `terminal_width`, the
    text is plain. With `everything`, all faults are listed.

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
       fault    where              how bad   witness      repaired by
    1  overlap  0 tile and 1 tile  0.1 deep  (0.95, 0.5)  moving 1 by (0.1, 0)
    """
    ranked = rank_faults(judgement, accepted=context.accepted) if ranked is None else ranked
    facts = list_measures(judgement, ranked, context)
    tables = [list_facts(facts, max(map(len, facts)))]
    if ranked:
        listed = make_table(("", "fault", "where", "how bad", "witness", "repaired by"))
        for number, one in enumerate(ranked if everything else ranked[:_MAX_LISTED], 1):
            where, *rest = describe_fault(judgement, one, context, repaired=number <= MAX_MEASURED)
            listed.add_row(str(number), one.fault.kind, where, *rest)
        tables.append(listed)
    text = lay_out(tables, terminal_width)
    if len(ranked) > _MAX_LISTED and not everything:
        text += f"... {len(ranked) - _MAX_LISTED} more (--all)\n"
    return text + "".join(
        f"note: {note}\n" for note in [*notes, *find_remarks(judgement, ranked, context)]
    )


def list_measures(
    judgement: Judgement, ranked: Sequence[WorstFirst], context: ReportContext = NO_CONTEXT
) -> dict[str, str]:
    layout = judgement.layout
    facts = {
        "verdict": write_verdict(judgement, ranked, context),
        "placements": f"{len(layout.placements)} of {count(len(layout.parts), 'part')}",
    }
    if layout.container is None and judgement.box is not None:
        low, high = judgement.box
        width, height = high.x - low.x, high.y - low.y
        sides = f"{approximate(width)} x {context.add_unit(approximate(height))}"
        facts["container"] = "none: parts are only compared with each other"
        square, length = approximate(max(width, height)), approximate(width)
        facts["box"] = f"{sides}, in a square of {square}; used length {length}"
        if error := judgement.box_error:
            facts["box"] += f"; each side within {approximate(2 * error, up=True)}"
    if judgement.density is not None:
        rounded = approximate(judgement.density)
        exact = rounded if judgement.density_error else abridge(judgement.density)
        facts["density"] = exact if rounded == exact else f"{rounded}, exactly {exact}"
    facts["contacts"] = str(len(judgement.contacts))
    if error := layout.greatest_error:
        within = approximate(error, up=True)
        facts["curves"] = f"flattened to within {within}; the verdict holds for the true curves"
    nearest = judgement.distance
    if nearest is not None and not (judgement.faults or judgement.contacts):
        named = " and ".join(context.name_placement(judgement, k) for k in nearest.placements)
        root = context.add_unit(approximate(take_root(nearest.square)))
        facts["nearest"] = f"{named}, {root} apart"
    return facts


def write_verdict(
    judgement: Judgement,
    ranked: Sequence[WorstFirst] = (),
    context: ReportContext = NO_CONTEXT,
) -> str:
    """Describe the verdict; `ranked` is needed if some depth is accepted."""
    accepted = [one for one in ranked if one.accepted]
    kinds = Counter(fault.kind for fault in judgement.faults)
    kinds.subtract(one.fault.kind for one in accepted)
    unchecked = f", but not judged: {'; '.join(context.unchecked)}" if context.unchecked else ""
    depth = "" if context.accepted is None else approximate(context.accepted)
    if not judgement.faults:
        return f"valid{unchecked}"
    if len(accepted) == len(judgement.faults):
        return f"valid within {depth}: {sum_up(accepted, context)}: rounding{unchecked}"
    said = _count_kinds({kind: number for kind, number in kinds.items() if number})
    more = f"; {len(accepted)} more within {depth}" if accepted else ""
    undecided = all(one == "undecided" for one in kinds if kinds[one])
    return f"{'' if undecided else 'not valid: '}{said}{more}"


def _count_kinds(kinds: Mapping[FaultKind, int]) -> str:
    plain = {"overlap", "turn", "shape"}
    return ", ".join(
        count(number, kind) if kind in plain else f"{number} {kind}"
        for kind, number in kinds.items()
    )


def sum_up(ranked: Sequence[WorstFirst], context: ReportContext) -> str:
    said = _count_kinds(Counter(one.fault.kind for one in ranked))
    depths = [one.depth for one in ranked]
    deepest = context.add_unit(approximate(max(depths), up=True))
    word = "deep" if all(one.fault.distance_squared is None for one in ranked) else "off"
    if len(ranked) == 1:
        return f"{said}, {deepest} {word}"
    return f"{said}, all at most {deepest} {word}"


def find_remarks(
    judgement: Judgement, ranked: Sequence[WorstFirst], context: ReportContext
) -> list[str]:
    """Report whether all faults are tiny, and the rules that were not judged."""
    said = []
    is_rounding = all(one.is_rounding(judgement) for one in ranked)
    if ranked and is_rounding and context.accepted is None:
        accept = _round_up(max(one.depth for one in ranked))
        said.append(f"{sum_up(ranked, context)}: possibly rounding; --accept {accept} accepts this")
    if ranked and context.unchecked and not all(one.accepted for one in ranked):
        said.append(f"not judged: {'; '.join(context.unchecked)}")
    return said


def _round_up(value: Fraction) -> str:
    """Round a positive number up to one digit."""
    unit = Fraction(10) ** find_magnitude(value)
    return approximate(-(-value // unit) * unit)


def describe_fault(
    judgement: Judgement,
    one: WorstFirst,
    context: ReportContext = NO_CONTEXT,
    *,
    repaired: bool = True,
) -> tuple[str, str, str, str]:
    """Describe the placements, measure, witness and, if `repaired`, the repair of a fault."""
    fault = one.fault
    bad, repair = fault.reason, ""
    if fault.distance_squared is not None and fault.required is not None:
        found, required = take_root(fault.distance_squared), fault.required
        bad = f"{context.add_unit(approximate(found))} apart, {approximate(required)} required"
        bad += f", {approximate(one.depth)} short"
    elif one.square is not None:
        least = approximate(take_root(fault.least_depth_squared or one.square))
        depth = approximate(take_root(one.square))
        bad = "" if least == depth else f"{least} to "
        bad += f"{context.add_unit(depth)} deep"
    elif fault.number:
        bad = count(fault.number, "placement")
    if repaired and fault.move is not None:
        repair = f"moving {fault.placements[-1]} by {_write_about(fault.move)}"
    elif repaired and fault.kind == "outside" and one.square is None:
        bad = "no free position at this rotation"
    places = context.name_placements(judgement, fault)
    witness = " ".join(_write_about(point, judgement.box) for point in fault.points)
    return places, spell_out(bad), witness, repair


def write_layout_json(
    judgement: Judgement,
    notes: Iterable[str] = (),
    ranked: Sequence[WorstFirst] | None = None,
    context: ReportContext = NO_CONTEXT,
) -> str:
    """Format a judgement as JSON; arguments as for `report_layout`."""
    nearest = judgement.distance
    ranked = rank_faults(judgement, accepted=context.accepted) if ranked is None else ranked
    data: dict[str, Any] = {
        "valid": judgement.valid,
        "accepted": None if context.accepted is None else all(one.accepted for one in ranked),
        "unchecked": list(context.unchecked),
        "faults": [
            _list_fault(judgement, one, context, measured=k < MAX_MEASURED)
            for k, one in enumerate(ranked)
        ],
        "contacts": [list(pair) for pair in judgement.contacts],
        "density": judgement.density,
        **({"density_error": judgement.density_error} if judgement.density_error else {}),
        "container": "none" if judgement.layout.container is None else "given",
        **_measure_box(judgement),
        "unit": context.unit or None,
        "distance_squared": None if nearest is None else format_fraction(nearest.square),
        "nearest": None if nearest is None else list(nearest.placements),
        "notes": list(notes),
    }
    error = judgement.layout.greatest_error
    data |= {"error": error} if error else {}
    return write_object({name: write_json(value) for name, value in data.items()})


def _measure_box(judgement: Judgement) -> dict[str, Any]:
    if judgement.box is None:
        return {"box": None}
    low, high = judgement.box
    width, height = high.x - low.x, high.y - low.y
    found = {
        "box": [list(map(format_fraction, corner)) for corner in judgement.box],
        "square": max(width, height),
        "length": width,
    }
    return found | ({"box_error": judgement.box_error} if judgement.box_error else {})


def _list_fault(
    judgement: Judgement, one: WorstFirst, context: ReportContext, *, measured: bool
) -> dict[str, Any]:
    fault, placements = one.fault, judgement.layout.placements
    data = fault.to_json(measured=measured)
    data["parts"] = [placements[k].part for k in fault.placements]
    if context.places:
        data["places"] = [context.places[k] for k in fault.placements]
    if context.accepted is not None:
        data["accepted"] = one.accepted
    return data


def _write_about(point: Point, box: tuple[Point, Point] | None = None) -> str:
    """Round a point, with enough digits if the box is small and far from the origin."""
    size = max((b - a for a, b in zip(*box, strict=True)), default=0) if box else 0
    rounded = []
    for c in point:
        more = find_magnitude(abs(c)) - find_magnitude(Fraction(size)) if c and size else 0
        rounded.append(approximate(c, more=max(0, more)))
    return f"({', '.join(rounded)})"
