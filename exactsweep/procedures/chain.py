"""X-monotone chains and their convex parts (Sections 2 to 4, Definitions 3.1, 5.1 and 5.2).

An X-monotone polygon has a bottom chain and a top chain (Figure 2). The inverse of a top chain is a
bottom chain. So every `Chain` runs from left to right and bounds a region above it. It may have
vertical edges (weak monotonicity). All numbers are ints: vertices have homogeneous coordinates.

`inverse`, `reverse` and `complement` are the operators of the paper, on lists of points. The
procedures need only `inverse`, and `Chain.half_turn` for the complement.

Errata. The paper calls a chain convex if a straight edge closes it to a convex polygon. Lemma 3.1
needs one side only: here a convex chain turns left at every vertex. The paper measures slopes
"clockwise" but means counter-clockwise.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from itertools import groupby, pairwise
from math import gcd, inf
from operator import itemgetter
from typing import NamedTuple, TypeVar

from exactsweep.geometry.frame import HomogeneousPoint, to_homogeneous
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Edge, Rational, Vertex, ratio

V = TypeVar("V", bound=tuple[Rational, Rational, Rational])

Break = tuple[int, int]
"""(x, w): the abscissa x/w, w > 0; not reduced."""

Line = tuple[int, int, int]
"""(dx, dy, c): the points with dx y = dy x + c, dx >= 0."""

SlopedEdge = tuple[int | float, int, int, int, int]
"""(slope, owner, dx, dy, c): an edge with its line, sorted by slope.

    slope  rounded down to an int in units (`Chain.unit`); infinite if vertical
    owner  0 for D_b, 1 for reversed G_t
"""

SlopeBound = tuple[int | float, ...]
"""(slope,), before all edges of that slope, or (slope, infinity), after them."""


class ChainError(ExactSweepError):
    """A sequence of points that is not an X-monotone chain."""


class Chain:
    """An X-monotone chain, from left to right. Iteration yields its points.

    >>> list(Chain.of([(0, 0), (1, -1), (2, 0)]).half_turn())
    [(-2, 0), (-1, 1), (0, 0)]
    """

    def __init__(self, vertices: list[HomogeneousPoint]) -> None:
        self.vertices = vertices
        self.cached_parts: dict[tuple[int, int], list[ConvexPart]] = {}

    @classmethod
    def of(cls, points: Sequence[Vertex]) -> Chain:
        """Create a chain from points in order of x; repeated points count once.

        Raises ChainError if x decreases, or never increases. Cost: O(n).
        """
        points = [point for point, _ in groupby(points)]
        for (px, py), (qx, qy) in pairwise(points):
            if qx < px:
                raise ChainError(f"({qx}, {qy}) lies left of ({px}, {py}): not an X-monotone chain")
        if not points or points[0][0] == points[-1][0]:
            raise ChainError("zero width: all edges of the chain are vertical")
        return cls([to_homogeneous(*point) for point in points])

    @cached_property
    def lines(self) -> list[Line]:
        """The lines of the edges; dx = 0 if vertical."""
        found: list[Line] = []
        for (px, py, pw), (qx, qy, qw) in pairwise(self.vertices):
            dx, dy, c = qx * pw - px * qw, qy * pw - py * qw, py * qx - px * qy
            if pw * qw > 1:
                # Denominators have made the numbers long.
                common = gcd(dx, dy, c)
                dx, dy, c = dx // common, dy // common, c // common
            found.append((dx, dy, c))
        return found

    @cached_property
    def unit(self) -> int:
        """A number u such that slopes of the edges, rounded down to multiples of 1/u, keep order.

        Different slopes dy/dx with dx < 2^b differ by more than 1/2^(2b), so 2^(2b) suffices. The
        length b is rounded up to a multiple of 16: with few units, the cached parts of a chain
        serve for nearly all other chains.
        """
        return 1 << -(-max(dx for dx, _, _ in self.lines).bit_length() // 16) * 32

    @property
    def points(self) -> list[Vertex]:
        """The vertices as pairs of rational numbers."""
        return [(x, y) if w == 1 else (ratio(x, w), ratio(y, w)) for x, y, w in self.vertices]

    def __iter__(self) -> Iterator[Vertex]:
        return iter(self.points)

    def half_turn(self) -> Chain:
        """Return the complement of the chain (Definition 5.2) after a half turn. Cost: O(n).

        So the other side of a bottom chain becomes a bottom chain.
        """
        return Chain([(-x, -y, w) for x, y, w in reversed(self.vertices)])


def inverse(points: Iterable[Vertex]) -> list[Vertex]:
    """Reflect points in the origin, in the same order (Definition 5.1).

    The bottom chain of a polygon becomes the top chain of its inverse, and vice versa.

    >>> inverse([(2, 0), (1, 3), (0, 0)])
    [(-2, 0), (-1, -3), (0, 0)]
    """
    return [(-x, -y) for x, y in points]


def reverse(edges: Iterable[Edge]) -> list[Edge]:
    """Reverse every directed edge and keep the order of the edges (Definition 3.1).

    Laid end to end, the reversed edges of a chain are the edges of its `inverse`.

    >>> reverse([((2, 0), (1, 3)), ((1, 3), (0, 0))])
    [((1, 3), (2, 0)), ((0, 0), (1, 3))]
    """
    return [(end, start) for start, end in edges]


def complement(points: Sequence[Vertex]) -> list[Vertex]:
    """Traverse a chain backwards: return the boundary of the other side (Definition 5.2).

    >>> complement([(0, 0), (1, -1), (2, 0)])
    [(2, 0), (1, -1), (0, 0)]
    """
    return list(reversed(points))


def split(loop: Sequence[Vertex]) -> tuple[list[Vertex], list[Vertex]]:
    """Split an X-monotone polygon into its bottom and its top chain (Section 2, Figure 2).

    The bottom chain runs from left to right, the top chain back; vertical edges at both extremes
    belong to neither. The loop is counter-clockwise and may start anywhere.

    >>> split([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)])
    ([(0, 0), (2, 0)], [(2, 1), (1, 2), (0, 1)])
    """
    first, greatest = loop.index(min(loop)), max(loop)
    ring = [*loop[first:], *loop[:first]]
    last = ring.index(greatest)
    # The bottom chain ends at the greatest vertex, the upper end of any vertical edge on the right.
    bottom, top = ring[: last + 1], ring[last:]
    while bottom[-2][0] == greatest[0]:
        bottom.pop()
    if top[-1][0] != bottom[0][0]:
        top.append(ring[0])
    return bottom, top


def precedes(first: Break | HomogeneousPoint, second: Break | HomogeneousPoint) -> bool:
    """Decide whether a break or a point lies left of another."""
    return first[0] * second[-1] < second[0] * first[-1]


def find_point(line: tuple[int, int, int, *tuple[object, ...]], at: Break) -> HomogeneousPoint:
    """Find the point of a line, or of a piece, at a break, reduced."""
    (dx, dy, c), (x, w) = line[:3], at
    if not dx:
        raise ChainError("the envelope has a gap: its graphs do not overlap in x")
    x, y, w = x * dx, dy * x + c * w, dx * w
    common = gcd(x, y, w)
    return x // common, y // common, w // common


def take_corners(vertices: Iterable[V]) -> list[V]:
    """Drop repeated vertices, and vertices between collinear neighbors."""
    kept: list[V] = []
    for vertex, _ in groupby(vertices):
        if len(kept) > 1:
            (px, py, pw), (qx, qy, qw), (rx, ry, rw) = *kept[-2:], vertex
            if px * (qy * rw - ry * qw) + py * (qw * rx - rw * qx) == pw * (rx * qy - qx * ry):
                kept.pop()
        kept.append(vertex)
    return kept


class ConvexPart(NamedTuple):
    """A convex part of a chain, between reflex vertices, vertical edges or ends of the chain.

    The paper slides all of G_t along each part of D_b. Here, only *relevant* edges move along a
    part. If an edge of G slid over a reflex vertex of D_b, G would overlap D. So along a part of
    D_b, the relevant edges of G are those with slopes between the slopes of the part, and vice
    versa. At an end of the chain, and at a vertical edge that leads up from the part, G may leave
    the part, so all slopes beyond those of the part are relevant as well.

    Attributes:
        vertices: the vertices of the whole chain.
        first: the index of the first vertex of the part.
        edges: the edges of the part, sorted by slope.
        least_slope, greatest_slope: the bounds of all relevant edges.
    """

    vertices: list[HomogeneousPoint]
    first: int
    edges: list[SlopedEdge]
    least_slope: SlopeBound
    greatest_slope: SlopeBound

    def faces(self, other: ConvexPart) -> bool:
        """Decide whether two parts have edges that are relevant to each other."""
        return self.least_slope < other.greatest_slope and other.least_slope < self.greatest_slope


def partition(generatrix: Chain, directrix: Chain) -> tuple[list[ConvexPart], list[ConvexPart]]:
    """Partition reversed G_t and D_b into convex parts (step 1 of Trajectory_CM, Trajectory_MM)."""
    unit = max(generatrix.unit, directrix.unit)
    return find_convex_parts(generatrix, unit, 1), find_convex_parts(directrix, unit, 0)


def find_convex_parts(chain: Chain, unit: int, owner: int) -> list[ConvexPart]:
    """Cut a chain at its reflex vertices and vertical edges into convex parts. Cost: O(n).

    Slopes are ints, in units of 1 / `unit`; `owner` is that of each `SlopedEdge`.
    """
    if known := chain.cached_parts.get((unit, owner)):
        return known
    edges: list[SlopedEdge] = [
        (dy * unit // dx if dx else inf if dy > 0 else -inf, owner, dx, dy, c)
        for dx, dy, c in chain.lines
    ]
    # Edges k - 1 and k, with the slopes b and a before and after, meet in vertex k.
    slopes = [-inf, *map(itemgetter(0), edges), inf]
    cuts = [k for k, (b, a) in enumerate(pairwise(slopes)) if not -inf < b <= a < inf]
    parts: list[ConvexPart] = []
    for first, last in pairwise(cuts):
        if chain.lines[first][0]:
            # The slope beyond an end counts only if it is infinite and extends those of the part.
            bounds = (min(slopes[first : first + 2]),), (max(slopes[last : last + 2]), inf)
            parts.append(ConvexPart(chain.vertices, first, edges[first:last], *bounds))
    chain.cached_parts[unit, owner] = parts
    return parts
