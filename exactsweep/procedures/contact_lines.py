"""Contact lines, which contain the boundary of the free positions of polygons of any shape.

Let D and H = I(G) be sets with connected interiors, bounded by rings with the interior on the left.
Let O = int D + int H be the positions of overlap, an open set. A *contact segment* is the path of a
convex vertex of one set along an edge of the other. The direction of the edge lies between the
directions of the two edges at the vertex, or equals one of them.

(1) A free position with contact lies on a contact segment. At a common point, the cones of the two
    sets have disjoint interiors, so one of the cones is convex. A line through an edge of one cone
    separates them. The cone beyond that line lies in a half-plane, so its vertex is convex. The
    ends of a piece that two edges share are vertices with this property, too. A set that touches
    itself in a point has several cones there, with gaps between them. The cones of the other set
    lie in one gap, since connected interiors cannot pass each other there. So the corner of the
    ring around that gap represents all cones.
(2) Near each inner point of a contact segment, the positions on its left overlap: there the vertex
    has crossed the edge, and the interior beside the vertex lies in the other interior.

By (1) the boundary of the free positions, and the exact fits, consist of pieces of contact
segments. Each piece between two neighbouring crossings is either free or overlapped. By (2) a free
region lies right of every contact segment that bounds it, and contact segments of both directions
run along an exact fit.

Reference: the reduced convolution of Behar and Lien, "Fast and robust 2D Minkowski sum using
reduced convolution", IROS 2011, has the same segments for polygons without holes, but excludes the
ends of the ranges of directions.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from math import gcd, inf, lcm

from exactsweep.geometry.direction import Vector, reduce_direction
from exactsweep.geometry.overlap import Rings
from exactsweep.numbers.number import Rational, Vertex, ratio
from exactsweep.procedures.leeway import Leeway
from exactsweep.procedures.neighbours import (
    Around,
    RankedEdge,
    leave_out_overlapped,
    look_around,
)

_UNITS = 2**32
_BEYOND = 1  # the length by which pieces extend beyond a leeway
_MANY = 1000
"""The product of the numbers of edges from which it pays to look at the edges beside each other."""

StretchPlace = tuple[int, int]
"""A place n / d on a line; d > 0."""

Cut = tuple[int, StretchPlace, bool, bool, bool]
"""A crossing of a stretch with another one.

Its fields: a sort key that never decreases with the place; the place on the stretch; whether the
other stretch proves overlap just before the place, and just after it; whether contact segments run
both ways along the other stretch.
"""

ReducedPoint = tuple[int, int, int, int]
"""A point of the plane by its reduced coordinates: x = n / d and y = m / e as (n, d, m, e)."""


class Stretch:
    """A stretch of a line on which contact segments of the same directions lie.

    The line consists of the points with dx * y - dy * x = c / e. The direction (dx, dy) has coprime
    ints, with dx > 0 or (0, 1); c and e > 0 are coprime ints. A place on the line is the value of
    x, or of y if the line is vertical. All numbers are ints, so that shapes off the lattice, such
    as trajectories, need no Fractions.

    Args:
        line: dx, dy and c / e.
        low: the place of one end.
        high: the place of the other end.
        left: see the attribute.
        right: see the attribute.

    Attributes:
        low, high: the places of the ends.
        left, right: the sides with overlap: whether contact segments run along (dx, dy), and
            whether they run against it.
        low_through, high_through: the same for segments that run through the point `low` or `high`;
            None if the line ends there.
        low_covered, high_covered: whether the stretch was cut at that end, with overlap just
            inside.
        cuts: the crossings with other stretches.
    """

    __slots__ = (
        "c",
        "cuts",
        "dx",
        "dy",
        "e",
        "high",
        "high_covered",
        "high_through",
        "left",
        "low",
        "low_covered",
        "low_through",
        "right",
    )

    def __init__(
        self,
        line: tuple[int, int, Rational],
        low: Rational,
        high: Rational,
        left: bool,
        right: bool,
    ) -> None:
        self.dx, self.dy, c = line
        self.c, self.e = c.as_integer_ratio()
        self.low: StretchPlace = low.as_integer_ratio()
        self.high: StretchPlace = high.as_integer_ratio()
        self.left = left
        self.right = right
        self.low_through: tuple[bool, bool] | None = None
        self.high_through: tuple[bool, bool] | None = None
        self.low_covered = self.high_covered = False
        self.cuts: list[Cut] = []

    def between(self, low: Rational, high: Rational) -> Stretch:
        """Return the piece between two places; an end inside the stretch counts as covered."""
        line = self.dx, self.dy, ratio(self.c, self.e)
        piece = Stretch(line, low, high, self.left, self.right)
        piece.low_covered = self.low_covered or piece.low != self.low
        piece.high_covered = self.high_covered or piece.high != self.high
        piece.low_through, piece.high_through = self.low_through, self.high_through
        return piece

    def bound(self) -> tuple[int, int, int, int]:
        """Return the bounds of the stretch, rounded outwards to ints: left, right, low, high."""
        dx, dy, c, e = self.dx, self.dy, self.c, self.e
        (low, below), (high, above) = self.low, self.high
        if below == above == e == 1:
            if dx == 0:
                return -c, -c, low, high
            start, end = low * dy + c, -high * dy - c
            if dy < 0:
                return low, high, -end // dx, -(-start // dx)
            return low, high, start // dx, -(end // dx)
        left, right = low // below, -(-high // above)
        if dx == 0:
            return -c // e, -(c // e), left, right
        if dy < 0:
            low, below, high, above = high, above, low, below
        floor = (low * dy * e + c * below) // (dx * e * below)
        return left, right, floor, -((-high * dy * e - c * above) // (dx * e * above))

    def within(self, leeway: Leeway) -> Stretch | None:
        """Return the piece in the leeway, or a little more; None if the stretch is outside.

        All positions outside the leeway overlap, and so do those just inside an end that is cut.
        """
        west, east, south, north = leeway
        left, right, lowest, highest = self.bound()
        if (
            west - _BEYOND <= left
            and right <= east + _BEYOND
            and south - _BEYOND <= lowest
            and highest <= north + _BEYOND
        ):
            return self
        if left > east or right < west or lowest > north or highest < south:
            return None
        dx, dy, c = self.dx, self.dy, ratio(self.c, self.e)
        low, high = ratio(*self.low), ratio(*self.high)
        if dx == 0:
            if not leeway.left <= -c <= leeway.right:
                return None
            start, end = max(low, leeway.low - _BEYOND), min(high, leeway.high + _BEYOND)
        else:
            start, end = max(low, leeway.left - _BEYOND), min(high, leeway.right + _BEYOND)
            # Ordinates, times dx.
            floor, ceiling = (leeway.low - _BEYOND) * dx, (leeway.high + _BEYOND) * dx
            first, last = (start, end) if dy >= 0 else (end, start)
            if first * dy + c > ceiling or last * dy + c < floor:
                return None
            if first * dy + c < floor:
                first = Fraction(floor - c, dy)
            if last * dy + c > ceiling:
                last = Fraction(ceiling - c, dy)
            start, end = (first, last) if dy >= 0 else (last, first)
        if start >= end:
            return None
        return self if (start, end) == (low, high) else self.between(start, end)

    def vertex(self, place: StretchPlace) -> ReducedPoint:
        """Return the point of the line at a place."""
        n, d = place
        if d == self.e == 1 and self.dx:
            y, rest = divmod(n * self.dy + self.c, self.dx)
            if not rest:
                return n, 1, y, 1
        common = gcd(n, d)
        if self.dx == 0:
            return -self.c, self.e, n // common, d // common
        y, unit = n * self.dy * self.e + self.c * d, self.dx * d * self.e
        other = gcd(y, unit)
        return n // common, d // common, y // other, unit // other


_Convex = tuple[Vertex, int, int, Around | None]
"""A convex vertex, the ranks of the edges before and after it, and the vertices around it."""


def find_contact_stretches(
    stationary: Rings, moving: Rings, leeway: Leeway | None = None
) -> list[Stretch]:
    """Find the contact segments of two shapes, and join those on one line to stretches.

    Args:
        stationary: the rings of D.
        moving: the rings of H = I(G), the orbiting shape after half a turn.
        leeway: segments outside it may be left out.

    Returns:
        The stretches, in the order of their lines.

    Cost: O(k log k + (m + n) log(m + n)) for k contact segments; k <= 2 m n.
    """
    shapes = [[_DirectedRing(ring) for ring in rings] for rings in (stationary, moving)]
    directions, ranks = _rank(u for rings in shapes for ring in rings for u in ring.directions)
    many = sum(map(len, stationary)) * sum(map(len, moving)) > _MANY
    sides = [_list_features(rings, ranks, len(directions), many) for rings in shapes]
    left, right, bottom, top = leeway or (-inf, inf, -inf, inf)
    lines: defaultdict[tuple[int, Rational], list[tuple[Rational, Rational, bool]]] = defaultdict(
        list
    )
    for (_, corners), (edges, _) in (sides, sides[::-1]):
        # The edges of two turns, so that each range of directions is one slice.
        circle = 2 * len(directions)
        order = sorted(edges)
        order += [(edge[0] + circle, *edge[1:]) for edge in order]
        at = [edge[0] for edge in order]
        for (x, y), first, last, around in corners:
            facing: Iterable[RankedEdge] = order[bisect_left(at, first) : bisect_right(at, last)]
            if around:
                facing = leave_out_overlapped(facing, directions, around)
            if type(x) is int and type(y) is int:
                for _, k, ahead, offset, low, high, _ in facing:
                    dx, dy = directions[k]
                    along, least, greatest = (x, left, right) if dx else (y, bottom, top)
                    if not leeway or (low + along <= greatest and high + along >= least):
                        c = dx * y - dy * x + offset
                        lines[k, c].append((low + along, high + along, ahead))
                continue
            # `unit` times the corner is on the lattice: ints spare most of the Fractions.
            unit = lcm(x.denominator, y.denominator)
            u, v = int(unit * x), int(unit * y)
            for _, k, ahead, offset, low, high, _ in facing:
                dx, dy = directions[k]
                along, least, greatest = (u, left, right) if dx else (v, bottom, top)
                start, end = ratio(low * unit + along, unit), ratio(high * unit + along, unit)
                if not leeway or (start <= greatest and end >= least):
                    c = ratio(dx * v - dy * u + offset * unit, unit)
                    lines[k, c].append((start, end, ahead))
    stretches: list[Stretch] = []
    for (k, c), segments in lines.items():
        line = *directions[k], c
        if len(segments) == 1:
            ((low, high, ahead),) = segments
            stretches.append(Stretch(line, low, high, ahead, not ahead))
        else:
            stretches += _join_segments(line, segments)
    return stretches


class _DirectedRing:
    """A ring, its edges, and their directions; edge i ends at vertex i."""

    def __init__(self, ring: Sequence[Vertex]) -> None:
        self.vertices = ring
        self.edges = list(zip((ring[-1], *ring[:-1]), ring, strict=True))
        self.directions = [reduce_direction((q[0] - p[0], q[1] - p[1])) for p, q in self.edges]


def _rank(given: Iterable[Vector]) -> tuple[list[Vector], dict[Vector, int]]:
    """Sort the directions of edges by slope, and return each direction's place in that order."""
    found = set(given)
    vertical = {(0, 1)} & found
    order = sorted((v * _UNITS // u, u, v) for u, v in found - vertical)
    if any(a[0] == b[0] for a, b in pairwise(order)):
        # Slopes that differ by less than a unit.
        order.sort(key=lambda item: Fraction(item[2], item[1]))
    directions = [(u, v) for _, u, v in order] + list(vertical)
    return directions, {u: k for k, u in enumerate(directions)}


def _list_features(
    rings: Sequence[_DirectedRing], ranks: dict[Vector, int], half: int, many: bool
) -> tuple[list[RankedEdge], list[_Convex]]:
    """List the edges and the convex vertices of a shape, with the ranks of their directions.

    Directions are ranked counter-clockwise from just above straight down, `half` to half a turn.
    """
    edges: list[RankedEdge] = []
    corners: list[_Convex] = []
    for ring in rings:
        of_ring: list[RankedEdge] = []
        near = [
            look_around(ring.vertices, i) if many else ((), None) for i in range(len(ring.edges))
        ]
        for i, ((p, q), u) in enumerate(zip(ring.edges, ring.directions, strict=True)):
            (px, py), (qx, qy) = p, q
            k, (dx, dy) = ranks[u], u
            ahead = p < q
            low, high = ((px, qx) if dx else (py, qy)) if ahead else ((qx, px) if dx else (qy, py))
            rank = k if ahead else k + half
            of_ring.append((rank, k, ahead, dx * py - dy * px, low, high, near[i][0]))
        for i, point in enumerate(ring.vertices):
            first, last = of_ring[i][0], of_ring[(i + 1) % len(of_ring)][0]
            if last < first:
                last += 2 * half
            if last - first < half:
                corners.append((point, first, last, near[i][1]))
        edges += of_ring
    return edges, corners


def _join_segments(
    line: tuple[int, int, Rational], segments: list[tuple[Rational, Rational, bool]]
) -> Iterator[Stretch]:
    """Join the contact segments of one line to stretches with constant directions."""
    # At each place, the numbers of segments that end and start there, against and along the line.
    places: dict[Rational, list[int]] = {}
    for low, high, ahead in segments:
        places.setdefault(low, [0, 0, 0, 0])[2 + ahead] += 1
        places.setdefault(high, [0, 0, 0, 0])[ahead] += 1
    against = along = 0
    before: Stretch | None = None
    for place, (end_against, end_along, start_against, start_along) in sorted(places.items()):
        along -= end_along
        against -= end_against
        # Segments that end here, where others start, do not run through. (2) does not cover their
        # ends, and an exact fit can begin there.
        through = along > 0, against > 0
        along += start_along
        against += start_against
        left, right = along > 0, against > 0
        if before is not None:
            sides = before.left, before.right
            if sides == (left, right) == through:
                continue
            before.high = place.as_integer_ratio()
            before.high_through = through if left or right else None
            yield before
        after = Stretch(line, place, place, left, right) if left or right else None
        if after is not None and before is not None:
            after.low_through = through
        before = after
