"""Figure 8: the inverse generatrix retraces both loops from the two sides of the trajectory."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Rational, Vertex
from exactsweep.paper.figures.figure import PaperFigure, list_loops, shift
from exactsweep.paper.figures.minkowski import invert_generatrix, sweep_example
from exactsweep.paper.functions import evaluate
from exactsweep.procedures.chain import complement, split
from exactsweep.sweep import no_fit_polygon


def _find_least_gap(ring: Sequence[Vertex], around: Polygon) -> Fraction:
    """The least vertical gap of a polygon in another one; below 0 if it sticks out sideways.

    Both are X-monotone.
    """
    chains = [split(ring), split(around.vertices)]
    (low, high), (floor, ceiling) = [(bottom, complement(top)) for bottom, top in chains]
    xs = {x for chain in (low, high, floor, ceiling) for x, _ in chain if not _beside(x, low)}
    if any(_beside(x, floor) for x in xs):
        return Fraction(-1)
    gaps = [evaluate(low, x) - evaluate(floor, x) for x in map(Fraction, xs)]
    return min(gaps + [evaluate(ceiling, x) - evaluate(high, x) for x in map(Fraction, xs)])


def _beside(x: Rational, chain: Sequence[Vertex]) -> bool:
    return not chain[0][0] <= x <= chain[-1][0]


def compute() -> PaperFigure:
    """Compute the figure."""
    s = sweep_example()
    inverted = invert_generatrix(s)
    outside = no_fit_polygon(s.trajectory, inverted).exterior
    # I(G) is drawn at vertices of the loop that it retraces.
    places = {
        "a": [s.inner.vertices[k] for k in (0, 2, 4, 7)],
        "b": [s.outer.vertices[k] for k in (0, 4, 12, 20)],
    }
    return PaperFigure(
        facts=[
            ("edges of the trajectory", len(s.trajectory)),
            ("edges of the inner loop, retraced inside", len(s.inner)),
            ("edges of the outer loop, retraced outside", len(s.outer)),
        ],
        laws=[
            ("the loop outside is the outer one", outside == s.outer, True),
            *(
                (
                    f"least gap above and below I(G) at ({x}, {y})",
                    _find_least_gap(shift(inverted.vertices, (x, y)), s.trajectory),
                    0,
                )
                for x, y in s.inner.vertices
            ),
        ],
        shapes=list_loops(s)
        | {f"{letter}_places": found for letter, found in places.items()}
        | {
            f"{letter}_turned": [shift(inverted.vertices, p) for p in found]
            for letter, found in places.items()
        }
        | {"widest": [shift(inverted.vertices, p) for p in places["b"]]},
        sweeps=[(s, [])],
    )
