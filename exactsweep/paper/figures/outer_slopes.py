"""Figure 5: the outer boundary of a CC sweep in order of slope."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.numbers.point import Point, Rational, Vertex
from exactsweep.paper.figures.figure import Facts, differ, loops_differ
from exactsweep.paper.figures.sheet import (
    SMALL,
    SMALL_DOT,
    TRAJECTORY,
    WIDE,
    Extent,
    Margins,
    Sheet,
    find_middle,
    shift,
)
from exactsweep.paper.figures.slopes import (
    Move,
    find_stations,
    lay,
    list_edges,
    sort_by_slope,
    sweep_example,
    write_slope,
)
from exactsweep.procedures.cc import sweep_outer_cc
from exactsweep.procedures.chain import split

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LOOKS = {
    "D_b": Look(style.GREY, 3.2, order=5),
    "G_t": Look(style.BLUE, 1.6, order=5),
    "G_b": Look(style.RED, 2.2, dash=(0, (3, 1)), order=5),
}


def _turn() -> int:
    """The number of the vertex of the trajectory between whose edges most edges of G_b fall."""
    path = sort_by_slope("D_b", "G_t")
    return max(range(1, len(path)), key=lambda k: len(_take_between(path[k - 1], path[k])))


def _take_between(before: Move, after: Move) -> list[Move]:
    return [m for m in list_edges()["G_b"] if before.slope < m.slope < after.slope]


def _outer() -> list[Vertex]:
    """The outer boundary by Lemma 3.2."""
    s = sweep_example()
    (g_bottom, g_top), (d_bottom, _) = (split(p.vertices) for p in (s.generatrix, s.directrix))
    start = shift([d_bottom[0]], (g_bottom[0][0] - g_top[0][0], g_bottom[0][1] - g_top[0][1]))[0]
    return lay(start, sort_by_slope("D_b", "G_t", "G_b"))


def list_facts() -> Facts:
    """List the figure's statements."""
    path, k = sort_by_slope("D_b", "G_t"), _turn()
    before, after = path[k - 1], path[k]
    return [
        ("edges of D_b, G_t, G_b", ", ".join(str(len(moves)) for moves in list_edges().values())),
        ("edges of the outer boundary", str(len(_outer()) - 1)),
        ("slopes of t_i and t_(i+1)", f"{before.slope}, {after.slope}"),
        (
            "slopes of G_b between them",
            ", ".join(str(m.slope) for m in _take_between(before, after)),
        ),
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    s = sweep_example()
    yield from loops_differ(s)
    (g_bottom, g_top), (d_bottom, _) = (split(p.vertices) for p in (s.generatrix, s.directrix))
    yield differ("outer boundary", sweep_outer_cc(g_top, g_bottom, d_bottom), _outer())
    yield differ("edges", len(_outer()) - 1, sum(map(len, list_edges().values())))


def _apart(moves: Sequence[Move]) -> list[list[Vertex]]:
    """The edges side by side, with gaps, each about the height 0."""
    found: list[list[Vertex]] = []
    x: Rational = 0
    for dx, dy in (move.by for move in moves):
        found.append([(x, -Fraction(dy) / 2), (x + dx, Fraction(dy) / 2)])
        x += dx + Fraction(3, 2)
    return found


def draw() -> Figure:
    """The picture."""
    s, k = sweep_example(), _turn()
    path = [Point(Fraction(x), Fraction(y)) for x, y in find_stations()]
    outer, order = _outer(), sort_by_slope("D_b", "G_t", "G_b")
    apart = _apart(order)
    boxes = [
        Extent.around(s.directrix.vertices, outer, path, title="(a)", margins=Margins(2, 4, 2, 4)),
        Extent.around(*apart, title="(b)", margins=Margins(8, 24, 8, 14)),
    ]
    with Sheet([[box] for box in boxes], WIDE) as sheet:
        panel, row = sheet.panels
        panel.area(s.directrix.vertices, style.DIRECTRIX)
        panel.generatrix(s, [path[k]])
        panel.line(path, TRAJECTORY)
        for edge, piece, move in zip(pairwise(outer), apart, order, strict=True):
            panel.line(edge, LOOKS[move.owner])
            row.line(piece, LOOKS[move.owner])
            lowest = find_middle(*piece)[0], min(y for _, y in piece)
            row.label(
                lowest, f"{write_slope(move.slope)}\n${move.owner}$", 0, -4, va="top", size=SMALL
            )
        panel.dots(path[1:-1], SMALL_DOT)
        panel.label((6, 3), "$D$")
        panel.label(path[k], "$G$", -36, -9)
        for number, name in ((k - 1, "$t_i$"), (k, "$t_{i+1}$")):
            panel.label(find_middle(path[number], path[number + 1]), name, -1, -9)
            piece = apart[order.index(sort_by_slope("D_b", "G_t")[number])]
            highest = find_middle(*piece)[0], max(y for _, y in piece)
            row.label(highest, name, 0, 8)
    return sheet.figure
