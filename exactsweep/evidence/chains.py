"""Evidence that loops and fits bound the sums: listed sums, and chains that cover their sides.

(1) For each known edge, of a loop or a fit, list sums with a side along it; prefer those with sides
    along the most known edges.
(2) Each side of a listed sum is covered from its start to its end by, in order of preference, known
    edges, the sum that covered the end of the last side, the largest listed sum, or the largest
    unlisted sum, which is then listed.
(3) An uncovered interval is a slit. Slits count as known edges.
"""

from __future__ import annotations

from bisect import insort
from collections import Counter, defaultdict
from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import isqrt
from typing import Any, NamedTuple

from exactsweep.evidence.homogeneous import (
    DirectedSegment,
    Interval,
    clip,
    find_between,
    intersect,
    is_along,
    is_on_border,
    is_right,
)
from exactsweep.evidence.slits import Gap, unite
from exactsweep.evidence.sums import CellBox, Sums
from exactsweep.geometry.near import boxes_meet

_STRIPS = 8
"""The number of strips divided by the square root of the number of known edges."""
_WHOLE = Fraction(0), Fraction(1)


class Covering(NamedTuple):
    """Sums and chains that prove a boundary.

    Attributes:
        sums: for each listed sum, its number and the list of chains of its sides.
        around: a chain for each half-plane.
        slits: the slits.
    """

    sums: list[list[Any]]
    around: list[list[int]]
    slits: list[DirectedSegment]


def find_evidence(sums: Sums, known: Sequence[DirectedSegment]) -> Covering:
    """Find sums whose sides are covered by known edges, slits and one another.

    `known` contains fits, and the edges of loops with the sums on their left; if these are not the
    boundary of the sums, the Covering proves nothing.
    """
    finder = _Finder(sums, len(known))
    finder.add_known(known)
    finder.cover()
    slits = unite((gap for gaps in finder.gaps.values() for gap in gaps), known)
    if slits:
        finder.add_known(slits)
        finder.close_gaps()
    return finder.write(slits)


class _Strips:
    """Boxes of listed sums in strips of the plane, largest sums first."""

    def __init__(self, box: CellBox, count: int) -> None:
        self._left, self._width = box[0], (box[1] - box[0]) // count + 1
        self._sums: dict[int, list[tuple[int, int, CellBox]]] = defaultdict(list)

    def add(self, k: int, area: int, box: CellBox) -> None:
        first, last = ((end - self._left) // self._width for end in box[:2])
        for strip in range(first, last + 1):
            insort(self._sums[strip], (-area, k, box))

    def find_near(self, box: CellBox) -> Iterator[int]:
        """Find the sums whose boxes touch the box of a point."""
        strip = self._sums[(box[0] - self._left) // self._width]
        return (k for _, k, other in strip if boxes_meet(box, other))


class _Finder:
    """A search for evidence: the sums listed so far, their chains, and the gaps in their sides."""

    def __init__(self, sums: Sums, count: int) -> None:
        self._sums = sums
        self._known: list[DirectedSegment] = []
        # Known edges that touch the box of a sum, by its number.
        self._edges: dict[int, list[int]] = defaultdict(list)
        self._listed: list[int] = []
        self._chains: dict[int, list[list[int]]] = {}
        self._strips = _Strips(sums.box, _STRIPS * isqrt(count) + 1)
        self._last = -1
        self.gaps: dict[tuple[int, int], list[Gap]] = {}
        for k in range(sums.count, len(sums.boxes)):
            self._list(k)

    def add_known(self, edges: Sequence[DirectedSegment]) -> None:
        """Add known edges, and list the sums along them, which are left of loops."""
        first = len(self._known)
        self._known += edges
        near = {}
        for n, edge in enumerate(edges, first):
            near[n] = list(self._sums.find_near(self._sums.bound((edge.start, edge.end))))
        for n, numbers in near.items():
            for k in numbers:
                self._edges[k].append(n)
        wanted = [found for n in near for found in self._find_along(n, near[n])]
        gain = Counter(k for found in wanted for k, _ in found)
        for found in wanted:
            self._list_along(found, gain)

    def _find_along(self, n: int, near: Sequence[int]) -> list[list[tuple[int, Interval]]]:
        """Find the sums with sides along a known edge, right and left of it, with intervals."""
        edge = self._known[n]
        if edge.start == edge.end:
            return [[(k, _WHOLE) for k in near if is_on_border(self._sums.sides(k), edge.start)]]
        found: list[list[tuple[int, Interval]]] = [[], []]
        (dx, dy) = edge.direction
        for k in near:
            for side in self._sums.sides(k):
                if is_along(edge, side) and (span := intersect(edge, side)):
                    is_left = dx * side.direction[0] + dy * side.direction[1] > 0
                    found[is_left].append((k, span))
        return found

    def _list_along(self, found: Sequence[tuple[int, Interval]], gain: Counter[int]) -> None:
        """List sums that cover an edge, preferring those along the most known edges."""

        def rank(k: int) -> tuple[bool, int, int]:
            is_listed = k in self._chains
            return is_listed, gain[k], 0 if is_listed else self._sums.measure(k)

        reach = Fraction(0)
        while reach < 1:
            ahead = {k: high for k, (low, high) in found if low <= reach < high}
            if not ahead:
                return
            best = max(ahead, key=rank)
            self._list(best)
            reach = ahead[best]

    def _list(self, k: int) -> None:
        if k not in self._chains:
            self._chains[k] = []
            self._listed.append(k)
            self._strips.add(k, self._sums.measure(k), self._sums.boxes[k])

    def cover(self) -> None:
        """Find a chain for each side of listed sums, and list more sums if necessary."""
        for k in self._listed:
            if not self._chains[k]:
                self._last = -1
                sides, edges = self._sums.sides(k), self._find_edges(k)
                self._chains[k] = [self._cover(side, edges, (k, s)) for s, side in enumerate(sides)]

    def close_gaps(self) -> None:
        """Cover the sides with gaps again."""
        gaps, self.gaps = self.gaps, {}
        for k, s in gaps:
            self._chains[k][s] = self._cover(self._sums.sides(k)[s], self._find_edges(k), (k, s))
        self.cover()

    def _find_edges(self, k: int) -> list[int]:
        """Find the known edges that no side of sum k separates from the sum."""
        sides, known = self._sums.sides(k), self._known
        return [n for n in self._edges[k] if not any(is_right(side, known[n]) for side in sides)]

    def _cover(self, side: DirectedSegment, edges: Sequence[int], at: tuple[int, int]) -> list[int]:
        """Cover a side; return the numbers of sums, and -1 - n for known edge n."""
        start, end = side.start, side.end
        ahead = [(span, -1 - n) for n in edges if (span := intersect(side, self._known[n]))]
        ahead.sort(reverse=True)
        best: tuple[Interval, int] = (Fraction(-1), Fraction(-1)), -1
        found: list[tuple[int, Fraction, bool]] = []
        gaps: list[Gap] = []
        reach, closed = Fraction(0), False
        while reach < 1 or (reach == 1 and not closed):
            while ahead and ahead[-1][0][0] <= reach:
                best = max(best, ahead.pop(), key=lambda entry: entry[0][1])
            if (best[0][1], True) > (reach, closed):
                (low, high), n = best
            elif (entry := self._find_next(side, reach, closed)) is not None:
                (low, high), n = entry
            else:
                until = self._find_end(side, reach, closed)
                gaps.append((find_between(start, end, reach), find_between(start, end, until)))
                reach, closed = until, True
                continue
            # This entry may make the previous ones redundant.
            while found and _continues(low, n, *found[-1][1:]):
                _, reach, closed = found.pop()
            found.append((n, reach, closed))
            reach, closed = high, n < 0
        if gaps:
            self.gaps[at] = gaps
        return [n for n, *_ in found]

    def _find_next(
        self, side: DirectedSegment, reach: Fraction, closed: bool
    ) -> tuple[Interval, int] | None:
        """Find a sum that covers a side from a parameter onward, by (2), and list it."""
        box = self._sums.bound([find_between(side.start, side.end, reach)])
        for k in self._find_around(box):
            span = clip(self._sums.sides(k), side.start, side.end)
            if span and span[1] > reach and _continues(span[0], k, reach, closed):
                self._last = k
                self._list(k)
                return span, k
        return None

    def _find_around(self, box: CellBox) -> Iterator[int]:
        """Find the sums that may contain a point, in the order of (2)."""
        if self._last >= 0:
            yield self._last
        yield from self._strips.find_near(box)
        near = (k for k in self._sums.find_near(box) if k not in self._chains)
        yield from sorted(near, key=self._sums.measure, reverse=True)

    def _find_end(self, side: DirectedSegment, reach: Fraction, closed: bool) -> Fraction:
        """Find where a slit ends: at the start of the next sum or edge."""
        start, end = side.start, side.end
        near = self._sums.find_near(self._sums.bound([start, end]))
        spans = [clip(self._sums.sides(k), start, end) for k in near]
        spans += [intersect(side, edge) for edge in self._known]
        lows = [span[0] for span in spans if span]
        ahead = (low for low in lows if low > reach or (low == reach and not closed))
        return min(ahead, default=Fraction(1))

    def write(self, slits: list[DirectedSegment]) -> Covering:
        """Number the listed sums, and then the half-planes."""
        # Half-planes were listed first.
        count = len(self._sums.boxes) - self._sums.count
        planes, listed = self._listed[:count], self._listed[count:]
        at = {k: n for n, k in enumerate((*listed, *planes))}
        written = {
            k: [[n if n < 0 else at[n] for n in entries] for entries in self._chains[k]] for k in at
        }
        sums = [[k, written[k]] for k in listed]
        return Covering(sums, [written[k][0] for k in planes], slits)


def _continues(low: Fraction, n: int, reach: Fraction, closed: bool) -> bool:
    """Decide whether a chain entry that begins at `low` continues the covered range."""
    return low < reach or (low == reach and (closed or n < 0))
