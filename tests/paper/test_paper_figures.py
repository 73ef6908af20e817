"""The figures of the paper: what they state, and how they are drawn."""

from collections.abc import Callable
from functools import partial
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

from exactsweep.cli import main
from exactsweep.corpus.generator.prng import Prng
from exactsweep.draw import save
from exactsweep.paper import plots
from exactsweep.paper.claim import Effort, reproduce
from exactsweep.paper.figures import procedures, sheet
from exactsweep.paper.figures.contact_motion import motion
from exactsweep.paper.figures.figure import PaperFigure, load
from exactsweep.paper.figures.local_width import measure_widths, narrow_widths
from exactsweep.paper.figures.undercuts import sweep_examples
from exactsweep.paper.ledger import CLAIMS, find
from exactsweep.paper.pairs import draw_pair
from exactsweep.paper.report import write_figures
from exactsweep.procedures import cc, cm, mm

IDS = [f"Figure {number}" for number in range(1, 14)]
OURS = "Undercuts under ceilings"
FIGURES = [load(find(name).figure) for name in [*IDS, OURS]]
POINTS_IN_174_MM = 174 / 25.4 * 72
each_figure = pytest.mark.parametrize("figure", FIGURES, ids=[*IDS, OURS])


def facts(number: int) -> dict[str, str]:
    return dict(FIGURES[number - 1].list_facts())


def words(figure: Figure) -> list[str]:
    return [text.get_text() for text in written(figure)]


def written(figure: Figure) -> list[Text]:
    texts = [*figure.texts, *(text for axes in figure.axes for text in axes.texts)]
    return [text for text in texts if text.get_text()]


def drawn(figure: Figure) -> FigureCanvasAgg:
    canvas = FigureCanvasAgg(figure)
    canvas.draw()  # type: ignore[no-untyped-call]
    return canvas


def test_all_thirteen_are_rows_of_the_ledger() -> None:
    assert [claim.name for claim in CLAIMS if claim.figure and claim.name != OURS] == IDS


@each_figure
def test_what_a_figure_states_is_borne_out(figure: PaperFigure) -> None:
    assert [failure for failure in figure.find_failures() if failure] == []
    assert all(value for _, value in figure.list_facts())


def test_figure_1_has_a_sweep_without_and_a_sum_with_overlap() -> None:
    found = facts(1)
    assert (found["class of the sweep"], found["undercuts"]) == ("MM", "2")
    assert found["positions in (b) at which G overlaps D"] == "4 of 4"


def test_figure_3_shows_that_g_travels_both_widths() -> None:
    assert facts(3)["horizontal distance from start to stop"] == "24"
    assert any(text.startswith("24 = width of") for text in words(FIGURES[2].draw()))


def test_figure_4_takes_an_edge_of_d_in_a_and_one_of_g_in_c() -> None:
    found = list(facts(4).values())
    assert found[0].endswith("D_b is next")
    assert found[2].endswith("G_t is next")


def test_figure_5_has_all_edges_in_order_of_slope() -> None:
    assert facts(5)["edges of D_b, G_t, G_b"] == "4, 3, 3"
    assert facts(5)["edges of the outer boundary"] == "10"
    assert facts(5)["slopes of G_b between them"] == "-1/2, -1/3"


def test_figure_6_has_two_convex_chains_and_one_undercut() -> None:
    assert facts(6)["convex chains of D_b"] == "2"
    assert facts(6)["undercuts"] == "1"


def test_figure_7_shows_one_undercut_of_each_kind() -> None:
    found = [[undercut.intersection for undercut in s.undercuts] for s in sweep_examples()]
    assert found == [["point"], ["segment"]]
    hollow = [
        sum(line.get_markerfacecolor() == "white" for line in axes.lines) and len(s.undercuts[0][4])
        for axes, s in zip(FIGURES[6].draw().axes, sweep_examples(), strict=True)
    ]
    assert hollow == [1, 2]


def test_figure_9_adds_up_on_one_side_only() -> None:
    near = narrow_widths()
    assert near.inner + near.outer < near.width
    found = measure_widths()
    assert found.inner > 0 < found.outer
    assert found.inner + found.outer == found.width
    texts = words(FIGURES[8].draw())
    assert {"$d' = 11/5$", "$d'' = 2$", "$d = 21/5$"} <= set(texts)


def test_figure_10_has_16_outer_edges() -> None:
    assert facts(10)["(a) (m_b, n_t, n_b): edges"] == "(2, 4, 6): 16"
    texts = words(FIGURES[9].draw())
    assert {"(a) 16 edges", "(b) 28 edges", *map(str, range(1, 17))} <= set(texts)
    assert "17" not in texts


def calls_made() -> set[tuple[str, str]]:
    """The calls that the kernel makes for pairs of each class."""
    words = {function.__code__: name for name, (function, _) in procedures.KERNEL.items()}
    found: set[tuple[str, str]] = set()
    for kind in ("CC", "CM", "MM"):
        for number in range(20):
            top, bottom, directrix = draw_pair(Prng(str(number)), kind).chains
            calls: list[Callable[[], object]] = [partial(mm.sweep_mm, top, bottom, directrix)]
            if kind != "MM":
                calls.append(partial(cm.sweep_inner_cm, top, directrix))
                calls.append(partial(cm.sweep_outer_cm, top, bottom, directrix))
            if kind == "CC":
                calls.append(partial(cc.sweep_outer_cc, top, bottom, directrix))
            for call in calls:
                found |= procedures.watch_calls(words, call)
    return {(one, other) for one, other in found if one != other}


def test_figure_11_has_all_calls_that_are_made_and_no_others() -> None:
    assert calls_made() == set(procedures.MADE)
    assert procedures.watch_kernel() == set(procedures.MADE)


def test_figure_12_has_no_vertex_event_beside_another() -> None:
    assert facts(12)["with a VE event and another one"] == "0"
    assert int(facts(12)["with several events"]) > 0


def test_figure_13_moves_to_the_right_only() -> None:
    path = motion()
    for ends in ([m.left.x for m in path], [m.right.x for m in path]):
        assert ends == sorted(ends)
    assert any(m.left.x < m.right.x for m in path)


@each_figure
def test_labels_are_readable_and_apart(figure: PaperFigure) -> None:
    picture = figure.draw()
    canvas = drawn(picture)
    texts = written(picture)
    assert all(float(text.get_fontsize()) >= 7 for text in texts)
    boxes = [text.get_window_extent(canvas.get_renderer()) for text in texts]  # type: ignore[no-untyped-call]
    for (one, first), (other, second) in combinations(zip(boxes, texts, strict=True), 2):
        assert not one.overlaps(other), (first.get_text(), second.get_text())


@each_figure
def test_a_figure_fits_the_page_with_one_unit_on_both_axes(figure: PaperFigure) -> None:
    picture = figure.draw()
    canvas = drawn(picture)
    wide, high = (size * 72 for size in picture.get_size_inches())
    box = picture.get_tightbbox(canvas.get_renderer())  # type: ignore[no-untyped-call]
    assert 0 < box.width * 72 + 14.4 <= POINTS_IN_174_MM + 1e-6
    units = set()
    for axes in picture.axes:
        (x0, x1), (y0, y1) = axes.get_xlim(), axes.get_ylim()
        place = axes.get_position()
        units |= {
            round(place.width * wide / (x1 - x0), 6),
            round(place.height * high / (y1 - y0), 6),
        }
    assert len(units) == 1


@each_figure
@pytest.mark.long
def test_the_same_figure_gives_the_same_bytes(figure: PaperFigure, tmp_path: Path) -> None:
    found = []
    for name in ("one", "two"):
        picture = figure.draw()
        paths = [tmp_path / f"{name}.svg", tmp_path / f"{name}.pdf"]
        for path in paths:
            save(picture, str(path))
        found.append([path.read_bytes() for path in paths])
    assert found[0] == found[1]
    svg, pdf = found[0]
    assert ElementTree.fromstring(svg).tag.endswith("svg")
    assert pdf.startswith(b"%PDF")
    assert b"<image" not in svg


@examples(25)
@given(st.lists(st.tuples(st.integers(1, 40), st.integers(1, 40)), min_size=1, max_size=4))
def test_panels_of_any_size_share_one_unit(sizes: list[tuple[int, int]]) -> None:
    boxes = [sheet.Extent((0, 0), size, "title") for size in sizes]
    rows = [boxes[:2], boxes[2:]] if len(boxes) > 2 else [boxes]
    with sheet.Sheet(rows, sheet.COLUMN) as made:
        pass
    wide, high = (float(size) * 72 for size in made.figure.get_size_inches())
    for axes, (x, y) in zip(made.figure.axes, sizes, strict=True):
        place = axes.get_position()
        assert place.width * wide == pytest.approx(x * made.unit)
        assert place.height * high == pytest.approx(y * made.unit)
        assert 0 <= place.x0 < place.x1 <= 1 + 1e-9
        assert 0 <= place.y0 < place.y1 <= 1 + 1e-9


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
    monkeypatch.setattr(plots, "find_spec", lambda name: None)
    rows = list(reproduce([find("Figure 2")], Effort()))
    assert rows[0].disagreement == ""
    assert write_figures(tmp_path, rows) == {}


@pytest.mark.parametrize("name", ["Figure 4", "Figure 6"])
def test_a_fault_turns_a_figure_red_and_it_is_not_drawn(name: str, tmp_path: Path) -> None:
    with mutated(MUTATIONS[0]):
        rows = list(reproduce([find(name)], Effort()))
        assert rows[0].disagreement
        assert write_figures(tmp_path, rows) == {}
