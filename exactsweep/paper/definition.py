"""The sweep by its definition: minima and maxima over the input.

The X axis is the shared direction. D_b, G_b and G_t are the bottom of D and the bottom and top of
G as functions of x. The lower halves of the three loops are

    trajectory   T(x) = min over a of D_b(a) - G_t(a - x)
    outer loop   S(x) = min over u of T(u) + G_b(x - u)
    inner loop   R(x) = max over u of T(u) + G_t(x - u), for x in D's x-range only

(Definitions 1.1 to 1.3, Theorems 2.1 and 2.2, and Lemma 5.3 as corrected); the upper halves are
mirror images. This module evaluates them on every open interval between sums of breakpoints.
"""

from collections import defaultdict
from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import lru_cache
from itertools import pairwise
from math import lcm
from typing import Any, NamedTuple

from exactsweep.check.cone import divide
from exactsweep.geometry.canonical import canonicalize_ring
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.error import ExactSweepError, explain_type_errors
from exactsweep.numbers.number import Edge, Fit, Loop, Point, Rational, Vertex, to_fraction


class LinearPiece(NamedTuple):
    """A linear function on the open interval (x0, x1); y0 and y1 are its limits at the ends."""

    x0: Rational
    y0: Rational
    x1: Rational
    y1: Rational

    def at(self, x: Rational) -> Rational:
        """Return the value at x, or the limit at an end."""
        if x == self.x0 or self.y0 == self.y1:
            return self.y0
        if x == self.x1:
            return self.y1
        return self.y0 + divide((self.y1 - self.y0) * (x - self.x0), self.x1 - self.x0)


# Adjacent pieces from left to right. Different limits at a common end form a vertical edge.
# Isolated values cannot occur, because loops bound regular closed sets.
PiecewiseLinear = tuple[LinearPiece, ...]


class _ScaledLine(NamedTuple):
    """The line y = slope * x + constant, with y in a unit that makes both ints."""

    slope: int
    constant: int

    def at(self, x: Rational) -> Rational:
        return self.slope * x + self.constant


def mirror(function: Iterable[LinearPiece]) -> PiecewiseLinear:
    return tuple(LinearPiece(x0, -y0, x1, -y1) for x0, y0, x1, y1 in function)


def list_ends(function: Iterable[LinearPiece]) -> set[tuple[Rational, Rational]]:
    """Return the breakpoints with their limits: one limit if continuous, two at a jump."""
    return {end for x0, y0, x1, y1 in function for end in ((x0, y0), (x1, y1))}


def min_plus_convolution(
    f: PiecewiseLinear, g: PiecewiseLinear, within: tuple[Rational, Rational] | None = None
) -> PiecewiseLinear:
    """Compute the function x -> min over u of f(u) + g(x - u), optionally for x in `within` only.

    Between two consecutive sums of breakpoints, a breakpoint of one function attains the minimum
    inside a piece of the other, as a one-sided limit. So the result is the lower envelope of g's
    pieces moved by f's breakpoints, and of f's pieces moved by g's breakpoints.
    """
    unit = lcm(*(c.denominator for function in (f, g) for piece in function for c in piece))
    scaled = [[[int(c * unit) for c in piece] for piece in function] for function in (f, g)]
    fine = lcm(*(x1 - x0 for function in scaled for x0, _, x1, _ in function))
    starting: dict[int, set[tuple[_ScaledLine, int]]] = defaultdict(set)
    cuts: set[int] = set()
    for fixed, other in (scaled, scaled[::-1]):
        corners = {end for x0, y0, x1, y1 in fixed for end in ((x0, y0), (x1, y1))}
        for x0, y0, x1, y1 in other:
            slope = (y1 - y0) * (fine // (x1 - x0))
            for x, y in corners:
                line = _ScaledLine(slope, (y0 + y) * fine - slope * (x0 + x))
                starting[x0 + x].add((line, x1 + x))
                cuts.update((x0 + x, x1 + x))
    over: set[tuple[_ScaledLine, int]] = set()  # pieces over the interval, with their right ends
    found: list[tuple[_ScaledLine, Rational]] = []  # lowest lines, with their left ends
    last: Rational = 0
    for left, right in pairwise(sorted(cuts)):
        over = {entry for entry in over if entry[1] > left} | starting[left]
        if within is None or (within[0] * unit <= left and right <= within[1] * unit):
            last = right
            for lowest in _lower_envelope(left, right, {line for line, _ in over}):
                if not found or found[-1][0] != lowest[0]:
                    found.append(lowest)
    stops = [x for _, x in found[1:]] + [last]
    return tuple(
        LinearPiece(
            divide(x0, unit),
            divide(line.at(x0), fine * unit),
            divide(x1, unit),
            divide(line.at(x1), fine * unit),
        )
        for (line, x0), x1 in zip(found, stops, strict=True)
    )


def _lower_envelope(
    left: int, right: int, lines: Iterable[_ScaledLine]
) -> Iterator[tuple[_ScaledLine, Rational]]:
    """Yield the lower envelope of lines over an interval, as lines with their left ends."""
    _, _, line = min((line.at(left), line.slope, line) for line in lines)
    yield line, left
    # Invariant: `line` is lowest just right of its left end. It ends at the first crossing with a
    # line that is lower at the right end; the steepest descent breaks ties.
    end = line.at(right)
    while lower := [rival for rival in lines if rival.at(right) < end]:
        x, _, line = min(
            (Fraction(rival.constant - line.constant, line.slope - rival.slope), rival.slope, rival)
            for rival in lower
        )
        yield line, x
        end = line.at(right)


class ReferenceLoops(NamedTuple):
    """The three loops of a sweep, each a canonical tuple of Point."""

    trajectory: tuple[Point, ...]
    inner: tuple[Point, ...]
    outer: tuple[Point, ...]


@explain_type_errors
def reference_loops(
    generatrix: Any, directrix: Any, direction: tuple[Any, Any] = (1, 0)
) -> ReferenceLoops:
    """Evaluate the three loops of the sweep (G, D) by the definition.

    Args:
        generatrix: G, a Polygon or its m vertices.
        directrix: D, a Polygon or its n vertices.
        direction: a nonzero pair of rationals; both polygons must be weakly monotone in it.

    Raises:
        ValueError: a polygon is not monotone in the direction, or the direction is zero.

    Cost: O(mn(m + n)) for the trajectory, then O(km(k + m)) for a trajectory of k edges.

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


@explain_type_errors
def reference_exact_fits(
    generatrix: Any, directrix: Any, direction: tuple[Any, Any] = (1, 0)
) -> tuple[Fit, ...]:
    """List the exact fits of the sweep (G, D) by Definition 1.1: contact, disjoint interiors.

    At each difference x0 of vertex abscissas, G slides up from the lower trajectory as long as D_b
    stays above G_t on the open common x-range of D and G + (x0, 0). There is a fit if G gets above
    both one-sided limits of T. Mirroring yields the fits from above.

    Each fit is a segment of positive length. If interiors are disjoint over an open interval, then
    G lies either below or above D on all of it, since the cross-sections of a polygon on both sides
    of any x share an interior point. From below, the heights form a half-open interval (T, limit].

    Arguments and errors are as for `reference_loops`.

    Returns:
        sorted pairs of Point: the end on the trajectory and the inner end.

    Cost: O(mn(m + n + k)) for a trajectory of k edges.

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
    """Bottom and top of G and D as functions over a direction u, with int coordinates."""

    def __init__(self, direction: tuple[Any, Any], generatrix: Polygon, directrix: Polygon) -> None:
        ux, uy = map(to_fraction, direction)
        if ux == uy == 0:
            raise ExactSweepError("the direction must not be (0, 0)")
        unit = lcm(ux.denominator, uy.denominator)
        self._ux, self._uy = int(ux * unit), int(uy * unit)
        loops = generatrix.vertices, directrix.vertices
        self._scale = lcm(*(c.denominator for loop in loops for p in loop for c in p))
        self.generatrix = self._halves(generatrix.vertices, "generatrix")
        self.directrix = self._halves(directrix.vertices, "directrix")

    def _halves(self, ring: Loop, name: str) -> tuple[PiecewiseLinear, PiecewiseLinear]:
        points = [(int(self._scale * x), int(self._scale * y)) for x, y in ring]
        rotated = [(self._ux * x + self._uy * y, self._ux * y - self._uy * x) for x, y in points]
        # Counter-clockwise, the bottom runs right and the top runs left. Vertical edges are jumps
        # of the functions and need no piece.
        edges = list(zip(rotated, rotated[1:] + rotated[:1], strict=True))
        bottom = sorted(LinearPiece(*p, *q) for p, q in edges if p[0] < q[0])
        top = sorted(LinearPiece(*q, *p) for p, q in edges if p[0] > q[0])
        # The ring is monotone if bottom and top each cover the x-range once.
        if any(p.x1 != q.x0 for half in (bottom, top) for p, q in pairwise(half)):
            raise ExactSweepError(
                f"the {name} is not monotone in direction ({self._ux}, {self._uy})"
            )
        return tuple(bottom), tuple(top)

    def _back(self, x: Rational, y: Rational) -> Vertex:
        return self._ux * x - self._uy * y, self._uy * x + self._ux * y

    def _leave(self, ring: Iterable[Vertex], finer: int = 1) -> tuple[Point, ...]:
        scale = (self._ux**2 + self._uy**2) * self._scale * finer
        return tuple(Point(Fraction(x, scale), Fraction(y, scale)) for x, y in ring)

    def segment(self, ends: Edge) -> Fit:
        attached, inner = self._leave(self._back(x, y) for x, y in ends)
        return attached, inner

    def loop(self, bottom: PiecewiseLinear, top: PiecewiseLinear) -> tuple[Point, ...]:
        points = [xy for p in bottom for xy in ((p.x0, p.y0), (p.x1, p.y1))]
        points += [xy for p in reversed(top) for xy in ((p.x1, p.y1), (p.x0, p.y0))]
        finer = lcm(*(c.denominator for xy in points for c in xy))
        ring = [self._back(int(x * finer), int(y * finer)) for x, y in points]
        return self._leave(canonicalize_ring(ring).points, finer)


def _lower_halves(
    d_bottom: PiecewiseLinear, g_bottom: PiecewiseLinear, g_top: PiecewiseLinear
) -> tuple[PiecewiseLinear, PiecewiseLinear, PiecewiseLinear]:
    trajectory = _trajectory(d_bottom, g_top)
    outer = min_plus_convolution(trajectory, g_bottom)
    # max(f + g) = -min(-f - g). For x in D's range, x - u covers all of G's range, so that G_t is
    # never cut off at the ends of T.
    within = d_bottom[0].x0, d_bottom[-1].x1
    inner = mirror(min_plus_convolution(mirror(trajectory), mirror(g_top), within))
    return trajectory, inner, outer


# Callers that compute the loops of a pair compute its exact fits next.
@lru_cache(maxsize=2)
def _trajectory(d_bottom: PiecewiseLinear, g_top: PiecewiseLinear) -> PiecewiseLinear:
    inverse = tuple(LinearPiece(-p.x1, -p.y1, -p.x0, -p.y0) for p in reversed(g_top))
    return min_plus_convolution(d_bottom, inverse)


def _fits_from_below(
    d_bottom: PiecewiseLinear, g_top: PiecewiseLinear
) -> Iterator[tuple[Rational, Rational, Rational]]:
    """Yield fits as triples: x0, the height on the trajectory, the height of the inner end."""
    trajectory = _trajectory(d_bottom, g_top)
    d_cuts = {x for x, _ in list_ends(d_bottom)}
    g_cuts = {x for x, _ in list_ends(g_top)}
    for x0 in {d - g for d in d_cuts for g in g_cuts}:
        limit = _min_gap(d_bottom, g_top, x0)
        # At both ends of the trajectory, the shapes share no open interval.
        if limit is None:
            continue
        attached = max(p.at(x0) for p in trajectory if p.x0 <= x0 <= p.x1)
        if attached < limit:
            yield x0, attached, limit


def _min_gap(d_bottom: PiecewiseLinear, g_top: PiecewiseLinear, x0: Rational) -> Rational | None:
    """Return the minimum of D_b(a) - G_t(a - x0) over the open common range."""
    gaps = []
    i = j = 0
    while i < len(d_bottom) and j < len(g_top):
        d, g = d_bottom[i], g_top[j]
        left, right = max(d.x0, g.x0 + x0), min(d.x1, g.x1 + x0)
        if left < right:
            gaps += [d.at(a) - g.at(a - x0) for a in (left, right)]
        i, j = i + (d.x1 == right), j + (g.x1 + x0 == right)
    return min(gaps, default=None)
