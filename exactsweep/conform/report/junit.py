"""A run as JUnit XML, which CI systems show."""

from __future__ import annotations

from collections.abc import Mapping
from xml.etree import ElementTree

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.report.text import tell_witness
from exactsweep.conform.run.outcome import Outcome, list_witnesses
from exactsweep.conform.run.peer import replace_controls
from exactsweep.conform.run.run import Run
from exactsweep.conform.run.tally import fails

_ERRORS = (Verdict.TIMEOUT, Verdict.MEMORY, Verdict.CRASH)


def write_junit(run: Run) -> str:
    """Write a run as JUnit XML: a test case each, the class of its pair as the class name.

    Crashes, timeouts and too much memory are errors, other verdicts that are not accepted are
    failures, and cases that were not judged are skipped. Any other reason for which a run fails is
    a failing test case of its own, so that no run with exit code 1 is green. Properties give the
    number of cases judged, the diagnosis of the answers that differ, and for each case its fault,
    memory and rounding.

    Args:
        run: a Run.

    Returns:
        The document, with its XML declaration.

    Cost: linear.
    """
    summary, objections = run.summary, run.find_objections()
    errors = sum(summary.total(v) for v in _ERRORS if fails(v, run.accepted))
    counts = {
        "name": run.hello.name,
        "tests": str(summary.total() + len(objections)),
        "failures": str(summary.failures(run.accepted) - errors + len(objections)),
        "errors": str(errors),
        "skipped": str(summary.total() - summary.judged),
        "time": f"{summary.seconds:.3f}",
    }
    suites = ElementTree.Element("testsuites")
    suite = ElementTree.SubElement(suites, "testsuite", _clean(counts))
    _add_properties(suite, {"judged": str(summary.judged), "diagnosis": summary.diagnosis()})
    for outcome in run.list_outcomes():
        _add_case(suite, outcome, run.accepted)
    for objection in objections:
        names = {"classname": "run", "name": objection}
        case = ElementTree.SubElement(suite, "testcase", _clean(names))
        ElementTree.SubElement(case, "failure", _clean({"message": objection}))
    ElementTree.indent(suites)
    written: str = ElementTree.tostring(suites, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{written}\n'


def _add_properties(element: ElementTree.Element, named: Mapping[str, str | None]) -> None:
    known = {name: value for name, value in named.items() if value}
    if known:
        properties = ElementTree.SubElement(element, "properties")
        for name, value in known.items():
            ElementTree.SubElement(properties, "property", _clean({"name": name, "value": value}))


def _add_case(suite: ElementTree.Element, outcome: Outcome, accepted: Verdict) -> None:
    names = {"classname": outcome.kind, "name": outcome.id, "time": f"{outcome.seconds:.6f}"}
    case = ElementTree.SubElement(suite, "testcase", _clean(names))
    is_failure = fails(outcome.verdict, accepted)
    granted = ", ".join(
        f"{part['name']} {part['granted']}" for part in outcome.parts if part["granted"]
    )
    memory = "" if outcome.memory is None else str(outcome.memory)
    fault = outcome.fault if is_failure else ""
    _add_properties(case, {"fault": fault, "memory": memory, "rounding granted": granted})
    if not outcome.verdict.is_judgement:
        ElementTree.SubElement(case, "skipped", _clean({"message": outcome.reason}))
    elif is_failure:
        tag = "error" if outcome.verdict in _ERRORS else "failure"
        said = {"type": outcome.verdict.value, "message": outcome.reason}
        ElementTree.SubElement(case, tag, _clean(said)).text = replace_controls(
            "\n".join(_lines(outcome))
        )
        if outcome.stderr:
            ElementTree.SubElement(case, "system-err").text = replace_controls(outcome.stderr)


def _lines(outcome: Outcome) -> list[str]:
    lines = [f"{outcome.verdict}: {outcome.reason}"]
    for part in outcome.parts:
        lines += (f"{part['name']}: {words}" for words in part["diagnosis"])
        for witness in list_witnesses(part):
            lines += (f"{part['name']}: {line}" for line in tell_witness(witness))
    return lines


def _clean(attributes: dict[str, str]) -> dict[str, str]:
    return {name: replace_controls(value) for name, value in attributes.items()}
