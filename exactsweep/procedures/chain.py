"""X-monotone chains and their convex parts (Sections 2 to 4, Definitions 3.1, 5.1 and 5.2).

A polygon that is monotone in X has a bottom chain and a top chain (Figure 2). The inverse
of a top chain is a bottom chain. So every `Chain` runs from left to right and bounds a region above
it. Vertical edges may stand anywhere (weak monotonicity). Numbers are ints, unless the common
denominator of a polygon is too long (`Polygon.lattice`); homogeneous coordinates keep crossings in
ints, too.

Errata. The paper calls a chain convex if a straight edge closes it to a convex polygon. Lemma 3.1
needs one side: here a convex chain turns left at every vertex. The paper measures slopes
"clockwise" and means counter-clockwise.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain as link
from itertools import groupby, pairwise
from math import gcd, inf
from typing import NamedTuple, TypeVar

from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Rational, Vertex, divide_exactly, ratio

T = TypeVar("T")

Break = tuple[Rational, Rational]
"""(x, w): the abscissa x/w, w > 0; not reduced."""

Line = tuple[Rational, Rational, Rational, *tuple[object, ...]]
"""(dx, dy, c, ...): the points with y = (dy x + c) / dx, dx > 0; other items do not matter."""

Homogeneous = tuple[Rational, Rational, Rational]
"""(x, y, w): the point (x/w, y/w), w > 0."""

SlopedEdge = tuple[Rational, int, Rational, Rational, Rational]
"""(slope, 0 for D_b or 1 for reversed G_t, dx, dy, c): an edge with its line, sorted by slope."""

SlopeBound = tuple[Rational | float, ...]
"""(slope,), before all edges of that slope, or (slope, infinity), after them."""


class ChainError(ExactSweepError):
    """A sequence of points that is not an X-monotone chain."""


class Chain:
    """An X-monotone chain, from left to right. Iteration yields its points.

    Attributes:
        vertices: the vertices, in homogeneous coordinates.
        lines: item k is the line of edge k, from vertex k to the next; None if vertical.

    >>> list(Chain.of([(0, 0), (1, -1), (2, 0)]).half_turn())
    [(-2, 0), (-1, 1), (0, 0)]
    """

    __slots__ = ("_lines", "_parts", "vertices")

    def __init__(self, vertices: list[Homogeneous], lines: list[Line | None] | None = None) -> None:
        self.vertices, self._lines = vertices, lines
        self._parts: dict[tuple[int, Rational], list[ConvexPart]] = {}

    @classmethod
    def of(cls, points: Sequence[Vertex]) -> Chain:
        """Make a chain of points, from left to right; repeated points count once.

        Raises ChainError if x decreases, or never increases. Cost: O(n).
        """
        if not all(issubclass(kind, int) for kind in {*map(type, link.from_iterable(points))}):
            points = [(Fraction(x), Fraction(y)) for x, y in points]
        points = [point for point, _ in groupby(points)]
        lines: list[Line | None] = []
        for (px, py), (qx, qy) in pairwise(points):
            dx, dy = qx - px, qy - py
            if dx < 0:
                raise ChainError(f"({qx}, {qy}) lies left of ({px}, {py}): not an X-monotone chain")
            lines.append((dx, dy, py * dx - px * dy) if dx else None)
        if not any(lines):
            raise ChainError("zero width: all edges of the chain are vertical")
        return cls([(x, y, 1) for x, y in points], lines)

    @property
    def lines(self) -> list[Line | None]:
        """The lines of the edges, computed on first access if missing."""
        if self._lines is None:
            self._lines = [_join(p, q) for p, q in pairwise(self.vertices)]
        return self._lines

    @property
    def points(self) -> list[Vertex]:
        """The vertices as pairs of rational numbers."""
        return [(x, y) if w == 1 else (ratio(x, w), ratio(y, w)) for x, y, w in self.vertices]

    def __iter__(self) -> Iterator[Vertex]:
        return iter(self.points)

    def half_turn(self) -> Chain:
        """Return the complement of the chain (Definition 5.2) after a half turn. Cost: O(n)."""
        return Chain(
            [(-x, -y, w) for x, y, w in reversed(self.vertices)],
            [line and (line[0], line[1], -line[2]) for line in reversed(self.lines)],
        )


def _join(p: Homogeneous, q: Homogeneous) -> Line | None:
    (px, py, pw), (qx, qy, qw) = p, q
    dx = qx * pw - px * qw
    return (dx, qy * pw - py * qw, py * qx - px * qy) if dx else None


def inverse(points: Iterable[Vertex]) -> list[Vertex]:
    """Mirror points about the origin, in the same order (Definition 5.1). Cost: O(n).

    The bottom chain of a polygon becomes the top chain of its inverse, and vice versa.

    >>> inverse([(2, 0), (1, 3), (0, 0)])
    [(-2, 0), (-1, -3), (0, 0)]
    """
    return [(-x, -y) for x, y in points]


def reverse(edges: Iterable[tuple[T, T]]) -> list[tuple[T, T]]:
    """Reverse every directed edge and keep the order of the edges (Definition 3.1).

    Laid end to end, the reversed edges of a chain are the edges of its `inverse`. Cost: O(n).

    >>> reverse([((2, 0), (1, 3)), ((1, 3), (0, 0))])
    [((1, 3), (2, 0)), ((0, 0), (1, 3))]
    """
    return [(end, start) for start, end in edges]


def complement(points: Sequence[T]) -> list[T]:
    """Return a chain traversed backwards: the boundary of the other side (Definition 5.2).

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
    # The bottom chain runs to the greatest vertex, the upper end of a vertical edge on the right.
    bottom, top = ring[: last + 1], ring[last:]
    while bottom[-2][0] == greatest[0]:
        bottom.pop()
    if top[-1][0] != bottom[0][0]:
        top.append(ring[0])
    return bottom, top


def precedes(first: Break, second: Break) -> bool:
    """Decide whether a break lies left of another one."""
    return first[0] * second[1] < second[0] * first[1]


def find_point(line: Line, at: Break) -> Homogeneous:
    """Find the point of a line at a break, reduced."""
    dx, dy, c = line[:3]
    x, w = at
    if not dx:
        raise ChainError("the envelope has a gap: its graphs do not overlap in x")
    x, y, w = x * dx, dy * x + c * w, dx * w
    try:
        common = gcd(x, y, w)  # type: ignore[arg-type]
    except TypeError:
        return ratio(x, w), ratio(y, w), 1
    return x // common, y // common, w // common


def take_corners(vertices: Iterable[Homogeneous]) -> list[Homogeneous]:
    """Drop repeated vertices, and vertices between collinear neighbours. Cost: O(n)."""
    kept: list[Homogeneous] = []
    for vertex, _ in groupby(vertices):
        if len(kept) > 1 and _are_collinear(kept[-2], kept[-1], vertex):
            kept.pop()
        kept.append(vertex)
    return kept


def _are_collinear(p: Homogeneous, q: Homogeneous, r: Homogeneous) -> bool:
    (px, py, pw), (qx, qy, qw), (rx, ry, rw) = p, q, r
    return px * (qy * rw - ry * qw) + py * (qw * rx - rw * qx) + pw * (qx * ry - rx * qy) == 0


class ConvexPart(NamedTuple):
    """A convex part of a chain, between two reflex vertices, vertical edges or ends of the chain.

    If an edge of G slid over a reflex vertex of D_b, G would overlap D. So along a part of D_b only
    edges of G with slopes between those of the part are relevant, and vice versa. At an end of the
    chain, and at a vertical edge to a higher neighbour, G may leave the part: there all slopes
    beyond those of the part are relevant, too.

    Attributes:
        vertices: the vertices of the whole chain.
        first: the number of the first vertex of the part.
        edges: the edges of the part, in order of slope.
        flattest: a lower bound of all relevant edges.
        steepest: an upper bound of all relevant edges.
    """

    vertices: list[Homogeneous]
    first: int
    edges: list[SlopedEdge]
    flattest: SlopeBound
    steepest: SlopeBound


def measure_unit(*chains: Chain) -> Rational:
    """Return the number of units in slope 1 that distinguishes all slopes of some chains.

    Slopes of edges of width at most w differ by at least 1 / w^2. So slopes rounded down to
    multiples of a unit of at most 1 / w^2 keep their order, and equal ints are equal slopes. For
    Fractions there is no such number: 0, for exact slopes.
    """
    ends = [(chain.vertices[0], chain.vertices[-1]) for chain in chains]
    if not all(isinstance(left, int) for (left, _, _), _ in ends):
        return 0
    width = max(-(-right // v) - left // w for (left, _, w), (right, _, v) in ends)
    return 1 << 2 * width.bit_length()


def partition(generatrix: Chain, directrix: Chain) -> tuple[list[ConvexPart], list[ConvexPart]]:
    """Partition reversed G_t and D_b into convex parts (step 1 of Trajectory_CM, Trajectory_MM)."""
    unit = measure_unit(generatrix, directrix)
    return find_convex_parts(generatrix, 1, unit), find_convex_parts(directrix, 0, unit)


def find_convex_parts(
    chain: Chain, whose: int = 0, unit: Rational | None = None
) -> list[ConvexPart]:
    """Cut a chain at its reflex vertices and vertical edges into convex parts. Cost: O(n).

    Args:
        chain: the chain, which caches its parts, because nesting programs sweep each polygon often.
        whose: the second item of each `SlopedEdge`: 0 for D_b, 1 for reversed G_t.
        unit: as from `measure_unit`; by default that of this chain alone.
    """
    unit = measure_unit(chain) if unit is None else unit
    if known := chain._parts.get((whose, unit)):
        return known
    edges = [
        line
        and (
            line[1] * unit // line[0] if unit else divide_exactly(line[1], line[0]),
            whose,
            line[0],
            line[1],
            line[2],
        )
        for line in chain.lines
    ]
    # A part begins after a vertical edge, and where the slope decreases.
    starts = [
        k for k, (d, e) in enumerate(pairwise([None, *edges])) if e and (not d or e[0] < d[0])
    ]
    heights: list[Break] = [(y, w) for _, y, w in chain.vertices]
    parts: list[ConvexPart] = []
    for first, end in pairwise([*starts, len(edges)]):
        own = [edge for edge in edges[first:end] if edge]
        last = first + len(own)
        flattest: SlopeBound = (own[0][0],)
        steepest: SlopeBound = (own[-1][0], inf)
        if first == 0 or (not edges[first - 1] and precedes(heights[first], heights[first - 1])):
            flattest = (-inf,)
        if last == len(edges) or (not edges[last] and precedes(heights[last], heights[last + 1])):
            steepest = (inf,)
        parts.append(ConvexPart(chain.vertices, first, own, flattest, steepest))
    chain._parts[whose, unit] = parts
    return parts
