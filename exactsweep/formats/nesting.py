"""Which rings lie inside which others, and which of them bound a filled area."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Sequence
from functools import partial
from math import lcm

from exactsweep.formats.candidate import Candidate
from exactsweep.geometry.canonical import PolygonError, find_doubled_area
from exactsweep.geometry.overlap import Overlap
from exactsweep.geometry.point import ORIGIN, Point, Vertex
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


def find_regions(rings: Sequence[Sequence[Point]], *, even_odd: bool) -> list[list[int]]:
    """Find the regions that several rings draw together.

    Args:
        rings: the vertices of subpaths as SVG has them, in either orientation.
        even_odd: whether a point in an even number of rings is left out; otherwise only one is
            around which the rings wind as often one way as the other (SVG 1.1, 11.3).

    Returns:
        For each region, the index of the exterior, then those of its holes, in order. Rings with
        filled area on both sides are left out.

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
    around = nest([_simple(ring, name) for ring, name in zip(rings, names, strict=True)], names)
    turns = [1 if even_odd or find_doubled_area(ring) > 0 else -1 for ring in rings]
    regions: dict[int, list[int]] = {}
    holes = []
    for k, turn in enumerate(turns):
        outside = sum(turns[j] for j in around[k])
        inside = outside + turn
        if even_odd:
            outside, inside = outside % 2, inside % 2
        if not outside:
            regions[k] = [k]
        elif not inside:
            holes.append(k)
    for k in holes:
        # The innermost exterior around it has the most rings around itself.
        regions[max((j for j in around[k] if j in regions), key=lambda j: len(around[j]))].append(k)
    return list(regions.values())


def nest_candidates(outlines: Sequence[Candidate]) -> list[Candidate]:
    """Make holes of what lies inside other outlines of the same layer.

    Args:
        outlines: those of a file; where there are no layers, all are on one.

    Returns:
        list of Candidate, one for each ring that an even number of others is around, in order; its
        holes are the rings just inside. The outlines of a layer of which one cannot be read, or two
        cross, all refuse to be read, for nobody knows what the holes are.

    Cost: that of `nest` for each layer.

    Example:
        >>> from exactsweep.formats.wkt import parse_wkt
        >>> text = "POLYGON (({0} {0}, {1} {0}, {1} {1}, {0} {1}, {0} {0}))"
        >>> squares = "".join(text.format(k, 6 - k) for k in range(3))
        >>> found = nest_candidates(parse_wkt(squares))
        >>> [outline.shape().area for outline in found]
        [Fraction(20, 1), Fraction(4, 1)]
    """
    layers: defaultdict[str | None, list[tuple[int, Candidate]]] = defaultdict(list)
    for place, outline in enumerate(outlines):
        layers[outline.layer].append((place, outline))
    found: list[tuple[int, Candidate]] = []
    for members in layers.values():
        try:
            found += _nest(members)
        except ValueError as error:
            reason = f"nested outlines are read with all of their layer: {error}"
            found += [(k, Candidate.refused(reason, o.name, o.layer)) for k, o in members]
    return [outline for _, outline in sorted(found, key=lambda pair: pair[0])]


def _nest(members: Sequence[tuple[int, Candidate]]) -> list[tuple[int, Candidate]]:
    """Make holes of what lies inside other outlines, each given with its number."""
    rings = [
        (k, ring._replace(vertices=partial(list, ring.vertices()), holes=tuple))
        for k, outline in members
        for ring in (outline, *outline.holes())
    ]
    names = [ring.place or "the exterior" for _, ring in rings]
    around = nest([ring.polygon() for _, ring in rings], names)
    found = []
    for i, (k, ring) in enumerate(rings):
        if len(around[i]) % 2 == 0:
            inner = [
                hole
                for (_, hole), others in zip(rings, around, strict=True)
                if i in others and len(others) == len(around[i]) + 1
            ]
            found.append((k, ring._replace(holes=partial(tuple, inner))))
    return found


def _simple(ring: Sequence[Point], name: str) -> Polygon:
    try:
        return Polygon(ring)
    except PolygonError as error:
        raise PolygonError(f"{name}: {error}") from None


def _may_overlap(first: Polygon, second: Polygon) -> bool:
    (a, b), (c, d) = first.bounding_box, second.bounding_box
    return a.x < d.x and c.x < b.x and a.y < d.y and c.y < b.y


def _is_around(outer: Sequence[Vertex], inner: Sequence[Vertex], names: tuple[str, str]) -> bool:
    """Whether one of two counter-clockwise rings lies in the other, not outside of it."""
    if not Overlap([outer], [inner]).at(ORIGIN):
        return False
    # The complement of the outer one is what its ring, run through backward, leaves of the plane.
    if Overlap([outer[::-1]], [inner], unbounded=True).at(ORIGIN):
        raise PolygonError(f"{names[0]} and {names[1]} cross")
    return True
