"""Figure 12: a vertex of G that slides along an edge of D is the only contact."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from typing import Any

from exactsweep.draw import cut_trajectory
from exactsweep.draw.features import Features
from exactsweep.numbers.point import Vertex
from exactsweep.paper.figures.figure import PaperFigure, find_middle, place, write_list
from exactsweep.paper.figures.undercuts import DIRECTRIX, sweep_examples

OFFSETS = {"VE": (-10, 6), "EV": (4, -10)}
"""Where the name of an event is written, in points from the contact."""


def compute() -> PaperFigure:
    """Compute the figure."""
    s = sweep_examples()[1]
    every = cut_trajectory(s)
    alone = [stretch for stretch in every if stretch.event == "VE"]
    several = [stretch for stretch in every if len(stretch.contacts) > 1]
    laws: list[tuple[str, object, object]] = []
    middles = [find_middle(stretch.start, stretch.end) for stretch in every]
    for stretch, t in zip(every, middles, strict=True):
        missing = set(stretch.contacts) - set(s.contacts_at(t))
        laws.append((f"contacts missing at ({t.x}, {t.y})", missing, set()))
    for stretch in several:
        laws.append(("edges of G", len({c.generatrix for c in stretch.contacts}), 1))
        kinds = {c.event for c in stretch.contacts}
        laws.append(("a VE event among several", "VE" in kinds, False))
    shapes: dict[str, Sequence[Any]] = {"directrix": DIRECTRIX}
    words = {}
    for letter, event, contacts in (("a", "VE", 1), ("b", "EV", 2)):
        # The last such stretch of the lower sweep.
        stretch, t = max(
            (stretch.start.x, stretch, t)
            for stretch, t in zip(every, middles, strict=True)
            if (stretch.event, len(stretch.contacts)) == (event, contacts)
            and stretch.start.x < stretch.end.x
        )[1:]
        (ring,) = place(s, [t])
        dx, dy = stretch.end.x - stretch.start.x, stretch.end.y - stretch.start.y
        by = 2 * dx / max(dx, abs(dy)), 2 * dy / max(dx, abs(dy))
        spots = [Features(s).spot(contact, t)[0] for contact in stretch.contacts]
        lowest = min(ring, key=lambda p: p.y)
        shapes |= {
            f"{letter}_placed": ring,
            f"{letter}_name": find_middle(min(ring), max(ring)),
            f"{letter}_spots": spots,
            f"{letter}_lines": [[_move(spot, by, -2), _move(spot, by, 3)] for spot in spots],
            f"{letter}_offsets": [OFFSETS[contact.event] for contact in stretch.contacts],
            f"{letter}_onward": [_move(lowest, by, Fraction(k, 4)) for k in (1, 6)],
        }
        words[f"{letter}_events"] = [contact.event for contact in stretch.contacts]
    return PaperFigure(
        facts=[
            ("stretches of the trajectory", len(every)),
            ("with a VE event", len(alone)),
            ("with a VE event and another one", sum(len(one.contacts) > 1 for one in alone)),
            ("with several events", len(several)),
            ("events there", write_list(sorted({c.event for o in several for c in o.contacts}))),
        ],
        laws=laws,
        shapes=shapes,
        words=words,
        sweeps=[(s, middles)],
    )


def _move(p: Vertex, by: Vertex, times: int | Fraction) -> Vertex:
    return p[0] + times * by[0], p[1] + times * by[1]
