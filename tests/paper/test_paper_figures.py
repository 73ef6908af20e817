"""The figures of the paper: what they state, and how they are drawn."""

from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import cache, partial
from itertools import combinations
from pathlib import Path
from xml.etree import ElementTree

import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text
from mutations import MUTATIONS, mutated
from tiers import examples

from exactsweep import Point
from exactsweep.cli import main
from exactsweep.corpus.generator.prng import Prng
from exactsweep.draw import save
from exactsweep.paper import kernel, report
from exactsweep.paper.claim import Effort, reproduce
from exactsweep.paper.figures import procedures
from exactsweep.paper.figures.drawing import Extent, draw_figure, lay_out
from exactsweep.paper.figures.figure import PaperFigure, load
from exactsweep.paper.ledger import CLAIMS, find
from exactsweep.paper.pairs import draw_pair
from exactsweep.paper.report import write_figures

IDS = [f"Figure {number}" for number in range(1, 14)]
OURS = "Undercuts under ceilings"
POINTS_IN_174_MM = 174 / 25.4 * 72
each_figure = pytest.mark.parametrize("name", [*IDS, OURS])


@cache
def figure(name: str) -> PaperFigure:
    return load(find(name).figure)


@cache
def picture(name: str) -> Figure:
    return draw_figure(find(name).figure, figure(name))


def facts(number: int) -> dict[str, str]:
    return {name: str(value) for name, value in figure(f"Figure {number}").facts}


def written(made: Figure) -> list[Text]:
    texts = [*made.texts, *(text for axes in made.axes for text in axes.texts)]
    return [text for text in texts if text.get_text()]


def drawn(made: Figure) -> FigureCanvasAgg:
    canvas = FigureCanvasAgg(made)
    canvas.draw()  # type: ignore[no-untyped-call]
    return canvas


def test_all_thirteen_are_rows_of_the_ledger() -> None:
    assert [claim.name for claim in CLAIMS if claim.figure and claim.name != OURS] == IDS


@each_figure
def test_statements_of_figures_hold(name: str) -> None:
    assert list(figure(name).find_failures()) == []
    assert all(str(value) for _, value in figure(name).facts)


def test_a_broken_law_and_a_position_of_overlap_are_failures() -> None:
    right = figure("Figure 7")
    s, _ = right.sweeps[0]
    wrong = right._replace(
        laws=[("edges", 15, 16)], sweeps=[(s, [Point(Fraction(6), Fraction(6))])]
    )
    assert list(wrong.find_failures()) == [
        "at (6, 6) the verdict on G is OVERLAP, not CONTACT",
        "edges: 15, not 16",
    ]


def calls_made() -> set[tuple[str, str]]:
    """The calls that the kernel makes for pairs of each class."""
    names = {function.__code__: name for name, (function, _) in procedures.KERNEL.items()}
    found: set[tuple[str, str]] = set()
    for kind in ("CC", "CM", "MM"):
        for number in range(20):
            top, bottom, directrix = draw_pair(Prng(str(number)), kind).chains
            calls: list[Callable[[], object]] = [partial(kernel.sweep_mm, top, bottom, directrix)]
            if kind != "MM":
                calls.append(partial(kernel.sweep_inner_cm, top, directrix))
                calls.append(partial(kernel.sweep_outer_cm, top, bottom, directrix))
            if kind == "CC":
                calls.append(partial(kernel.trajectory_cc, top, directrix))
                calls.append(partial(kernel.sweep_outer_cc, top, bottom, directrix))
            found |= procedures.watch_calls(names, *calls)
    return found


def test_figure_11_shows_exactly_the_calls_made() -> None:
    assert calls_made() == set(procedures.MADE)
    assert procedures.watch_kernel() == set(procedures.MADE)


@each_figure
def test_labels_are_readable_and_do_not_overlap(name: str) -> None:
    canvas = drawn(picture(name))
    texts = written(picture(name))
    assert all(float(text.get_fontsize()) >= 7 for text in texts)
    boxes = [text.get_window_extent(canvas.get_renderer()) for text in texts]  # type: ignore[no-untyped-call]
    for (one, first), (other, second) in combinations(zip(boxes, texts, strict=True), 2):
        assert not one.overlaps(other), (first.get_text(), second.get_text())


@each_figure
def test_a_figure_fits_the_page_with_one_unit_on_both_axes(name: str) -> None:
    canvas = drawn(picture(name))
    box = picture(name).get_tightbbox(canvas.get_renderer())  # type: ignore[no-untyped-call]
    assert 0 < box.width * 72 + 14.4 <= POINTS_IN_174_MM + 1e-6
    assert len({round(unit, 6) for unit in units(picture(name))}) == 1


def units(made: Figure) -> Iterator[float]:
    """The points of a unit along both axes of each panel."""
    wide, high = (size * 72 for size in made.get_size_inches())
    for axes in made.axes:
        (x0, x1), (y0, y1) = axes.get_xlim(), axes.get_ylim()
        place = axes.get_position()
        assert -1e-9 <= place.x0 < place.x1 <= 1 + 1e-9
        assert -1e-9 <= place.y0 < place.y1 <= 1 + 1e-9
        yield from (place.width * wide / (x1 - x0), place.height * high / (y1 - y0))


@each_figure
@pytest.mark.long
def test_the_same_figure_gives_the_same_bytes(name: str, tmp_path: Path) -> None:
    for stem in ("one", "two"):
        for suffix in ("svg", "pdf"):
            save(draw_figure(find(name).figure, figure(name)), str(tmp_path / f"{stem}.{suffix}"))
    svg, pdf = ((tmp_path / f"one.{suffix}").read_bytes() for suffix in ("svg", "pdf"))
    assert (svg, pdf) == ((tmp_path / "two.svg").read_bytes(), (tmp_path / "two.pdf").read_bytes())
    assert ElementTree.fromstring(svg).tag.endswith("svg")
    assert pdf.startswith(b"%PDF")
    assert b"<image" not in svg


@examples(25)
@given(st.lists(st.tuples(st.integers(1, 40), st.integers(1, 40)), min_size=1, max_size=4))
def test_panels_of_any_size_share_one_unit(sizes: list[tuple[int, int]]) -> None:
    boxes = [Extent((0, 0), size, "title") for size in sizes]
    made, pictures = lay_out([boxes[:2], boxes[2:]] if len(boxes) > 2 else [boxes], 3.1)
    assert [axes.get_xlim()[1] for axes in made.axes] == [x for x, _ in sizes]
    assert [picture.axes for picture in pictures] == made.axes
    assert len({round(unit, 6) for unit in units(made)}) == 1


def test_one_figure_alone_is_reported_and_drawn(tmp_path: Path) -> None:
    result = CliRunner().invoke(main, ["reproduce", "Figure 7", "--out", str(tmp_path)])
    assert result.exit_code == 0
    assert "| (b) the sub-trajectories meet in a | segment |" in result.output
    assert sorted(path.name for path in tmp_path.iterdir()) == [
        *("counterexamples", "figure-7.pdf", "figure-7.svg", "ledger.json"),
        *("report.html", "report.md", "tables"),
    ]
    assert b"<text" not in (tmp_path / "figure-7.svg").read_bytes()
    assert b"/FontFile2" in (tmp_path / "figure-7.pdf").read_bytes()
    assert "![Figure 7](figure-7.svg)" in (tmp_path / "report.md").read_text(encoding="utf-8")
    html = (tmp_path / "report.html").read_text(encoding="utf-8")
    assert '<img class="figure" alt="Figure 7" src="data:image/svg+xml;base64,' in html


def test_without_matplotlib_figures_are_checked_and_not_drawn(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(report, "find_spec", lambda name: None)
    rows = list(reproduce([find("Figure 2")], Effort()))
    assert rows[0].disagreement == ""
    assert write_figures(tmp_path, rows) == {}


@pytest.mark.parametrize("name", ["Figure 4", "Figure 6"])
def test_a_figure_with_a_fault_fails_and_is_not_drawn(name: str, tmp_path: Path) -> None:
    with mutated(MUTATIONS[0]):
        rows = list(reproduce([find(name)], Effort()))
        assert rows[0].disagreement
        assert write_figures(tmp_path, rows) == {}
