"""The Fréchet distance of loops, compared with a bound.

It decides whether two points can travel once around two loops, neither turning back, and stay
closer than a bound in x and in y (Alt and Godau, "Computing the Fréchet distance between two
polygonal curves", 1995, in the maximum norm, where all is rational). The close pairs of places on
two edges are a convex set. So a walk leads from any place on the left or lower side of such a cell
to any place on its right or upper side that does not lie before it, and only the earliest place
that can be reached on each side matters. A walk that is found is a proof. Walks start at the first
vertex of one loop and a vertex or a middle of a close part of the other; one that can only start
elsewhere, or takes more than MAX_CELLS cells, is not found.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise
from typing import NamedTuple

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import Point, PointRings

MAX_CELLS = 300_000


class _EdgePart(NamedTuple):
    """The places on an edge strictly between two shares: an end is in if low < 0, or high > 1."""

    low: Fraction
    high: Fraction

    def after(self, low: Fraction) -> _EdgePart | None:
        """Return the places that are not before another one."""
        part = _EdgePart(max(self.low, low), self.high)
        return part if part.start < part.end else None

    @property
    def start(self) -> Fraction:
        """The low end, on the edge."""
        return max(self.low, Fraction(0))

    @property
    def end(self) -> Fraction:
        """The high end, on the edge."""
        return min(self.high, Fraction(1))


def walk_together(first: Sequence[Point], second: Sequence[Point], bound: Fraction) -> bool:
    """Decide whether two loops can be walked together, always closer than a bound.

    Args:
        first: vertices of a loop of m edges, not closed.
        second: those of another one of n edges, of the same orientation.
        bound: the differences in x and in y must stay below it at every moment.

    Returns:
        True if a walk is found.

    Cost: O(m + n) operations on rationals where the bound is below all distances of edges that are
    no neighbours; otherwise up to O(m n) for each start, and MAX_CELLS for all of them.

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
    """Decide whether some rings are all of others except for rounding, as by `take_pairs`."""
    return len(exact) == len(theirs) and not any(take_pairs(exact, list(theirs), rounding))


def take_pairs(
    exact: PointRings, theirs: list[Sequence[Point]], rounding: Fraction
) -> Iterator[Sequence[Point]]:
    """Take from a list the rings that are exact ones except for rounding, by `walk_together`.

    The exact ones are counter-clockwise; rounding may have made the others cross themselves.

    Yields:
        The exact rings of which there is none.
    """
    for ring in exact:
        found = next((other for other in theirs if _is_rounded(ring, other, rounding)), None)
        if found is None:
            yield ring
        else:
            theirs.remove(found)


def _is_rounded(exact: Sequence[Point], theirs: Sequence[Point], rounding: Fraction) -> bool:
    corners = zip(find_box([exact]), find_box([theirs]), strict=True)
    if not all(is_near(p, q, rounding) for p, q in corners):  # pragma: no mutate: costs only time
        return False
    if not rounding:
        return Polygon(exact) == Polygon(theirs)
    turn = find_doubled_area(theirs)
    return (turn >= 0 and walk_together(exact, theirs, rounding)) or (
        turn <= 0 and walk_together(exact, theirs[::-1], rounding)
    )


def is_near(p: Point, q: Point, rounding: Fraction) -> bool:
    """Decide whether two points are equal, or closer than a rounding in x and in y."""
    return p == q or all(abs(a - b) < rounding for a, b in zip(p, q, strict=True))


def find_box(rings: PointRings) -> tuple[Point, Point]:
    """Return the lower left and the upper right corner of the box around rings."""
    xs, ys = zip(*chain.from_iterable(rings), strict=True)
    return Point(min(xs), min(ys)), Point(max(xs), max(ys))


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
    """Decide whether two paths whose starts are close can be walked together.

    Cell (i, j) has edge i of the first and edge j of the second path. Its lower side belongs to
    vertex i, its left side to vertex j.
    """
    m, n = len(first) - 1, len(second) - 1
    lower = _along(first[0], second, bound)
    for i in range(m):
        upper: dict[int, _EdgePart] = {}
        # Where vertex i is close to the start of the second path, the lower side begins there.
        left = None
        for start, stop in pairwise([*sorted(lower), n]):
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
    """Find the parts of edges, by number, before the first place of a path not close to a point."""
    found: dict[int, _EdgePart] = {}
    for k, (a, b) in enumerate(pairwise(path)):
        close = find_close_part(p, a, b, bound)
        if close is None:
            break
        found[k] = close
        if close.high <= 1:
            break
    return found


def find_close_part(p: Point, a: Point, b: Point, bound: Fraction) -> _EdgePart | None:
    """Find the places on an edge that are closer to a point than the bound, in x and in y."""
    low, high = Fraction(-1), Fraction(2)
    for place, start, end in zip(p, a, b, strict=True):
        if start == end:
            if abs(place - start) >= bound:
                return None
            continue
        near, far = sorted(((place + sign * bound - start) / (end - start)) for sign in (-1, 1))
        low, high = max(low, near), min(high, far)
    return _EdgePart(low, high).after(low)
