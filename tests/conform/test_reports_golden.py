"""All reports of one run, verbatim; `python -m tests.goldens` rewrites them."""

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from pathlib import Path
from typing import Any

from judged import SLOT, SQUARE

from exactsweep import __version__
from exactsweep.cli.pair import DIRECTRIX, GENERATRIX
from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.report.ci import write_junit
from exactsweep.conform.report.html import write_html
from exactsweep.conform.report.text import close, describe, write_table
from exactsweep.conform.run.outcome import judge_case
from exactsweep.conform.run.peer import CallablePeer
from exactsweep.conform.run.protocol import Hello
from exactsweep.conform.run.run import Run
from exactsweep.corpus import Case

FILE = Path(__file__).parent / "reports.txt"
INTO: Any = (SLOT, SQUARE, (0, 0))
NOTCH: Any = (DIRECTRIX, GENERATRIX, ("1/2", 1))
# The common point of an overlap, which is arbitrary.
POINT = re.compile(r'(OVERLAP, point )\(.*?\)|("OVERLAP", "point": )\[.*?\]')


def list_answers() -> Iterator[tuple[str, Any, dict[str, Any]]]:
    """Yield the name of a case, its pair, and an answer."""
    for name, pair in (("slot", INTO), ("notch", NOTCH)):
        case = Case.of(name, "", *pair)
        loop = list(case.trajectory.vertices)
        fits, x = case.exact_fits, Fraction(1, 3)
        (px, py), *rest = loop
        turned = [(2 * case.reference.x - a, 2 * case.reference.y - b) for a, b in loop]
        yield f"{name}-exact", pair, {"trajectory": loop, "exact_fits": fits}
        yield f"{name}-reversed", pair, {"trajectory": loop[::-1], "exact_fits": fits}
        yield f"{name}-pushed", pair, {"trajectory": [(px - x, py - x), *rest]}
        yield f"{name}-pulled", pair, {"trajectory": [(px + x, py + x), *rest]}
        yield f"{name}-turned", pair, {"trajectory": turned}
        yield f"{name}-doubles", pair, {"trajectory": [(float(a) + 1e-15, b) for a, b in loop]}
        yield f"{name}-nan", pair, {"trajectory": [("nan", 0), *rest]}
        yield f"{name}-error", pair, {"error": f"no <row> {len(loop)}"}
        yield f"{name}-hard", pair, {"unsupported": "too hard"}
    yield "slot-inner", INTO, {"trajectory": SLOT, "inner": [(0, 0), (3, 0), (0, 5)]}


def make_run(accepted: Verdict) -> Run:
    """Judge the answers, with seconds and memory independent of the machine."""
    hello = Hello("mine & theirs", ("trajectory",))
    run = Run(hello, ["mine", "-v"], accepted, Fraction(9, 10))
    for k, (name, pair, answer) in enumerate(list_answers()):
        d, g, reference = pair
        flags = ["identical"] if k % 5 == 1 else []
        case = Case.of(name, f"the case {k}", d, g, reference, flags)
        peer = CallablePeer(lambda d, g, r, answer=answer: answer, hello)
        outcome = replace(
            judge_case(peer, case),
            seconds=(7 * k % 11) / 8,
            memory=k << 20 if k % 3 else None,
            stderr="\x1b Abort\n" * (k % 4 == 3),
        )
        run.add(outcome)
        if name == "slot-pushed":
            run.add_shrunk(name, replace(outcome, id=f"{name}-shrunk", seconds=0.5))
    return run


def list_parts() -> Iterator[str]:
    run = make_run(Verdict.EQUIVALENT)
    yield f"{write_table(run.summary)}\n{close(run)}"
    run.complaints, run.interrupted = ["exited with code 1 after bye"], True
    yield close(run)
    yield close(make_run(Verdict.WITHIN))
    yield "".join(
        describe(compare(Case.of(name, "", *pair), answer)) for name, pair, answer in list_answers()
    )
    yield "".join(f"{name}: {json.dumps(value)}\n" for name, value in run.to_json().items())
    yield write_junit(run)
    page = re.sub("<style>.*</style>\n", "", write_html(run), flags=re.S)
    yield re.sub("<pre>.*?</pre>", lambda found: " ".join(found[0].split()), page, flags=re.S)


def write_reports() -> str:
    text = "\n".join(list_parts()).replace(__version__, "VERSION")
    return POINT.sub(r"\1\2...", text)


def test_reports_are_golden() -> None:
    assert write_reports() == FILE.read_text(encoding="utf-8")
