"""Proofs for certificates, as `check/CERTIFICATES.md` describes them: convex pieces, sums, chains.

Nothing here is trusted: if an answer is wrong, the checker does not accept what is found.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain
from math import lcm
from typing import Any

from exactsweep.evidence.chains import find_evidence
from exactsweep.evidence.sums import Grid, Node, Side, Sums, make_node, make_side
from exactsweep.geometry.convex import IntRing, cut_to_convex
from exactsweep.numbers.digits import to_plain
from exactsweep.numbers.number import Point, to_fraction

_EDGES = 3
"""Of a convex polygon, on either side of a slice."""

_Points = Iterable[Iterable[object]]


def add_proof(claim: dict[str, Any]) -> dict[str, Any]:
    """Add the key `proof`, by which `check/standalone.py` proves a claim.

    Args:
        claim: a certificate of a sweep, a no-fit polygon or an inner fit, with or without a proof.
            Numbers are Fractions, or strings.

    Returns:
        Plain JSON data. If the answer is wrong, it is not proved.

    Cost: that of `cut_to_convex` for both shapes, and that of `find_evidence`.
    """
    return to_plain({**claim, "proof": _PROVERS[claim["claim"]](claim)})


class _Lattice:
    """The lattice of two shapes."""

    def __init__(self, *shapes: Any) -> None:
        self._shapes = [
            [_read(ring) for ring in (shape["exterior"], *(shape.get("holes") or ()))]
            for shape in shapes
        ]
        denominators = {
            c.denominator for shape in self._shapes for ring in shape for p in ring for c in p
        }
        self.scale = lcm(*denominators)
        self.shapes = [
            [self._orient(ring, k) for k, ring in enumerate(shape)] for shape in self._shapes
        ]

    def _orient(self, ring: Sequence[Point], k: int) -> IntRing:
        found = [(int(x * self.scale), int(y * self.scale)) for x, y in ring]
        area = sum(x * v - u * y for (x, y), (u, v) in zip(found, found[1:] + found[:1]))
        return found if (area > 0) == (k == 0) else found[::-1]

    def enter(self, point: Iterable[object]) -> Node:
        x, y = map(to_fraction, point)
        return make_node(x * self.scale, y * self.scale)

    def loop(self, points: _Points, *, is_reversed: bool = False) -> list[Side]:
        nodes = [self.enter(point) for point in points]
        if is_reversed:
            nodes.reverse()
        return [make_side(p, q) for p, q in zip(nodes, nodes[1:] + nodes[:1])]

    def segments(self, fits: Iterable[_Points]) -> list[Side]:
        return [make_side(*map(self.enter, fit)) for fit in fits]

    def leave(self, lists: Iterable[Sequence[Node]]) -> list[list[Point]]:
        scale = self.scale
        return [
            [Point(Fraction(x, w * scale), Fraction(y, w * scale)) for x, y, w in points]
            for points in lists
        ]


def _read(points: Any) -> list[Point]:
    found = [Point(*map(to_fraction, point)) for point in points]
    return [p for k, p in enumerate(found) if p != found[k - 1]]


def _prove_no_fit(claim: dict[str, Any]) -> dict[str, Any]:
    lattice = _Lattice(claim["directrix"], claim["generatrix"])
    still, moving = map(_cut, lattice.shapes)
    loops = [lattice.loop(claim["exterior"])]
    loops += [lattice.loop(hole, is_reversed=True) for hole in claim["holes"]]
    known = [*chain(*loops), *lattice.segments(claim["exact_fits"])]
    opposite = [*map(_turn, moving)]
    sums = Sums(still, opposite, Grid([*chain(*still, *opposite)]))
    found = find_evidence(sums, known)
    return {
        "directrix": lattice.leave(still),
        "generatrix": lattice.leave(moving),
        "sums": found.sums,
    }


def _prove_sweep(claim: dict[str, Any]) -> dict[str, Any]:
    proof = _prove_no_fit(claim)
    lattice = _Lattice(claim["directrix"], claim["generatrix"])
    moving = _cut(lattice.shapes[1])
    trajectory = [edge[:2] for edge in lattice.loop(claim["exterior"])]
    loops = [lattice.loop(claim["outer"])]
    loops += [lattice.loop(loop, is_reversed=True) for loop in (claim["inner"], *claim["unswept"])]
    sums = Sums(trajectory, moving, Grid([*chain(*trajectory, *moving)]))
    found = find_evidence(sums, [*chain(*loops)])
    return {**proof, "swept": found.sums, "slits": lattice.leave(found.slits)}


def _prove_inner_fit(claim: dict[str, Any]) -> dict[str, Any]:
    lattice = _Lattice(claim["container"], claim["part"])
    scale = lattice.scale
    (exterior, *defects), part = lattice.shapes
    xs, ys = ([p[k] for p in exterior] for k in (0, 1))
    us, vs = ([p[k] for p in part[0]] for k in (0, 1))
    wide, high = (max(us) - min(us)) // scale + 1, (max(vs) - min(vs)) // scale + 1
    frame = (
        min(xs) // scale - wide,
        min(ys) // scale - high,
        -(-max(xs) // scale) + wide,
        -(-max(ys) // scale) + high,
    )
    left, low, right, top = (end * scale for end in frame)
    rectangle = [(left, low), (right, low), (right, top), (left, top)]
    outside = [
        *_cut([rectangle, exterior[::-1]]),
        *chain(*(_cut([ring[::-1]]) for ring in defects)),
    ]
    moving = _cut(part)
    opposite = [*map(_turn, moving)]
    corners = [
        (left - min(us), low - min(vs), 1),
        (right - max(us), low - min(vs), 1),
        (right - max(us), top - max(vs), 1),
        (left - min(us), top - max(vs), 1),
    ]
    beyond = [make_side(q, p) for p, q in zip(corners, corners[1:] + corners[:1])]
    known = []
    for region in claim["regions"]:
        known += lattice.loop(region["exterior"], is_reversed=True)
        for hole in region["holes"]:
            known += lattice.loop(hole)
    known += lattice.segments(claim["exact_fits"])
    sums = Sums(outside, opposite, Grid([*chain(*outside, *opposite)]))
    found = find_evidence(sums, known, beyond)
    return {
        "frame": [Fraction(end) for end in frame],
        "outside": lattice.leave(outside),
        "part": lattice.leave(moving),
        "sums": found.sums,
        "around": found.around,
    }


_PROVERS = {"no_fit": _prove_no_fit, "inner_fit": _prove_inner_fit, "sweep": _prove_sweep}


def _turn(points: Sequence[Node]) -> list[Node]:
    return [(-x, -y, w) for x, y, w in points]


def _cut(rings: Sequence[IntRing]) -> list[list[Node]]:
    """Cut a shape into convex pieces of few sides."""
    cut = chain.from_iterable(map(_slice, cut_to_convex(rings)))
    return [[(x, y, 1) for x, y in piece] for piece in cut]


def _slice(points: IntRing) -> Iterator[IntRing]:
    """Cut a convex polygon across into slices of few sides, whose sums have few sides."""
    last = (len(points) - 1) // 2
    for k in range(0, last, _EDGES):
        end = min(k + _EDGES, last)
        start = max(len(points) - 1 - end, end + 1)
        yield [*points[k : end + 1], *points[start : len(points) - k]]
