"""Check that rings are a polygon with holes: simple, canonical, the interior in one piece."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations

from exactsweep.check.boxes import Rectangle, find_box, meet
from exactsweep.check.certificate import CertificateError
from exactsweep.check.claim import ClaimedShape
from exactsweep.check.cone import cross, subtract
from exactsweep.check.location import locate
from exactsweep.check.meeting import split_where_touching
from exactsweep.check.shape import LatticeRing, list_edges, scale_ring, to_point
from exactsweep.check.size import find_common_scale
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Loop, Vertex


def check_loop(loop: Loop, name: str) -> None:
    """Check that a loop is simple and canonical. Cost: that of Polygon."""
    try:
        canonical = Polygon(loop).vertices
    except PolygonError as error:
        raise CertificateError(f"{name}: {error}", loop[0]) from None
    if canonical != loop:
        raise CertificateError(f"{name}: not canonical", loop[0])


def check_shape(shape: ClaimedShape, name: str) -> None:
    """Check that a shape is a polygon with holes, sorted, whose interior is connected.

    Holes and the exterior may touch each other in points, as long as they do not part the interior.

    Raises:
        CertificateError: the witness is a point of a ring.

    Cost: O(n log n) for one ring, O(n**2) for several.
    """
    rings = [shape.exterior, *shape.holes]
    names = [f"{name}.exterior", *(f"{name}.holes[{k}]" for k in range(len(shape.holes)))]
    for ring, which in zip(rings, names, strict=True):
        check_loop(ring, which)
    if list(shape.holes) != sorted(shape.holes):
        raise CertificateError(f"{name}.holes: not sorted", shape.holes[0][0])
    if len(rings) == 1:
        return
    # In ints, where there is a lattice of use.
    scale = find_common_scale([p for ring in rings for p in ring])
    _check_rings([scale_ring(ring, scale) for ring in rings], scale, name, names)


def _check_rings(rings: Sequence[LatticeRing], scale: int, name: str, names: Sequence[str]) -> None:
    """Check how rings lie with regard to each other."""
    boxes = [find_box(ring) for ring in rings]
    near = [(i, j) for i, j in combinations(range(len(rings)), 2) if meet(boxes[i], boxes[j])]
    for i, j in near:
        if (met := _find_crossing(rings[i], rings[j])) is not None:
            raise CertificateError(
                f"{names[i]} and {names[j]} meet in more than points", to_point(met, scale)
            )
    split = split_where_touching(tuple(rings))
    # No other ring passes through the middle of an edge.
    middles = [[_find_middle(*edge) for edge in list_edges([ring])] for ring in split]
    for j in range(1, len(rings)):
        if any(locate(p, rings[0]) < 0 for p in middles[j]):
            raise CertificateError(
                f"{names[j]} is not inside the exterior", to_point(rings[j][0], scale)
            )
    for i, j in near:
        if i and any(locate(p, rings[b]) > 0 for a, b in ((i, j), (j, i)) for p in middles[a]):
            raise CertificateError(
                f"{names[i]} and {names[j]} overlap", to_point(rings[j][0], scale)
            )
    _check_connected(split, scale, name)


def _find_crossing(one: LatticeRing, other: LatticeRing) -> Vertex | None:
    """A point by which to see that two simple rings cross or share part of an edge."""
    near, others = _list_edges_near(one, other), _list_edges_near(other, one)
    for box, a, b in near:
        way = subtract(b, a)
        for around, p, q in others:
            if not meet(box, around):
                continue
            from_p, from_q = cross(way, subtract(p, a)), cross(way, subtract(q, a))
            if from_p == from_q == 0:
                low, high = max(min(a, b), min(p, q)), min(max(a, b), max(p, q))
                if low < high:
                    return low
            elif from_p * from_q < 0:
                along = subtract(q, p)
                if cross(along, subtract(a, p)) * cross(along, subtract(b, p)) < 0:
                    return a
    return None


def _list_edges_near(
    ring: LatticeRing, other: LatticeRing
) -> list[tuple[Rectangle, Vertex, Vertex]]:
    """The edges of a ring, each behind its box, that meet the box of another one."""
    around = find_box(other)
    boxed = [(find_box(edge), *edge) for edge in list_edges([ring])]
    return [edge for edge in boxed if meet(edge[0], around)]


def _check_connected(rings: Sequence[LatticeRing], scale: int, name: str) -> None:
    """Check that rings and the points in which they touch form no circle."""
    places: dict[Vertex, list[int]] = {}
    for k, ring in enumerate(rings):
        for p in ring:
            places.setdefault(p, []).append(k)
    parts = list(range(len(rings)))
    for p, met in places.items():
        for k in met[1:]:
            first, second = parts[met[0]], parts[k]
            if first == second:
                raise CertificateError(f"{name}: its interior falls apart", to_point(p, scale))
            parts = [first if part == second else part for part in parts]


def _find_middle(a: Vertex, b: Vertex) -> Vertex:
    return Fraction(a[0] + b[0]) / 2, Fraction(a[1] + b[1]) / 2
