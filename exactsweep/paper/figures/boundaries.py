"""Figure 3: inner and outer boundary of the lower sweep."""

from __future__ import annotations

from exactsweep.numbers.number import Point, Vertex
from exactsweep.paper.figures.figure import PaperFigure, shift, take_half
from exactsweep.paper.figures.minkowski import sweep_example
from exactsweep.paper.functions import clip_to, keep_corners, take_bottom
from exactsweep.procedures.chain import complement, inverse
from exactsweep.procedures.mm import trajectory_mm
from exactsweep.procedures.monotone import LowerSweep


def _find_top_chain(half: LowerSweep) -> list[Vertex]:
    """The top chain of what G passes over in the lower sweep, from left to right.

    That is where I(G) runs along the other side of the trajectory (Lemma 5.3), beyond both ends
    of D, too.
    """
    inside = inverse(complement(list(half.trajectory)))
    return complement(inverse(list(trajectory_mm(half.top, inside))))


def compute() -> PaperFigure:
    """Compute the figure."""
    s = sweep_example()
    half = take_half(s)
    top, path = _find_top_chain(half), list(half.trajectory)
    start, stop = (Point(x + s.reference.x, y + s.reference.y) for x, y in (path[0], path[-1]))
    travelled = stop.x - start.x
    widths = sum(p.bounding_box[1].x - p.bounding_box[0].x for p in (s.generatrix, s.directrix))
    low = min(y for _, y in half.outer) - 3
    return PaperFigure(
        facts=[
            ("edges of the inner boundary", len(half.inner) - 1),
            ("edges of the outer boundary", len(half.outer) - 1),
            ("horizontal distance from start to stop", travelled),
        ],
        laws=[
            ("inner boundary", clip_to(top, half.directrix), keep_corners(half.inner)),
            ("bottom of the outer loop", take_bottom(s.outer.vertices), keep_corners(half.outer)),
            ("horizontal distance", travelled, widths),
            ("start", shift(half.top[:1], path[0]), half.directrix[:1]),
        ],
        shapes={"lower": half.outer, "upper": half.inner, "path": shift(path, s.reference)}
        | {"swept": [*half.outer, *reversed(top)], "ends": [start, stop]}
        | {"distance": [(start.x, low), (stop.x, low)]},
        words={"widths": [f"{travelled} = width of $G$ + width of $D$"]},
        sweeps=[(s, [start, stop])],
    )
