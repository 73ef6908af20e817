"""Contact segments, on which the boundary of the free positions of two shapes lies.

D and H = I(G) are shapes with connected interiors, given by rings with the interior on the left.
The open set O = int D + int H contains the positions of overlap; all other positions are free. A
*contact segment* is an edge of one shape, moved by a convex vertex of the other. The direction of
the edge lies between the directions of the two edges at the vertex, or equals one of them.

(1) A free position with contact lies on a contact segment. Where the shapes touch, a line along an
    edge separates their cones, and the vertex of the cone beyond that line is convex. If rings of
    one shape touch there, the cones of the other shape lie in one gap between its cones, because
    connected interiors cannot pass each other, and the vertex of that gap counts.
(2) At positions just to the left of an interior point of a contact segment, D and G overlap: there
    the vertex has crossed the edge.

A path may replace H or D, as one ring that runs back and forth, or as two rings if it is closed.
Its reversals at the ends count as convex vertices. Its interior is the path itself.

Source: the reduced convolution of Behar and Lien, "Fast and robust 2D Minkowski sum using reduced
convolution", IROS 2011, which excludes the ends of the ranges of directions.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import chain, groupby
from math import gcd, lcm
from operator import itemgetter

from exactsweep.geometry.direction import reduce_direction
from exactsweep.geometry.edges import Rings
from exactsweep.geometry.frame import to_homogeneous
from exactsweep.numbers.number import Rational, Vertex
from exactsweep.procedures.chain import Line

Sides = tuple[bool, bool]
"""The sides of a line with overlap: its left, and its right."""

NEITHER: Sides = False, False
BOTH: Sides = True, True

Cut = tuple[int, int, int, bool, bool, Sides]
"""(key, n, d, before, after, sides): a crossing with another segment, at parameter n / d.

    key            the key of n / d, see `crossings`
    before, after  whether overlap passes through the crossing on one side of the other segment:
                   the side of the smaller parameters, and that of the greater ones
    sides          the sides of the other segment
"""

Adjacent = tuple[int, int, int, int, int]
"""The vectors of the edges before and after an edge, times a unit, and the unit."""

EdgeFeature = tuple[int, int, tuple[int, int], Rational, Rational, bool, Adjacent]
"""(dx, dy, (n, d), low, high, ahead, adjacent): an edge on the line dx y - dy x = n / d.

    low, high  its least and its greatest parameter
    ahead      whether it runs along (dx, dy)
    adjacent   the adjacent edges
"""

_Span = tuple[Rational, Rational, bool]
"""(low, high, ahead): a contact segment on its line, as in `EdgeFeature`."""

LeaveOut = Callable[[Sequence[EdgeFeature], Sequence[Vertex], int], Sequence[EdgeFeature]]
"""A pruning step: it returns the parts to keep of the edges that face vertex k of a ring."""


@dataclass(eq=False, slots=True)
class ContactSegment:
    """A piece of a line along which contact segments have the same directions.

    The parameter of a point of the line is its x, or its y if the line is vertical.

    Attributes:
        line: its line in coprime ints, with dx > 0, or dx = 0 < dy.
        low, high: the parameters of the ends.
        sides: the sides of the line with overlap, by (2).
        low_sides, high_sides: the sides on which overlap passes through the ends.
        cuts, keys: the crossings with other segments, and the keys of the ends; see `crossings`.
    """

    line: Line
    low: Rational
    high: Rational
    sides: Sides
    low_sides: Sides = NEITHER
    high_sides: Sides = NEITHER
    cuts: list[Cut] = field(default_factory=list)
    keys: tuple[int, int] = (0, 0)

    @property
    def box(self) -> tuple[int, int, int, int]:
        """The bounds of the segment, rounded outwards to ints: left, right, low, high."""
        (n, d), (m, e) = self.low.as_integer_ratio(), self.high.as_integer_ratio()
        (dx, dy, c), left, right = self.line, n // d, -(-m // e)
        if dx == 0:
            return -c // dy, -(c // dy), left, right
        if dy < 0:
            n, d, m, e = m, e, n, d
        return left, right, (n * dy + c * d) // (dx * d), -((-m * dy - c * e) // (dx * e))


def find_contact_segments(
    stationary: Rings, moving: Rings, leave_out: LeaveOut = lambda edges, *_: edges
) -> list[ContactSegment]:
    """Find the contact segments of two shapes, joined along each line.

    The rings are those of D and of H = I(G); `leave_out` returns the parts of facing edges that may
    bound a free region. Cost: O(k log k + (m + n) log(m + n)) for k <= 2 m n contact segments.
    """
    shapes = [[_list_edges(ring) for ring in rings] for rings in (stationary, moving)]
    angle, full_turn = _measure_angles(
        [edge for rings in shapes for ring in rings for edge in ring]
    )
    ranked = [[[(angle(edge), edge) for edge in ring] for ring in rings] for rings in shapes]
    spans: defaultdict[Line, list[_Span]] = defaultdict(list)
    # The edges of one shape face the vertices of the other.
    for (faced, facing_rings), rings in ((ranked, moving), (ranked[::-1], stationary)):
        order = sorted(chain.from_iterable(faced), key=itemgetter(0))
        # Two full turns, so that each range of directions is one slice.
        at = [a for a, _ in order] + [a + full_turn for a, _ in order]
        edges = [edge for _, edge in order] * 2
        for ring, own in zip(rings, facing_rings, strict=True):
            for k, first, last in _find_convex_vertices([a for a, _ in own], full_turn):
                facing = edges[bisect_left(at, first) : bisect_right(at, last)]
                x, y = ring[k]
                u, v, w = to_homogeneous(x, y)
                for dx, dy, (offset, unit), low, high, ahead, _ in leave_out(facing, ring, k):
                    # Move the edge by the vertex, and reduce its line.
                    c = unit * (dx * v - dy * u) + w * offset
                    common = gcd(unit * w, c)
                    times, along = unit * w // common, x if dx else y
                    line = times * dx, times * dy, c // common
                    spans[line].append((low + along, high + along, ahead))
    return [segment for line, ends in spans.items() for segment in _join(line, ends)]


def _list_edges(ring: Sequence[Vertex]) -> list[EdgeFeature]:
    """List the edges of a ring; edge k ends at vertex k."""
    edges: list[EdgeFeature] = []
    (ox, oy), (px, py) = ring[-2], ring[-1]
    for (qx, qy), (rx, ry) in zip(ring, [*ring[1:], ring[0]], strict=True):
        dx, dy = reduce_direction((qx - px, qy - py))
        first, last = (px, qx) if dx else (py, qy)
        ahead = first < last
        low, high = (first, last) if ahead else (last, first)
        adjacent = _scale(px - ox, py - oy, rx - qx, ry - qy)
        offset = (dx * py - dy * px).as_integer_ratio()
        edges.append((dx, dy, offset, low, high, ahead, adjacent))
        ox, oy, px, py = px, py, qx, qy
    return edges


def _scale(bx: Rational, by: Rational, ax: Rational, ay: Rational) -> Adjacent:
    unit = lcm(bx.denominator, by.denominator, ax.denominator, ay.denominator)
    return int(bx * unit), int(by * unit), int(ax * unit), int(ay * unit), unit


def _measure_angles(edges: Sequence[EdgeFeature]) -> tuple[Callable[[EdgeFeature], int], int]:
    """Return a map from edges to ints by angle from straight down, and the int of a full turn."""
    # Different slopes differ by at least a unit.
    bits = 2 * max(edge[0] for edge in edges).bit_length()
    vertical = (1 + max(abs(edge[1]) for edge in edges)) << bits

    def angle(edge: EdgeFeature) -> int:
        dx, dy, _, _, _, ahead, _ = edge
        slope = (dy << bits) // dx if dx else vertical
        return slope if ahead else slope + 2 * vertical

    return angle, 4 * vertical


def _find_convex_vertices(angles: Sequence[int], full_turn: int) -> Iterator[tuple[int, int, int]]:
    """Yield the indices of convex vertices, with the angles of the edges before and after them."""
    for k, (first, last) in enumerate(zip(angles, [*angles[1:], angles[0]], strict=True)):
        if last < first:
            last += full_turn
        if 2 * (last - first) <= full_turn:
            yield k, first, last


def _join(line: Line, spans: list[_Span]) -> Iterator[ContactSegment]:
    """Join the contact segments of one line; yield maximal segments with constant sides."""
    if len(spans) == 1:
        ((low, high, ahead),) = spans
        yield ContactSegment(line, low, high, (ahead, not ahead))
        return
    events = [(low, True, ahead) for low, _, ahead in spans]
    events += [(high, False, ahead) for _, high, ahead in spans]
    # The numbers of segments that run against the line, and along it.
    count = [0, 0]
    segment: ContactSegment | None = None
    for place, group in groupby(sorted(events), key=itemgetter(0)):
        # Process ends before starts: (2) does not hold at a point that no segment passes through.
        here = list(group)
        for _, starts, ahead in here:
            count[ahead] -= not starts
        through = count[True] > 0, count[False] > 0
        for _, starts, ahead in here:
            count[ahead] += starts
        sides = count[True] > 0, count[False] > 0
        if segment:
            if segment.sides == sides == through:
                continue
            segment.high, segment.high_sides = place, through
            yield segment
        segment = ContactSegment(line, place, place, sides, through) if any(sides) else None
