"""Figure 8: the inverse generatrix retraces both loops from the two sides of the trajectory."""

from __future__ import annotations

from exactsweep.check import classify
from exactsweep.paper.figures.figure import PaperFigure, join_panels, shift
from exactsweep.paper.figures.minkowski import invert_generatrix, sweep_example
from exactsweep.paper.functions import frame_around
from exactsweep.sweep import no_fit_polygon


def compute() -> PaperFigure:
    s = sweep_example()
    inverted = invert_generatrix(s)
    outside = no_fit_polygon(s.trajectory, inverted).exterior
    # I(G) is drawn at these vertices of the loop that it retraces.
    places = {
        "a": [s.inner.vertices[k] for k in (0, 2, 4, 7)],
        "b": [s.outer.vertices[k] for k in (0, 4, 12, 20)],
    }
    turned = {
        letter: [shift(inverted.vertices, p) for p in found] for letter, found in places.items()
    }
    beyond = frame_around(s.trajectory, inverted)
    inside = [classify(beyond, inverted, p).verdict for p in s.inner.vertices]
    whole = PaperFigure(
        facts=[
            ("edges of the trajectory", len(s.trajectory)),
            ("edges of the inner loop, retraced inside", len(s.inner)),
            ("edges of the outer loop, retraced outside", len(s.outer)),
        ],
        laws=[
            ("the loop outside is the outer one", outside == s.outer, True),
            ("verdicts on I(G) and the exterior at the inner vertices", {*inside}, {"CONTACT"}),
        ],
        shapes={"widest": turned["b"]},
        sweeps=[(s, [])],
    )
    drawn = {k: PaperFigure(shapes={"places": places[k], "turned": turned[k]}) for k in "ab"}
    return join_panels({"": whole} | drawn)
