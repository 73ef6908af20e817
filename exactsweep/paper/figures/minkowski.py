"""Figure 1: the sweep of G around D, and the Minkowski sum of G and D's boundary."""

from __future__ import annotations

from fractions import Fraction

from exactsweep.check import classify
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import Point
from exactsweep.paper.figures.figure import PaperFigure, place
from exactsweep.paper.functions import explain_unproved
from exactsweep.sweep import Sweep, inner_fit_polygon, no_fit_polygon, sweep

GENERATRIX = [(0, 0), (2, 1), (4, 0), (3, 3), (1, 3)]
DIRECTRIX = [(0, 5), (4, 0), (8, 4), (12, -1), (20, 5), (17, 10), (11, 6), (8, 11), (3, 9)]
# Positions of G in panel (b), with the reference point on two vertices and two edges of D.
ALONG = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 5), (12, -1), (16, 2), (11, 6)]]


def sweep_example() -> Sweep:
    """Compute the sweep of Figures 1 and 8."""
    return sweep(GENERATRIX, DIRECTRIX, reference=(2, 1))


def invert_generatrix(s: Sweep) -> Polygon:
    """Return I(G), with its reference point at the origin."""
    return s.generatrix.exterior.translated((-s.reference.x, -s.reference.y)).reflected()


def compute() -> PaperFigure:
    """Compute the figure.

    The sum of D and G is the no-fit polygon of D and I(G). The sum of D's boundary and G excludes
    the points p such that p + I(G) lies in the interior of D.
    """
    s = sweep_example()
    inverted = invert_generatrix(s)
    around = no_fit_polygon(s.directrix, inverted)
    inside = inner_fit_polygon(s.directrix, inverted)
    outer = around.exterior.vertices
    holes = [region.exterior.vertices for region in inside.regions]
    met = [classify(s.directrix, ring, (0, 0)).verdict for ring in place(s, ALONG)]
    # G is drawn at a corner, and where it closes the upper undercut.
    positions = [s.trajectory.vertices[6], s.undercuts[-1].positions[0]]
    return PaperFigure(
        facts=[
            ("class of the sweep", s.kind),
            ("edges of the trajectory", len(s.trajectory)),
            ("edges of the inner and the outer loop", f"{len(s.inner)}, {len(s.outer)}"),
            ("undercuts", len(s.undercuts)),
            ("positions in (b) at which G overlaps D", f"{met.count('OVERLAP')} of {len(met)}"),
            ("holes of the sum", len(holes)),
        ],
        laws=[
            ("boundary of the sum", explain_unproved(around), ""),
            ("holes of the sum", explain_unproved(inside), ""),
        ],
        shapes={"sum": outer, "holes": holes, "positions": positions}
        | {"b_positions": ALONG, "b_placed": place(s, ALONG)},
        sweeps=[(s, positions)],
    )
