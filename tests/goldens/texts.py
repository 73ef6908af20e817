"""The contents of the golden files: pictures, figures and exports as text, by name.

No text depends on fonts, on layouts computed by matplotlib, or on the formatting of floats.
"""

import json
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import asdict, replace
from fractions import Fraction
from hashlib import sha256
from importlib import import_module
from itertools import chain
from pathlib import Path
from pkgutil import walk_packages
from typing import Any
from unittest.mock import patch

from command import EXAMPLE
from matplotlib.axes import Axes
from matplotlib.colors import to_hex

from exactsweep import (
    InnerFit,
    NoFitPolygon,
    Region,
    Sweep,
    __version__,
    free_positions,
    inner_fit_polygon,
    no_fit_polygon,
    sweep,
)
from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.canvas.window import Window
from exactsweep.corpus import (
    FAMILIES,
    Case,
    case_to_json,
    find_case,
    find_layout_case,
    generate,
    generator,
)
from exactsweep.corpus.case_json import case_to_line
from exactsweep.corpus.describe import describe
from exactsweep.corpus.export import cases_to_geojson, cases_to_svg, cases_to_wkt
from exactsweep.corpus.generator.growing import bowls, bumps, ceilings, forks, needles, rim, wide
from exactsweep.draw import (
    Picture,
    Scale,
    draw_chains,
    draw_sub_trajectories,
    make_figure,
    plot_positions,
    plot_sweep,
)
from exactsweep.draw.intervals import cut_trajectory
from exactsweep.layout import Layout, judge_layout
from exactsweep.layout.report import draw_layout, rank_faults
from exactsweep.numbers.number import Vertex
from exactsweep.paper import checks, figures, report
from exactsweep.paper.claim import Effort, Evidence, Finding, gather, reproduce
from exactsweep.paper.costs import COSTS
from exactsweep.paper.data import as_json
from exactsweep.paper.figures.drawing import draw_figure
from exactsweep.paper.figures.figure import load
from exactsweep.paper.growth import BOUNDS, Growth, Size
from exactsweep.paper.kernel import find_convex_parts, trajectory_cc, trajectory_cm
from exactsweep.paper.ledger import CLAIMS, find
from exactsweep.paper.pairs import LARGE, draw_pairs
from exactsweep.procedures.chain import split
from exactsweep.view.data import gather_page_data, gather_positions

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
PAIRS = json.loads(Path(__file__).with_name("pairs.json").read_text(encoding="utf-8"))


def read_pair(pair: list[Any]) -> list[Any]:
    """Two shapes, each a list of vertices, or an exterior with holes."""
    return [Region(**shape) if isinstance(shape, dict) else shape for shape in pair]


SWEEPS = {
    "example": EXAMPLE,
    **{name: sweep(*read_pair(pair)) for name, pair in PAIRS["sweeps"].items()},
    "far": sweep(EXAMPLE.generatrix, EXAMPLE.directrix, reference=(10**40, 3 * 10**40)),
}
POSITIONS: dict[str, NoFitPolygon | InnerFit] = {
    name: answer(*read_pair(pair))
    for asked, answer in (("no fit", no_fit_polygon), ("inner fit", inner_fit_polygon))
    for name, pair in PAIRS[asked].items()
}
POSITIONS["placed"] = free_positions(
    [(0, 0), (9, 0), (9, 5), (0, 5)], [[(3, 2), (5, 2), (4, 3)], [(6, 4), (8, 4), (7, 5)]], SQUARE
)
CASES = [
    *("fits-square", "worked-roof", "caves-open-thirds", "holes-hole-at-the-rim"),
    "spelling-clockwise-both",
    *("holes-as-large", "containers-too-low", "gen-fractions-3-1"),
]
SIZES = ("vertices", "edges", "holes", "undercuts")
"""The units of growth that depend on the pairs alone."""
E9 = 10**9
BOXES: list[tuple[Vertex, Vertex]] = [
    *(((0, 0), (8, 5)), ((-3, 2), (-1, 50)), ((0, 0), (12, 1)), ((0, 0), (13, 1))),
    *(((0, 0), (1, 13)), ((E9, E9), (E9 + 7, E9 + 3)), ((-E9 - 9, 5), (-E9, 6))),
    *(((0, 0), (Fraction(1, 300), Fraction(1, 700))), ((5, 5), (5, 5)), ((0, 7), (9, 7))),
    *(((123_456, 1), (123_500, 2)), ((1000, 0), (1001, 1)), ((1001, 0), (1002, 1))),
    *(((0, 0), (Fraction(1, 9), Fraction(1, 999))), ((123_456_789_012, 0), (123_456_789_013, 1))),
    *(((0, 0), (10**4, 10**3)), ((0, 0), (9999, 10)), ((Fraction(1, 3), 0), (E9, 10**12))),
]
VALUES = Fraction, tuple, list, Region
FIGURES = ("minkowski", "lower_bound", "local_width", "chains", "contact_motion")


def write_number(value: float) -> str:
    """A number in a picture with nine digits, without a negative zero."""
    return f"{value + 0.0:.9g}"


def write_points(points: Any) -> str:
    """Points of a picture."""
    return " ".join(",".join(write_number(float(c)) for c in point) for point in points)


def list_artists(axes: Axes) -> Iterator[str]:
    """Describe the artists of an Axes, one per line."""
    labels = axes.get_title(), axes.get_title(loc="right"), axes.get_xlabel(), axes.get_ylabel()
    yield f"axes {' | '.join(labels)}, aspect {axes.get_aspect()}"
    for line in axes.lines:
        marks = line.get_marker(), line.get_markersize(), line.get_markerfacecolor()
        yield f"line {line.get_label()}, {line.get_color()}, {line.get_linewidth()}, {marks}"
        yield f"  {line.get_zorder()}: {write_points(line.get_xydata())}"
    for area in axes.patches:
        colors = (to_hex(c, True) for c in (area.get_facecolor(), area.get_edgecolor()))
        yield f"area {area.get_label()}, {', '.join(colors)}, {area.get_hatch()}"
        yield f"  {area.get_zorder()}: {write_points(area.get_path().vertices)}"
    for text in axes.texts:
        place: Any = getattr(text, "xyann", None)
        yield f"text {text.get_text()!r} at {write_points([getattr(text, 'xy', (0, 0))])}"
        how = text.get_horizontalalignment(), text.get_fontsize()
        yield f"  {place and write_points([place])}, {how}"
    if legend := axes.get_legend():
        yield f"legend {[text.get_text() for text in legend.get_texts()]}"
    for child in axes.child_axes:
        if isinstance(child, Axes):
            yield f"detail {write_points([child.get_xlim(), child.get_ylim()])}"
            yield from list_artists(child)


def write_places(s: Sweep, columns: int) -> str:
    """The positions of a picture, alone or among others, and of its legend."""
    axes = plot_sweep(s, make_figure(columns=columns).axes[0])
    legend: Any = axes.get_legend()
    corner = legend.get_bbox_to_anchor().transformed(axes.transAxes.inverted()).p0
    return f"placed {write_points([*axes.get_position(original=True).get_points(), corner])}"


def list_looks() -> Iterator[str]:
    """All looks and colors of the style."""
    for name, value in vars(style).items():
        looks = value if isinstance(value, dict) else {"": value}
        if name.isupper() and not name.startswith("_"):
            shown = {k: asdict(v) if isinstance(v, Look) else v for k, v in looks.items()}
            yield f"{name} {shown}"
    yield from (f"chain {k} {asdict(style.choose_chain_look(k))}" for k in range(8))


def list_pictures() -> Iterator[str]:
    """List the contents of pictures of sweeps and of no-fit polygons."""
    for name, s in SWEEPS.items():
        yield f"== {name}"
        yield from list_artists(plot_sweep(s, make_figure().axes[0]))
        yield from (_write(interval) for interval in cut_trajectory(s))
        yield from (write_places(s, columns) for columns in (1, 2))
    for name, found in POSITIONS.items():
        yield f"== {name}"
        yield from list_artists(plot_positions(found, make_figure().axes[0]))
    valley: list[Vertex] = [(0, 0), (3, 3), (5, 0), (8, 2)]
    parts = find_convex_parts(valley)
    top = split(EXAMPLE.generatrix.vertices)[1]
    chains = [trajectory_cc(top, part) for part in parts]
    picture = Picture(make_figure().axes[0], Scale.of(valley, *chains))
    draw_chains(picture, {f"D_{k}": part for k, part in enumerate(parts, 1)})
    draw_sub_trajectories(picture, chains, list(trajectory_cm(top, valley)))
    picture.text(valley[1], "reflex")
    picture.legend()
    yield "== chains"
    yield from list_artists(picture.axes)


def list_images() -> Iterator[str]:
    """Images and tables of notebooks."""
    yield EXAMPLE.directrix._repr_html_()
    for name, s in SWEEPS.items():
        yield f"== {name}\n{s._repr_html_()}"
    for name, found in POSITIONS.items():
        yield f"== {name}\n{found._repr_html_()}"


def list_layouts() -> Iterator[str]:
    """Pictures of layouts, without their style sheet."""
    moves = [(3 * k, 0) for k in range(5)] + [(3 * k + Fraction(k + 1, k + 2), 0) for k in range(5)]
    overlaps = {
        "container": {"exterior": [(0, 0), (14, 0), (14, 2), (0, 2)]},
        "parts": [{"id": "", "exterior": SQUARE}],
        "placements": [{"part": "", "turn": 0, "move": move} for move in moves],
    }
    faulty = (find_layout_case(f"layouts-{name}") for name in ("all-at-once", "defect-overlapped"))
    for layout in (*(case.layout for case in faulty), Layout.from_json(overlaps)):
        judgement = judge_layout(layout)
        for y_down in (False, True):
            picture = draw_layout(judgement, rank_faults(judgement), "faults", y_down=y_down)
            head, _, rest = picture.partition("<style>")
            yield f"{head}{rest.partition('</style>')[2].rstrip()}"


def list_pages() -> Iterator[str]:
    """The data of pages."""
    found = {name: gather_page_data(s) for name, s in SWEEPS.items()}
    found |= {name: gather_positions(f) for name, f in POSITIONS.items() if name != "none"}
    yield from (f"{name} {json.dumps(data)}" for name, data in found.items())


def list_figures() -> Iterator[str]:
    """The figures of the paper: what they state and show."""
    for claim in CLAIMS:
        if claim.figure:
            figure = load(claim.figure)
            yield f"== {claim.name}"
            yield from (f"{name}: {value}" for name, value in figure.facts)
            yield from (f"law {name}: {_write(value)}" for name, value, _ in figure.laws)
            yield from (f"{name} = {_write(shape)}" for name, shape in figure.list_shapes().items())
            yield from (f"{name} = {list(words)}" for name, words in figure.words.items())
    for name in FIGURES:
        made = draw_figure(name, load(name))
        yield f"== {name} {write_points([made.get_size_inches()])}"
        for axes in made.axes:
            yield write_points(axes.get_position().get_points())
            yield from list_artists(axes)
        yield f"{[text.get_text() for text in made.texts]}"


def _write(value: Any) -> str:
    """Write nested points on one line, sets in order, and a bound as its value."""
    if callable(value):
        return f"{value(24, 40):.6g}"
    if isinstance(value, set | frozenset):
        value = sorted(value)
    if isinstance(value, tuple | list | Iterator):
        return f"({' '.join(map(_write, value))})"
    return str(value)


def list_exports() -> Iterator[str]:
    """Cases of the corpus in the formats of other programs, and described."""
    beyond = Case.of("beyond", "Beyond doubles", [(0, 0), (10**309, 0), (0, 1)], SQUARE)
    shown = [*map(find_case, CASES), beyond]
    yield from cases_to_wkt(shown)
    yield from cases_to_geojson(shown)
    yield from cases_to_svg(shown)
    yield from (describe(name) for name in (*CASES, "huge", "fits", "convex", "combs"))


def list_growing() -> Iterator[str]:
    """The pairs of the growing families at two sizes, and pairs that the ledger draws."""
    for make in (*LARGE["CC"], *LARGE["CM"], *LARGE["MM"], needles, ceilings, wide, bowls, rim):
        for sizes in ((14, 16), (20, 12)):
            yield f"{make.__name__} {sizes} {make(*sizes)}"
    for kind, how in (
        ("CM", ""),
        ("MM", "weak"),
        ("CM", "large"),
        ("MM", "far"),
        ("CM", "resting"),
    ):
        yield f"{kind} {how} {_write(draw_pairs(Effort(1), kind, 2, how))}"
    yield f"SS {_write(draw_pairs(Effort(1), 'SS', 2))}"
    yield from (f"forks {forks(m, n)}" for m, n in ((18, 18), (18, 24)))
    yield from (f"bumps {bumps(*sizes)}" for sizes in ((2, 4, 6), (4, 6, 4)))


def list_generated() -> Iterator[str]:
    """The digests and flags of generated cases, family by family, and three of them in full.

    Cases must never change, because ids keep their meaning. The flags show whether a family has its
    intended properties.
    """
    parts = "id", "directrix", "generatrix", "reference", "directrix_holes", "generatrix_holes"
    for family in FAMILIES:
        drawn = list(generate(family, 7, 12))
        for start, end in ((0, 3), (3, 9)):
            shown = map(case_to_json, drawn[start:end])
            found = [[case[part] for part in parts if part in case] for case in shown]
            yield f"{family} {start} {end} {sha256(repr(found).encode()).hexdigest()[:12]}"
        counts = Counter(
            chain.from_iterable((case.kind, *case.flags, *case.representable) for case in drawn)
        )
        yield f"{family} of 12: {', '.join(f'{flag} {counts[flag]}' for flag in sorted(counts))}"
    for id in ("gen-convex-7-0", "gen-container-7-1", "gen-plate-7-2"):
        yield case_to_line(find_case(id)).rstrip()


def list_scales() -> Iterator[str]:
    """Scales and windows of small, large, distant, flat and tall boxes."""
    for low, high in BOXES:
        scale, window = Scale.of([low, high]), Window.around([low, high], 130, 90, 7)
        labels = scale.x.label("x"), scale.y.label("y")
        yield f"{low} {high}: {_write(scale)}, {labels}, {window.is_true}, {window.longest}"
        yield f"  {scale.place(high)}, {_write(window)}: {window.place(low)}, {window.place(high)}"


def list_report() -> Iterator[str]:
    """A report of some rows without times and machine; the costs; a drawn counterexample."""
    names = ("Definition 1.1", "Lemma 5.3", "Trajectory_CC", "Slope")
    rows = [row._replace(seconds=1.25) for row in reproduce(map(find, names), Effort(quick=True))]
    points = tuple(Size(8 << k, 16, 100 << 2 * k, 8 << k) for k in range(3))
    counts = [Growth(f"{unit} of P", "ints", "m", points) for unit in ("operations", "bytes")]
    claim = replace(find("Corollary 3.4"), name="Corollary 0")
    rows.append(Finding(claim, gather([Evidence("Counts."), *counts]), 0.5))
    nowhere = {"exactsweep": "0", "seed": 1, "quick": True, "packages": {"sympy": "1"}}
    nowhere |= dict.fromkeys(("commit", "python", "system", "processor", "date"), "any")
    with patch.object(report, "describe_environment", lambda effort: nowhere):
        text = report.render("report.md", rows, Effort(quick=True), {}, {})
        html = report.render("report.html", rows, Effort(quick=True), {}, {})
    for written in (text, html[html.index("<body") :]):
        yield written.replace(f"version = {{{__version__}}}", "version")
    yield report.count_verdicts(rows)
    for cost in COSTS:
        called = cost.row, cost.procedure, cost.bound[0], cost.family.__name__, cost.varied
        limits = cost.timed, cost.fixed, cost.limit, cost.slack, cost.sizes(cost.first, 2)
        yield f"{called} {limits} {cost.bound[1](24, 40):.6g}"


def list_examples() -> Iterator[str]:
    """The bounds and examples of the ledger, and the options of the generator, each once."""
    yield from (f"bound {name} {bound(24, 40):.6g}" for name, bound in BOUNDS.values())
    seen = set()
    for room in (generator, checks, figures):
        for module in sorted(m.name for m in walk_packages(room.__path__, f"{room.__name__}.")):
            for name, value in sorted(vars(import_module(module)).items()):
                if name.isupper() and isinstance(value, VALUES) and id(value) not in seen:
                    seen.add(id(value))
                    yield f"{module}.{name} {_write(value)}"


def show_row(row: Finding) -> dict[str, Any]:
    """Return the findings of a row of the ledger without counts of operations and times."""
    (found,) = as_json([row], Effort(seed=2, quick=True))["claims"]
    shown = {name: value for name, value in found.items() if name not in ("seconds", "code")}
    for name in ("words", "correction", "proof", "kernel", "chosen"):
        shown[name] = bool(shown[name])
    shown["growth"] = [g for g in shown["growth"] if g["what"].split()[0] in SIZES]
    shown["tables"] = [t for t in shown["tables"] if "Exponents" not in t["caption"]]
    if {"counted", "measured"} & {*row.claim.evidence}:
        del shown["tried"]
        for case in shown["counterexamples"]:
            del case["text"]
    plain: dict[str, Any] = json.loads(json.dumps(shown))
    return plain


def list_rows() -> Iterator[str]:
    """The findings of a quick run of the ledger."""
    for row in reproduce(CLAIMS, Effort(seed=2, quick=True)):
        yield json.dumps({row.claim.name: show_row(row)}, ensure_ascii=False)


TEXTS: dict[str, Callable[[], Iterator[str]]] = {
    "looks": list_looks,
    "pictures": list_pictures,
    "images": list_images,
    "layouts": list_layouts,
    "pages": list_pages,
    "figures": list_figures,
    "exports": list_exports,
    "generated": list_generated,
    "examples": list_examples,
    "growing": list_growing,
    "report": list_report,
    "scales": list_scales,
}
"""The texts that `test_goldens.py` regenerates; `tests/paper/test_paper.py` compares the rows."""
