"""Figure 10: sweeps whose outer boundary has a number of edges of order m n^2."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.corpus.generator.growing import bumps, edges_of_bumps, printed_count
from exactsweep.draw import place_generatrix
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Edge
from exactsweep.paper.figures.figure import Facts, differ, loops_differ
from exactsweep.paper.figures.sheet import (
    OUTER,
    PAGE,
    PLACED,
    SMALL,
    SMALL_DOT,
    THIN,
    BarePicture,
    Extent,
    Margins,
    Sheet,
    find_middle,
)
from exactsweep.paper.functions import take_bottom
from exactsweep.procedures.chain import split
from exactsweep.procedures.lower_sweep import LowerSweep
from exactsweep.sweep import Sweep, sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Two peaks above a round tip of four edges between steep flanks, in units of 1/4 and 1/20.
PEAKS = [(80, 0), (60, 80), (40, 0), (20, 80), (0, 0)]
TIP = [(25, -120), (33, -135), (40, -142), (47, -135), (55, -120)]
SIZES = ((2, 4, 6), (4, 4, 6), (4, 6, 8), (6, 6, 6), (6, 8, 8))


def sweep_example(teeth: int) -> Sweep:
    """The pair of the paper's sizes (2 teeth, 4, 6), flatter and with a wider tip than `bumps`."""
    bottom = [(40 * k, -120 if k % 2 else 0) for k in range(2 * teeth + 1)]
    rings = PEAKS + TIP, [*bottom, (40 * teeth, 60)]
    g, d = ([(Fraction(x, 4), Fraction(y, 20)) for x, y in ring] for ring in rings)
    return sweep(g, d)


def count_sizes(s: Sweep) -> tuple[int, int, int]:
    """m_b, n_t and n_b, counted."""
    g_bottom, g_top = split(s.generatrix.vertices)
    return len(split(s.directrix.vertices)[0]) - 1, len(g_top) - 1, len(g_bottom) - 1


def list_outer_edges(s: Sweep) -> list[Edge]:
    """The edges of the outer boundary of the lower sweep."""
    return list(pairwise(take_bottom(s.outer.vertices)))


def measure() -> tuple[tuple[tuple[int, int, int], int], ...]:
    """Sizes in the family of `bumps`, and the edges of its outer boundary."""
    return tuple((size, len(list_outer_edges(sweep(*bumps(*size))))) for size in SIZES)


def list_facts() -> Facts:
    """List the figure's statements."""
    rows = [
        (f"({letter}) (m_b, n_t, n_b): edges", f"{count_sizes(s)}: {len(list_outer_edges(s))}")
        for letter, s in (("a", sweep_example(1)), ("b", sweep_example(2)))
    ]
    return [
        *rows,
        *(
            (f"family, {size}: edges, formula of the paper", f"{edges}, {printed_count(*size)}")
            for size, edges in measure()
        ),
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    for s in (sweep_example(1), sweep_example(2)):
        yield from loops_differ(s)
        yield differ(
            f"edges for {count_sizes(s)}", len(list_outer_edges(s)), edges_of_bumps(*count_sizes(s))
        )
    yield differ("sizes", count_sizes(sweep_example(1)), (2, 4, 6))
    yield differ("edges", len(list_outer_edges(sweep_example(1))), printed_count(2, 4, 6))
    for size, edges in measure():
        g, d = (Polygon(ring) for ring in bumps(*size))
        (bottom, top), (directrix, _) = split(g.vertices), split(d.vertices)
        lower = LowerSweep("MM", top, bottom, directrix)
        yield differ(f"edges for {size}", edges, len(lower.outer) - 1)
        yield differ(f"edges for {size}", edges, edges_of_bumps(*size))


def draw() -> Figure:
    """The picture."""
    first, second = sweep_example(1), sweep_example(2)
    boxes = [[_box(first, "a"), Extent((0, 0), (18, 18), "(c)")], [_box(second, "b")]]
    with Sheet(boxes, PAGE) as sheet:
        a, table, b = sheet.panels
        for panel, s in ((a, first), (b, second)):
            _draw_pair(panel, s)
        _number(a, list_outer_edges(first))
        _draw_table(table)
    return sheet.figure


def _box(s: Sweep, letter: str) -> Extent:
    lower, title = take_bottom(s.outer.vertices), f"({letter}) {len(list_outer_edges(s))} edges"
    return Extent.around(s.directrix.vertices, lower, title=title, margins=Margins(4, 18, 4, 2))


def _draw_pair(panel: BarePicture, s: Sweep) -> None:
    """D, G where a peak of it is under a tooth, and the edges of the outer boundary."""
    place = min(s.trajectory.vertices, key=lambda p: (p.y, p.x))
    panel.area(s.directrix.vertices, style.DIRECTRIX)
    panel.area(place_generatrix(s, place).vertices, PLACED)
    panel.lines(list_outer_edges(s), replace(OUTER, order=5))
    panel.dots(take_bottom(s.outer.vertices), SMALL_DOT)
    panel.label((10, -2), "$D$")
    panel.label((place.x + 10, place.y), "$G$", 0, -12)


def _number(panel: BarePicture, edges: Sequence[Edge]) -> None:
    """Number edges below them, but above them where the chain turns right."""
    vectors = [(q[0] - p[0], q[1] - p[1]) for p, q in edges]
    right = [dx * ny < dy * nx for (dx, dy), (nx, ny) in pairwise(vectors)]
    for k, (edge, (dx, dy)) in enumerate(zip(edges, vectors, strict=True)):
        if any(right[max(k - 1, 0) : k + 1]):
            panel.label(find_middle(*edge), str(k + 1), -5 if dy > 0 else 5, 8, size=SMALL)
        else:
            shift = 7 * float(dy) / (float(dx) + abs(float(dy)))
            # Numbers of two digits on neighbouring short edges stand on two levels.
            low = -14 if k >= 9 and k % 2 and dx < 3 else -7
            panel.label(find_middle(*edge), str(k + 1), shift, low, size=SMALL)


def _draw_table(panel: BarePicture) -> None:
    """The counts of the family."""
    columns = [(3, "$(m_b, n_t, n_b)$"), (10, "formula"), (16, "edges")]
    for x, head in columns:
        panel.label((x, 16), head, size=SMALL)
    panel.line([(-1, Fraction(29, 2)), (19, Fraction(29, 2))], THIN)
    for row, (size, edges) in enumerate(measure(), 1):
        cells = str(size), str(printed_count(*size)), str(edges)
        for (x, _), cell in zip(columns, cells, strict=True):
            panel.label((x, 16 - Fraction(5, 2) * row), cell, 0, -3, size=SMALL)
