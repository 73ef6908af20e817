"""The report of a run: one HTML file that needs no other, and Markdown."""

from __future__ import annotations

import platform
import re
from base64 import b64encode
from collections import Counter
from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined
from markupsafe import Markup, escape

from exactsweep import __version__
from exactsweep.paper import plots
from exactsweep.paper.cite import bibtex
from exactsweep.paper.claim import Counterexample, Row, Run, Status
from exactsweep.paper.figures.files import write_figures
from exactsweep.paper.pairs import Pair
from exactsweep.paper.picture import pair_svg


def write(folder: Path, rows: Sequence[Row], run: Run) -> tuple[Path, Path]:
    """Write report.html and report.md, and the pictures that the latter shows, into a folder.

    The same seed, effort and versions give the same bytes, but for the times.

    Returns:
        The paths of the two.

    Raises:
        OSError: the folder cannot be written to.
    """
    folder.mkdir(parents=True, exist_ok=True)
    drawn = _plots(rows)
    for name, svg in drawn.items():
        (folder / f"{_file_name(name)}.svg").write_bytes(svg)
    figures = write_figures(folder, rows)
    paths = folder / "report.html", folder / "report.md"
    for path in paths:
        text = render(path.name, rows, run, drawn, figures)
        path.write_text(text, encoding="utf-8", newline="\n")
    return paths


def render(
    name: str,
    rows: Sequence[Row],
    run: Run,
    drawn: dict[str, bytes],
    figures: dict[str, bytes],
) -> str:
    """Fill one of the templates, "report.html" or "report.md"."""
    sections: dict[str, list[Row]] = {}
    for row in rows:
        sections.setdefault(row.claim.section, []).append(row)
    statuses = Counter(row.claim.status for row in rows)
    text = (
        _environment(html=name.endswith("html"))
        .get_template(f"{name}.j2")
        .render(
            rows=rows,
            sections=sections,
            counts=[(status.value, statuses[status]) for status in Status],
            failing=[row for row in rows if row.disagreement],
            run=run,
            versions=_versions(),
            seconds=sum(row.seconds for row in rows),
            plots={name: b64encode(svg).decode() for name, svg in drawn.items()},
            figures={name: b64encode(svg).decode() for name, svg in figures.items()},
            bibtex=bibtex(),
        )
    )
    return f"{text.rstrip()}\n"


def render_row(row: Row) -> str:
    """One row in Markdown, as the terminal shows it."""
    template = _environment(html=False).from_string(
        '{% from "row.md.j2" import show %}{{ show(row, {}, {}) }}'
    )
    return f"{template.render(row=row).strip()}\n"


def _plots(rows: Sequence[Row]) -> dict[str, bytes]:
    if not plots.available():
        return {}
    return {r.claim.name: plots.ratios(r.evidence.growth) for r in rows if r.evidence.growth}


def _versions() -> dict[str, str]:
    return {"exactsweep": __version__, "Python": platform.python_version()}


@cache
def _environment(*, html: bool) -> Environment:
    environment = Environment(
        loader=PackageLoader("exactsweep.paper"),
        autoescape=html,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    filters: dict[str, Any] = {
        "alignments": alignments,
        "cell": lambda text: str(text).replace("|", "\\|"),
        "file_name": _file_name,
        "formula": formula,
        "number": lambda value: f"{value:.3f}",
        "picture": _picture,
        "slug": lambda text: re.sub(r"[^a-z0-9]+", "-", text.lower()).strip("-"),
    }
    environment.filters.update(filters)
    return environment


def formula(text: str) -> Markup:
    """Text as HTML, its indices and its Greek letter set as such.

    >>> print(formula("m_b < n_t"))
    m<sub>b</sub> &lt; n<sub>t</sub>
    >>> print(formula("T_(i-1), D_1, Trajectory_CC"))
    T<sub>i-1</sub>, D<sub>1</sub>, Trajectory_CC
    """
    index = r"\b([A-Za-z])_(?:([a-z0-9])\b|\(([a-z0-9+-]+)\))"
    html = re.sub(index, lambda m: f"{m[1]}<sub>{m[2] or m[3]}</sub>", str(escape(text)))
    return Markup(re.sub(r"\balpha\b", "&alpha;", html))


def alignments(rows: Sequence[Sequence[str]]) -> list[str]:
    """For each column of a table its class in HTML: "number" where nothing else is in it.

    >>> alignments([["edges", "12"], ["mn", "1,024"]])
    ['text', 'number']
    """
    return [
        "number" if all(re.fullmatch(r"-?[0-9.,/]+", cell) for cell in column) else "text"
        for column in zip(*rows, strict=True)
    ]


def _file_name(name: str) -> str:
    return "growth-" + re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def _picture(case: Counterexample) -> Markup:
    """The pair of a counterexample, drawn by `pair_svg`, which writes numbers only."""
    if not case.generatrix:
        return Markup("")
    return Markup(pair_svg(Pair(list(case.generatrix), list(case.directrix))))
