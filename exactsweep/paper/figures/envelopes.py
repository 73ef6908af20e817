"""Figure 6: a CM sweep from the CC sweeps of D's convex chains."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.draw import draw_undercuts
from exactsweep.numbers.point import Vertex
from exactsweep.paper.checks.section4 import lowest
from exactsweep.paper.figures.figure import Facts, differ, loops_differ, overlaps
from exactsweep.paper.figures.sheet import (
    BOLD,
    COLUMN,
    OUTER,
    PLACED,
    THIN,
    Extent,
    Margins,
    Sheet,
    shift,
)
from exactsweep.paper.functions import keep_corners, take_bottom
from exactsweep.procedures.cc import sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import find_convex_parts, split
from exactsweep.procedures.cm import sweep_outer_cm, trajectory_cm
from exactsweep.procedures.lower_sweep import LowerSweep
from exactsweep.sweep import Sweep, sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

GENERATRIX = [(0, 0), (1, -2), (4, -1), (5, 0), (3, 3), (1, 2)]
DIRECTRIX = [(0, 5), (2, 1), (5, 0), (8, 4), (10, 0), (14, 1), (16, 5), (12, 7), (4, 7)]
PARTS = (
    Look(style.BLUE, 1.6, order=4),
    Look(style.RED, 1.6, dash=(0, (4, 1.2)), order=4.1),
)
GROUND = Look("white", 3.0, order=4.5)
"""Under dashes, so that other lines do not show between them."""


def sweep_example() -> Sweep:
    """The CM sweep; the reference point is inside G."""
    return sweep(GENERATRIX, DIRECTRIX, reference=(2, 0))


def sweep_half() -> LowerSweep:
    """Its lower half."""
    s = sweep_example()
    bottom, top = split(s.generatrix.vertices)
    return LowerSweep(s.kind, top, bottom, split(s.directrix.vertices)[0])


def _sub_chains() -> tuple[list[list[Vertex]], list[list[Vertex]]]:
    """Sub-trajectories of the reference point, and sub-outer chains."""
    lower, reference = sweep_half(), sweep_example().reference
    parts = find_convex_parts(lower.directrix)
    return (
        [shift(trajectory_cc(lower.top, part), reference) for part in parts],
        [sweep_outer_cc(lower.top, lower.bottom, part) for part in parts],
    )


def _envelopes() -> tuple[list[Vertex], list[Vertex]]:
    """The trajectory of the reference point, and the outer boundary."""
    lower = sweep_half()
    return (
        shift(trajectory_cm(lower.top, lower.directrix), sweep_example().reference),
        list(sweep_outer_cm(lower.top, lower.bottom, lower.directrix)),
    )


def list_facts() -> Facts:
    """List the figure's statements."""
    parts = find_convex_parts(sweep_half().directrix)
    paths, outers = _sub_chains()
    path, outer = _envelopes()
    return [
        ("convex chains of D_b", str(len(parts))),
        ("their edges", ", ".join(str(len(part) - 1) for part in parts)),
        ("edges of the sub-trajectories", ", ".join(str(len(p) - 1) for p in paths)),
        ("edges of the trajectory", str(len(path) - 1)),
        ("edges of the sub-outer chains", ", ".join(str(len(p) - 1) for p in outers)),
        ("edges of the outer boundary", str(len(outer) - 1)),
        ("undercuts", str(len(sweep_example().undercuts))),
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    s = sweep_example()
    yield from loops_differ(s)
    yield from overlaps(s, s.undercuts[0].positions)
    path, outer = _envelopes()
    yield differ("trajectory", keep_corners(path), take_bottom(s.trajectory.vertices))
    yield differ("outer boundary", keep_corners(outer), take_bottom(s.outer.vertices))
    paths, outers = _sub_chains()
    yield lowest("sub-trajectory", paths, path)
    yield lowest("sub-outer chain", outers, outer)
    meeting = s.undercuts[0].positions[0]
    yield differ("the sub-trajectories meet on the trajectory", meeting in path, True)


def draw() -> Figure:
    """The picture."""
    s = sweep_example()
    paths, outers = _sub_chains()
    path, outer = _envelopes()
    parts = find_convex_parts(sweep_half().directrix)
    d_top = split(s.directrix.vertices)[1]
    everything = [s.directrix.vertices, *paths, *outers]
    beside = shift(s.generatrix.vertices, (-5, 0))
    ends = [(x, 0) for x, _ in (outer[0], outer[-1])]
    boxes = [
        Extent.around(s.directrix.vertices, beside, ends, title="(a)", margins=Margins(2, 8, 2, 2)),
        Extent.around(*everything, title="(b)", margins=Margins(2, 16, 2, 2)),
        Extent.around(*everything, title="(c)", margins=Margins(2, 16, 2, 2)),
    ]
    with Sheet([[box] for box in boxes], COLUMN) as sheet:
        a, b, c = sheet.panels
        for panel in sheet.panels:
            panel.area(s.directrix.vertices, replace(style.DIRECTRIX, width=0))
            panel.line(d_top, THIN)
            panel.label((8, 6), "$D$")
        for look, part in zip(PARTS, parts, strict=True):
            a.line(part, look)
        a.area(beside, PLACED)
        a.label((-3, 0), "$G$", 2, 2)
        a.label(parts[0][-2], "$D_1$", -14, -8)
        a.label(parts[1][1], "$D_2$", 14, -8)
        a.dots([parts[0][-1]])
        for panel in (b, c):
            panel.line(sweep_half().directrix, THIN)
        for look, one, two in zip(PARTS, paths, outers, strict=True):
            b.line(one, look)
            b.line(two, replace(look, width=1.0))
        b.label(paths[0][0], "$T(G_t, D_1)$", 2, 8)
        b.label(paths[1][-1], "$T(G_t, D_2)$", -2, 8)
        for chain in (*paths, *outers):
            c.line(chain, style.SUB_TRAJECTORY)
        draw_undercuts(c, s.undercuts)
        c.line(path, BOLD)
        c.line(outer, GROUND)
        c.line(outer, replace(OUTER, width=2.4, order=5))
        c.generatrix(s, s.undercuts[0].positions[:1])
        c.label(path[0], "trajectory", 4, 8)
        c.label((8, 3), "undercut", 34, 13, leader=True)
        for panel, words in ((b, "sub-outer chains"), (c, "outer boundary")):
            panel.label((sweep_half().directrix[3][0] - 2, min(y for _, y in outer)), words, 0, -9)
    return sheet.figure
