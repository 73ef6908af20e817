"""Proofs for certificates, as `check/CERTIFICATES.md` describes them: pieces, sums and chains.

Nothing here is trusted. The finder lists a sum beside each edge of a loop or fit, and then, as long
as a side of a listed sum has a point that neither listed sums nor edges cover, the largest sum
around that point. Where no sum is around it there is a slit: a position that is free, between
others that are not.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise
from math import lcm
from typing import Any

from exactsweep.check import standalone
from exactsweep.check.standalone import (
    Edge,
    Node,
    Ring,
    Span,
    Sums,
    Work,
    edges,
    line,
    node,
    place,
    ring,
    shape,
    turn,
)
from exactsweep.geometry.convex import IntRing, cut_to_convex
from exactsweep.numbers.digits import format_fraction

_STRIPS = 64
_EDGES = 3  # of a convex polygon, on either side of a slice


def add_proof(certificate: dict[str, Any]) -> dict[str, Any]:
    """Add the key `proof`, by which `check/standalone.py` proves a certificate.

    Args:
        certificate: of a sweep, a no-fit polygon or an inner fit, without a proof.

    Returns:
        A new dict. If the answer is wrong, it is not proved. The certificate of a sweep of polygons
        with a shared direction needs no proof and gets none.

    Cost: that of `cut_to_convex` for both shapes, and O(k log k) sums of pieces, with k those that
    are near edges of the answer.

    Example:
        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> standalone.prove(add_proof(sweep(square, square).certificate()))
        'CC sweep of 4 around 4 vertices, trajectory 4, inner 4, outer 4, area 8'
    """
    if "claim" not in certificate:
        return dict(certificate)
    prover = _PROVERS[certificate["claim"]]
    return {**certificate, "proof": prover(certificate, Work(standalone.MAX_STEPS))}


def _prove_no_fit(certificate: dict[str, Any], work: Work) -> dict[str, Any]:
    d, g = (shape(certificate[key]) for key in ("directrix", "generatrix"))
    work.fit(d + g)
    still, moving = _cut(d), _cut(g)
    holes = [ring(hole)[::-1] for hole in certificate["holes"]]
    finder = _Finder(
        Sums(still, [*map(turn, moving)], work, []),
        [ring(certificate["exterior"]), *holes],
        standalone.read_fits(certificate["exact_fits"]),
    )
    return {"directrix": _write(still), "generatrix": _write(moving), "sums": finder.find()}


def _prove_inner_fit(certificate: dict[str, Any], work: Work) -> dict[str, Any]:
    container, part = (shape(certificate[key]) for key in ("container", "part"))
    work.fit(container + part)
    wide, high = (
        max(of) - min(of) for of in zip(*map(place, chain.from_iterable(part)), strict=True)
    )
    xs, ys = zip(*map(place, chain.from_iterable(container)), strict=True)
    ends = (
        min(xs) // 1 - wide // 1 - 1,
        min(ys) // 1 - high // 1 - 1,
        max(xs) // 1 + wide // 1 + 2,
        max(ys) // 1 + high // 1 + 2,
    )
    frame = standalone.frame(*map(Fraction, ends))
    outer, *defects = (one[::-1] for one in container)
    outside = [*_cut([frame, outer]), *chain.from_iterable(_cut([one]) for one in defects)]
    moving = _cut(part)
    turned = [*map(turn, moving)]
    loops = [
        one if k else one[::-1]
        for region in certificate["regions"]
        for k, one in enumerate(map(ring, (region["exterior"], *region["holes"])))
    ]
    sums = Sums(outside, turned, work, standalone.find_positions(frame, turned))
    finder = _Finder(sums, loops, standalone.read_fits(certificate["exact_fits"]))
    return {
        "frame": [format_fraction(Fraction(end)) for end in ends],
        "outside": _write(outside),
        "part": _write(moving),
        "sums": finder.find(),
        "around": finder.around,
    }


def _prove_sweep(certificate: dict[str, Any], work: Work) -> dict[str, Any]:
    around = _prove_no_fit(certificate, work)
    trajectory, inner, outer = (ring(certificate[key]) for key in ("exterior", "inner", "outer"))
    unswept = [ring(hole)[::-1] for hole in certificate["unswept"]]
    moving = _cut(shape(certificate["generatrix"]))
    sums = Sums([*map(list, edges(trajectory))], moving, work, [])
    finder = _Finder(sums, [outer, inner[::-1], *unswept], [])
    swept = finder.find()
    return {**around, "swept": swept, "slits": _write(finder.slits)}


_PROVERS = {"no_fit": _prove_no_fit, "inner_fit": _prove_inner_fit, "sweep": _prove_sweep}


class _Finder:
    """Sums whose sides are covered by each other, by loops, fits and slits.

    Attributes:
        around: a chain for each edge of B, once found.
        slits: the slits, once found.
    """

    def __init__(self, sums: Sums, loops: Sequence[Ring], fits: Sequence[Edge]) -> None:
        self._sums = sums
        self._known: list[Edge] = [*chain.from_iterable(map(edges, loops)), *fits]
        self._beyond = sums.beyond
        self._listed: dict[int, int] = {}
        self._areas: dict[int, int] = {}
        left, right, *_ = (
            one + other for one, other in zip(*(tree[0] for tree in sums.trees), strict=True)
        )
        self._left, self._width = left, (right - left) // _STRIPS + 1
        self._strips: dict[int, list[tuple[standalone.Grid, int]]] = defaultdict(list)
        self._gaps: list[Edge] = []
        self.around: list[list[int] | int] = []
        self.slits: list[Edge] = []

    def find(self) -> list[list[Any]]:
        """List sums, each with a chain for each of its sides."""
        for n in range(len(self._known)):
            self._list_beside(n)
        found = self._list_chains()
        if self._gaps:
            self.slits = _unite(self._gaps, self._known)
            self._known += self.slits
            found = self._list_chains()
        # Half-planes are numbered after sums.
        numbers = list(self._listed)
        at = {k: n for n, k in enumerate(numbers)} | {
            k: len(numbers) + n for n, k in enumerate(self._beyond)
        }
        written = {
            k: [
                one[0] if len(one) == 1 else one
                for one in ([n if n < 0 else at[n] for n in side] for side in sides)
            ]
            for k, sides in found.items()
        }
        self.around = [written[k][0] for k in self._beyond]
        return [[k, *written[k]] for k in numbers]

    def _list_beside(self, n: int) -> None:
        """List sums with sides along an edge; on the right of a loop there are none."""
        a, b = self._known[n]
        near = self._near([a, b])
        if a == b:
            at = [
                k for k in near if min(standalone.side(of, a) for of in self._sums.get(k)[0]) == 0
            ]
            self._list_one(at)
            return
        for start, end in ((a, b), (b, a)):
            spans = [
                (k, span)
                for k in near
                for of, side in zip(*self._sums.get(k), strict=True)
                if standalone.side(of, start) == 0 == standalone.side(of, end)
                and (span := standalone.share(start, end, *side))
                and _is_along(start, end, *side)
            ]
            reach = Fraction(0)
            while reach < 1:
                on = {k: high for k, (low, high) in spans if low <= reach < high}
                if not on:
                    break
                reach = on[self._list_one(on)]

    def _list_one(self, numbers: Iterable[int]) -> int:
        """List the largest of some sums, unless one is listed."""
        best = max(numbers, key=lambda k: (k in self._listed, self._measure(k)), default=-1)
        if 0 <= best < self._sums.count and best not in self._listed:
            self._listed[best] = len(self._listed)
            box = self._box([p for p, _ in self._sums.get(best)[1]])
            first, last = ((end - self._left) // self._width for end in box[:2])
            for strip in range(first, last + 1):
                self._strips[strip].append((box, best))
        return best

    def _measure(self, k: int) -> int:
        """Measure a sum, roughly: twice its area, its corners rounded to the grid of boxes."""
        if k not in self._areas:
            corners = [p for p, _ in self._sums.get(k)[1]]
            scale = self._sums.work.scale
            points = [(x * scale // w, y * scale // w) for x, y, w in corners]
            around = pairwise([*points, points[0]])
            self._areas[k] = sum(x * v - u * y for (x, y), (u, v) in around)
        return self._areas[k]

    def _list_chains(self) -> dict[int, list[list[int]]]:
        """Find a chain for each side of listed sums, which may list more."""
        found: dict[int, list[list[int]]] = {}
        self._gaps = []
        boxes = [(self._box(edge), n) for n, edge in enumerate(self._known)]
        self._trees = [standalone.tree(boxes)] if boxes else []
        for k in self._beyond:
            found[k] = [self._cover(*side) for side in self._sums.get(k)[1]]
        numbers = list(self._listed)
        for k in numbers:
            before = len(self._listed)
            found[k] = [self._cover(*side) for side in self._sums.get(k)[1]]
            numbers += list(self._listed)[before:]
        return found

    def _box(self, points: Sequence[Node]) -> standalone.Grid:
        return standalone.grid_box(points, self._sums.work.scale)

    def _near(self, points: Sequence[Node]) -> list[int]:
        """List the half-planes, and the sums whose boxes meet that of points or touch it."""
        left, right, low, high = self._box(points)
        around: standalone.Tree = (left - 1, right + 1, low - 1, high + 1), -1, 0
        near = standalone.meet([around, *self._sums.trees], self._sums.work)
        return [*self._beyond, *(i * len(self._sums.h) + j for _, i, j in near)]

    def _cover(self, a: Node, b: Node) -> list[int]:
        """Cover a segment: entries -1 - n for edges, and numbers of sums."""
        reach, closed, found = Fraction(0), False, list[tuple[int, Fraction, bool]]()
        while reach < 1 or (reach == 1 and not closed):
            p = _along(a, b, reach)
            box = self._box([p])
            spans = [
                (span, -1 - n)
                for tree in self._trees
                for n in _list_near(tree, box)
                if (span := standalone.share(a, b, *self._known[n])) and span[0] <= reach
            ]
            strip = self._strips[(box[0] - self._left) // self._width]
            listed = [k for around, k in strip if standalone.are_near(around, box)]
            spans += self._clip([*self._beyond, *listed], a, b, reach, closed)
            best = max(spans, key=lambda e: (e[0][1], e[1] < 0), default=None)
            if best is None or (best[0][1], best[1] < 0) <= (reach, closed):
                around = [k for _, k in self._clip(self._near([p]), a, b, reach, closed)]
                if not around:
                    end = self._find_end(a, b, reach, closed)
                    self._gaps.append((p, _along(a, b, end)))
                    reach, closed = end, True
                    continue
                k = self._list_one(around)
                best = self._clip([k], a, b, reach, closed)[0]
            (low, high), n = best
            # This entry may cover the stretch of the last ones, too.
            while found and _meets(low, n, *found[-1][1:]):
                _, reach, closed = found.pop()
            found.append((n, reach, closed))
            reach, closed = high, n < 0
        return [n for n, *_ in found]

    def _clip(
        self, numbers: Iterable[int], a: Node, b: Node, reach: Fraction, closed: bool
    ) -> list[tuple[Span, int]]:
        """List what sums around a point of a segment have of it."""
        spans = [(standalone.clip(self._sums.get(k)[0], a, b), k) for k in numbers]
        return [
            (span, k)
            for span, k in spans
            if span and span[1] > reach and _meets(span[0], k, reach, closed)
        ]

    def _find_end(self, a: Node, b: Node, reach: Fraction, closed: bool) -> Fraction:
        """Find where a slit ends: where the next sum or edge begins."""
        near = self._near([a, b])
        spans = [standalone.clip(self._sums.get(k)[0], a, b) for k in near]
        spans += [standalone.share(a, b, *edge) for edge in self._known]
        lows = [span[0] for span in spans if span]
        ahead = [low for low in lows if low > reach or (low == reach and not closed)]
        return min([*ahead, Fraction(1)])


def _meets(low: Fraction, n: int, reach: Fraction, closed: bool) -> bool:
    """Return whether an entry of a chain that begins at low goes on from what is reached."""
    return low < reach or (low == reach and (closed or n < 0))


def _list_near(tree: standalone.Tree, box: standalone.Grid) -> Iterator[int]:
    """List the numbers of a tree whose boxes meet another one."""
    around, size, parts = tree
    if standalone.are_near(around, box):
        if size < 0:
            yield parts
        else:
            for part in parts:
                yield from _list_near(part, box)


def _is_along(a: Node, b: Node, p: Node, q: Node) -> bool:
    """Return whether parallel edges go the same way."""
    (x, y), (u, v) = standalone.ways([a, b, p, q])[::2]
    return x * u + y * v > 0


def _along(a: Node, b: Node, share: Fraction) -> Node:
    (x, y), (u, v) = place(a), place(b)
    return node(x + share * (u - x), y + share * (v - y))


def _unite(slits: Sequence[Edge], known: Sequence[Edge]) -> list[Edge]:
    """Join slits along one line, and leave out points that are on others or known."""
    along: dict[Node, list[tuple[Any, Any]]] = defaultdict(list)
    for p, q in slits:
        if p != q:
            of = max(line(p, q), line(q, p))
            along[of].append((min(place(p), place(q)), max(place(p), place(q))))
    joined: list[Edge] = []
    for spans in along.values():
        low, high = min(spans)
        for start, end in sorted(spans):
            if start > high:
                joined.append((node(*low), node(*high)))
                low, high = start, end
            high = max(high, end)
        joined.append((node(*low), node(*high)))
    for p in {p for p, q in slits if p == q}:
        if not any(standalone.lies(p, *edge) for edge in (*known, *joined)):
            joined.append((p, p))
    return sorted(joined)


def _cut(rings: list[Ring]) -> list[Ring]:
    """Cut a shape into convex pieces of few sides."""
    scale = lcm(*(w for one in rings for _, _, w in one))
    scaled = [[(x * (scale // w), y * (scale // w)) for x, y, w in one] for one in rings]
    cut = chain.from_iterable(map(_slice, cut_to_convex(scaled)))
    return [[node(Fraction(x, scale), Fraction(y, scale)) for x, y in piece] for piece in cut]


def _slice(points: IntRing) -> Iterator[IntRing]:
    """Cut a convex polygon across into slices of few sides, whose sums have few sides."""
    last = (len(points) - 1) // 2
    for k in range(0, last, _EDGES):
        end = min(k + _EDGES, last)
        start = max(len(points) - 1 - end, end + 1)
        yield [*points[k : end + 1], *points[start : len(points) - k]]


def _write(lists: Sequence[Sequence[Node]]) -> list[list[list[str]]]:
    return [[[format_fraction(c) for c in place(p)] for p in points] for points in lists]
