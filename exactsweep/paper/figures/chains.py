"""Figure 2: the monotone chains of a polygon."""

from fractions import Fraction
from itertools import pairwise

from exactsweep.corpus.generator.shapes import Ring
from exactsweep.geometry.polygon import Polygon
from exactsweep.paper.figures.figure import PaperFigure, find_middle, join_panels
from exactsweep.paper.figures.minkowski import DIRECTRIX, GENERATRIX
from exactsweep.paper.functions import sample_between
from exactsweep.procedures.chain import split

# D of Figure 1, and G of Figure 1 at twice its size.
POLYGONS = {"D": DIRECTRIX, "G": [(2 * x, 2 * y) for x, y in GENERATRIX]}


def compute() -> PaperFigure:
    return join_panels({letter: _show(letter, ring) for letter, ring in POLYGONS.items()})


def _show(letter: str, ring: Ring) -> PaperFigure:
    corners = Polygon(ring).vertices
    bottom, top = chains = split(corners)
    laws: list[tuple[str, object, object]] = [
        (f"vertices of {letter}", {*bottom, *top}, set(corners))
    ]
    for x in sample_between(corners):
        met = [
            sum(min(p[0], q[0]) < x < max(p[0], q[0]) for p, q in pairwise(chain))
            for chain in chains
        ]
        laws.append((f"edges of {letter}'s chains over x = {x}", met, [1, 1]))
    # Arrow heads in the middle of the edges, which run counter-clockwise.
    b_heads, t_heads = (
        [(find_middle(*e), find_middle(*e, share=Fraction(5, 8))) for e in pairwise(chain)]
        for chain in chains
    )
    return PaperFigure(
        facts=[(f"edges of {letter}_b", len(bottom) - 1), (f"edges of {letter}_t", len(top) - 1)],
        laws=laws,
        shapes={"ring": ring, "b": bottom, "t": top, "b_heads": b_heads, "t_heads": t_heads},
    )
