"""A run for continuous integration: JUnit XML, annotations and a badge."""

import json
from collections.abc import Mapping
from itertools import chain, islice
from xml.etree import ElementTree

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.report.text import describe_witness
from exactsweep.conform.run.outcome import Outcome, list_witnesses
from exactsweep.conform.run.peer import replace_controls
from exactsweep.conform.run.run import Run, fails

MAX_ANNOTATIONS = 10  # GitHub shows no more for a step
_EXACT = (Verdict.EXACT, Verdict.EQUIVALENT, Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS)
_ERRORS = (Verdict.TIMEOUT, Verdict.MEMORY, Verdict.CRASH)


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
    """Write GitHub Actions annotations: the smallest case of each fault, then objections."""
    lines = [
        _annotate(f"{one.id} {one.verdict}", one, fault.count - 1)
        for fault in run.list_faults()
        for one in fault.kept[:1]
        if fails(one.verdict, run.accepted)
    ]
    objections = (_write_command(run.hello.name, words) for words in run.find_objections())
    return "".join([*lines, *objections][:MAX_ANNOTATIONS])


def _annotate(title: str, outcome: Outcome, others: int) -> str:
    witnesses = chain.from_iterable(map(list_witnesses, outcome.parts))
    shown = islice(chain.from_iterable(map(describe_witness, witnesses)), 2)
    more = [f"and {others} more like it"] if others else []
    return _write_command(title, "\n".join([outcome.reason, *shown, *more]))


def _write_command(title: str, words: str) -> str:
    return f"::error title={_escape(title, ',:')}::{_escape(words)}\n"


def _escape(text: str, more: str = "") -> str:
    text = replace_controls(text)
    return "".join(f"%{ord(c):02X}" if c in f"%\r\n{more}" else c for c in text)


def write_junit(run: Run) -> str:
    """Write a run as JUnit XML; crashes, timeouts and memory limits are errors, not failures."""
    summary, objections = run.summary, run.find_objections()
    errors = sum(summary.total(v) for v in _ERRORS if fails(v, run.accepted))
    suites = ElementTree.Element("testsuites")
    suite = _add(
        suites,
        "testsuite",
        name=run.hello.name,
        tests=summary.total() + len(objections),
        failures=summary.failures(run.accepted) - errors + len(objections),
        errors=errors,
        skipped=summary.total() - summary.judged,
        time=f"{summary.seconds:.3f}",
    )
    _add_properties(suite, {"judged": summary.judged, "diagnosis": summary.diagnosis()})
    for outcome in run.list_outcomes():
        _add_case(suite, outcome, run.accepted)
    for objection in objections:
        case = _add(suite, "testcase", classname="run", name=objection)
        _add(case, "failure", message=objection)
    ElementTree.indent(suites)
    written: str = ElementTree.tostring(suites, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{written}\n'


def _add(
    parent: ElementTree.Element, tag: str, text: str = "", **attributes: object
) -> ElementTree.Element:
    # XML forbids control characters.
    clean = {name: replace_controls(str(value)) for name, value in attributes.items()}
    element = ElementTree.SubElement(parent, tag, clean)
    element.text = replace_controls(text) or None
    return element


def _add_properties(element: ElementTree.Element, named: Mapping[str, object]) -> None:
    known = {name: value for name, value in named.items() if value not in ("", None)}
    if known:
        properties = _add(element, "properties")
        for name, value in known.items():
            _add(properties, "property", name=name, value=value)


def _add_case(suite: ElementTree.Element, outcome: Outcome, accepted: Verdict) -> None:
    verdict, reason = outcome.verdict, outcome.reason
    seconds = f"{outcome.seconds:.6f}"
    case = _add(suite, "testcase", classname=outcome.kind, name=outcome.id, time=seconds)
    is_failure = fails(verdict, accepted)
    granted = [f"{part['name']} {part['granted']}" for part in outcome.parts if part["granted"]]
    fault = outcome.fault if is_failure else ""
    named = {"fault": fault, "memory": outcome.memory, "rounding granted": ", ".join(granted)}
    _add_properties(case, named)
    if not verdict.is_judgement:
        _add(case, "skipped", message=reason)
    elif is_failure:
        tag = "error" if verdict in _ERRORS else "failure"
        _add(case, tag, "\n".join(_lines(outcome)), type=verdict, message=reason)
        if outcome.stderr:
            _add(case, "system-err", outcome.stderr)


def _lines(outcome: Outcome) -> list[str]:
    lines = [f"{outcome.verdict}: {outcome.reason}"]
    for part in outcome.parts:
        said = [*part["diagnosis"], *chain(*map(describe_witness, list_witnesses(part)))]
        lines += (f"{part['name']}: {words}" for words in said)
    return lines
