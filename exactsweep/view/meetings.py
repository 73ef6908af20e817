"""Positions at which two vertices meet, the only instantaneous contacts inside an edge of a loop.

The positions at which two given features touch form a segment that does not cross the loop. So
inside an edge of the loop, only an end of the segment can touch the loop, and there two vertices
meet.
"""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from math import inf

from exactsweep.draw.sweeps import Moving
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.region import AnyPolygon, share_lattice, to_region
from exactsweep.geometry.vectors import cross, minus, turn
from exactsweep.numbers.number import Point

# The numbers of vertex pairs, and of tests of a pair with an edge, that take about a second.
_MOST_PAIRS, _MOST_LOOKS = 250_000, 4_000_000


class Meetings:
    """The positions at which two vertices meet without overlap near them.

    Args:
        s: the moving and the stationary shape, of a sweep or a fit.
        others: further stationary shapes.
        inside: whether the moving shape is inside the stationary one, as in an inner fit.

    Attributes:
        reference: the reference point of the moving shape.
        scale: the scale of the lattice of the translations.
        translations: the translations, on the lattice, sorted.

    Cost: O((m + n) log(m + n) + p log p) for p pairs of an edge and a vertex that can touch without
    overlap. Convex polygons have O(m + n) such pairs, others O(m n).
    """

    def __init__(
        self, s: Moving, others: Sequence[AnyPolygon] = (), *, inside: bool = False
    ) -> None:
        self.reference = s.reference
        shapes = [to_region(shape, "") for shape in (s.generatrix, s.directrix, *others)]
        self.scale, (moving, around, *placed) = share_lattice(shapes)
        g = Outline(moving)
        translations = set()
        for rings in ([ring[::-1] for ring in around] if inside else around, *placed):
            d = Outline(rings)
            pairs = set()
            for i, j in find_facing(g, d):
                pairs |= {(i, j), (g.after[i], j)}
            for j, i in find_facing(d, g):
                pairs |= {(i, j), (i, d.after[j])}
            translations |= {minus(d.vertices[j], g.vertices[i]) for i, j in pairs}
        self.translations = sorted(translations)

    def on_edges(self, loop: Sequence[Point]) -> list[Point]:
        """Find the meetings inside edges of a loop of free positions, sorted.

        Cost: O(t log p), plus O(1) for each edge and each position in its x-range.

        Example:
            >>> from exactsweep import sweep
            >>> s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], [(0, 0), (3, 0), (0, 3)])
            >>> Point(2, -1) in Meetings(s).on_edges(s.trajectory.vertices)
            True
        """
        (rx, ry), scale = self.reference, self.scale
        raised = [((x - rx) * scale, (y - ry) * scale) for x, y in loop]
        found = set()
        for p, q in pairwise([*raised, raised[0]]):
            low, high = sorted((p, q))
            start = bisect_right(self.translations, low)
            for x, y in self.translations[start : bisect_left(self.translations, high)]:
                if not turn(low, high, (x, y)):
                    found.add(Point(Fraction(x, scale) + rx, Fraction(y, scale) + ry))
        return sorted(found)


def find_meetings(
    s: Moving, corners: int, others: Sequence[AnyPolygon] = (), *, inside: bool = False
) -> Meetings | None:
    """Find the meetings of vertices; return None if the search would take more than a second."""
    if len(s.generatrix) * sum(map(len, (s.directrix, *others))) > _MOST_PAIRS:
        return None
    found = Meetings(s, others, inside=inside)
    return found if len(found.translations) * corners <= _MOST_LOOKS else None


def find_facing(shape: Outline, outline: Outline) -> Iterator[tuple[int, int]]:
    """Find the pairs of an edge and a vertex that can touch without overlap.

    An edge touches a vertex from outside only if both edges at the vertex run on the other side of
    its line. Then the vertex is convex, and the direction of the reversed edge lies between those
    of the two edges.

    Args:
        shape: the features of a polygon.
        outline: those of the other polygon, no three neighbours collinear.

    Returns:
        (number of the edge, number of the vertex).

    Cost: O((m + n) log n + pairs) for n edges and m vertices.

    >>> square, steep = Outline([[(0, 0), (1, 0), (1, 1), (0, 1)]]), Outline([[(1, 0), (0, 1)]])
    >>> sorted(pair for pair in find_facing(steep, square) if pair[0] == 0)
    [(0, 0)]
    """
    # Slopes of edges no wider than 2**n differ by 4**-n, so ints in that unit have their order.
    widths = [piece.direction[0] for o in (shape, outline) for piece in o.pieces]
    bits = 2 * max(widths).bit_length()

    def angle(o: Outline, k: int, *, turned: bool) -> tuple[bool, float]:
        """Return a key that orders directed edges by angle, from -90 degrees, exclusive."""
        a, b = o.pieces[k].direction
        p, q = o.edge(k)
        return (p > q) != turned, (b << bits) // a if a else inf

    order = sorted((angle(shape, i, turned=True), i) for i in range(len(shape.vertices)))
    angles = [key for key, _ in order]
    directions = [angle(outline, k, turned=False) for k in range(len(outline.vertices))]
    for j, into in enumerate(outline.before):
        first, last = directions[into], directions[j]
        if (cross(outline.pieces[into].direction, outline.pieces[j].direction) > 0) == (
            first[0] == last[0]
        ):
            start, end = bisect_left(angles, first), bisect_right(angles, last)
            found = order[start:end] if first <= last else order[start:] + order[:end]
            for _, i in found:
                yield i, j
