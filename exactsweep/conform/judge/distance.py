"""The maximum distance from a vertex of one loop to the other loop."""

from __future__ import annotations

from fractions import Fraction
from itertools import chain
from math import lcm

from exactsweep.geometry.distance import measure_to_edge
from exactsweep.numbers.number import PointRings, Rational


def measure_distance(first: PointRings, second: PointRings) -> Fraction:
    """Return the greatest squared distance of a vertex from the boundary of the other rings.

    It is symmetric, 0 for equal loops, and at most the square of the Hausdorff distance. Both loops
    must have vertices.

    Cost: O(m n) at worst; linear in the vertices that both loops have.

    Example:
        >>> from exactsweep import Point
        >>> square = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (4, 0), (4, 4), (0, 4)]]
        >>> dented = [*square[:3], Point(Fraction(2), Fraction(3)), square[3]]
        >>> measure_distance([square], [dented])
        Fraction(1, 1)
    """
    scale = lcm(*(c.denominator for c in chain.from_iterable(chain(*first, *second))))
    one, other = (
        [[(int(x * scale), int(y * scale)) for x, y in ring] for ring in rings]
        for rings in (first, second)
    )
    n: Rational = 0
    d: Rational = 1
    for rings, target in ((one, other), (other, one)):
        edges = [(ring[k - 1], p) for ring in target for k, p in enumerate(ring)]
        for p in {*chain(*rings)}.difference(*target):
            least, unit = measure_to_edge(p, edges[0])
            for edge in edges:
                found = measure_to_edge(p, edge)
                if found[0] * unit < least * found[1]:
                    least, unit = found
                if least * d <= n * unit:
                    break
            else:
                n, d = least, unit
    return Fraction(n, d * scale * scale)
