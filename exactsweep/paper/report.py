"""The report of a run, as one self-contained HTML file and as Markdown."""

import re
from base64 import b64encode
from collections import Counter
from collections.abc import Callable, Sequence
from functools import cache
from importlib.resources import files
from importlib.util import find_spec
from io import BytesIO
from itertools import cycle
from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader
from markupsafe import Markup, escape

from exactsweep import sweep
from exactsweep.canvas import style
from exactsweep.canvas.style import PALETTE
from exactsweep.canvas.svg import Shape, write_svg
from exactsweep.draw import save
from exactsweep.geometry.polygon import Polygon
from exactsweep.paper import read_toml
from exactsweep.paper.claim import ClaimVerdict, Counterexample, Effort, Finding
from exactsweep.paper.costs import tabulate
from exactsweep.paper.data import describe_environment, make_slug, write_data
from exactsweep.paper.figures.drawing import draw_figure
from exactsweep.paper.figures.figure import load
from exactsweep.paper.growth import LIMITS, Growth, write_power
from exactsweep.paper.ledger import ABSTRACT, KINDS, OPEN, WEIGHTS
from exactsweep.paper.pairs import SweepPair
from exactsweep.text.template import make_environment

MINUS = "\N{MINUS SIGN}"
GROWTH = ("what", "family", "m", "n", "divided by", "ratio", "exponent", "of the bound", "found")


def write(folder: Path, rows: Sequence[Finding], effort: Effort) -> tuple[Path, Path, Path]:
    """Write report.html, report.md with its pictures, and ledger.json; return the three paths."""
    folder.mkdir(parents=True, exist_ok=True)
    drawn = _plots(rows)
    for name, plot in drawn.items():
        (folder / f"{name_plot(name)}.svg").write_bytes(plot)
    figures = write_figures(folder, rows)
    paths = folder / "report.html", folder / "report.md"
    for path in paths:
        text = render(path.name, rows, effort, drawn, figures)
        path.write_text(text, encoding="utf-8", newline="\n")
    return *paths, write_data(folder, rows, effort)


def render(
    name: str,
    rows: Sequence[Finding],
    effort: Effort,
    drawn: dict[str, bytes],
    figures: dict[str, bytes],
) -> str:
    shown = [{key: b64encode(svg).decode() for key, svg in d.items()} for d in (drawn, figures)]
    template = _environment(html=name.endswith("html")).get_template(f"{name}.j2")
    text = template.render(
        rows=rows,
        plots=shown[0],
        figures=shown[1],
        effort=effort,
        environment=describe_environment(effort),
        bounds=tabulate(series for row in rows for series in row.evidence.growth),
    )
    return f"{text.rstrip()}\n"


def title_section(section: str) -> str:
    return f"Section {section}" if section[0].isdigit() else section


def count_verdicts(rows: Sequence[Finding]) -> str:
    verdicts = Counter(row.claim.verdict for row in rows)
    counts = ", ".join(f"{verdicts[v]} {v.value}" for v in ClaimVerdict if verdicts[v])
    failing = [row.claim.name for row in rows if row.disagreement]
    outcome = f"evidence fails: {', '.join(failing)}" if failing else "all supported"
    return f"{len(rows)} rows: {counts}; {outcome}; {sum(row.seconds for row in rows):.0f} s"


def render_row(row: Finding) -> str:
    template = _environment(html=False).from_string(
        '{% from "row.md.j2" import show %}{{ show(row, {}, {}) }}'
    )
    return f"{template.render(row=row).strip()}\n"


def _plots(rows: Sequence[Finding]) -> dict[str, bytes]:
    if not has_matplotlib():
        return {}
    counted = {
        row.claim.name: [g for g in row.evidence.growth if g.unit not in LIMITS] for row in rows
    }
    return {name: plot_ratios(growth) for name, growth in counted.items() if growth}


@cache
def _environment(*, html: bool) -> Environment:
    environment = make_environment(PackageLoader("exactsweep.paper"), html=html)
    filters: tuple[Callable[..., Any], ...] = (
        *(cell, cite, describe_power, draw_case, find_alignments, growth_row, make_slug, name_plot),
        *(set_formula, split_proof, title_section),
    )
    environment.filters |= {function.__name__: function for function in filters}
    environment.globals.update(GROWTH=GROWTH, LIMITS=LIMITS, VERDICTS=ClaimVerdict)
    environment.globals.update(ABSTRACT=ABSTRACT, OPEN=OPEN, WEIGHTS=WEIGHTS, KINDS=KINDS)
    environment.globals.update(read_bibtex=read_bibtex)
    return environment


def set_formula(text: str) -> Markup:
    """Convert formulas to HTML: subscripts, minus and inequality signs, and alpha.

    >>> print(set_formula("m_b < n_t, T(u) <= -G_P - 1"))
    m<sub>b</sub> &lt; n<sub>t</sub>, T(u) ≤ −G<sub>P</sub> − 1
    >>> print(set_formula("T_(i-1) >= -1, D_1, Trajectory_CC, non-convex"))
    T<sub>i−1</sub> ≥ −1, D<sub>1</sub>, Trajectory_CC, non-convex
    """  # noqa: RUF002
    # A minus sign precedes a digit, a single letter or a parenthesis; other signs are hyphens.
    sign = r"(?<![\w)])-(?=[\d(]|[A-Za-z](?:_|\b))|(?<=[\w)]) - (?=[\w(])"
    signed = re.sub(sign, lambda m: m[0].replace("-", MINUS), text)
    signed = signed.replace("<=", "≤").replace(">=", "≥")
    index = r"\b([A-Za-z])_(?:([A-Za-z0-9])\b|\(([a-z0-9+-]+)\))"
    html = re.sub(
        index,
        lambda m: f"{m[1]}<sub>{(m[2] or m[3]).replace('-', MINUS)}</sub>",
        str(escape(signed)),
    )
    return Markup(re.sub(r"\balpha\b", "&alpha;", html))


def cell(text: object) -> str:
    return str(text).replace("|", "\\|")


def split_proof(text: str) -> tuple[str, list[str]]:
    """Split a proof into its introduction and its numbered steps.

    >>> split_proof("Let x = 1. (1) Then x > 0, by f(2). (2) So x > -1.")
    ('Let x = 1.', ['Then x > 0, by f(2).', 'So x > -1.'])
    >>> split_proof("Obvious: see (1).")
    ('Obvious: see (1).', [])
    """
    steps: list[str] = []
    rest = text
    while (before := re.search(rf"(?:^|(?<=[.:;]) )\({len(steps) + 1}\) ", rest)) is not None:
        steps.append(rest[: before.start()])
        rest = rest[before.end() :]
    first, *others = [*steps, rest]
    return first, others


def find_alignments(rows: Sequence[Sequence[str]]) -> list[str]:
    """Return the HTML class of each column: "number" if all cells are numbers, else "text"."""
    return [
        "number" if all(re.fullmatch(r"-?[0-9.,/]+", cell) for cell in column) else "text"
        for column in zip(*rows, strict=True)
    ]


def growth_row(series: Growth) -> list[str]:
    ends = series.points[0], series.points[-1]
    ranges = [[str(p.m) for p in ends], [str(p.n) for p in ends], [f"{p.ratio:.3g}" for p in ends]]
    m, n, ratio = (" to ".join(dict.fromkeys(values)) for values in ranges)
    powers = map(
        write_power, (series.exponent(series.fitted_sizes), series.claimed(series.fitted_sizes))
    )
    return [series.what, series.family, m, n, series.bound, ratio, *powers, series.verdict]


def describe_power(sampled: int) -> str:
    """State the fault rate that a sample detects with probability 95%: 3 in n for n pairs.

    >>> describe_power(300)
    '300 pairs per law: a fault in 1 of 100 pairs would escape with probability below 5%.'
    >>> describe_power(3)
    '3 pairs per law, as examples.'
    """
    if sampled < 10:
        return f"{sampled} pairs per law, as examples." if sampled else ""
    return (
        f"{sampled:,} pairs per law: a fault in 1 of {max(1, sampled // 3):,} pairs would escape "
        "with probability below 5%."
    )


def name_plot(name: str) -> str:
    return f"growth-{make_slug(name)}"


def draw_case(case: Counterexample) -> Markup:
    # The SVG contains only numbers, so it needs no escaping.
    pair = SweepPair(list(case.generatrix), list(case.directrix))
    return Markup(pair_svg(pair) if case.generatrix else "")


def write_citation(folder: Path) -> list[Path]:
    folder.mkdir(parents=True, exist_ok=True)
    paths = []
    for name in ("CITATION.cff", "references.bib"):
        text = files("exactsweep.paper").joinpath(name).read_text(encoding="utf-8")
        paths.append(folder / name)
        paths[-1].write_text(text, encoding="utf-8")
    return paths


def cite(key: str) -> str:
    """Format an entry of references.bib on one line.

    >>> cite("oks2006minkowski")
    'Oks and Sharir 2006, Minkowski sums of monotone and general simple polygons, \
doi:10.1007/s00454-005-1206-y'
    """
    (entry,) = re.findall(rf"@\w+{{{key},\n(.*?)\n}}\n", read_bibtex(), re.S)
    fields = dict(re.findall(r"^  (\w+) *= \{(.*)\},?$", entry, re.M))
    names = [author.partition(",")[0] for author in fields["author"].split(" and ")]
    who = " and ".join(names) if len(names) < 3 else f"{names[0]} et al."
    title = re.sub(r"[{}\\]", "", fields["title"]).replace("--", "-")
    where = f"doi:{fields['doi']}" if "doi" in fields else fields["note"]
    return f"{who} {fields['year']}, {title}, {where}"


def read_bibtex() -> str:
    return files("exactsweep.paper").joinpath("references.bib").read_text(encoding="utf-8")


def pair_svg(pair: SweepPair) -> str:
    """Draw D, the trajectory, and G at one of its vertices as SVG, with a caption."""
    g, d = map(Polygon, pair)
    path = sweep(g, d).trajectory
    shapes = (
        Shape([d.vertices], style.DIRECTRIX),
        Shape([g.translated(path.vertices[0]).vertices], style.GENERATRIX),
        Shape([path.vertices], style.TRAJECTORY),
    )
    picture = write_svg(shapes, "D in gray, G in blue, and the path T of G's origin in black")
    colors = [shape.look.color for shape in shapes]
    template = _environment(html=True).get_template("pair.svg.j2")
    return template.render(picture=Markup(picture), colors=colors)


def write_figures(folder: Path, rows: Sequence[Finding]) -> dict[str, bytes]:
    """Write the figures without failures as SVG and PDF; return the SVG by row name."""
    if not has_matplotlib():
        return {}
    from matplotlib import rc_context

    drawn = {}
    for row in rows:
        if row.claim.figure and not row.disagreement:
            name, stem = row.claim.figure, make_slug(row.claim.name)
            picture = draw_figure(name, load(name))
            save(picture, str(folder / f"{stem}.pdf"))
            # Draw letters as outlines, so that the SVG needs no font.
            with style.use_style(), rc_context({"svg.fonttype": "path"}):
                svg = folder / f"{stem}.svg"
                picture.savefig(svg, metadata={"Date": None}, bbox_inches="tight")
            drawn[row.claim.name] = svg.read_bytes()
    return drawn


STYLES = tuple(
    (color, marker, dash)
    for dash in ("-", "--")
    for color, marker in zip(PALETTE, "os^Dv<>", strict=True)
)
SETTINGS = read_toml("plots.toml")


def has_matplotlib() -> bool:
    return find_spec("matplotlib") is not None


def plot_ratios(growth: Sequence[Growth]) -> bytes:
    """Plot the ratio of count and bound over size, one line per series, as SVG."""
    from matplotlib.figure import Figure
    from matplotlib.style import context
    from matplotlib.ticker import NullFormatter, NullLocator

    with context(SETTINGS):
        figure = Figure(figsize=(4.6, 2.2 + 0.16 * len(growth)), layout="constrained")
        axes = figure.subplots()
        for series, (color, marker, dash) in zip(growth, cycle(STYLES), strict=False):
            axes.plot(
                [max(point.m, point.n) for point in series.points],
                [point.ratio for point in series.points],
                color=color,
                marker=marker,
                linestyle=dash,
                label=f"{series.what}, {series.family}, {series.varied}, / ({series.bound})",
            )
        sizes = sorted({max(point.m, point.n) for series in growth for point in series.points})
        axes.set_xscale("log")
        axes.set_xticks(sizes, [str(size) for size in sizes])
        axes.xaxis.set_minor_locator(NullLocator())
        axes.xaxis.set_minor_formatter(NullFormatter())
        axes.set_ylim(0, 1.1 * max(p.ratio for series in growth for p in series.points))
        axes.set_xlabel("the greater of m and n")
        axes.set_ylabel("count / bound")
        figure.legend(loc="outside lower left", frameon=False)
        out = BytesIO()
        figure.savefig(out, format="svg", metadata={"Date": None})
    return out.getvalue()
