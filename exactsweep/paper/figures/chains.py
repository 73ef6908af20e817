"""Figure 2: the monotone chains of a polygon."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import Any

from exactsweep.geometry.polygon import Polygon
from exactsweep.paper.figures.figure import PaperFigure, find_middle
from exactsweep.paper.figures.minkowski import DIRECTRIX, GENERATRIX
from exactsweep.paper.functions import sample_between
from exactsweep.procedures.chain import split

# D of Figure 1, and its G twice as large.
POLYGONS = {"D": DIRECTRIX, "G": [(2 * x, 2 * y) for x, y in GENERATRIX]}


def compute() -> PaperFigure:
    """Compute the figure."""
    facts: list[tuple[str, object]] = []
    laws: list[tuple[str, object, object]] = []
    shapes: dict[str, Sequence[Any]] = {}
    for letter, ring in POLYGONS.items():
        corners = Polygon(ring).vertices
        chains = split(corners)
        shapes[f"{letter}_ring"] = ring
        for name, chain in zip("bt", chains, strict=True):
            facts.append((f"edges of {letter}_{name}", len(chain) - 1))
            shapes[f"{letter}_{name}"] = chain
            # Arrow heads in the middle of the edges, which run counter-clockwise.
            shapes[f"{letter}_{name}_heads"] = [
                (find_middle(p, q), find_middle(p, q, share=Fraction(5, 8)))
                for p, q in pairwise(chain)
            ]
        laws.append((f"vertices of {letter}", {*chains[0], *chains[1]}, set(corners)))
        for x in sample_between(corners):
            met = [
                sum(min(p[0], q[0]) < x < max(p[0], q[0]) for p, q in pairwise(chain))
                for chain in chains
            ]
            laws.append((f"edges of {letter}'s chains over x = {x}", met, [1, 1]))
    return PaperFigure(facts, laws, shapes)
