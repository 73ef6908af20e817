"""Figure 12: a vertex of G that slides along an edge of D is the only contact."""

from __future__ import annotations

from fractions import Fraction

from exactsweep.draw import ContactInterval, cut_trajectory
from exactsweep.draw.features import SweepFeatures
from exactsweep.numbers.number import Vertex
from exactsweep.paper.figures.figure import PaperFigure, find_middle, join_panels, place, write_list
from exactsweep.paper.figures.undercuts import sweep_examples
from exactsweep.sweep import Sweep

OFFSETS = {"VE": (-10, 6), "EV": (4, -10)}
"""Offsets of the names of events, in points from the contact."""


def compute() -> PaperFigure:
    s = sweep_examples()[1]
    every = cut_trajectory(s)
    alone = [segment for segment in every if segment.event == "VE"]
    several = [segment for segment in every if len(segment.contacts) > 1]
    middles = [find_middle(segment.start, segment.end) for segment in every]
    laws: list[tuple[str, object, object]] = [
        (f"contacts missing at ({t.x}, {t.y})", set(o.contacts) - set(s.contacts_at(t)), set())
        for o, t in zip(every, middles, strict=True)
    ]
    for segment in several:
        laws.append(("edges of G", len({c.generatrix for c in segment.contacts}), 1))
        kinds = {c.event for c in segment.contacts}
        laws.append(("a VE event among several", "VE" in kinds, False))
    whole = PaperFigure(
        facts=[
            ("contact intervals of the trajectory", len(every)),
            ("with a VE event", len(alone)),
            ("with a VE event and another one", sum(len(one.contacts) > 1 for one in alone)),
            ("with several events", len(several)),
            ("events there", write_list(sorted({c.event for o in several for c in o.contacts}))),
        ],
        laws=laws,
        sweeps=[(s, middles)],
    )
    panels = {"": whole}
    for letter, kind in (("a", ("VE", 1)), ("b", ("EV", 2))):
        # The last such interval of the lower sweep.
        found = (o for o in every if (o.event, len(o.contacts)) == kind and o.start.x < o.end.x)
        panels[letter] = _show(s, max(found, key=lambda one: one.start.x))
    return join_panels(panels)


def _show(s: Sweep, segment: ContactInterval) -> PaperFigure:
    t = find_middle(segment.start, segment.end)
    (ring,) = place(s, [t])
    dx, dy = segment.end.x - segment.start.x, segment.end.y - segment.start.y
    by = 2 * dx / max(dx, abs(dy)), 2 * dy / max(dx, abs(dy))
    spots = [SweepFeatures(s).spot(contact, t)[0] for contact in segment.contacts]
    lowest = min(ring, key=lambda p: p.y)
    return PaperFigure(
        shapes={"placed": ring, "name": find_middle(min(ring), max(ring)), "spots": spots}
        | {"lines": [[_move(spot, by, -2), _move(spot, by, 3)] for spot in spots]}
        | {"offsets": [OFFSETS[contact.event] for contact in segment.contacts]}
        | {"onward": [_move(lowest, by, Fraction(k, 4)) for k in (1, 6)]},
        words={"events": [contact.event for contact in segment.contacts]},
    )


def _move(p: Vertex, by: Vertex, times: int | Fraction) -> Vertex:
    return p[0] + times * by[0], p[1] + times * by[1]
