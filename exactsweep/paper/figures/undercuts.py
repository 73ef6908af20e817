"""Figure 7: the two kinds of undercut."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.draw import draw_undercuts, place_generatrix
from exactsweep.evidence.undercut import Undercut
from exactsweep.geometry.region import Vertices
from exactsweep.numbers.point import Vertex
from exactsweep.paper.figures.figure import Facts, differ, loops_differ, overlaps
from exactsweep.paper.figures.sheet import (
    BOLD,
    GHOST,
    HOLLOW,
    PAGE,
    PLACED,
    TRAJECTORY,
    Extent,
    Sheet,
    find_middle,
    shift,
)
from exactsweep.paper.functions import take_bottom
from exactsweep.procedures.cc import trajectory_cc
from exactsweep.procedures.chain import find_convex_parts, split
from exactsweep.sweep import Sweep, sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

DIRECTRIX = [(0, 4), (3, 0), (6, 5), (9, 1), (12, 5), (6, 8)]
# A roof, and a long straight edge parallel to the line through the two lowest vertices of D.
GENERATRICES: tuple[Vertices, ...] = (
    [(0, 0), (5, -4), (9, 0), (4, 3)],
    [(0, -1), (6, -4), (11, 0), (10, "3/2"), (1, 0)],
)
REFERENCES = ((5, -4), (6, -4))


def sweep_examples() -> tuple[Sweep, Sweep]:
    """The two sweeps; the reference points are the lowest vertices of G."""
    first, second = (
        sweep(g, DIRECTRIX, reference=r) for g, r in zip(GENERATRICES, REFERENCES, strict=True)
    )
    return first, second


def find_undercut(s: Sweep) -> Undercut:
    """The only one."""
    (found,) = s.undercuts
    return found


def list_facts() -> Facts:
    """List the figure's statements."""
    facts = []
    for letter, s in zip("ab", sweep_examples(), strict=True):
        found = find_undercut(s)
        facts += [
            (f"({letter}) undercuts", str(len(s.undercuts))),
            (f"({letter}) the sub-trajectories meet in a", found.intersection),
            (f"({letter}) edges of the bottom chain", str(len(found.bottom) - 1)),
            (f"({letter}) contact points", " ".join(f"({p.x}, {p.y})" for p in found.extremes)),
        ]
    return facts


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    for s, kind in zip(sweep_examples(), ("point", "segment"), strict=True):
        found = find_undercut(s)
        yield from loops_differ(s)
        yield from overlaps(s, found.positions)
        yield differ("kind", found.intersection, kind)
        yield differ("positions", len(found.positions), 1 if kind == "point" else 2)
        gap = s.inner.area - s.directrix.area
        yield differ("area between D and the inner loop", gap, found.polygon.area)


def sweep_sub_trajectories(s: Sweep) -> list[list[Vertex]]:
    """The paths of the reference point along the two convex chains of D_b."""
    top, d_bottom = split(s.generatrix.vertices)[1], split(s.directrix.vertices)[0]
    return [shift(trajectory_cc(top, part), s.reference) for part in find_convex_parts(d_bottom)]


def draw() -> Figure:
    """The picture."""
    boxes = []
    for letter, s in zip("ab", sweep_examples(), strict=True):
        placed = [place_generatrix(s, place).vertices for place in find_undercut(s).positions]
        shapes = s.directrix.vertices, *placed, *sweep_sub_trajectories(s)
        boxes.append(Extent.around(*shapes, title=f"({letter})"))
    with Sheet([boxes], PAGE) as sheet:
        for panel, s in zip(sheet.panels, sweep_examples(), strict=True):
            found = find_undercut(s)
            panel.area(s.directrix.vertices, style.DIRECTRIX)
            for place, look in zip(found.positions, (PLACED, GHOST), strict=False):
                panel.area(place_generatrix(s, place).vertices, look)
            draw_undercuts(panel, [found])
            for chain in sweep_sub_trajectories(s):
                panel.line(chain, style.SUB_TRAJECTORY)
            panel.line(take_bottom(s.trajectory.vertices), TRAJECTORY)
            panel.line(found.bottom, BOLD)
            panel.dots(found.extremes)
            panel.dots(found.positions, HOLLOW)
            panel.label((6, Fraction(13, 2)), "$D$")
            panel.label(found.positions[0], "$G$", 0, 22)
            panel.label((6, 4), "undercut", 94, -2, leader=True)
            panel.label(find_middle(*found.bottom[:2]), "bottom chain", -72, 4, leader=True)
        one, other = find_undercut(sweep_examples()[1]).positions
        sheet.panels[1].label(find_middle(one, other), "$l$", 2, -8)
    return sheet.figure
