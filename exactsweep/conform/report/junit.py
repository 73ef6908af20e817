"""A run as JUnit XML, which CI systems show."""

from __future__ import annotations

import re
from xml.etree import ElementTree

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.report.text import witness_lines
from exactsweep.conform.run.outcome import Outcome, witnesses
from exactsweep.conform.run.run import Run, fails

_ERRORS = (Verdict.TIMEOUT, Verdict.CRASH)
# What XML 1.0 cannot hold, not even as a reference.
_NOT_XML = re.compile("[^\t\n\r -\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def junit(run: Run) -> str:
    """Write a run as JUnit XML: a test case each, the class of its pair as the class name.

    Timeouts and crashes are errors, other verdicts that are not accepted are failures, and
    unsupported cases are skipped.

    Args:
        run: a Run.

    Returns:
        The document, with its XML declaration.

    Cost: linear.
    """
    summary = run.summary
    errors = sum(summary.total(v) for v in _ERRORS if fails(v, run.accepted))
    counts = {
        "name": run.hello.name,
        "tests": str(summary.total()),
        "failures": str(summary.failures(run.accepted) - errors),
        "errors": str(errors),
        "skipped": str(summary.total(Verdict.UNSUPPORTED)),
        "time": f"{summary.seconds:.3f}",
    }
    suites = ElementTree.Element("testsuites")
    suite = ElementTree.SubElement(suites, "testsuite", _clean(counts))
    for outcome in run.outcomes:
        _test_case(suite, outcome, run.accepted)
    said = [*run.complaints, *(["interrupted"] if run.interrupted else [])]
    if said:
        ElementTree.SubElement(suite, "system-err").text = _text("\n".join(said))
    ElementTree.indent(suites)
    written: str = ElementTree.tostring(suites, encoding="unicode")
    return f'<?xml version="1.0" encoding="UTF-8"?>\n{written}\n'


def _test_case(suite: ElementTree.Element, outcome: Outcome, accepted: Verdict) -> None:
    names = {"classname": outcome.kind, "name": outcome.id, "time": f"{outcome.seconds:.6f}"}
    case = ElementTree.SubElement(suite, "testcase", _clean(names))
    if outcome.verdict is Verdict.UNSUPPORTED:
        ElementTree.SubElement(case, "skipped", _clean({"message": outcome.reason}))
    elif fails(outcome.verdict, accepted):
        tag = "error" if outcome.verdict in _ERRORS else "failure"
        said = {"type": outcome.verdict.value, "message": outcome.reason}
        ElementTree.SubElement(case, tag, _clean(said)).text = _text("\n".join(_lines(outcome)))
        if outcome.stderr:
            ElementTree.SubElement(case, "system-err").text = _text(outcome.stderr)


def _lines(outcome: Outcome) -> list[str]:
    lines = [f"{outcome.verdict}: {outcome.reason}"]
    for part in outcome.parts:
        for witness in witnesses(part):
            lines += (f"{part['name']}: {line}" for line in witness_lines(witness))
    return lines


def _clean(attributes: dict[str, str]) -> dict[str, str]:
    return {name: _text(value) for name, value in attributes.items()}


def _text(text: str) -> str:
    return _NOT_XML.sub("\N{REPLACEMENT CHARACTER}", text)
