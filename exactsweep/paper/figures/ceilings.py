"""A figure of ours: the undercuts between two needles of the family of ceilings."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.corpus.generator.growing import ceilings, undercuts_under_ceilings
from exactsweep.draw import draw_undercuts, place_generatrix
from exactsweep.evidence.undercut import Undercut
from exactsweep.numbers.point import Point
from exactsweep.paper.figures.figure import Facts, differ, loops_differ, overlaps
from exactsweep.paper.figures.sheet import INNER, PLACED, WIDE, Extent, Margins, Sheet
from exactsweep.sweep import Sweep, sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

M, N = 7, 8
CEILING = 8
# The first inner valley of G_t, which is at 9, holds the left needle, whose tip is the origin.
PLACE = Point(Fraction(-9), Fraction(0))


def sweep_example() -> Sweep:
    """The sweep of the least pair of the family."""
    return sweep(*ceilings(M, N))


def find_lower(s: Sweep) -> list[Undercut]:
    """The undercuts of the lower sweep, from left to right."""
    lower = [u for u in s.undercuts if u.bottom[0].x < u.bottom[-1].x]
    return sorted(lower, key=lambda undercut: undercut.bottom[0])


def _find_touched(s: Sweep) -> list[Point]:
    """The places between two undercuts, where G touches the ceiling."""
    lower = find_lower(s)
    return [u.bottom[-1] for u in lower[:-1]]


def list_facts() -> Facts:
    """List the figure's statements."""
    s = sweep_example()
    return [
        ("(m, n)", f"({M}, {N})"),
        ("undercuts between the needles", str(len(find_lower(s)))),
        ("places where G touches the ceiling", str(len(_find_touched(s)))),
        ("their x", ", ".join(str(p.x) for p in _find_touched(s))),
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    s = sweep_example()
    yield from loops_differ(s)
    yield from overlaps(s, [PLACE])
    yield differ("undercuts", len(find_lower(s)), undercuts_under_ceilings(M, N))
    yield differ("heights of the places", {p.y for p in _find_touched(s)}, {CEILING})


def draw() -> Figure:
    """The picture."""
    s = sweep_example()
    box = Extent((-10, -9), (24, 13), margins=Margins(2, 2, 2, 2), is_cut=True)
    with Sheet([[box]], WIDE) as sheet:
        (panel,) = sheet.panels
        panel.area(s.directrix.vertices, style.DIRECTRIX)
        panel.area(place_generatrix(s, PLACE).vertices, PLACED)
        draw_undercuts(panel, find_lower(s))
        panel.line(s.inner.vertices, INNER, closed=True)
        panel.dots(_find_touched(s))
        panel.label((10, 11), "$D$")
        panel.label((4, -3), "$G$")
        panel.label((0, 0), "needle", -22, -10)
        panel.label((20, 0), "needle", 4, -10)
        panel.label((15, 5), "undercuts", 26, -24, leader=True)
    return sheet.figure
