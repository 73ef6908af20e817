"""Positions at which two vertices meet: the only momentary contacts inside an edge of a loop.

The positions at which two given features touch form a segment that does not cross the loop. Inside
an edge of the loop, only an end of that segment can touch the loop; there two vertices meet.
"""

from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from math import inf

from exactsweep.draw.sweeps import Moving
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.region import AnyPolygon, share_lattice, to_region
from exactsweep.geometry.vectors import cross, minus, orientation
from exactsweep.numbers.number import Point

# The numbers of vertex pairs, and of tests of a pair with an edge, that take about a second.
_MAX_PAIRS, _MAX_TESTS = 250_000, 4_000_000


class Meetings:
    """The positions at which two vertices meet without overlap near them.

    `others` are more stationary shapes; `inside` is true for inner fits. Cost:
    O((m + n) log(m + n) + p log p) for p pairs of an edge and a vertex that can touch without
    overlap; p is O(m + n) for convex polygons, and O(mn) in general.
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
        """Return the sorted meetings inside edges of a loop of free positions."""
        (rx, ry), scale = self.reference, self.scale
        corners = [((x - rx) * scale, (y - ry) * scale) for x, y in loop]
        found = set()
        for p, q in pairwise([*corners, corners[0]]):
            low, high = sorted((p, q))
            start = bisect_right(self.translations, low)
            for x, y in self.translations[start : bisect_left(self.translations, high)]:
                if not orientation(low, high, (x, y)):
                    found.add(Point(Fraction(x, scale) + rx, Fraction(y, scale) + ry))
        return sorted(found)


def find_meetings(
    s: Moving, corners: int, others: Sequence[AnyPolygon] = (), *, inside: bool = False
) -> Meetings | None:
    """Return the meetings of vertices, or None if the search would take more than a second."""
    if len(s.generatrix) * sum(map(len, (s.directrix, *others))) > _MAX_PAIRS:
        return None
    found = Meetings(s, others, inside=inside)
    return found if len(found.translations) * corners <= _MAX_TESTS else None


def find_facing(shape: Outline, outline: Outline) -> Iterator[tuple[int, int]]:
    """Yield the pairs of an edge of one polygon and a vertex of another that can touch.

    The vertex must be convex, and the direction of the reversed edge must lie between those of the
    two edges at the vertex. Cost: O((m + n) log n + pairs) for n edges and m vertices.

    >>> square, steep = Outline([[(0, 0), (1, 0), (1, 1), (0, 1)]]), Outline([[(1, 0), (0, 1)]])
    >>> sorted(pair for pair in find_facing(steep, square) if pair[0] == 0)
    [(0, 0)]
    """
    # Slopes of edges at most 2**n wide differ by at least 4**-n: ints in that unit keep the order.
    widths = [piece.direction[0] for o in (shape, outline) for piece in o.pieces]
    bits = 2 * max(widths).bit_length()

    def angle(o: Outline, k: int, *, reverse: bool) -> tuple[bool, float]:
        """Return a key that orders directed edges by angle, starting just above -90 degrees."""
        a, b = o.pieces[k].direction
        p, q = o.edge(k)
        return (p > q) != reverse, (b << bits) // a if a else inf

    order = sorted((angle(shape, i, reverse=True), i) for i in range(len(shape.vertices)))
    angles = [key for key, _ in order]
    directions = [angle(outline, k, reverse=False) for k in range(len(outline.vertices))]
    for j, into in enumerate(outline.before):
        first, last = directions[into], directions[j]
        if (cross(outline.pieces[into].direction, outline.pieces[j].direction) > 0) == (
            first[0] == last[0]
        ):
            start, end = bisect_left(angles, first), bisect_right(angles, last)
            found = order[start:end] if first <= last else order[start:] + order[:end]
            for _, i in found:
                yield i, j
