"""Two loops walked together: whether one is the other except for rounding.

Two points travel around two loops once, neither ever turning back, and are to stay closer than a
bound in x and in y at every moment: the decision of the Fréchet distance (Alt and Godau,
"Computing the Fréchet distance between two polygonal curves", 1995), in the maximum norm, where all
is rational.

The free space of an edge of the one and an edge of the other, the pairs of places that are close,
is convex. So a walk through it is possible from any place on its left or lower side to any place on
its right or upper side that lies not before it, and all that has to be kept is from where on each
side of a cell can be reached.

A walk has to begin somewhere. The first vertex of the one loop is taken together, one after the
other, with each vertex of the other that is close to it, and with the middle of the close part of
each edge. A walk that is found is a proof. (One that begins at other places only, and not at any of
those, is not found; then its points are nearly as far apart as the bound allows at the start. Nor
is one found after MAX_CELLS cells, which takes a bound that is large beside the loops.)
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.numbers.point import Point, PointRings

MAX_CELLS = 300_000


class _EdgePart(NamedTuple):
    """The places on an edge strictly between two shares of its length, cut off at its ends.

    So an end belongs to the part if the share is beyond it: low < 0, or high > 1.
    """

    low: Fraction
    high: Fraction

    def after(self, low: Fraction) -> _EdgePart | None:
        """The places that are not before another one."""
        part = _EdgePart(max(self.low, low), self.high)
        return part if part.start < part.end else None

    @property
    def start(self) -> Fraction:
        """The low end, cut off at the edge's own."""
        return max(self.low, Fraction(0))

    @property
    def end(self) -> Fraction:
        """The high end, cut off at the edge's own."""
        return min(self.high, Fraction(1))


def walk_together(first: Sequence[Point], second: Sequence[Point], bound: Fraction) -> bool:
    """Tell whether two loops can be walked together, always closer than a bound.

    Args:
        first: vertices of a loop of m edges, not closed.
        second: those of another one of n edges, of the same orientation.
        bound: what the differences in x and in y must be below at every moment.

    Returns:
        True if a walk is found.

    Cost: O(m + n) operations on rationals where the bound is below all distances of edges that
    are no neighbours; otherwise up to O(m n) for each start, and MAX_CELLS for all of them.

    Example:
        >>> loop = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (9, 0), (9, 9), (0, 9)]]
        >>> rounded = [*loop[1:], Point(Fraction(-1, 3), Fraction(0))]
        >>> [walk_together(loop, rounded, Fraction(1, k)) for k in (2, 3)]
        [True, False]
    """
    closed = [*first, first[0]]
    cells = iter(range(MAX_CELLS))
    return any(_walk(closed, start, bound, cells) for start in _starts(first[0], second, bound))


def match_rings(exact: PointRings, theirs: PointRings, rounding: Fraction) -> bool:
    """Tell whether rings are others except for rounding, each of them one of the others.

    Args:
        exact: rings that are counter-clockwise.
        theirs: rings of any orientation; rounding may have made them touch or cross themselves.
        rounding: what coordinates must be off by less.

    Returns:
        Whether each two of a pairing can be walked together.

    Cost: that of `walk_together`, at most for each two of them.
    """
    if not rounding or len(exact) != len(theirs):
        return False
    left = list(theirs)
    for ring in exact:
        found = next((other for other in left if _is_rounded(ring, other, rounding)), None)
        if found is None:
            return False
        left.remove(found)
    return True


def _is_rounded(exact: Sequence[Point], theirs: Sequence[Point], rounding: Fraction) -> bool:
    for axis in (0, 1):
        one, other = ([point[axis] for point in ring] for ring in (exact, theirs))
        if abs(min(one) - min(other)) >= rounding or abs(max(one) - max(other)) >= rounding:
            return False
    turn = find_doubled_area(theirs)
    return (turn >= 0 and walk_together(exact, theirs, rounding)) or (
        turn <= 0 and walk_together(exact, theirs[::-1], rounding)
    )


def _starts(p: Point, loop: Sequence[Point], bound: Fraction) -> Iterator[list[Point]]:
    """Yield the loop as a path from a place close to a point all the way around to it."""
    for k, b in enumerate(loop):
        a = loop[k - 1]
        if close := find_close_part(p, a, b, bound):
            rest = [*loop[k:], *loop[:k]]
            if close.high > 1:
                yield [*rest, b]
            t = (close.start + close.end) / 2
            middle = Point(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))
            yield [middle, *rest, middle]


def _walk(
    first: Sequence[Point], second: Sequence[Point], bound: Fraction, cells: Iterator[int]
) -> bool:
    """Tell whether two paths whose starts are close can be walked together.

    Cell (i, j) is that of edge i of the first and edge j of the second path. Its lower side is that
    of vertex i, its left side that of vertex j.
    """
    m, n = len(first) - 1, len(second) - 1
    lower = _along(first[0], second, bound)
    leftmost = _along(second[0], first, bound)
    for i in range(m):
        upper: dict[int, _EdgePart] = {}
        left = leftmost.get(i)
        columns = sorted({*lower, 0})
        for k, start in enumerate(columns):
            stop = columns[k + 1] if k + 1 < len(columns) else n
            for j in range(start, stop):
                below = lower.get(j)
                if (below is None and left is None) or next(cells, None) is None:
                    break
                right = find_close_part(second[j + 1], first[i], first[i + 1], bound)
                above = find_close_part(first[i + 1], second[j], second[j + 1], bound)
                if right and left and below is None:
                    right = right.after(left.low)
                if above and below and left is None:
                    above = above.after(below.low)
                if above:
                    upper[j] = above
                left = right
        lower = upper
    return n - 1 in lower and lower[n - 1].high > 1


def _along(p: Point, path: Sequence[Point], bound: Fraction) -> dict[int, _EdgePart]:
    """The parts of edges, by number, up to the first place of a path not close to a point."""
    found: dict[int, _EdgePart] = {}
    for k, (a, b) in enumerate(pairwise(path)):
        close = find_close_part(p, a, b, bound)
        if close is None or close.low >= 0:
            break
        found[k] = close
        if close.high <= 1:
            break
    return found


def find_close_part(p: Point, a: Point, b: Point, bound: Fraction) -> _EdgePart | None:
    """The places on an edge that are closer to a point than the bound, in x and in y."""
    low, high = Fraction(-1), Fraction(2)
    for place, start, end in zip(p, a, b, strict=True):
        if start == end:
            if abs(place - start) >= bound:
                return None
            continue
        near, far = sorted(((place + sign * bound - start) / (end - start)) for sign in (-1, 1))
        low, high = max(low, near), min(high, far)
    return _EdgePart(low, high).after(low)
