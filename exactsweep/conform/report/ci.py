"""Annotations and a badge of a run, for continuous integration."""

from __future__ import annotations

import json
from itertools import chain, islice

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.report.text import tell_witness
from exactsweep.conform.run.outcome import Outcome, list_witnesses
from exactsweep.conform.run.peer import replace_controls
from exactsweep.conform.run.run import Run
from exactsweep.conform.run.tally import fails

MOST_ANNOTATIONS = 10
"""GitHub shows no more for a step."""
_EXACT = (Verdict.EXACT, Verdict.EQUIVALENT, Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS)


def write_badge(run: Run) -> str:
    """Write a badge such as "1184 of 1197 exact", as JSON for a badge endpoint."""
    summary = run.summary
    message = f"{sum(map(summary.total, _EXACT))} of {summary.judged} exact"
    if within := summary.total(Verdict.WITHIN):
        message += f", {within} within rounding"
    color = "brightgreen" if run.passed else "red"
    badge = {"schemaVersion": 1, "label": "exactsweep", "message": message, "color": color}
    return json.dumps(badge) + "\n"


def write_annotations(run: Run) -> str:
    """Write a GitHub Actions annotation for the smallest case of each fault, the worst first.

    Objections come last; there are at most MOST_ANNOTATIONS lines.
    """
    lines = [
        _annotate(f"{one.id} {one.verdict}", one, fault.count - 1)
        for fault in run.list_faults()
        for one in fault.kept[:1]
        if fails(one.verdict, run.accepted)
    ]
    objections = (_write_command(run.hello.name, words) for words in run.find_objections())
    return "".join([*lines, *objections][:MOST_ANNOTATIONS])


def _annotate(title: str, outcome: Outcome, others: int) -> str:
    witnesses = chain.from_iterable(map(list_witnesses, outcome.parts))
    shown = islice(chain.from_iterable(map(tell_witness, witnesses)), 2)
    more = [f"and {others} more like it"] if others else []
    return _write_command(title, "\n".join([outcome.reason, *shown, *more]))


def _write_command(title: str, words: str) -> str:
    return f"::error title={_escape(title, ',:')}::{_escape(words)}\n"


def _escape(text: str, more: str = "") -> str:
    text = replace_controls(text)
    return "".join(f"%{ord(c):02X}" if c in f"%\r\n{more}" else c for c in text)
