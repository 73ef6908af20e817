"""Judging of layouts from files: rows of a table, or one judgement with its notes."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TYPE_CHECKING, NamedTuple

from exactsweep.cli.layout_curves import judge_finely
from exactsweep.formats import show_path
from exactsweep.words import spell_out

if TYPE_CHECKING:
    from exactsweep.formats.layouts import FoundLayout
    from exactsweep.layout import Judgement


class LayoutRow(NamedTuple):
    """A row of the table of several layouts.

    For an unreadable file, `verdict` is the error and `valid` is None. `worst` is the depth of the
    worst fault, or the minimum distance in a valid layout. `unchecked` lists unjudged rules.
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
    """Return the notes of the reader, and conventions that would explain the faults."""
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
    """Judge the layouts in a file; an unreadable file gets a row as well."""
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
    from exactsweep.layout.report.table import list_measures, tell_fault
    from exactsweep.text.report import approximate, take_root

    context = ReportContext(found.unchecked, found.places, found.unit, accept)
    ranked = rank_faults(judgement, accepted=accept)
    facts = list_measures(judgement, ranked, context)
    worst, nearest = "", judgement.distance
    if ranked:
        worst = tell_fault(judgement, ranked[0], context, repaired=False)[1]
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
    """Format a table with one layout per line, and the number of valid layouts."""
    from exactsweep.text.report import lay_out, make_table

    table = make_table(("layout", "placements", "verdict", "worst or nearest"), {"placements"})
    for row in rows:
        placements = "" if row.valid is None else str(row.placements)
        table.add_row(row.name, placements, row.verdict, row.worst)
    valid = sum(bool(row.valid) or row.accepted for row in rows)
    notes = [f"note: {row.name}: {note}\n" for row in rows for note in row.notes]
    return lay_out([table], terminal_width) + "".join(notes) + f"{valid} of {len(rows)} valid\n"
