"""Figure 3: inner and outer boundary of the lower sweep."""

from __future__ import annotations

from exactsweep.numbers.number import Point
from exactsweep.paper.figures.figure import PaperFigure, shift, take_half
from exactsweep.paper.figures.minkowski import sweep_example
from exactsweep.paper.functions import clip_to, keep_corners, take_bottom
from exactsweep.paper.kernel import find_inner, find_trajectory, sweep_mm


def compute() -> PaperFigure:
    s = sweep_example()
    half = take_half(s)
    # As defined, the inner boundary is the top chain of the area covered in the lower sweep, which
    # extends beyond both ends of D.
    top, path = find_inner(half), find_trajectory(half)
    inner, outer = sweep_mm(*half)
    start, stop = (Point(x + s.reference.x, y + s.reference.y) for x, y in (path[0], path[-1]))
    travelled = stop.x - start.x
    widths = sum(p.bounding_box[1].x - p.bounding_box[0].x for p in (s.generatrix, s.directrix))
    low = min(y for _, y in outer) - 3
    return PaperFigure(
        facts=[
            ("edges of the inner boundary", len(inner) - 1),
            ("edges of the outer boundary", len(outer) - 1),
            ("horizontal distance from start to stop", travelled),
        ],
        laws=[
            ("inner boundary", clip_to(top, half.directrix), keep_corners(inner)),
            ("bottom of the outer loop", take_bottom(s.outer.vertices), keep_corners(outer)),
            ("horizontal distance", travelled, widths),
            ("start", shift(half.top[:1], path[0]), half.directrix[:1]),
        ],
        shapes={"lower": outer, "upper": inner, "path": shift(path, s.reference)}
        | {"swept": [*outer, *reversed(top)], "ends": [start, stop]}
        | {"distance": [(start.x, low), (stop.x, low)]},
        words={"widths": [f"{travelled} = width of $G$ + width of $D$"]},
        sweeps=[(s, [start, stop])],
    )
