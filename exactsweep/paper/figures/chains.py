"""Figure 2: the monotone chains of a polygon."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise
from typing import TYPE_CHECKING

from exactsweep.canvas import style
from exactsweep.canvas.style import Look
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Vertex
from exactsweep.paper.figures.figure import Facts, differ
from exactsweep.paper.figures.minkowski import DIRECTRIX, GENERATRIX
from exactsweep.paper.figures.sheet import (
    COLUMN,
    PLACED,
    BarePicture,
    Extent,
    Margins,
    Sheet,
    find_middle,
)
from exactsweep.paper.functions import sample_between
from exactsweep.procedures.chain import split

if TYPE_CHECKING:
    from matplotlib.figure import Figure

BOTTOM = Look(style.BLUE, 2.0, order=5)
TOP = Look(style.RED, 2.0, dash=(0, (4, 1.2)), order=5)
# D of Figure 1, and its G twice as large.
POLYGONS = {"D": DIRECTRIX, "G": [(2 * x, 2 * y) for x, y in GENERATRIX]}


def _chains() -> dict[str, list[Vertex]]:
    """The chains of both polygons by name, D_b, D_t, G_b and G_t."""
    found = {}
    for letter, ring in POLYGONS.items():
        found[f"{letter}_b"], found[f"{letter}_t"] = split(Polygon(ring).vertices)
    return found


def list_facts() -> Facts:
    """List the figure's statements."""
    return [(f"edges of {name}", str(len(chain) - 1)) for name, chain in _chains().items()]


def find_failures() -> Iterator[str]:
    """List the statements that fail."""
    chains = _chains()
    for letter, ring in POLYGONS.items():
        corners = Polygon(ring).vertices
        bottom, top = chains[f"{letter}_b"], chains[f"{letter}_t"]
        yield differ(f"vertices of {letter}", {*bottom, *top}, set(corners))
        for x in sample_between(corners):
            met = [
                sum(min(p[0], q[0]) < x < max(p[0], q[0]) for p, q in pairwise(chain))
                for chain in (bottom, top)
            ]
            yield differ(f"edges of {letter}'s chains over x = {x}", met, [1, 1])


def draw() -> Figure:
    """The picture."""
    rings = list(POLYGONS.values())
    margins = Margins(15, 10, 17, 8)
    boxes = [Extent.around(ring, margins=margins) for ring in rings]
    chains = _chains()
    with Sheet([boxes], COLUMN) as sheet:
        for panel, (letter, ring) in zip(sheet.panels, POLYGONS.items(), strict=True):
            look = style.DIRECTRIX if letter == "D" else PLACED
            panel.area(ring, replace(look, width=0))
            bottom, top = chains[f"{letter}_b"], chains[f"{letter}_t"]
            panel.line(bottom, BOTTOM)
            panel.line(top, TOP)
            _heads(panel, bottom, BOTTOM)
            _heads(panel, top, TOP)
            panel.dots([bottom[0], bottom[-1]])
            panel.label(bottom[0], f"$v_l^{letter}$", -10)
            panel.label(bottom[-1], f"$v_r^{letter}$", 10)
        d, g = sheet.panels
        d.label((8, 7), "$D$")
        d.label((15, 1), "$D_b$", 6, -4)
        d.label((5, 10), "$D_t$", -4, 5)
        g.label((4, 4), "$G$")
        g.label((4, 2), "$G_b$", 0, -9)
        g.label((4, 6), "$G_t$", 0, 8)
    return sheet.figure


def _heads(panel: BarePicture, chain: Sequence[Vertex], look: Look) -> None:
    """Arrow heads in the middle of the edges, which run counter-clockwise."""
    for p, q in pairwise(chain):
        panel.arrow(
            find_middle(p, q), find_middle(p, q, share=Fraction(5, 8)), replace(look, dash="-")
        )
