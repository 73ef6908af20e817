"""Figure 3: inner and outer boundary of the lower sweep."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.draw import draw_undercuts
from exactsweep.numbers.point import Point, Vertex
from exactsweep.paper.figures.figure import Facts, differ, loops_differ, overlaps
from exactsweep.paper.figures.minkowski import sweep_example
from exactsweep.paper.figures.sheet import (
    COLUMN,
    INNER,
    OUTER,
    TRAJECTORY,
    Extent,
    Margins,
    Sheet,
    shift,
)
from exactsweep.paper.functions import clip, keep_corners, take_bottom
from exactsweep.procedures.chain import complement, inverse, split
from exactsweep.procedures.lower_sweep import LowerSweep
from exactsweep.procedures.mm import trajectory_mm

if TYPE_CHECKING:
    from matplotlib.figure import Figure


def _sweep_half() -> LowerSweep:
    """The lower sweep of Figure 1."""
    s = sweep_example()
    bottom, top = split(s.generatrix.vertices)
    return LowerSweep(s.kind, top, bottom, split(s.directrix.vertices)[0])


def _top_chain(half: LowerSweep) -> list[Vertex]:
    """The top chain of what G passes over in the lower sweep, from left to right.

    That is where I(G) runs along the other side of the trajectory (Lemma 5.3), beyond both ends
    of D, too.
    """
    inside = inverse(complement(list(half.trajectory)))
    return complement(inverse(list(trajectory_mm(half.top, inside))))


def _stations(half: LowerSweep) -> list[Point]:
    """Find the positions of the reference point at the start and at the stop of the sweep."""
    x, y = sweep_example().reference
    path = list(half.trajectory)
    return [Point(px + x, py + y) for px, py in (path[0], path[-1])]


def list_facts() -> Facts:
    """List the figure's statements."""
    half = _sweep_half()
    start, stop = _stations(half)
    return [
        ("edges of the inner boundary", str(len(half.inner) - 1)),
        ("edges of the outer boundary", str(len(half.outer) - 1)),
        ("horizontal distance from start to stop", str(stop.x - start.x)),
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    s, half = sweep_example(), _sweep_half()
    yield from loops_differ(s)
    yield from overlaps(s, _stations(half))
    left, right = (Fraction(x) for x, _ in (half.directrix[0], half.directrix[-1]))
    yield differ("inner boundary", clip(_top_chain(half), left, right), keep_corners(half.inner))
    yield differ(
        "bottom of the outer loop", take_bottom(s.outer.vertices), keep_corners(half.outer)
    )
    start, stop = _stations(half)
    widths = sum(p.bounding_box[1].x - p.bounding_box[0].x for p in (s.generatrix, s.directrix))
    yield differ("horizontal distance", stop.x - start.x, widths)
    first, (x0, y0) = half.top[0], next(iter(half.trajectory))
    yield differ("start", (first[0] + x0, first[1] + y0), half.directrix[0])


def draw() -> Figure:
    """The picture."""
    s, half = sweep_example(), _sweep_half()
    top = _top_chain(half)
    low = min(y for _, y in half.outer) - 3
    start, stop = _stations(half)
    box = Extent.around(
        s.directrix.vertices, top, half.outer, [(start.x, low)], margins=Margins(2, 8, 2, 10)
    )
    with Sheet([[box]], COLUMN) as sheet:
        (panel,) = sheet.panels
        panel.area([*half.outer, *reversed(top)], style.SWEPT)
        panel.area(s.directrix.vertices, style.DIRECTRIX)
        draw_undercuts(panel, s.undercuts[:1])
        panel.line(shift(half.trajectory, s.reference), TRAJECTORY)
        panel.line(half.inner, INNER)
        panel.line(half.outer, OUTER)
        panel.generatrix(s, [start, stop])
        panel.label((6, 7), "$D$")
        panel.label(start, "$G$", 0, 9)
        panel.label(stop, "$G$", 0, 9)
        panel.label((15, Fraction(5, 4)), "inner boundary", -10, 25, leader=True)
        panel.label((4, -3), "outer boundary", 0, -9)
        panel.arrow((start.x, low), (stop.x, low), both=True)
        panel.label(
            ((start.x + stop.x) / 2, low),
            f"{stop.x - start.x} = width of $G$ + width of $D$",
            0,
            -8,
        )
    return sheet.figure
