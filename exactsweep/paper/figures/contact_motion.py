"""Figure 13: the contact moves to the right only."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, NamedTuple

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.draw import ContactStretch, cut_trajectory, place_generatrix
from exactsweep.draw.features import Features
from exactsweep.numbers.point import Point, Rational, Vertex
from exactsweep.paper.figures.figure import Facts, differ, loops_differ, overlaps
from exactsweep.paper.figures.sheet import (
    BOLD,
    PAGE,
    PLACED,
    SMALL,
    Extent,
    Margins,
    Sheet,
    find_half_way,
    find_middle,
)
from exactsweep.paper.figures.undercuts import find_undercut, sweep_examples
from exactsweep.procedures.chain import split
from exactsweep.sweep import Sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LEFT = Look(style.BLUE, 2.6, order=5)
RIGHT = Look(style.RED, 1.6, dash=(0, (4, 1.2)), order=5.1)
LEFT_HALF = Look("none", 0, fill=f"{style.YELLOW}40", order=0)


class Frozen(NamedTuple):
    """A position of G, and the leftmost and the rightmost point of contact there."""

    at: Point
    left: Point
    right: Point


def _at(s: Sweep, stretch: ContactStretch, at: Point) -> Frozen:
    """The contact at a position on a stretch, by the events that last there."""
    spots = [p for c in stretch.contacts for p in Features(s).spot(c, at)]
    return Frozen(at, min(spots), max(spots))


def motion() -> list[Frozen]:
    """The ends of the contact along the lower sweep of Figure 7b, at both ends of each stretch."""
    s = sweep_examples()[1]
    return [
        _at(s, stretch, at)
        for stretch in cut_trajectory(s)
        if stretch.start.x < stretch.end.x
        for at in (stretch.start, stretch.end)
    ]


def freeze() -> Frozen:
    """Half-way along the segment of positions at which G closes the undercut of Figure 7b."""
    s = sweep_examples()[1]
    first, last = find_undercut(s).positions
    at = find_half_way(first, last)
    spots = [p for c in s.contacts_at(at) for p in Features(s).spot(c, at)]
    return Frozen(at, min(spots), max(spots))


def list_facts() -> Facts:
    """List the figure's statements."""
    found = freeze()
    path = motion()
    return [
        ("p_l and p_r at the position drawn", f"{_text(found.left)}, {_text(found.right)}"),
        ("positions compared", str(len(path))),
        ("p_l goes from, to", f"{path[0].left.x}, {path[-1].left.x}"),
        ("p_r goes from, to", f"{path[0].right.x}, {path[-1].right.x}"),
    ]


def _text(p: Point) -> str:
    return f"({p.x}, {p.y})"


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    s = sweep_examples()[1]
    yield from loops_differ(s)
    path = motion()
    yield from overlaps(s, [moment.at for moment in path])
    for name in ("left", "right"):
        xs = [getattr(moment, name).x for moment in path]
        yield differ(f"the {name} end moves to the right only", xs, sorted(xs))


def draw() -> Figure:
    """The picture."""
    s, found = sweep_examples()[1], freeze()
    ring = place_generatrix(s, found.at).vertices
    path = motion()
    first, travelled = path[0].at.x, path[-1].at.x - path[0].at.x
    width = s.directrix.bounding_box[1].x
    low, high = min(y for _, y in ring) - 1, max(y for _, y in s.directrix.vertices)
    left = min(x for x, _ in ring) - 2
    boxes = [
        Extent.around(s.directrix.vertices, ring, [(left, low), (left, high)], title="(a)"),
        Extent((0, 0), (travelled + 1, width + 1), "(b)", Margins(18, 20, 2, 2)),
    ]
    with Sheet([boxes], PAGE) as sheet:
        picture, chart = sheet.panels
        picture.area(_left_half(found, ring, (left, low), high), LEFT_HALF)
        picture.area(s.directrix.vertices, style.DIRECTRIX)
        picture.area(ring, PLACED)
        picture.line(_border(found, ring, low, high), BOLD)
        picture.dots([found.left, found.right])
        picture.label(found.left, "$p_l$", 9, -8)
        picture.label(found.right, "$p_r$", 3, -9)
        picture.label(min(ring), "$v_l$", -9)
        picture.label((6, 6), "$D$")
        bottom = split(s.directrix.vertices)[0]
        picture.label(find_middle(*bottom[:2]), "$D_b^l$", -9, -7)
        picture.label(find_middle(*bottom[-2:]), "$D_b^r$", 13, -5)
        picture.label(find_middle(min(ring), max(ring)), "$G$", 0, -8)
        chart.arrow((0, 0), (travelled + 1, 0))
        chart.arrow((0, 0), (0, width + 1))
        chart.line([(m.at.x - first, m.left.x) for m in path], LEFT)
        chart.line([(m.at.x - first, m.right.x) for m in path], RIGHT)
        for x in sorted({p.x for m in path for p in (m.left, m.right)}):
            chart.label((0, x), str(x), -4, ha="right", size=SMALL)
        chart.label((travelled / 2, 0), "distance that $G$ has travelled", 0, -8)
        chart.label((0, width), "$x$ on $D_b$", 6, 6, ha="left")
        start, end = (p.x - first for p in find_undercut(s).positions)
        chart.label(((start + end) / 2, found.left.x), "$p_l$", 0, -8)
        chart.label(((start + end) / 2, found.right.x), "$p_r$", 0, 8)
    return sheet.figure


def _border(found: Frozen, ring: Sequence[Vertex], low: Rational, high: Rational) -> list[Vertex]:
    """The ray up from p_l, the chain of G_t from there to v_l, and the ray down from v_l."""
    top = split(ring)[1]
    passed = [p for p in top if p[0] < found.left.x]
    return [(found.left.x, high), found.left, *passed, (passed[-1][0], low)]


def _left_half(
    found: Frozen, ring: Sequence[Vertex], corner: Vertex, high: Rational
) -> list[Vertex]:
    """The part of the picture that is left of the border."""
    left, low = corner
    return [(left, low), (left, high), *_border(found, ring, low, high)]
