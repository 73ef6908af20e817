"""An additional figure: the undercuts between two needles of the family of ceilings."""

from fractions import Fraction

from exactsweep.corpus.generator.growing import ceilings, undercuts_under_ceilings
from exactsweep.numbers.number import Point
from exactsweep.paper.figures.figure import PaperFigure, write_list
from exactsweep.paper.functions import lower_undercuts
from exactsweep.sweep import sweep

M, N = 7, 8
CEILING = 8
# With G at PLACE, the left needle, whose tip is the origin, is in the first inner valley of G_t.
PLACE = Point(Fraction(-9), Fraction(0))


def compute() -> PaperFigure:
    s = sweep(*ceilings(M, N))
    lower = sorted(lower_undercuts(s), key=lambda u: u.bottom[0])
    # The points between two undercuts, at which G touches the ceiling.
    touched = [undercut.bottom[-1] for undercut in lower[:-1]]
    return PaperFigure(
        facts=[
            ("(m, n)", f"({M}, {N})"),
            ("undercuts between the needles", len(lower)),
            ("places where G touches the ceiling", len(touched)),
            ("their x", write_list(p.x for p in touched)),
        ],
        laws=[
            ("undercuts", len(lower), undercuts_under_ceilings(M, N)),
            ("heights of the places", {p.y for p in touched}, {CEILING}),
        ],
        shapes={"undercuts": [u.polygon.vertices for u in lower], "touched": touched},
        sweeps=[(s, [PLACE])],
    )
