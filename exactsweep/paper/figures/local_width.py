"""Figure 9: the distance between the two loops across an edge of the trajectory."""

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.check import point_in_polygon
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import Point, Vertex, find_root
from exactsweep.paper.checks.section5 import NARROW
from exactsweep.paper.figures.figure import PaperFigure, find_middle, join_panels, shift
from exactsweep.paper.figures.minkowski import invert_generatrix, sweep_example
from exactsweep.paper.functions import evaluate, take_bottom
from exactsweep.sweep import Sweep, sweep

THIRD = Fraction(1, 3)
NINTHS = (Fraction(-1, 9), Fraction(0), Fraction(1, 9))


class Widths(NamedTuple):
    """An edge e of the trajectory, its unit vector, and the distances of Figure 9.

    I(G) touches e `at` a point from both sides. `inside` and `outside` are the positions of I(g),
    `inner` and `outer` their distances d' and d'' from e; `width` is the width of G across e.
    """

    sweep: Sweep
    length: Fraction
    direction: Vertex
    at: Point
    inside: Point
    outside: Point
    inner: Fraction
    outer: Fraction
    width: Fraction

    def go(self, start: Vertex, along: Fraction, across: Fraction = Fraction(0)) -> Point:
        """Return the point at given distances from `start` along e and to the left of e."""
        dx, dy = self.direction
        return Point(start[0] + along * dx - across * dy, start[1] + along * dy + across * dx)

    def invert_at(self, p: Vertex) -> list[Vertex]:
        return shift(invert_generatrix(self.sweep).vertices, p)

    def find_foot(self, p: Point) -> Point:
        (dx, dy), (x, y) = self.direction, self.at
        return self.go(self.at, Fraction((p.x - x) * dx + (p.y - y) * dy))


def _measure(s: Sweep) -> Iterator[Widths]:
    """Yield both widths, where they exist, at the midpoints of lower edges of rational length."""
    corners = invert_generatrix(s).vertices
    for p, q in pairwise(s.trajectory.vertices):
        length = find_root((q.x - p.x) ** 2 + (q.y - p.y) ** 2)
        if q.x <= p.x or length is None:
            continue
        dx, dy = (q.x - p.x) / length, (q.y - p.y) / length
        at = find_middle(p, q)
        heights = {Point(at.x - w.x, at.y - w.y): dx * w.y - dy * w.x for w in corners}
        inside, outside = (
            next((place for place in heights if point_in_polygon(place, loop) == 0), None)
            for loop in (s.inner, s.outer)
        )
        if inside and outside:
            own = [dx * w.y - dy * w.x for w in s.generatrix.vertices]
            wide, ends = max(own) - min(own), (inside, outside)
            yield Widths(s, length, (dx, dy), at, *ends, -heights[inside], heights[outside], wide)


def measure_widths() -> tuple[Widths, Widths]:
    g, d = ([(x * THIRD, y * THIRD) for x, y in ring] for ring in NARROW)
    return (
        max(_measure(sweep_example()), key=lambda found: found.length),
        next(one for one in _measure(sweep(g, d)) if one.inner + one.outer < one.width),
    )


def _show(letter: str, found: Widths, across: Sequence[Point], share: Fraction) -> PaperFigure:
    s = found.sweep
    distances = {"d'": found.inner, "d''": found.outer, "d": found.width}
    laws = []
    for loop, p in ((s.inner, found.inside), (s.outer, found.outside)):
        for on_e in (found.go(p, by * found.length) for by in NINTHS):
            height = evaluate(take_bottom(loop.vertices), on_e.x)
            laws.append((f"height over {on_e.x}", height, on_e.y))
    written = [[f"${name} = {format_fraction(value)}$"] for name, value in distances.items()]
    return PaperFigure(
        facts=[(f"({letter}) {name}", value) for name, value in distances.items()],
        laws=laws,
        shapes={
            "placed": [found.invert_at(p) for p in (found.inside, found.outside)],
            "at": found.at,
        }
        | {"inside": found.inside, "near": [found.inside, found.find_foot(found.inside)]}
        | {"outside": found.outside, "far": [found.outside, found.find_foot(found.outside)]}
        | {"across": across, "measure": find_middle(*across, share=share)},
        words=dict(zip(("inner", "outer", "width"), written, strict=True)),
        sweeps=[(s, [])],
    )


def compute() -> PaperFigure:
    first, near = measure_widths()
    whole = PaperFigure(
        laws=[
            ("(a) d' + d''", first.inner + first.outer, first.width),
            ("(b) d' + d'', d", (near.inner + near.outer, near.width), (11 * THIRD, 16 * THIRD)),
        ]
    )
    foot = first.go(first.at, Fraction(-14, 5))
    across = [first.go(foot, Fraction(0), by) for by in (first.inner, -first.outer)]
    x, high = near.at.x - 4, Fraction(max(y for _, y in near.invert_at(near.outside)))
    upright = [Point(x, high), Point(x, high - near.width)]
    shown = _show("a", first, across, Fraction(3, 4)), _show("b", near, upright, Fraction(2, 3))
    return join_panels({"": whole, "a": shown[0], "b": shown[1]})
