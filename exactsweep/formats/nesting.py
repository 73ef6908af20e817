"""Nesting of rings: rings inside others, and rings that bound a filled area."""

from __future__ import annotations

from bisect import insort
from collections import defaultdict
from collections.abc import Iterator, Sequence
from fractions import Fraction

from exactsweep.geometry.canonical import PolygonError, find_doubled_area
from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.overlap import Relation, contains, relate
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import common_lattice
from exactsweep.numbers.error import name_refusals
from exactsweep.numbers.number import Point


def nest(rings: Sequence[Polygon], names: Sequence[str]) -> list[int | None]:
    """Find the ring just around each ring.

    Args:
        rings: Polygons, whose boundaries may touch and run along each other.
        names: their names in messages.

    Returns:
        For each ring the index of the innermost ring around it, or None. If two rings are equal,
        the later lies in the earlier.

    Raises:
        PolygonError: two rings cross, so that neither lies inside or outside the other.

    Cost: O(m n) at worst for each pair of rings of m and n vertices whose bounds meet, up to the
        innermost ring around each; O(n) to find these pairs for each ring above or below others.

    Example:
        >>> squares = [Polygon([(0, 0), (k, 0), (k, k), (0, k)]) for k in (2, 1, 3)]
        >>> nest(squares, "abc")
        [2, 0, None]
    """
    boxes = [ring.bounding_box for ring in rings]
    # The larger one of two is the one around; of equal ones, the earlier.
    sizes = [(ring.area, -k) for k, ring in enumerate(rings)]
    parents: list[int | None] = [None] * len(rings)
    # From left to right, so that what is around a ring comes before it; by size, those not past.
    active: list[tuple[Fraction, int]] = []
    for k in sorted(range(len(rings)), key=lambda k: (boxes[k][0].x, -sizes[k][0], k)):
        low, high = boxes[k]
        for size in active[:]:
            j = -size[1]
            (_, bottom), (right, top) = boxes[j]
            if right <= low.x:
                active.remove(size)
            elif bottom < high.y and low.y < top:
                inner, outer = (-number for _, number in sorted((size, sizes[k])))
                if _is_around(rings[outer], rings[inner], (names[outer], names[inner])):
                    # A larger ring around this one is around the ring, too. A larger ring that
                    # crosses the ring also crosses this one, so the loop has met it already.
                    parents[inner] = outer
                    break
        insort(active, sizes[k])
    return parents


def find_regions(rings: Sequence[Sequence[Point]], *, even_odd: bool) -> list[list[int]]:
    """Find the regions that several rings draw together.

    Args:
        rings: the vertices of subpaths as SVG has them, in either orientation.
        even_odd: whether points in an even number of rings are outside; otherwise points with
            winding number 0 are outside (SVG 1.1, 11.3).

    Returns:
        For each region, the index of the exterior, then the indices of its holes, in order. Rings
        with filled area on both sides are left out.

    Raises:
        PolygonError: a ring is not simple, or two cross.

    Cost: that of `nest`.

    Example:
        >>> rings = [Polygon([(0, 0), (k, 0), (0, k)]).vertices for k in (3, 1)]
        >>> find_regions(rings, even_odd=True), find_regions(rings, even_odd=False)
        ([[0, 1]], [[0]])
        >>> find_regions([rings[0], rings[1][::-1]], even_odd=False)
        [[0, 1]]
    """
    names = [f"subpath {k}" for k in range(len(rings))]
    parents = nest([_simple(ring, name) for ring, name in zip(rings, names, strict=True)], names)
    # For each ring, the winding number just inside, and the innermost exterior there.
    inside: dict[int, int] = {}
    exterior: dict[int, int] = {}
    holes = []
    for k in _from_outside(parents):
        parent = parents[k]
        outside = 0 if parent is None else inside[parent]
        turn = 1 if find_doubled_area(rings[k]) > 0 else -1
        inside[k] = (outside + turn) % 2 if even_odd else outside + turn
        exterior[k] = k if parent is None or not outside else exterior[parent]
        if outside and not inside[k]:
            holes.append(k)
    regions = {k: [k] for k in range(len(rings)) if exterior[k] == k}
    for k in sorted(holes):
        regions[exterior[k]].append(k)
    return list(regions.values())


def _from_outside(parents: Sequence[int | None]) -> Iterator[int]:
    """Yield all rings, each after the ring just around it."""
    children: defaultdict[int | None, list[int]] = defaultdict(list)
    for k, parent in enumerate(parents):
        children[parent].append(k)
    left = children[None]
    while left:
        k = left.pop()
        yield k
        left += children[k]


def _simple(ring: Sequence[Point], name: str) -> Polygon:
    with name_refusals(name):
        return Polygon(ring)


def _is_around(outer: Polygon, inner: Polygon, names: tuple[str, str]) -> bool:
    """Decide whether one of two rings lies inside the other."""
    _, (around, within) = common_lattice([outer, inner])
    if relate(EdgeIndex([around]), EdgeIndex([within])) is not Relation.OVERLAP:
        return False
    if not contains([around], [within]):
        raise PolygonError(f"{names[0]} and {names[1]} cross")
    return True
