"""Figure 1: the sweep of G around D beside the Minkowski sum of G and D's boundary."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.check import classify, reference_inner_fit, reference_no_fit
from exactsweep.draw import Picture, draw_undercuts, place_generatrix
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Loop, Point
from exactsweep.paper.figures.figure import Facts, differ, loops_differ, overlaps
from exactsweep.paper.figures.sheet import INNER, OUTER, PAGE, TRAJECTORY, Extent, Margins, Sheet
from exactsweep.sweep import Sweep, inner_fit_polygon, no_fit_polygon, sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

GENERATRIX = [(0, 0), (2, 1), (4, 0), (3, 3), (1, 3)]
DIRECTRIX = [(0, 5), (4, 0), (8, 4), (12, -1), (20, 5), (17, 10), (11, 6), (8, 11), (3, 9)]
# Where G stands in the right half, its reference point on D's boundary: two vertices, two edges.
ALONG = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 5), (12, -1), (16, 2), (11, 6)]]


def sweep_example() -> Sweep:
    """The sweep, which Figure 8 shows, too."""
    return sweep(GENERATRIX, DIRECTRIX, reference=(2, 1))


def invert_generatrix(s: Sweep) -> Polygon:
    """I(G), its reference point at the origin."""
    return s.generatrix.exterior.translated((-s.reference.x, -s.reference.y)).reflected()


def sum_boundary() -> tuple[Loop, tuple[Loop, ...]]:
    """The outer boundary, and the holes, of the Minkowski sum of D's boundary and G.

    The sum of D and G is the no-fit polygon of D and I(G). The sum of D's boundary and G lacks the
    points p for which p + I(G) lies inside D, off its boundary.
    """
    s = sweep_example()
    inverted = invert_generatrix(s)
    outer = no_fit_polygon(s.directrix, inverted).exterior.vertices
    inside = inner_fit_polygon(s.directrix, inverted).regions
    return outer, tuple(region.exterior.vertices for region in inside)


def draw_sweep(picture: Picture, s: Sweep) -> None:
    """Draw the swept area, D, undercuts, both loops and the trajectory, each in its look."""
    outer, inner = s.outer.vertices, s.inner.vertices
    picture.ring(outer, inner, style.SWEPT)
    picture.area(s.directrix.vertices, style.DIRECTRIX)
    draw_undercuts(picture, s.undercuts)
    picture.line(inner, INNER, closed=True)
    picture.line(outer, OUTER, closed=True)
    picture.line(s.trajectory.vertices, TRAJECTORY, closed=True)


def list_facts() -> Facts:
    """List the figure's statements."""
    s = sweep_example()
    _, holes = sum_boundary()
    met = [classify(s.directrix, place_generatrix(s, t), (0, 0)).verdict for t in ALONG]
    return [
        ("class of the sweep", s.kind),
        ("edges of the trajectory", str(len(s.trajectory))),
        ("edges of the inner and the outer loop", f"{len(s.inner)}, {len(s.outer)}"),
        ("undercuts", str(len(s.undercuts))),
        ("positions in (b) at which G overlaps D", f"{met.count('OVERLAP')} of {len(met)}"),
        ("holes of the sum", str(len(holes))),
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    s = sweep_example()
    yield from loops_differ(s)
    yield from overlaps(s, _positions(s))
    outer, holes = sum_boundary()
    inverted = invert_generatrix(s)
    yield differ("boundary of the sum", outer, reference_no_fit(s.directrix, inverted).exterior)
    inside = reference_inner_fit(s.directrix, inverted).regions
    yield differ("holes of the sum", holes, tuple(exterior for exterior, _ in inside))


def _positions(s: Sweep) -> list[Point]:
    """A corner, and where G closes the upper undercut."""
    return [s.trajectory.vertices[6], s.undercuts[-1].positions[0]]


def draw() -> Figure:
    """The picture."""
    s = sweep_example()
    sum_outer, holes = sum_boundary()
    shapes = s.outer.vertices, sum_outer
    margins = Margins(top=22)
    boxes = [
        Extent.around(*shapes, title="(a) sweep", margins=margins),
        Extent.around(*shapes, title="(b) Minkowski sum", margins=margins),
    ]
    with Sheet([boxes], PAGE) as sheet:
        left, right = sheet.panels
        draw_sweep(left, s)
        left.generatrix(s, _positions(s))
        left.label((4, 6), "$D$")
        for x, y in _positions(s):
            left.label((x, y), "$G$", 0, 8)
        left.label((8, Fraction(7, 2)), "undercut", -33, 8, leader=True)
        left.label((1, 10), "trajectory", -14, 30, leader=True)
        left.label((16, 2), "inner loop", -4, 24, leader=True)
        left.label((19, 13), "outer loop", 10, 14, leader=True)
        right.area(sum_outer, style.SWEPT)
        right.area(s.directrix.vertices, replace(style.DIRECTRIX, fill="#b4b4b480"))
        for hole in holes:
            right.line(hole, INNER, closed=True)
        right.line(sum_outer, OUTER, closed=True)
        right.line(s.directrix.vertices, TRAJECTORY, closed=True)
        right.generatrix(s, ALONG)
        right.label((Fraction(37, 2), 5), "$D$")
        right.label(ALONG[0], "$G$", 0, 8)
        right.label((8, 11), "path of the marked point", -20, 34, leader=True)
    return sheet.figure
