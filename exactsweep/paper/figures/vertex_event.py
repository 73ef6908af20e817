"""Figure 12: a vertex of G that slides along an edge of D is the only contact."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.draw import ContactStretch, cut_trajectory, place_generatrix
from exactsweep.draw.features import Features
from exactsweep.numbers.point import Vertex
from exactsweep.paper.figures.figure import Facts, differ, loops_differ, overlaps
from exactsweep.paper.figures.sheet import (
    PLACED,
    WIDE,
    Extent,
    Sheet,
    find_half_way,
    find_middle,
)
from exactsweep.paper.figures.undercuts import sweep_examples

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LINE = Look(style.BLACK, 0.9, dash=(0, (4, 2)), order=6)

OFFSETS = {"VE": (-10, 6), "EV": (4, -10)}
"""Where the name of an event is written, in points from the contact."""


def find_moment(event: str, contacts: int) -> ContactStretch:
    """The last stretch of the lower sweep of Figure 7b with an event and so many contacts."""
    found = [
        stretch
        for stretch in cut_trajectory(sweep_examples()[1])
        if stretch.event == event
        and len(stretch.contacts) == contacts
        and stretch.start.x < stretch.end.x
    ]
    return max(found, key=lambda stretch: stretch.start.x)


def list_facts() -> Facts:
    """List the figure's statements."""
    every = cut_trajectory(sweep_examples()[1])
    alone = [s for s in every if s.event == "VE"]
    several = [s for s in every if len(s.contacts) > 1]
    return [
        ("stretches of the trajectory", str(len(every))),
        ("with a VE event", str(len(alone))),
        ("with a VE event and another one", str(sum(len(s.contacts) > 1 for s in alone))),
        ("with several events", str(len(several))),
        ("events there", ", ".join(sorted({c.event for s in several for c in s.contacts}))),
    ]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    s = sweep_examples()[1]
    yield from loops_differ(s)
    for stretch in cut_trajectory(s):
        t = find_half_way(stretch.start, stretch.end)
        yield from overlaps(s, [t])
        missing = set(stretch.contacts) - set(s.contacts_at(t))
        yield differ(f"contacts missing at ({t.x}, {t.y})", missing, set())
        if len(stretch.contacts) > 1:
            yield differ("edges of G", len({c.generatrix for c in stretch.contacts}), 1)
            kinds = {c.event for c in stretch.contacts}
            yield differ("a VE event among several", "VE" in kinds, False)


def draw() -> Figure:
    """The picture."""
    s = sweep_examples()[1]
    moments = find_moment("VE", 1), find_moment("EV", 2)
    places = [find_half_way(m.start, m.end) for m in moments]
    placed = [place_generatrix(s, place).vertices for place in places]
    boxes = [
        Extent.around(s.directrix.vertices, ring, title=title)
        for ring, title in zip(placed, ("(a)", "(b)"), strict=True)
    ]
    with Sheet([boxes], WIDE) as sheet:
        for panel, ring, place, stretch in zip(sheet.panels, placed, places, moments, strict=True):
            panel.area(s.directrix.vertices, style.DIRECTRIX)
            panel.area(ring, PLACED)
            dx, dy = stretch.end.x - stretch.start.x, stretch.end.y - stretch.start.y
            share = 2 / max(dx, abs(dy))
            by = share * dx, share * dy
            panel.label((6, 6), "$D$")
            panel.label(find_middle(min(ring), max(ring)), "$G$", 0, -6)
            for contact in stretch.contacts:
                spot = Features(s).spot(contact, place)[0]
                panel.line([_plus(spot, by, -2), _plus(spot, by, 3)], LINE)
                panel.dots([spot])
                panel.label(spot, contact.event, *OFFSETS[contact.event])
            low = min(ring, key=lambda p: p.y)
            panel.arrow(_plus(low, by, Fraction(1, 4)), _plus(low, by, Fraction(3, 2)))
    return sheet.figure


def _plus(p: Vertex, by: Vertex, times: int | Fraction) -> Vertex:
    return p[0] + times * by[0], p[1] + times * by[1]
