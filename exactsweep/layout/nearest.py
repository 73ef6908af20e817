"""The minimum distance between two solids that do not overlap.

Two disjoint segments are nearest at an end of one of them, so their squared distance is a quotient
of two ints.
"""

from __future__ import annotations

from fractions import Fraction
from math import isqrt

from exactsweep.geometry.distance import SquaredDistance, find_nearest_ends, measure_ends
from exactsweep.geometry.edges import BoxedEdge
from exactsweep.geometry.vectors import minus, orientation, touch
from exactsweep.layout.solid import LatticeForm, Solid
from exactsweep.numbers.number import Edge, Point, Rational


def find_gap(a: Solid, b: Solid, below: Fraction) -> SquaredDistance | None:
    """Find the squared distance of disjoint polygonal solids on one lattice, if below a bound."""
    assert isinstance(a.form, LatticeForm)
    assert isinstance(b.form, LatticeForm)
    scale = a.scale
    bound = below * scale * scale
    n: Rational = bound.numerator
    d: Rational = bound.denominator
    reach = isqrt(n // d) + 1
    x, y = b.x - a.x, b.y - a.y
    left, right, low, high = a.form.box
    west, east, south, north = b.form.box
    ours = a.form.near((west + x - reach, east + x + reach, south + y - reach, north + y + reach))
    around = (left - x - reach, right - x + reach, low - y - reach, high - y + reach)
    theirs = b.form.near(around) if ours else []
    best: tuple[BoxedEdge, BoxedEdge] | None = None
    for e in theirs:
        left, right, low, high = e[0] + x, e[1] + x, e[2] + y, e[3] + y
        farthest, nearest = right + reach, left - reach
        other = _move(e, x, y)
        for f in ours:
            if f[0] > farthest:
                break
            if f[1] < nearest:
                continue
            across = left - f[1] if left > f[1] else f[0] - right if f[0] > right else 0
            up = low - f[3] if low > f[3] else f[2] - high if f[2] > high else 0
            if (across * across + up * up) * d >= n:
                continue
            one = (f[4], f[5]), (f[6], f[7])
            if _is_far(one, other, n, d) or _is_far(other, one, n, d):
                continue
            square, length = measure_ends(one, other)[:2] if touch(*one, *other) == [] else (0, 1)
            if square * d < n * length:
                n, d, best = square, length, (f, e)
                reach = isqrt(n // d) + 1
                farthest, nearest = right + reach, left - reach
    if best is None:
        return None
    one, other = _move(best[0], 0, 0), _move(best[1], x, y)
    if n:
        p, q = find_nearest_ends(one, other)
    else:
        # Solids that touch without overlap share a vertex of one of them.
        p = q = Point(*map(Fraction, (touch(*one, *other) or [one[0]])[0]))
    return SquaredDistance(
        Fraction(n, d * scale * scale) if type(n) is int else Fraction(n) / d / scale**2,
        (a.leave(p[0] + a.x, p[1] + a.y), a.leave(q[0] + a.x, q[1] + a.y)),
    )


def _move(edge: BoxedEdge, x: int, y: int) -> Edge:
    return (edge[4] + x, edge[5] + y), (edge[6] + x, edge[7] + y)


def _is_far(line: Edge, edge: Edge, n: Rational, d: Rational) -> bool:
    """Return whether an edge is at least sqrt(n / d) away from the line of another one."""
    of_p, of_q = (orientation(*line, end) for end in edge)
    least = min(of_p, of_q) if of_p > 0 else -max(of_p, of_q)
    dx, dy = minus(*line)
    return least > 0 and least * least * d >= n * (dx * dx + dy * dy)
