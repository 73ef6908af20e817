"""A run as one HTML page that needs nothing else."""

from __future__ import annotations

import json
from collections.abc import Mapping
from fractions import Fraction
from importlib.resources import files
from typing import Any, NamedTuple

from exactsweep import __version__
from exactsweep.conform.outcome import Outcome, witnesses
from exactsweep.conform.picture import SIDE, Panel, panels, root
from exactsweep.conform.run import SHOWN, Run
from exactsweep.conform.summary import fails
from exactsweep.conform.told import witness_lines
from exactsweep.conform.verdict import Verdict
from exactsweep.draw import style
from exactsweep.number import to_fraction
from exactsweep.report import approximation

_MOST_LISTED = 2000
_KEY = (
    ("directrix", "D"),
    ("generatrix", "G, at the witness if it is a position"),
    ("exact", "exact"),
    ("theirs", "theirs"),
)


class Failure(NamedTuple):
    """One failure as the page shows it."""

    outcome: Outcome
    title: str
    panels: list[Panel]
    parts: list[dict[str, Any]]
    case: str
    result: str
    smaller: Failure | None


def html(run: Run) -> str:
    """Write a run as an HTML page, pictures and all within it.

    Args:
        run: a Run.

    Returns:
        The page. What the implementation said is in it as text, never as markup.

    Cost: linear; pictures are made of those failures that the run keeps whole.
    """
    from jinja2 import Environment, StrictUndefined

    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=True, lstrip_blocks=True
    )
    template = files("exactsweep.conform").joinpath("report.html.j2").read_text(encoding="utf-8")
    failed = [outcome for outcome in run.outcomes if fails(outcome.verdict, run.accepted)]
    summary = run.summary
    return environment.from_string(template).render(
        run=run,
        summary=summary,
        version=__version__,
        style=style,
        side=SIDE,
        bad={verdict for verdict in Verdict if fails(verdict, run.accepted)},
        key=_KEY,
        most_shown=SHOWN,
        worst={
            name: [
                (_about(root(worst.distance_squared[0])), worst.distance_squared[1]),
                (_about(worst.area[0]), worst.area[1]),
            ]
            for name, worst in summary.worst.items()
        },
        judged=summary.total() - summary.total(Verdict.UNSUPPORTED),
        failed=failed[:_MOST_LISTED],
        more=len(failed[_MOST_LISTED:]),
        failures=[_failure(outcome, run.shrunk.get(outcome.id)) for outcome in run.shown()],
    )


def _failure(outcome: Outcome, smaller: Outcome | None = None) -> Failure:
    case = outcome.case
    return Failure(
        outcome,
        case["title"] if case else "",
        panels(outcome) if case else [],
        [_part(part) for part in outcome.parts],
        json.dumps(case, indent=1) if case else "",
        json.dumps(outcome.result, indent=1) if outcome.result else "",
        _failure(smaller) if smaller else None,
    )


def _part(part: Mapping[str, Any]) -> dict[str, Any]:
    said = [line for witness in witnesses(part) for line in witness_lines(witness)]
    squares = part["distance_squared"]
    return {
        "name": part["name"].replace("_", " "),
        "verdict": part["verdict"],
        "reason": part["reason"],
        "distance": _about(root(to_fraction(squares[0]))) if squares else "",
        "permitted": _area(part["permitted"]),
        "forbidden": _area(part["forbidden"]),
        "said": said or [part["reason"]],
    }


def _area(text: str | None) -> str:
    return "" if text is None else _about(to_fraction(text))


def _about(value: Fraction) -> str:
    rounded = approximation(value)
    return rounded if to_fraction(rounded) == value else f"about {rounded}"
