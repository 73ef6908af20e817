"""Proofs of claims, in the format of `check/CERTIFICATES.md`: convex pieces, sums and chains.

The checker does not trust this module: it rejects any proof of a wrong claim.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import chain, pairwise
from math import lcm
from typing import Any

from exactsweep.evidence.chains import find_evidence
from exactsweep.evidence.homogeneous import DirectedSegment, list_sides, make_side
from exactsweep.evidence.sums import Sums
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.convex import IntRing, cut_to_convex
from exactsweep.geometry.frame import HomogeneousPoint, to_homogeneous
from exactsweep.numbers.digits import to_plain
from exactsweep.numbers.number import Point, to_fraction

_EDGES = 5
"""Maximum number of edges on each side of a slice of a convex polygon."""

_PointList = Iterable[Iterable[object]]


def add_proof(claim: dict[str, Any]) -> dict[str, Any]:
    """Return a claim with a new proof, as a certificate; any old proof is replaced.

    Cost: as for `cut_to_convex`, plus O(1) clipped segments for each side of a listed sum, and O(1)
    for each known edge and each sum whose box touches it.
    """
    return to_plain({**claim, "proof": _PROVERS[claim["claim"]](claim)})


class _ShapeLattice:
    """The lattice of shapes, with spacing 1 / `scale`, and their rings, interior on the left."""

    def __init__(self, *shapes: dict[str, Any]) -> None:
        listed = [
            [_read(ring) for ring in (shape["exterior"], *(shape.get("holes") or ()))]
            for shape in shapes
        ]
        points = chain.from_iterable(chain.from_iterable(listed))
        self.scale = lcm(*{c.denominator for point in points for c in point})
        self.shapes = [
            [self._enter_ring(ring, is_hole=k > 0) for k, ring in enumerate(rings)]
            for rings in listed
        ]

    def _enter_ring(self, ring: Iterable[Point], *, is_hole: bool) -> IntRing:
        found = [(int(x * self.scale), int(y * self.scale)) for x, y in ring]
        return found if (find_doubled_area(found) > 0) != is_hole else found[::-1]

    def enter(self, points: _PointList) -> list[HomogeneousPoint]:
        """Convert points of an answer, which may be off the lattice."""
        return [to_homogeneous(x * self.scale, y * self.scale) for x, y in _read(points)]

    def enter_loop(self, points: _PointList) -> list[DirectedSegment]:
        """Convert a loop in the given order; a wrong claim may repeat vertices."""
        nodes = self.enter(points)
        return list_sides([p for k, p in enumerate(nodes) if p != nodes[k - 1]])

    def enter_reversed(self, points: _PointList) -> list[DirectedSegment]:
        """Convert a loop in reverse order."""
        return self.enter_loop([*points][::-1])

    def enter_fits(self, fits: Iterable[_PointList]) -> list[DirectedSegment]:
        """Convert exact fits."""
        return [make_side(*self.enter(fit)) for fit in fits]

    def leave(self, lists: Iterable[Iterable[HomogeneousPoint]]) -> list[list[Point]]:
        """Convert points back to the plane."""
        unit = self.scale
        return [
            [Point(Fraction(x, w * unit), Fraction(y, w * unit)) for x, y, w in points]
            for points in lists
        ]


def _read(points: Any) -> list[Point]:
    return [Point(*map(to_fraction, point)) for point in points]


def _prove_no_fit(claim: dict[str, Any]) -> dict[str, Any]:
    lattice = _ShapeLattice(claim["directrix"], claim["generatrix"])
    still, moving = map(_cut, lattice.shapes)
    loops = [lattice.enter_loop(claim["exterior"]), *map(lattice.enter_reversed, claim["holes"])]
    known = [*chain.from_iterable(loops), *lattice.enter_fits(claim["exact_fits"])]
    found = find_evidence(Sums(still, [*map(_turn, moving)]), known)
    pieces = {"directrix": lattice.leave(still), "generatrix": lattice.leave(moving)}
    return {**pieces, "sums": found.sums}


def _prove_sweep(claim: dict[str, Any]) -> dict[str, Any]:
    lattice = _ShapeLattice(claim["directrix"], claim["generatrix"])
    trajectory = [side[:2] for side in lattice.enter_loop(claim["exterior"])]
    holes = claim["inner"], *claim["unswept"]
    loops = [lattice.enter_loop(claim["outer"]), *map(lattice.enter_reversed, holes)]
    found = find_evidence(Sums(trajectory, _cut(lattice.shapes[1])), [*chain.from_iterable(loops)])
    slits = lattice.leave(slit[:2] for slit in found.slits)
    return {**_prove_no_fit(claim), "swept": found.sums, "slits": slits}


def _prove_sum(claim: dict[str, Any]) -> dict[str, Any]:
    lattice = _ShapeLattice(claim["shape"])
    pieces = _cut(lattice.shapes[0])
    path = [[p, q] for p, q in pairwise(lattice.enter(claim["path"])) if p != q]
    loops = [lattice.enter_loop(claim["exterior"]), *map(lattice.enter_reversed, claim["holes"])]
    found = find_evidence(Sums(path, pieces), [*chain.from_iterable(loops)])
    slits = lattice.leave(slit[:2] for slit in found.slits)
    return {"shape": lattice.leave(pieces), "sums": found.sums, "slits": slits}


def _prove_inner_fit(claim: dict[str, Any]) -> dict[str, Any]:
    lattice = _ShapeLattice(claim["container"], claim["part"])
    (exterior, *defects), part = lattice.shapes
    ends, frame, positions = _surround(exterior, part[0], lattice.scale)
    # The frame and each hole of the container are cut separately.
    cut = map(_cut, ([frame, exterior[::-1]], *([defect[::-1]] for defect in defects)))
    outside, moving = [*chain.from_iterable(cut)], _cut(part)
    loops = []
    for region in claim["regions"]:
        loops += [lattice.enter_reversed(region["exterior"])]
        loops += map(lattice.enter_loop, region["holes"])
    known = [*chain.from_iterable(loops), *lattice.enter_fits(claim["exact_fits"])]
    beyond = [make_side(side.end, side.start) for side in list_sides(positions)]
    found = find_evidence(Sums(outside, [*map(_turn, moving)], beyond), known)
    return {
        "frame": ends,
        "outside": lattice.leave(outside),
        "part": lattice.leave(moving),
        "sums": found.sums,
        "around": found.around,
    }


_PROVERS = {
    "no_fit": _prove_no_fit,
    "sweep": _prove_sweep,
    "sum": _prove_sum,
    "inner_fit": _prove_inner_fit,
}


def _surround(
    container: IntRing, part: IntRing, unit: int
) -> tuple[list[Fraction], IntRing, list[HomogeneousPoint]]:
    """Return a frame with room for a part around a container, its ring, and its inner fit."""
    lows, highs, ends = [], [], []
    for k in (0, 1):
        low, high = min(p[k] for p in container), max(p[k] for p in container)
        first, last = min(p[k] for p in part), max(p[k] for p in part)
        room = (last - first) // unit + 1
        ends += [low // unit - room, -(-high // unit) + room]
        lows.append(ends[-2] * unit - first)
        highs.append(ends[-1] * unit - last)
    left, right, low, high = (end * unit for end in ends)
    frame = [(left, low), (right, low), (right, high), (left, high)]
    (west, south), (east, north) = lows, highs
    corners = [(west, south, 1), (east, south, 1), (east, north, 1), (west, north, 1)]
    return [Fraction(ends[k]) for k in (0, 2, 1, 3)], frame, corners


def _turn(ring: Iterable[HomogeneousPoint]) -> list[HomogeneousPoint]:
    return [(-x, -y, w) for x, y, w in ring]


def _cut(rings: Sequence[IntRing]) -> list[list[HomogeneousPoint]]:
    cut = chain.from_iterable(map(_slice, cut_to_convex(rings)))
    return [[(x, y, 1) for x, y in piece] for piece in cut]


def _slice(ring: IntRing) -> Iterator[IntRing]:
    """Slice a convex polygon into pieces of few edges, whose sums have few edges."""
    last = (len(ring) - 1) // 2
    for k in range(0, last, _EDGES):
        end = min(k + _EDGES, last)
        start = max(len(ring) - 1 - end, end + 1)
        yield [*ring[k : end + 1], *ring[start : len(ring) - k]]
