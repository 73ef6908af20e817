"""Figure 9: how far the two loops are apart along an edge of the trajectory."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from math import isqrt
from typing import Any, NamedTuple

from exactsweep.check import point_in_polygon
from exactsweep.numbers.number import format_fraction
from exactsweep.numbers.point import Point, Vertex
from exactsweep.paper.checks.section5 import NARROW
from exactsweep.paper.figures.figure import PaperFigure, find_middle, list_loops, shift
from exactsweep.paper.figures.minkowski import invert_generatrix, sweep_example
from exactsweep.paper.functions import evaluate, take_bottom
from exactsweep.sweep import Sweep, sweep

THIRD = Fraction(1, 3)
NINTHS = (Fraction(-1, 9), Fraction(0), Fraction(1, 9))


class Widths(NamedTuple):
    """The edge e of the trajectory, a point of it, and the distances of Figure 9.

    Attributes:
        sweep: whose trajectory it is.
        length: the length of e.
        direction: the unit vector of e.
        at: where I(G) touches e from both sides.
        inside: I(g) when I(G) is on the inner side of e.
        outside: I(g) on the outer side.
        inner, outer: their distances from e, d' and d''.
        width: of G, orthogonally to e.
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
        """A point by its distances from another one, along e and to the left of e."""
        dx, dy = self.direction
        return Point(start[0] + along * dx - across * dy, start[1] + along * dy + across * dx)

    def find_foot(self, p: Point) -> Point:
        """The foot of the perpendicular from a point to e."""
        (dx, dy), (x, y) = self.direction, self.at
        return self.go(self.at, Fraction((p.x - x) * dx + (p.y - y) * dy))


def _measure(s: Sweep) -> Iterator[Widths]:
    """Measure at the middles of the edges of the lower half that have a rational length.

    An edge is left out where no vertex of I(G) is on a loop, from the inside or the outside.
    """
    turned = invert_generatrix(s).vertices
    for p, q in pairwise(s.trajectory.vertices):
        square = (q.x - p.x) ** 2 + (q.y - p.y) ** 2
        length = Fraction(isqrt(square.numerator), isqrt(square.denominator))
        if q.x <= p.x or length**2 != square:
            continue
        dx, dy = (q.x - p.x) / length, (q.y - p.y) / length
        at = find_middle(p, q)
        heights = {Point(at.x - w.x, at.y - w.y): dx * w.y - dy * w.x for w in turned}
        inside, outside = (
            next((place for place in heights if point_in_polygon(place, loop) == 0), None)
            for loop in (s.inner, s.outer)
        )
        if inside and outside:
            own = [dx * w.y - dy * w.x for w in s.generatrix.vertices]
            wide, ends = max(own) - min(own), (inside, outside)
            yield Widths(s, length, (dx, dy), at, *ends, -heights[inside], heights[outside], wide)


def measure_widths() -> tuple[Widths, Widths]:
    """At the longest such edge of Figure 1's pair; and of a pair that refutes the statement."""
    g, d = ([(x * THIRD, y * THIRD) for x, y in ring] for ring in NARROW)
    return (
        max(_measure(sweep_example()), key=lambda found: found.length),
        next(one for one in _measure(sweep(g, d)) if one.inner + one.outer < one.width),
    )


def _equal(letters: str, value: Fraction) -> list[str]:
    return [f"${letters} = {format_fraction(value)}$"]


def compute() -> PaperFigure:
    """Compute the figure."""
    first, near = measure_widths()
    facts: list[tuple[str, object]] = []
    laws: list[tuple[str, object, object]] = [
        ("(a) d' + d''", first.inner + first.outer, first.width),
        ("(b) d' + d'', d", (near.inner + near.outer, near.width), (11 * THIRD, 16 * THIRD)),
    ]
    shapes: dict[str, Sequence[Any]] = {}
    words: dict[str, Sequence[str]] = {}
    for letter, found in (("a", first), ("b", near)):
        s = found.sweep
        turned = invert_generatrix(s).vertices
        placed = [shift(turned, p) for p in (found.inside, found.outside)]
        facts += [
            (f"({letter}) {name}", value)
            for name, value in (("d'", found.inner), ("d''", found.outer), ("d", found.width))
        ]
        for loop, p in ((s.inner, found.inside), (s.outer, found.outside)):
            for by in NINTHS:
                on_e = found.go(p, by * found.length)
                height = evaluate(take_bottom(loop.vertices), on_e.x)
                laws.append((f"height over {on_e.x}", height, on_e.y))
        if letter == "a":
            foot = found.go(found.at, Fraction(-14, 5))
            across = [found.go(foot, Fraction(0), by) for by in (found.inner, -found.outer)]
            share = Fraction(3, 4)
        else:
            x, high = found.at.x - 4, Fraction(max(y for _, y in placed[1]))
            across = [Point(x, high), Point(x, high - found.width)]
            share = Fraction(2, 3)
        shapes |= list_loops(s, f"{letter}_") | {
            f"{letter}_placed": placed,
            f"{letter}_at": found.at,
            f"{letter}_inside": found.inside,
            f"{letter}_outside": found.outside,
            f"{letter}_near": [found.inside, found.find_foot(found.inside)],
            f"{letter}_far": [found.outside, found.find_foot(found.outside)],
            f"{letter}_across": across,
            f"{letter}_beside": find_middle(*across, share=share),
        }
        words |= {
            f"{letter}_inner": _equal("d'", found.inner),
            f"{letter}_outer": _equal("d''", found.outer),
            f"{letter}_width": _equal("d", found.width),
        }
    return PaperFigure(facts, laws, shapes, words, [(first.sweep, []), (near.sweep, [])])
