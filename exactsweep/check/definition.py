"""The sweep by its definition: minima and maxima taken straight from the input.

In a frame whose x-axis is the direction of monotonicity, with D_b the bottom of D and G_b, G_t
the bottom and top of G as functions of x, the lower halves of the three loops are

    trajectory   T(x) = min over a of D_b(a) - G_t(a - x)
    outer loop   S(x) = min over u of T(u) + G_b(x - u)
    inner loop   R(x) = max over u of T(u) + G_t(x - u), for x in D's x-range only

(Definitions 1.1 to 1.3, Theorems 2.1 and 2.2, Lemma 5.3 as far as it holds); the upper halves are
their mirror images. Here they are evaluated on every open interval between sums of breakpoints,
slowly and on Fractions, to hold the procedures of the paper against.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise
from typing import Any, NamedTuple

from exactsweep.check.piecewise import Function, Piece, ends, least_sum, mirror, piece_over
from exactsweep.geometry.error import ExactSweepError
from exactsweep.geometry.number import to_fraction
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon


class ReferenceLoops(NamedTuple):
    """The three loops of a sweep, each a tuple of Point in canonical order."""

    trajectory: tuple[Point, ...]
    inner: tuple[Point, ...]
    outer: tuple[Point, ...]


def reference_loops(
    generatrix: Any, directrix: Any, direction: tuple[Any, Any] = (1, 0)
) -> ReferenceLoops:
    """Evaluate trajectory, inner loop and outer loop of the sweep (G, D) from the definition.

    Args:
        generatrix: G, a Polygon or its vertices, m edges.
        directrix: D, likewise, n edges.
        direction: a pair of rationals, not both zero, to which both are weakly monotone.

    Returns:
        ReferenceLoops of tuples of Point, counter-clockwise, not closed, canonical.

    Raises:
        ValueError: a polygon is not monotone to the direction, or the direction is zero.

    Cost: mn intervals of m + n candidates for a trajectory of k edges, then km of k + m.
    Source: Definitions 1.1 to 1.3.

    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> [(str(x), str(y)) for x, y in reference_loops(square, square).trajectory]
    [('-1', '-1'), ('1', '-1'), ('1', '1'), ('-1', '1')]
    """
    frame = _Frame(direction)
    g_bottom, g_top = frame.halves(generatrix, "generatrix")
    d_bottom, d_top = frame.halves(directrix, "directrix")
    lower = _lower_halves(d_bottom, g_bottom, g_top)
    mirrored = _lower_halves(mirror(d_top), mirror(g_top), mirror(g_bottom))
    halves = zip(lower, map(mirror, mirrored), strict=True)
    return ReferenceLoops(*(frame.loop(bottom, top) for bottom, top in halves))


def reference_exact_fits(
    generatrix: Any, directrix: Any, direction: tuple[Any, Any] = (1, 0)
) -> tuple[tuple[Point, Point], ...]:
    """List the exact fits of the sweep (G, D): contact without overlap, hemmed in on both sides.

    At a difference x0 of vertex abscissas, G slides up from the lower trajectory as far as D_b
    stays above G_t on the open interval of x that D and G + (x0, 0) share; what lies beyond both
    one-sided limits of T there is a fit. Fits seen from above are the mirror image.

    Every fit is a segment of positive length, never a lone point: if interiors are disjoint over
    a shared open interval, then G lies either below D on all of it or above D on all of it (the
    cross-sections left and right of any x have a common interior point in each polygon, so the
    order cannot change there), and from below the set of heights is half-open, (T, limit].

    Args:
        generatrix: as for `reference_loops`.
        directrix: likewise.
        direction: likewise.

    Returns:
        tuple of pairs of Point, sorted: the end that hangs on the trajectory, the inner end.

    Raises:
        ValueError: as by `reference_loops`.

    Cost: mn abscissas of m + n + k steps each, k the edges of the trajectory.
    Source: Definition 1.1, which asks for contact and for disjoint interiors.

    >>> slot = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> [[tuple(map(str, p)) for p in fit] for fit in reference_exact_fits(square, slot)]
    [[('1', '3'), ('1', '1')]]
    """
    frame = _Frame(direction)
    g_bottom, g_top = frame.halves(generatrix, "generatrix")
    d_bottom, d_top = frame.halves(directrix, "directrix")
    below = _fits_from_below(d_bottom, g_top)
    above = _fits_from_below(mirror(d_top), mirror(g_bottom))
    fits = [(frame.back(x, t), frame.back(x, end)) for x, t, end in below]
    fits += [(frame.back(x, -t), frame.back(x, -end)) for x, t, end in above]
    return tuple(sorted(fits))


class _Frame:
    """Coordinates along a direction u and its left normal: the matrix [u; u_perp] and back."""

    def __init__(self, direction: tuple[Any, Any]) -> None:
        self._ux, self._uy = map(to_fraction, direction)
        if self._ux == self._uy == 0:
            raise ExactSweepError("the direction (0, 0) is no direction")
        self._norm = self._ux**2 + self._uy**2

    def halves(self, vertices: Any, name: str) -> tuple[Function, Function]:
        """Bottom and top of a polygon as functions of x."""
        polygon = Polygon(vertices)
        turned = [
            (self._ux * x + self._uy * y, self._ux * y - self._uy * x) for x, y in polygon.vertices
        ]
        # Counter-clockwise: the bottom runs to the right and the top to the left. Edges that do
        # neither are vertical; they are the jumps of the functions and need no piece.
        edges = list(zip(turned, turned[1:] + turned[:1], strict=True))
        bottom = [Piece(*p, *q) for p, q in edges if p[0] < q[0]]
        top = [Piece(*q, *p) for p, q in edges if p[0] > q[0]]
        bottom.sort()
        top.sort()
        # Monotone is: bottom and top each cover the range of x once.
        if any(p.x1 != q.x0 for half in (bottom, top) for p, q in pairwise(half)):
            raise ExactSweepError(f"the {name} is not monotone to ({self._ux}, {self._uy})")
        return tuple(bottom), tuple(top)

    def back(self, x: Fraction, y: Fraction) -> Point:
        return Point(
            (self._ux * x - self._uy * y) / self._norm, (self._uy * x + self._ux * y) / self._norm
        )

    def loop(self, bottom: Function, top: Function) -> tuple[Point, ...]:
        """The canonical loop between two functions on the same range."""
        there = [xy for p in bottom for xy in ((p.x0, p.y0), (p.x1, p.y1))]
        return_ = [xy for p in reversed(top) for xy in ((p.x1, p.y1), (p.x0, p.y0))]
        return Polygon([self.back(x, y) for x, y in there + return_]).vertices


def _lower_halves(
    d_bottom: Function, g_bottom: Function, g_top: Function
) -> tuple[Function, Function, Function]:
    """T, R and S, in the order of ReferenceLoops."""
    trajectory = _trajectory(d_bottom, g_top)
    outer = least_sum(trajectory, g_bottom)
    # max(f + g) = -min(-f - g). Over D's range x - u runs through all of G's range, so nothing
    # of T is passed by and no partial overlap at T's ends comes in.
    within = d_bottom[0].x0, d_bottom[-1].x1
    inner = mirror(least_sum(mirror(trajectory), mirror(g_top), within))
    return trajectory, inner, outer


def _trajectory(d_bottom: Function, g_top: Function) -> Function:
    """D_b(a) - G_t(a - x) is D_b(a) plus the bottom of I(G) at x - a."""
    inverse = tuple(Piece(-p.x1, -p.y1, -p.x0, -p.y0) for p in reversed(g_top))
    return least_sum(d_bottom, inverse)


def _fits_from_below(
    d_bottom: Function, g_top: Function
) -> Iterator[tuple[Fraction, Fraction, Fraction]]:
    """Triples x0, height on the trajectory, height of the inner end."""
    trajectory = _trajectory(d_bottom, g_top)
    d_cuts = {x for x, _ in ends(d_bottom)}
    g_cuts = {x for x, _ in ends(g_top)}
    for x0 in {d - g for d in d_cuts for g in g_cuts}:
        cuts = d_cuts | {x0 + g for g in g_cuts}
        low = max(d_bottom[0].x0, x0 + g_top[0].x0)
        high = min(d_bottom[-1].x1, x0 + g_top[-1].x1)
        shared = sorted(x for x in cuts if low <= x <= high)
        # At the two ends of the trajectory's range no open interval is shared.
        if len(shared) < 2:
            continue
        limit = min(_least_gap(d_bottom, g_top, x0, *interval) for interval in pairwise(shared))
        hanging = max(p.at(x0) for p in trajectory if p.x0 <= x0 <= p.x1)
        if hanging < limit:
            yield x0, hanging, limit


def _least_gap(
    d_bottom: Function, g_top: Function, x0: Fraction, left: Fraction, right: Fraction
) -> Fraction:
    """The least limit of D_b(a) - G_t(a - x0) inside an interval without breakpoints."""
    middle = (left + right) / 2
    d, g = piece_over(d_bottom, middle), piece_over(g_top, middle - x0)
    assert d is not None  # the interval lies in both ranges
    assert g is not None
    return min(d.at(a) - g.at(a - x0) for a in (left, right))
