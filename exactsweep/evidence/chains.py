"""Chains of sums and known edges that cover the sides of sums.

The finder lists sums beside each known edge. Then it covers each side of a listed sum from its
start on. Where neither a known edge nor a listed sum continues, it lists the largest sum that does.
Where no sum does there is a slit: a free position between two sums.
"""

from __future__ import annotations

from bisect import insort
from collections import Counter, defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import Any, NamedTuple

from exactsweep.evidence.sums import (
    Interval,
    Node,
    Side,
    Sums,
    Tree,
    between,
    clip,
    find_touching,
    grow,
    intersect,
    is_right,
    make_node,
    make_side,
)

_STRIPS = 8
"""The number of strips for each root of the number of known edges."""


class Evidence(NamedTuple):
    """Sums and chains that prove a boundary.

    Attributes:
        sums: for each listed sum its number, and a chain for each of its sides.
        around: a chain for each half-plane.
        slits: segments and points that no sum covers, and that are no known edge.
    """

    sums: list[list[Any]]
    around: list[list[int] | int]
    slits: list[tuple[Node, Node]]


def find_evidence(sums: Sums, known: Sequence[Side], beyond: Sequence[Side] = ()) -> Evidence:
    """Find sums whose sides are covered by each other, known edges and slits.

    Args:
        sums: the sums.
        known: the edges of loops, the sums on their left, and fits.
        beyond: the boundaries of open half-planes, which count as sums.

    Returns:
        The Evidence. If the known edges are not the boundary of the sums, it proves nothing.

    Cost: O(k log k) clipped segments for k listed sums, if few sums are near each edge.
    """
    finder = _Finder(sums, known, beyond)
    finder.list_beside(range(len(known)))
    finder.cover()
    if finder.gaps:
        slits = _unite([gap for gaps in finder.gaps.values() for gap in gaps], known)
        finder.add([make_side(*slit) for slit in slits])
    else:
        slits = []
    return finder.write(slits)


class _Finder:
    def __init__(self, sums: Sums, known: Sequence[Side], beyond: Sequence[Side]) -> None:
        self._sums, self._known = sums, [*known]
        self._beyond = {sums.count + k: side for k, side in enumerate(beyond)}
        # The known edges that touch the box of a sum, and the sums whose boxes touch an edge.
        self._edges: dict[int, list[int]] = defaultdict(list)
        self._near: dict[int, list[int]] = defaultdict(list)
        self._listed: dict[int, int] = {}
        left, right, *_ = (a + b for a, b in zip(*(t.box for t in sums.trees), strict=True))
        self._left = left
        self._width = (right - left) // (_STRIPS * int(len(known) ** 0.5) + 1) + 1
        self._strips: dict[int, list[tuple[int, int, int, int, int, int]]] = defaultdict(list)
        self._chains: dict[int, list[list[int]]] = {}
        self.gaps: dict[tuple[int, int], list[tuple[Node, Node]]] = {}
        self._index(range(len(known)))

    def _index(self, numbers: Iterable[int]) -> None:
        """Find the sums near known edges."""
        boxes = [(self._sums.grid.box(self._known[n][:2]), n) for n in numbers]
        if boxes:
            for n, i, j in find_touching(grow(boxes), *self._sums.trees):
                k = i * self._sums.columns + j
                self._edges[k].append(n)
                self._near[n].append(k)
        for k, side in self._beyond.items():
            left, right, low, high = self._sums.grid.box(side[:2])
            for (west, east, south, north), n in boxes:
                if west <= right and left <= east and south <= high and low <= north:
                    self._edges[k].append(n)
                    self._near[n].append(k)

    def _sides(self, k: int) -> Sequence[Side]:
        return [self._beyond[k]] if k in self._beyond else self._sums.sides(k)

    def list_beside(self, numbers: Iterable[int]) -> None:
        """List sums with sides along known edges; on the right of a loop there are none."""
        wanted: list[list[tuple[int, Interval]]] = []
        for n in numbers:
            edge = self._known[n]
            p, q = edge[:2]
            if p == q:
                span = Fraction(0), Fraction(1)
                wanted.append(
                    [(k, span) for k in self._near[n] if _is_on_border(self._sides(k), p)]
                )
                continue
            along: tuple[list[tuple[int, Interval]], ...] = [], []
            (dx, dy), (a, b, c) = edge.direction, edge.line
            for k in self._near[n]:
                for side in self._sides(k):
                    ex, ey = side.direction
                    if dx * ey == dy * ex:
                        x, y, w = side.start
                        if a * x + b * y + c * w == 0:
                            span = intersect(edge, side)
                            if span and span[0] < 1 and span[1] > 0:
                                along[dx * ex + dy * ey > 0].append((k, span))
            wanted += along
        gain = Counter(k for spans in wanted for k, _ in spans)
        for spans in wanted:
            reach = Fraction(0)
            while reach < 1:
                on = {k: high for k, (low, high) in spans if low <= reach < high}
                if not on:
                    break
                best = max(
                    on,
                    key=lambda k: (
                        k in self._listed or k in self._beyond,
                        gain[k],
                        self._sums.measure(k) if k < self._sums.count else 0,
                    ),
                )
                if best not in self._listed and best not in self._beyond:
                    self._list(best)
                reach = on[best]

    def _list(self, k: int) -> None:
        self._listed[k] = len(self._listed)
        entry = (-self._sums.measure(k), k, *self._sums.box(k))
        for strip in range(
            (entry[2] - self._left) // self._width, (entry[3] - self._left) // self._width + 1
        ):
            insort(self._strips[strip], entry)

    def cover(self) -> None:
        """Find a chain for each side of listed sums, which may list more."""
        numbers = [k for k in (*self._beyond, *self._listed) if k not in self._chains]
        for k in numbers:
            before = len(self._listed)
            sides = self._sides(k)
            known = [
                n for n in self._edges[k] if not any(is_right(s, self._known[n]) for s in sides)
            ]
            self._last = -1
            self._chains[k] = [self._cover(side, known, (k, s)) for s, side in enumerate(sides)]
            numbers += list(self._listed)[before:]

    def add(self, slits: Sequence[Side]) -> None:
        """Add slits to the known edges, and close the gaps."""
        first = len(self._known)
        self._known += slits
        self._index(range(first, len(self._known)))
        self.list_beside(range(first, len(self._known)))
        for k, s in list(self.gaps):
            self._chains[k][s] = self._cover(self._sides(k)[s], self._edges[k], (k, s))
        self.cover()

    def _cover(self, side: Side, edges: Sequence[int], at: tuple[int, int]) -> list[int]:
        """Cover a side: entries -1 - n for known edges, and numbers of sums."""
        a, b = side[:2]
        known = [(span, n) for n in edges if (span := intersect(side, self._known[n]))]
        gaps: list[tuple[Node, Node]] = []
        found: list[tuple[int, Fraction, bool]] = []
        reach, closed = Fraction(0), False
        while reach < 1 or (reach == 1 and not closed):
            ahead = [e for e in known if e[0][0] <= reach and (e[0][1], True) > (reach, closed)]
            if ahead:
                (low, high), n = max(ahead, key=lambda e: e[0][1])
                n = -1 - n
            elif (entry := self._find_next(a, b, reach, closed)) is not None:
                (low, high), n = entry
            else:
                end = self._find_end(side, reach, closed)
                gaps.append((between(a, b, reach), between(a, b, end)))
                reach, closed = end, True
                continue
            # This entry may cover the stretch of the last ones, too.
            while found and _continues(low, n, *found[-1][1:]):
                _, reach, closed = found.pop()
            found.append((n, reach, closed))
            reach, closed = high, n < 0
        if gaps:
            self.gaps[at] = gaps
        return [n for n, *_ in found]

    def _find_next(
        self, a: Node, b: Node, reach: Fraction, closed: bool
    ) -> tuple[Interval, int] | None:
        """Find a sum that continues from a parameter of a segment, and list it."""

        def clip_with(k: int) -> Interval | None:
            span = clip(self._sides(k), a, b)
            goes_on = span and span[1] > reach and _continues(span[0], k, reach, closed)
            return span if goes_on else None

        if self._last >= 0 and (span := clip_with(self._last)):
            return span, self._last
        found = self._search(between(a, b, reach), clip_with)
        if found:
            self._last = found[1]
        return found

    def _search(self, p: Node, clip_with: Any) -> tuple[Interval, int] | None:
        left, right, low, high = box = self._sums.grid.box([p])
        for k in self._beyond:
            if span := clip_with(k):
                return span, k
        for _, k, west, east, south, north in self._strips[(left - self._left) // self._width]:
            near = west <= right and left <= east and south <= high and low <= north
            if near and (span := clip_with(k)):
                return span, k
        trees = self._sums.trees
        near = [i * self._sums.columns + j for _, i, j in find_touching(Tree(box, -1, 0), *trees)]
        for k in sorted(near, key=self._sums.measure, reverse=True):
            if k not in self._listed and (span := clip_with(k)):
                self._list(k)
                return span, k
        return None

    def _find_end(self, side: Side, reach: Fraction, closed: bool) -> Fraction:
        """Find where a slit ends: where the next sum or edge begins."""
        a, b = side[:2]
        box = Tree(self._sums.grid.box([a, b]), -1, 0)
        near = [i * self._sums.columns + j for _, i, j in find_touching(box, *self._sums.trees)]
        spans = [clip(self._sides(k), a, b) for k in (*self._beyond, *near)]
        spans += [intersect(side, edge) for edge in self._known]
        lows = [span[0] for span in spans if span]
        ahead = [low for low in lows if low > reach or (low == reach and not closed)]
        return min([*ahead, Fraction(1)])

    def write(self, slits: list[tuple[Node, Node]]) -> Evidence:
        """Number the listed sums, and then the half-planes."""
        numbers = [*self._listed, *self._beyond]
        at = {k: n for n, k in enumerate(numbers)}
        written = {
            k: [
                one[0] if len(one) == 1 else one
                for one in ([n if n < 0 else at[n] for n in chain] for chain in self._chains[k])
            ]
            for k in numbers
        }
        listed = [[k, *written[k]] for k in self._listed]
        return Evidence(listed, [written[k][0] for k in self._beyond], slits)


def _continues(low: Fraction, n: int, reach: Fraction, closed: bool) -> bool:
    """Return whether an entry of a chain that begins at low continues what is covered."""
    return low < reach or (low == reach and (closed or n < 0))


def _is_on_border(sides: Sequence[Side], p: Node) -> bool:
    """Return whether a point is on the boundary of a convex polygon."""
    x, y, w = p
    return min(a * x + b * y + c * w for *_, (a, b, c) in sides) == 0


def _unite(slits: Sequence[tuple[Node, Node]], known: Sequence[Side]) -> list[tuple[Node, Node]]:
    """Join slits along one line, and leave out points that are on others or known."""
    along: dict[Any, list[Any]] = defaultdict(list)
    points = set()
    for p, q in slits:
        start, end = sorted(((Fraction(x, w), Fraction(y, w)) for x, y, w in (p, q)))
        if start == end:
            points.add(start)
            continue
        (dx, dy) = make_side(make_node(*start), make_node(*end)).direction
        along[dx, dy, dx * start[1] - dy * start[0]].append((start, end))
    joined: list[tuple[Any, Any]] = []
    for spans in along.values():
        low, high = min(spans)
        for start, end in sorted(spans):
            if start > high:
                joined.append((low, high))
                low, high = start, end
            high = max(high, end)
        joined.append((low, high))
    found = [(make_node(*p), make_node(*q)) for p, q in sorted(joined)]
    edges = [*known, *(make_side(*slit) for slit in found)]
    for p in sorted(points):
        at = make_node(*p)
        if not any(lies(at, edge) for edge in edges):
            found.append((at, at))
    return found


def lies(p: Node, edge: Side) -> bool:
    """Return whether a point is on a segment."""
    x, y, w = p
    a, b, c = edge.line
    if a * x + b * y + c * w:
        return False
    at = Fraction(x, w), Fraction(y, w)
    ends = sorted((Fraction(x, w), Fraction(y, w)) for x, y, w in edge[:2])
    return ends[0] <= at <= ends[1]
