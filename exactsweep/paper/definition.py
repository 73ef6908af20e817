"""The sweep by its definition: minima and maxima straight from the input.

In a frame whose x-axis is the direction of monotonicity, with D_b the bottom of D and G_b, G_t the
bottom and top of G as functions of x, the lower halves of the three loops are

    trajectory   T(x) = min over a of D_b(a) - G_t(a - x)
    outer loop   S(x) = min over u of T(u) + G_b(x - u)
    inner loop   R(x) = max over u of T(u) + G_t(x - u), for x in D's x-range only

(Definitions 1.1 to 1.3, Theorems 2.1 and 2.2, Lemma 5.3 as far as it holds); the upper halves are
their mirror images. Here they are evaluated on every open interval between sums of breakpoints, as
a reference for the procedures of the paper.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import pairwise
from math import lcm
from typing import Any, NamedTuple

from exactsweep.geometry.canonical import canonicalize_ring
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.error import ExactSweepError, tells_arguments
from exactsweep.numbers.number import (
    Edge,
    Fit,
    Loop,
    Point,
    Rational,
    Vertex,
    divide_exactly,
    to_fraction,
)
from exactsweep.paper.piecewise import (
    LinearPiece,
    PiecewiseLinear,
    list_ends,
    mirror,
    take_least_sum,
)


class ReferenceLoops(NamedTuple):
    """The three loops of a sweep, each a tuple of Point in canonical order."""

    trajectory: tuple[Point, ...]
    inner: tuple[Point, ...]
    outer: tuple[Point, ...]


@tells_arguments
def reference_loops(
    generatrix: Any, directrix: Any, direction: tuple[Any, Any] = (1, 0)
) -> ReferenceLoops:
    """Evaluate trajectory, inner loop and outer loop of the sweep (G, D) from the definition.

    Args:
        generatrix: G, a Polygon or its vertices, m edges.
        directrix: D, likewise, n edges.
        direction: a pair of rationals, not both zero, to which both are weakly monotone.

    Returns:
        ReferenceLoops of canonical tuples of Point.

    Raises:
        ValueError: a polygon is not monotone to the direction, or the direction is zero.

    Cost: mn intervals of m + n candidates for a trajectory of k edges, then km of k + m.

    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> [(str(x), str(y)) for x, y in reference_loops(square, square).trajectory]
    [('-1', '-1'), ('1', '-1'), ('1', '1'), ('-1', '1')]
    """
    frame = _IntegerFrame(direction, Polygon(generatrix), Polygon(directrix))
    (g_bottom, g_top), (d_bottom, d_top) = frame.generatrix, frame.directrix
    lower = _lower_halves(d_bottom, g_bottom, g_top)
    mirrored = _lower_halves(mirror(d_top), mirror(g_top), mirror(g_bottom))
    halves = zip(lower, map(mirror, mirrored), strict=True)
    return ReferenceLoops(*(frame.loop(bottom, top) for bottom, top in halves))


@tells_arguments
def reference_exact_fits(
    generatrix: Any, directrix: Any, direction: tuple[Any, Any] = (1, 0)
) -> tuple[Fit, ...]:
    """List the exact fits of the sweep (G, D) from Definition 1.1: contact, disjoint interiors.

    At a difference x0 of vertex abscissas, G slides up from the lower trajectory as far as D_b
    stays above G_t on the open common x-range of D and G + (x0, 0); all beyond both one-sided
    limits of T there is a fit. Fits seen from above are the mirror image.

    Every fit is a segment of positive length. If interiors are disjoint over a shared open
    interval, then G lies either below D or above D on all of it, since the cross-sections left and
    right of any x have a common interior point in each polygon. From below the set of heights is
    half-open, (T, limit].

    Arguments and errors are those of `reference_loops`.

    Returns:
        tuple of pairs of Point, sorted: the end that hangs on the trajectory, the inner end.

    Cost: mn abscissas of m + n + k steps each, k the edges of the trajectory.

    >>> slot = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> [[tuple(map(str, p)) for p in fit] for fit in reference_exact_fits(square, slot)]
    [[('1', '3'), ('1', '1')]]
    """
    frame = _IntegerFrame(direction, Polygon(generatrix), Polygon(directrix))
    (g_bottom, g_top), (d_bottom, d_top) = frame.generatrix, frame.directrix
    below = _fits_from_below(d_bottom, g_top)
    above = _fits_from_below(mirror(d_top), mirror(g_bottom))
    fits = [((x, t), (x, end)) for x, t, end in below]
    fits += [((x, -t), (x, -end)) for x, t, end in above]
    return tuple(sorted(map(frame.segment, fits)))


class _IntegerFrame:
    """Coordinates along a direction u and its left normal: the matrix [u; u_perp] and back.

    Attributes:
        generatrix: bottom and top of G as functions of x, on integers.
        directrix: those of D.
    """

    def __init__(self, direction: tuple[Any, Any], generatrix: Polygon, directrix: Polygon) -> None:
        ux, uy = map(to_fraction, direction)
        if ux == uy == 0:
            raise ExactSweepError("the direction (0, 0) is no direction")
        unit = lcm(ux.denominator, uy.denominator)
        self._ux, self._uy = int(ux * unit), int(uy * unit)
        loops = generatrix.vertices, directrix.vertices
        self._scale = lcm(*(c.denominator for loop in loops for p in loop for c in p))
        self.generatrix = self._halves(generatrix.vertices, "generatrix")
        self.directrix = self._halves(directrix.vertices, "directrix")

    def _halves(self, ring: Loop, name: str) -> tuple[PiecewiseLinear, PiecewiseLinear]:
        points = [(int(self._scale * x), int(self._scale * y)) for x, y in ring]
        turned = [(self._ux * x + self._uy * y, self._ux * y - self._uy * x) for x, y in points]
        # Counter-clockwise: the bottom runs to the right and the top to the left. Edges that do
        # neither are vertical; they are the jumps of the functions and need no piece.
        edges = list(zip(turned, turned[1:] + turned[:1], strict=True))
        bottom = sorted(LinearPiece(*p, *q) for p, q in edges if p[0] < q[0])
        top = sorted(LinearPiece(*q, *p) for p, q in edges if p[0] > q[0])
        # Monotone is: bottom and top each cover the range of x once.
        if any(p.x1 != q.x0 for half in (bottom, top) for p, q in pairwise(half)):
            raise ExactSweepError(f"the {name} is not monotone to ({self._ux}, {self._uy})")
        return tuple(bottom), tuple(top)

    def _back(self, x: Rational, y: Rational) -> Vertex:
        return self._ux * x - self._uy * y, self._uy * x + self._ux * y

    def _leave(self, ring: Iterable[Vertex], finer: int = 1) -> tuple[Point, ...]:
        scale = (self._ux**2 + self._uy**2) * self._scale * finer
        return tuple(Point(divide_exactly(x, scale), divide_exactly(y, scale)) for x, y in ring)

    def segment(self, ends: Edge) -> Fit:
        hanging, inner = self._leave(self._back(x, y) for x, y in ends)
        return hanging, inner

    def loop(self, bottom: PiecewiseLinear, top: PiecewiseLinear) -> tuple[Point, ...]:
        """Return the canonical loop between two functions on the same range."""
        there = [xy for p in bottom for xy in ((p.x0, p.y0), (p.x1, p.y1))]
        return_ = [xy for p in reversed(top) for xy in ((p.x1, p.y1), (p.x0, p.y0))]
        finer = lcm(*(c.denominator for xy in there + return_ for c in xy))
        ring = [self._back(int(x * finer), int(y * finer)) for x, y in there + return_]
        return self._leave(canonicalize_ring(ring).points, finer)


def _lower_halves(
    d_bottom: PiecewiseLinear, g_bottom: PiecewiseLinear, g_top: PiecewiseLinear
) -> tuple[PiecewiseLinear, PiecewiseLinear, PiecewiseLinear]:
    trajectory = _trajectory(d_bottom, g_top)
    outer = take_least_sum(trajectory, g_bottom)
    # max(f + g) = -min(-f - g). Over D's range x - u runs through all of G's range, so nothing
    # of T is passed by and no partial overlap at T's ends comes in.
    within = d_bottom[0].x0, d_bottom[-1].x1
    inner = mirror(take_least_sum(mirror(trajectory), mirror(g_top), within))
    return trajectory, inner, outer


# Callers that need the loops of a pair need its exact fits next.
@lru_cache(maxsize=2)
def _trajectory(d_bottom: PiecewiseLinear, g_top: PiecewiseLinear) -> PiecewiseLinear:
    inverse = tuple(LinearPiece(-p.x1, -p.y1, -p.x0, -p.y0) for p in reversed(g_top))
    return take_least_sum(d_bottom, inverse)


def _fits_from_below(
    d_bottom: PiecewiseLinear, g_top: PiecewiseLinear
) -> Iterator[tuple[Rational, Rational, Rational]]:
    """List triples x0, height on the trajectory, height of the inner end."""
    trajectory = _trajectory(d_bottom, g_top)
    d_cuts = {x for x, _ in list_ends(d_bottom)}
    g_cuts = {x for x, _ in list_ends(g_top)}
    for x0 in {d - g for d in d_cuts for g in g_cuts}:
        limit = _least_gap(d_bottom, g_top, x0)
        # At the two ends of the trajectory's range no open interval is shared.
        if limit is None:
            continue
        hanging = max(p.at(x0) for p in trajectory if p.x0 <= x0 <= p.x1)
        if hanging < limit:
            yield x0, hanging, limit


def _least_gap(d_bottom: PiecewiseLinear, g_top: PiecewiseLinear, x0: Rational) -> Rational | None:
    """Return the least limit of D_b(a) - G_t(a - x0) inside intervals without breakpoints."""
    gaps = []
    i = j = 0
    while i < len(d_bottom) and j < len(g_top):
        d, g = d_bottom[i], g_top[j]
        left, right = max(d.x0, g.x0 + x0), min(d.x1, g.x1 + x0)
        if left < right:
            gaps += [d.at(a) - g.at(a - x0) for a in (left, right)]
        i, j = i + (d.x1 == right), j + (g.x1 + x0 == right)
    return min(gaps, default=None)
