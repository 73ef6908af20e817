"""Which rings lie inside which others, and which of them bound a filled area."""

from __future__ import annotations

from collections.abc import Sequence
from math import lcm

from exactsweep.geometry.canonical import PolygonError, doubled_area
from exactsweep.geometry.overlap import Overlap
from exactsweep.geometry.point import ORIGIN, LatticePoint, Point
from exactsweep.geometry.polygon import Polygon

MAX_DEPTH = 100
"""How many rings may be around one, lest a small file keeps its reader busy."""


def nest(rings: Sequence[Polygon], names: Sequence[str]) -> list[list[int]]:
    """Find the rings around each ring.

    Args:
        rings: Polygons, whose boundaries may touch and run along each other.
        names: what messages call them.

    Returns:
        For each ring, the indices of those that it lies in, in order; of equal ones, the later lies
        in the earlier.

    Raises:
        PolygonError: two rings cross, so that neither lies in the other, nor outside of it; more
            than MAX_DEPTH rings around one.

    Cost: O(m n) at worst for each two rings of m and n vertices whose bounds meet.

    Example:
        >>> squares = [Polygon([(0, 0), (k, 0), (k, k), (0, k)]) for k in (2, 1, 3)]
        >>> nest(squares, "abc")
        [[2], [0, 2], []]
    """
    lattices = [ring.lattice() for ring in rings]
    scale = lcm(*(own for own, _ in lattices))
    points = [[(x * (scale // own), y * (scale // own)) for x, y in p] for own, p in lattices]
    found: list[list[int]] = [[] for _ in rings]
    boxes = sorted((ring.bounding_box, k) for k, ring in enumerate(rings))
    active: list[int] = []
    for (low, _), k in boxes:
        active = [j for j in active if rings[j].bounding_box[1].x > low.x]
        for j in active:
            if _may_overlap(rings[j], rings[k]):
                # The larger one is the one around; of equal ones, the earlier.
                outer, inner = sorted((j, k), key=lambda i: (-rings[i].area, i))
                if _is_around(points[outer], points[inner], (names[outer], names[inner])):
                    found[inner].append(outer)
                    if len(found[inner]) > MAX_DEPTH:
                        raise PolygonError(f"{names[inner]} lies in more than {MAX_DEPTH} others")
        active.append(k)
    return [sorted(around) for around in found]


def drawn(rings: Sequence[Sequence[Point]], *, even_odd: bool) -> list[int]:
    """Find the one region that several rings draw together.

    Args:
        rings: the vertices of subpaths as SVG has them, in either orientation.
        even_odd: whether a point in an even number of rings is left out; otherwise only one is
            around which the rings wind as often one way as the other (SVG 1.1, 11.3).

    Returns:
        The index of the exterior, then those of its holes, in order. Rings with filled area on both
        sides are left out.

    Raises:
        PolygonError: a ring is not simple, two cross, or the filled area has several parts.

    Cost: that of `nest`.

    Example:
        >>> rings = [Polygon([(0, 0), (k, 0), (0, k)]).vertices for k in (3, 1)]
        >>> drawn(rings, even_odd=True), drawn(rings, even_odd=False)
        ([0, 1], [0])
        >>> drawn([rings[0], rings[1][::-1]], even_odd=False)
        [0, 1]
    """
    names = [f"subpath {k}" for k in range(len(rings))]
    around = nest([_simple(ring, name) for ring, name in zip(rings, names, strict=True)], names)
    turns = [1 if even_odd or doubled_area(ring) > 0 else -1 for ring in rings]
    exteriors, holes = [], []
    for k, turn in enumerate(turns):
        outside = sum(turns[j] for j in around[k])
        inside = outside + turn
        if even_odd:
            outside, inside = outside % 2, inside % 2
        if not outside:
            exteriors.append(k)
        elif not inside:
            holes.append(k)
    if len(exteriors) > 1:
        first, second = (names[k] for k in exteriors[:2])
        raise PolygonError(
            f"not the rings of one region: {first} and {second} are two of the {len(exteriors)} "
            "exteriors"
        )
    return exteriors + holes


def _simple(ring: Sequence[Point], name: str) -> Polygon:
    try:
        return Polygon(ring)
    except PolygonError as error:
        raise PolygonError(f"{name}: {error}") from None


def _may_overlap(first: Polygon, second: Polygon) -> bool:
    (a, b), (c, d) = first.bounding_box, second.bounding_box
    return a.x < d.x and c.x < b.x and a.y < d.y and c.y < b.y


def _is_around(
    outer: Sequence[LatticePoint], inner: Sequence[LatticePoint], names: tuple[str, str]
) -> bool:
    """Whether one of two counter-clockwise rings lies in the other, not outside of it."""
    if not Overlap([outer], [inner]).at(ORIGIN):
        return False
    # The complement of the outer one is what its ring, run through backward, leaves of the plane.
    if Overlap([outer[::-1]], [inner], unbounded=True).at(ORIGIN):
        raise PolygonError(f"{names[0]} and {names[1]} cross")
    return True
