"""An exact test of whether two regions are equal up to rounding of their coordinates.

Two regions E and T are closer than a bound r if

    (1)  every point of E's boundary is closer than r to T's boundary, and conversely; and
    (2)  every point in exactly one of them is closer than r / 2 to one of the boundaries,

in the maximum norm, which keeps all numbers rational. Moving each vertex by less than r changes a
region by less than r: a point that changes sides lies on the path of a boundary point, so it is
closer than r / 2 to an end of that path. Rings may merge, split or touch, but no feature of width r
is lost or gained. `match_rounded` also accepts loops that trace exact fits.

(1): on each edge, the points closer than r to another edge form an open interval; such intervals
must cover every edge. (2): the points closer than r / 2 to an edge form an open hexagon; such
hexagons must cover every trapezoid of the difference.
"""

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain
from typing import NamedTuple, Self

from exactsweep.conform.judge.boundary import RingBoundary, are_bridges, find_boundary, trace_rings
from exactsweep.conform.judge.region import RegionError, find_differences
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.number import Fit, Loop, Point, PointRings
from exactsweep.words import write_pair

_NUMBERS = {2: "two", 3: "three", 4: "four"}


class _NearEdge(NamedTuple):
    """The open hexagon of points closer than a bound to an edge, with its bounding box."""

    left: Fraction
    right: Fraction
    bottom: Fraction
    top: Fraction
    strips: tuple[tuple[Fraction, Fraction, Fraction, Fraction], ...]

    @classmethod
    def around(cls, edge: Fit, bound: Fraction) -> Self:
        (ax, ay), (bx, by) = edge
        zero, one = Fraction(0), Fraction(1)
        dx, dy = bx - ax, by - ay
        wide, high = abs(dx) / 2 + bound, abs(dy) / 2 + bound
        x, y = (ax + bx) / 2, (ay + by) / 2
        strips = [(one, zero, x, wide), (zero, one, y, high)]
        if dx and dy:
            strips.append((-dy, dx, dx * ay - dy * ax, bound * (abs(dx) + abs(dy))))
        return cls(x - wide, x + wide, y - high, y + high, tuple(strips))

    def holds(self, p: Point) -> bool:
        return all(abs(u * p.x + v * p.y - middle) < half for u, v, middle, half in self.strips)

    def meets(self, low: Point, high: Point) -> bool:
        return (
            self.left < high.x and low.x < self.right and self.bottom < high.y and low.y < self.top
        )

    def subtract_from(self, corners: Sequence[Point]) -> Iterator[list[Point]]:
        """Yield convex pieces that cover the points of a convex polygon outside the hexagon."""
        inside = list(corners)
        for u, v, middle, half in self.strips:
            for sign in (1, -1):
                above = [sign * (u * p.x + v * p.y - middle) - half for p in inside]
                if outside := _clip(inside, above):
                    yield outside
                    inside = _clip(inside, [-height for height in above])

    def reach(self, a: Point, b: Point) -> Fraction:
        """Return the t <= 2 at which a + t (b - a) leaves the hexagon, which it meets."""
        ends = [Fraction(2)]
        for u, v, middle, half in self.strips:
            start, step = u * a.x + v * a.y - middle, u * (b.x - a.x) + v * (b.y - a.y)
            if step:
                ends.append(((half if step > 0 else -half) - start) / step)
        return min(ends)


def is_close(p: Point, edge: Fit, bound: Fraction) -> bool:
    return _NearEdge.around(edge, bound).holds(p)


def find_box(rings: PointRings) -> tuple[Point, Point]:
    xs, ys = zip(*chain.from_iterable(rings), strict=True)
    return Point(min(xs), min(ys)), Point(max(xs), max(ys))


def is_near(p: Point, q: Point, bound: Fraction) -> bool:
    return p == q or all(abs(a - b) < bound for a, b in zip(p, q, strict=True))


def are_boxes_near(first: PointRings, second: PointRings, bound: Fraction) -> bool:
    corners = zip(find_box(first), find_box(second), strict=True)
    return all(is_near(p, q, bound) for p, q in corners)


def match_rings(
    exact: PointRings, theirs: list[Sequence[Point]], bound: Fraction
) -> Iterator[Sequence[Point]]:
    """Remove a close ring from a list for each exact ring; yield the unmatched exact rings."""
    for ring in exact:
        found = next((other for other in theirs if are_close([ring], [other], bound)), None)
        if found is None:
            yield ring
        else:
            theirs.remove(found)


def covers(target: Iterable[Fit], edges: Iterable[Fit], bound: Fraction) -> bool:
    """Decide whether all points of some edges are closer than a positive bound to target edges.

    This is linear if edges of equal index in both lists are close, else O(m n).

    >>> a, b, c = (Point(Fraction(x), Fraction(0)) for x in (0, 2, 5))
    >>> covers([(a, b), (b, c)], [(a, c)], Fraction(1)), covers([(a, b)], [(a, c)], Fraction(1))
    (True, False)
    """
    near = [_NearEdge.around(edge, bound) for edge in target]
    hit = 0
    for a, b in edges:
        low, high = (Point(*map(f, a, b)) for f in (min, max))
        t, one = Fraction(0), Fraction(1)
        while t <= one:
            p = Point(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y))
            # The next edge is usually close to the next target.
            for k in chain(range(hit, len(near)), range(hit)):
                if near[k].meets(low, high) and near[k].holds(p):
                    hit = k
                    break
            else:
                return False
            t = near[hit].reach(a, b)
    return True


def are_close(
    first: PointRings, second: PointRings, bound: Fraction, besides: Sequence[Fit] = ()
) -> bool:
    """Decide whether the regions of two sets of rings are closer than a bound; 0 tests equality.

    The second boundary may also be close to segments in `besides`. The result is False if the
    difference has too many trapezoids.

    >>> ring = [Point(Fraction(x), Fraction(y)) for x, y in [(0, 0), (9, 0), (9, 9), (0, 9)]]
    >>> rounded = [*ring[1:], Point(Fraction(-1, 3), Fraction(0))]
    >>> [are_close([ring], [rounded], Fraction(1, k)) for k in (2, 3)]
    [True, False]
    """
    if not are_boxes_near(first, second, bound) and not besides:
        return False
    one, other = find_boundary(first), find_boundary(second)
    if not bound:
        return one.solid == other.solid
    return are_boundaries_close(one, other, bound, besides)


def are_boundaries_close(
    one: RingBoundary, other: RingBoundary, bound: Fraction, besides: Sequence[Fit] = ()
) -> bool:
    return (
        covers([*one.solid, *one.doubled, *besides], other.solid, bound)
        and covers([*other.solid, *other.doubled], one.solid, bound)
        and _is_difference_thin(trace_rings(one), trace_rings(other), bound)
    )


def _is_difference_thin(first: PointRings, second: PointRings, bound: Fraction) -> bool:
    """Decide (2) for rings without doubled segments."""
    edges: list[_NearEdge] = []
    try:
        for cell in find_differences(first, second):
            own = [_NearEdge.around(edge, bound / 2) for edge in cell.edges]
            corners = cell.corners()
            if _is_covered(corners, own):
                continue
            edges = edges or [
                _NearEdge.around((ring[k - 1], p), bound / 2)
                for ring in (*first, *second)
                for k, p in enumerate(ring)
            ]
            low, high = find_box([corners])
            if not _is_covered(corners, [edge for edge in edges if edge.meets(low, high)]):
                return False
    except RegionError:
        return False
    return True


def _is_covered(corners: Sequence[Point], edges: Sequence[_NearEdge]) -> bool:
    """Decide whether open hexagons cover a convex polygon; each cuts a piece only once."""
    left = [corners]
    while left:
        piece = left.pop()
        middle = Point(*(add_up(values) / len(piece) for values in zip(*piece, strict=True)))
        edge = next((edge for edge in edges if edge.holds(middle)), None)
        if edge is None:
            return False
        left += edge.subtract_from(piece)
    return True


def _clip(corners: Sequence[Point], heights: Sequence[Fraction]) -> list[Point]:
    """Return the part of a convex polygon where the height, a linear function, is not negative."""
    part: list[Point] = []
    for k, (q, after) in enumerate(zip(corners, heights, strict=True)):
        p, before = corners[k - 1], heights[k - 1]
        if before * after < 0:
            share = before / (before - after)
            part.append(Point(p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)))
        if after >= 0:
            part.append(q)
    return list(dict.fromkeys(part))


def match_rounded(
    theirs: RingBoundary, exact: RingBoundary, fits: Sequence[Fit], rounding: Fraction
) -> list[Fit] | None:
    """Find the fits that rings trace, or None if the regions differ by more than rounding."""
    if not rounding:
        return None
    known = [*exact.solid, *fits]
    near = [line for line in theirs.doubled if covers(known, [line], rounding)]
    far = [line for line in theirs.doubled if line not in near]
    if not (
        are_bridges(far, [*theirs.solid, *near])
        and are_boundaries_close(exact, theirs, rounding, fits)
    ):
        return None
    if not fits:
        return []
    # Segments that are not close to the loop trace fits.
    lines = [line for line in (*theirs.solid, *near) if not covers(exact.solid, [line], rounding)]
    return [fit for fit in fits if covers(lines, [fit], rounding)]


def describe_merge(
    exact: Sequence[Loop], theirs: Sequence[Loop], name: str, rounding: Fraction
) -> str:
    """Describe which rings rounding merges or splits, and where; "" if none."""
    if len(exact) == len(theirs):
        return ""
    left = list[Sequence[Point]](theirs)
    missing = list(match_rings(exact, left, rounding))
    is_joined = len(missing) > len(left)
    several, verb = (missing, "joins") if is_joined else (left, "separates")
    has_outer = name != "inner_fit" and exact[0] in missing
    what = "rings" if has_outer or name == "inner_fit" else "holes"
    for k, ring in enumerate(several):
        edges = [(other[j - 1], p) for other in several[:k] for j, p in enumerate(other)]
        place = next((p for p in ring if any(is_close(p, e, 2 * rounding) for e in edges)), None)
        if place is not None:
            corners = (p for one in exact for p in one if is_near(p, place, 2 * rounding))
            at = write_pair(next(corners, place))
            return f"the rounding {verb} {_NUMBERS.get(len(several), 'several')} {what} at {at}"
    return f"the rounding leaves {len(theirs)} of {len(exact)} rings"
