"""Proofs for certificates, as `check/CERTIFICATES.md` describes them: pieces and chains.

Nothing here is trusted. The checker's own functions list the segments and the sums; along each
segment the finder goes from point to point, to the sum or edge around the point that reaches
farthest. Where nothing is around a point there is a slit: a position that is free, between others
that are not.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import chain
from math import lcm
from typing import Any

from exactsweep.check import standalone
from exactsweep.check.convex import cut_to_convex
from exactsweep.check.size import UNLIMITED
from exactsweep.check.standalone import (
    Edge,
    Node,
    Ring,
    Solid,
    Work,
    add,
    edges,
    line,
    node,
    place,
    ring,
    shape,
)
from exactsweep.numbers.number import format_fraction
from exactsweep.numbers.point import Vertex

_STRIPS = 64
_LONG = 2000  # bits of a common denominator that are worth while
_RECENT = 8  # sums that are tried before others


def add_proof(certificate: dict[str, Any]) -> dict[str, Any]:
    """Add the key `proof`, by which `check/standalone.py` proves a certificate.

    Args:
        certificate: of a sweep, a no-fit polygon or an inner fit, without a proof.

    Returns:
        A new dict.

    Raises:
        Refused: the answer is wrong.

    Cost: O(m n) sums of pieces, and those of them that are around the ends of the others on each
        contact segment.

    Example:
        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> standalone.prove(add_proof(sweep(square, square).certificate()))
        'CC sweep of 4 around 4 vertices, trajectory 4, inner 4, outer 4, area 8'
    """
    work = Work(standalone.MAX_STEPS)
    claim = certificate.get("claim", "sweep")
    if claim == "inner_fit":
        container, part = (shape(certificate[key]) for key in ("container", "part"))
        work.fit(container + part)
        frame, around = _frame(container)
        outside, moving = _cut_outside(container, around), _cut(part)
        loops = [
            one if k else one[::-1]
            for region in certificate["regions"]
            for k, one in enumerate(map(ring, (region["exterior"], *region["holes"])))
        ]
        fits = standalone.read_fits(certificate["exact_fits"])
        chains, _ = _Finder(outside, moving.turned(), loops, fits, work).find()
        pieces = {"outside": outside, "part": moving}
        return {**certificate, "proof": {"frame": frame, **_write(pieces), "chains": chains}}
    if claim == "no_fit":
        directrix, generatrix = (
            _cut(shape(certificate[key])) for key in ("directrix", "generatrix")
        )
        work.fit(directrix.rings + generatrix.rings)
        exterior = ring(certificate["exterior"])
        holes = [ring(hole)[::-1] for hole in certificate["holes"]]
        fits = standalone.read_fits(certificate["exact_fits"])
        finder = _Finder(directrix, generatrix.turned(), [exterior, *holes], fits, work)
        pieces = {"directrix": directrix, "generatrix": generatrix}
        return {**certificate, "proof": {**_write(pieces), "chains": finder.find()[0]}}
    return {**certificate, "proof": _prove_sweep(certificate, work)}


def _prove_sweep(certificate: dict[str, Any], work: Work) -> dict[str, Any]:
    is_any = "claim" in certificate
    directrix, generatrix = (
        _cut(shape(certificate[key]) if is_any else [ring(certificate[key])])
        for key in ("directrix", "generatrix")
    )
    work.fit(directrix.rings + generatrix.rings)
    back = (0, 0, 1) if is_any else standalone.turn([standalone.point(certificate["reference"])])[0]
    trajectory = ring(certificate["exterior" if is_any else "trajectory"])
    trajectory = [node(*place(add(p, back))) for p in trajectory]
    fits = [
        (add(p, back), add(q, back)) for p, q in standalone.read_fits(certificate["exact_fits"])
    ]
    holes, unswept = (
        [ring(hole)[::-1] for hole in certificate.get(key, [])] for key in ("holes", "unswept")
    )
    inner, outer = (ring(certificate[key]) for key in ("inner", "outer"))
    x, y, w = generatrix.rings[0][0]
    within = [
        k
        for k, hole in enumerate(unswept)
        # Is G, with a vertex of it at the middle of an edge of the hole, inside the trajectory?
        if standalone.winds(trajectory, add(_inside(hole), (-x, -y, w)))
    ]
    frame, around = _frame([trajectory])
    region, outside = _cut([trajectory]), _cut_outside([trajectory], around)
    first = _Finder(directrix, generatrix.turned(), [trajectory, *holes], fits, work).find()[0]
    free = [outer, *(hole for k, hole in enumerate(unswept) if k not in within)]
    second, between = _Finder(region, generatrix, free, [], work).find()
    free = [inner[::-1], *(hole for k, hole in enumerate(unswept) if k in within)]
    third, beside = _Finder(outside, generatrix, free, [], work).find()
    pieces = {
        "directrix": directrix,
        "generatrix": generatrix,
        "trajectory": region,
        "outside": outside,
    }
    return {
        "frame": frame,
        **_write(pieces),
        "slits": [[[_write_point(p) for p in fit] for fit in fits] for fits in (between, beside)],
        "within": within,
        "chains": [first, second, third],
    }


class _Finder:
    """Chains that cover the contact segments of two shapes by sums, loops, fits and slits."""

    def __init__(
        self, d: Solid, h: Solid, loops: Sequence[Ring], fits: Sequence[Edge], work: Work
    ) -> None:
        self._d, self._h, self._work = d, h, work
        self._known: list[Edge] = [*chain.from_iterable(map(edges, loops)), *fits]
        self._sides: dict[int, list[Node]] = {}
        self._recent: list[int] = []
        boxes = [[self._box(piece) for piece in pieces] for pieces in (d.pieces, h.pieces)]
        sums = [standalone.add_boxes(one, other) for one in boxes[0] for other in boxes[1]]
        left = min((box[0] for box in sums), default=0)
        self._left = left
        self._width = 1 + (max((box[1] for box in sums), default=0) - left) // _STRIPS
        # Large ones first.
        order = sorted(
            range(len(sums)),
            key=lambda k: (sums[k][0] - sums[k][1]) * (sums[k][3] - sums[k][2]),
        )
        self._boxes, self._beyond = sums, range(len(sums), len(sums) + len(d.beyond))
        self._strips: dict[int, list[int]] = defaultdict(list)
        for k in order:
            for strip in self._list_strips(sums[k]):
                self._strips[strip].append(k)
        self._edges: dict[int, list[int]] = defaultdict(list)
        self._list_edges(0)

    def find(self) -> tuple[list[list[int]], list[Edge]]:
        """Find a chain for each segment, and the slits that some of them need."""
        contacts = list(standalone.list_contacts(self._d, self._h, self._work))
        found: list[list[int]] = []
        slits: list[Edge] = []
        again = []
        for n, (a, b) in enumerate(contacts):
            missing = len(slits)
            found.append(self._cover(a, b, slits))
            if len(slits) > missing:
                again.append(n)
        first = len(self._known)
        self._known += _unite(slits, self._known)
        self._list_edges(first)
        for n in again:
            found[n] = self._cover(*contacts[n], slits)
        return found, self._known[first:]

    def _box(self, points: Sequence[Node]) -> standalone.Grid:
        return standalone.grid_box(points, self._work.scale)

    def _list_strips(self, box: standalone.Grid) -> range:
        first, last = ((end - self._left) // self._width for end in box[:2])
        # All that is left or right of the sums is in the first or the last strip.
        return range(min(max(first, 0), _STRIPS), min(max(last, 0), _STRIPS) + 1)

    def _list_edges(self, first: int) -> None:
        for k in range(first, len(self._known)):
            for strip in self._list_strips(self._box(self._known[k])):
                self._edges[strip].append(k)

    def _clip(self, k: int, a: Node, b: Node) -> standalone.Span | None:
        if k not in self._sides:
            self._sides[k] = standalone.sum_sides(self._d, self._h, k)
        return standalone.clip(self._sides[k], a, b)

    def _cover(self, a: Node, b: Node, slits: list[Edge]) -> list[int]:
        reach, closed, found = Fraction(0), False, []
        while reach < 1 or (reach == 1 and not closed):
            best = self._reach_from(a, b, reach, closed)
            if best is None:
                # Free from here to where the next sum begins.
                lows = [low for low, _ in self._list_spans(a, b)]
                ahead = [low for low in lows if low > reach or (low == reach and not closed)]
                end = min([*ahead, Fraction(1)])
                slits.append((_along(a, b, reach), _along(a, b, end)))
                reach, closed = end, True
                continue
            (reach, closed), k = best
            found.append(k)
            if k >= 0 and k not in self._recent:
                self._recent = [k, *self._recent[: _RECENT - 1]]
        return found

    def _reach_from(
        self, a: Node, b: Node, reach: Fraction, closed: bool
    ) -> tuple[tuple[Fraction, bool], int] | None:
        """The sum or edge around a point that reaches farthest, and how far."""
        best: tuple[tuple[Fraction, bool], int] | None = None
        for k in self._list_around(_along(a, b, reach)):
            span = self._clip(k, a, b) if k >= 0 else standalone.share(a, b, *self._known[-1 - k])
            if span is None:
                continue
            low, high = span
            if low > reach or (low == reach and not (closed or k < 0)):
                continue
            farther = (high, k < 0)
            if farther > (reach, closed) and (best is None or farther > best[0]):
                best = farther, k
                if high > 1 or (high == 1 and k < 0):
                    break
        return best

    def _list_around(self, p: Node) -> Iterator[int]:
        """The sums and edges whose boxes have a point, those of late first."""
        yield from self._recent
        yield from self._beyond
        box = self._box([p])
        strip = self._list_strips(box)[0]
        for k in self._edges.get(strip, ()):
            if standalone.are_near(self._box(self._known[k]), box):
                yield -1 - k
        for k in self._strips.get(strip, ()):
            if standalone.are_near(self._boxes[k], box):
                yield k

    def _list_spans(self, a: Node, b: Node) -> Iterator[standalone.Span]:
        """The shares of a segment in all sums and edges."""
        box = self._box((a, b))
        for k in chain(range(len(self._boxes)), self._beyond):
            near = k >= len(self._boxes) or standalone.are_near(self._boxes[k], box)
            if near and (span := self._clip(k, a, b)):
                yield span
        yield from filter(None, (standalone.share(a, b, *edge) for edge in self._known))


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


def _cut(rings: list[Ring]) -> Solid:
    """Cut a shape into convex pieces, in ints where a common denominator is of use."""
    scale = lcm(*(w for one in rings for _, _, w in one))
    if scale.bit_length() > _LONG:
        scale = 1
    scaled: list[tuple[Vertex, ...]] = []
    for points in rings:
        found = [(x * scale, y * scale) for x, y in map(place, points)]
        scaled.append(tuple(found if scale == 1 else [(int(x), int(y)) for x, y in found]))
    cut = cut_to_convex((scaled[0], *scaled[1:]), UNLIMITED)
    pieces = [[node(Fraction(x) / scale, Fraction(y) / scale) for x, y in piece] for piece in cut]
    return Solid(rings, pieces, [])


def _cut_outside(rings: list[Ring], around: Ring) -> Solid:
    """Cut what a frame has outside a shape."""
    outer, *defects = (one[::-1] for one in rings)
    pieces = _cut([around, outer]).pieces
    for defect in defects:
        pieces += _cut([defect]).pieces
    beyond = [line(q, p) for p, q in edges(around)]
    return Solid([outer, *defects], pieces, beyond)


def _frame(rings: Sequence[Ring]) -> tuple[list[str], Ring]:
    """A rectangle with ints around a shape."""
    xs, ys = zip(*(place(p) for one in rings for p in one), strict=True)
    ends = [min(xs) // 1 - 1, min(ys) // 1 - 1, max(xs) // 1 + 2, max(ys) // 1 + 2]
    written = [format_fraction(Fraction(end)) for end in ends]
    return written, standalone.read_frame(written)


def _inside(hole: Ring) -> Node:
    """A point inside a clockwise ring."""
    p, q, r = _cut([hole[::-1]]).pieces[0][:3]
    x, y, w = add(add(p, q), r)
    return x, y, 3 * w


def _write(solids: dict[str, Solid]) -> dict[str, Any]:
    return {
        name: [[_write_point(p) for p in piece] for piece in solid.pieces]
        for name, solid in solids.items()
    }


def _write_point(p: Node) -> list[str]:
    return [format_fraction(c) for c in place(p)]
