"""Figure 4: a CC sweep goes along the edges of both polygons in order of slope."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any, Literal, NamedTuple

from exactsweep.numbers.number import format_fraction
from exactsweep.numbers.point import Point, Rational, Vertex
from exactsweep.paper.figures.figure import (
    PaperFigure,
    find_middle,
    list_loops,
    place,
    shift,
    take_half,
)
from exactsweep.procedures.cc import trajectory_cc
from exactsweep.procedures.chain import inverse
from exactsweep.sweep import Sweep, sweep

GENERATRIX = [(0, 0), (2, -1), (5, -2), (6, 1), (3, 3), (2, 3)]
DIRECTRIX = [(0, 5), (2, 1), (4, -1), (8, -2), (10, -1), (7, 6)]
STEPS = 4

Owner = Literal["D_b", "G_t", "G_b"]


class Move(NamedTuple):
    """An edge along which G slides: whose it is, and which vector it adds to the path."""

    owner: Owner
    by: Vertex

    @property
    def slope(self) -> Rational:
        """Its slope."""
        return Fraction(self.by[1]) / self.by[0]


def sweep_example() -> Sweep:
    """The CC sweep of Figures 4 and 5; the reference point is the right end of G."""
    return sweep(GENERATRIX, DIRECTRIX, reference=(6, 1))


def list_edges() -> dict[Owner, list[Move]]:
    """The edges of D_b, of reversed G_t and of G_b, each from left to right."""
    half = take_half(sweep_example())
    chains: dict[Owner, list[Vertex]] = {
        "D_b": half.directrix,
        "G_t": inverse(half.top),
        "G_b": half.bottom,
    }
    return {
        owner: [Move(owner, (q[0] - p[0], q[1] - p[1])) for p, q in pairwise(chain)]
        for owner, chain in chains.items()
    }


def sort_by_slope(*owners: Owner) -> list[Move]:
    """The edges of some chains, sorted."""
    found = list_edges()
    return sorted((move for owner in owners for move in found[owner]), key=lambda m: m.slope)


def lay(start: Vertex, moves: Sequence[Move]) -> list[Point]:
    """Edges laid end to end."""
    path = [Point(Fraction(start[0]), Fraction(start[1]))]
    for move in moves:
        path.append(Point(path[-1].x + move.by[0], path[-1].y + move.by[1]))
    return path


def find_stations() -> list[Point]:
    """The path of the right end of G, from the left end of D_b on, by Lemma 3.1."""
    return lay(take_half(sweep_example()).directrix[0], sort_by_slope("D_b", "G_t"))


def write_slope(move: Move) -> str:
    """A slope, with a true minus sign."""
    return format_fraction(Fraction(move.slope)).replace("-", "\N{MINUS SIGN}")


def compute() -> PaperFigure:
    """Compute the figure."""
    s, path, order = sweep_example(), find_stations(), sort_by_slope("D_b", "G_t")
    half = take_half(s)
    facts: list[tuple[str, object]] = []
    laws: list[tuple[str, object, object]] = [
        ("trajectory", shift(trajectory_cc(half.top, half.directrix), s.reference), path)
    ]
    shapes: dict[str, Sequence[Any]] = list_loops(s)
    words: dict[str, Sequence[str]] = {}
    for step, letter in enumerate("abcd"):
        taken, done = order[step], order[:step]
        # The next edges of D_b and of reversed G_t, from the vertex of D_b that G's vertex is at.
        ours, theirs = (
            next(move for move in list_edges()[owner] if move not in done)
            for owner in ("D_b", "G_t")
        )
        x, y = lay(half.directrix[0], [move for move in done if move.owner == "D_b"])[-1]
        on_d = [(x, y), (x + ours.by[0], y + ours.by[1])]
        on_g = [(x, y), (x - theirs.by[0], y - theirs.by[1])]
        placed, moved = place(s, path[step : step + 2])
        facts.append(
            (
                f"({letter}) slopes ahead on D_b and on G_t",
                f"{ours.slope}, {theirs.slope}: {taken.owner} is next",
            )
        )
        first = min(ours, theirs, key=lambda move: move.slope)
        laws.append((f"edge taken in step {step}", taken, first))
        contacts = [c.event for c in s.contacts_at(path[step])]
        laws.append((f"contacts before step {step}", contacts, ["VV"]))
        shapes |= {
            f"{letter}_placed": placed,
            f"{letter}_moved": moved,
            f"{letter}_path": path[: step + 1],
            f"{letter}_met": [(x, y)],
            f"{letter}_edge": on_d if taken == ours else on_g,
            f"{letter}_middles": [find_middle(*on_d), find_middle(*on_g)],
        }
        words |= {f"{letter}_ours": [write_slope(ours)], f"{letter}_theirs": [write_slope(theirs)]}
    shapes["across"] = [(x, 0) for ring in place(s, path[: STEPS + 1]) for x, _ in ring]
    facts.append(("edges of the trajectory", len(path) - 1))
    return PaperFigure(facts, laws, shapes, words, [(s, path)])
