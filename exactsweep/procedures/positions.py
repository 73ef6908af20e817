"""No-fit polygons, inner fits, free positions and sums with paths, for any shapes.

The paper does not treat this case (kind "SS"). Each problem asks for the free positions of a part
among obstacles. Contact segments (`segments`) are pruned (`neighbors`, `cover`), cut where they
cross (`crossings`), and joined to loops and exact fits (`walk`) by an exact overlap test
(`geometry.overlap`).

With several obstacles or moving shapes, O is the union of the open sets O_k = int D_i + int H_j of
all pairs. The numbered statements of the modules hold for such a union:

(1) A boundary point of the union is a boundary point of some O_k, so it lies on a contact segment
    of that pair, with O_k just to the left.
(2) Around a single free position, open sectors of the O_k cover all directions. A sector starts
    along a contact segment that leaves the position, or against one that ends there. Two lines that
    do not both have segments in both directions give too few starts.

The obstacles of an inner fit are a frame around the container, and each of its defects.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import NamedTuple

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.edges import EdgeIndex, Rings
from exactsweep.geometry.frame import HomogeneousPoint, to_homogeneous
from exactsweep.geometry.near import boxes_meet
from exactsweep.geometry.overlap import Relation, find_outside, relate
from exactsweep.numbers.number import Fit, Point, Vertex
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.cover import leave_out_covered
from exactsweep.procedures.crossings import Pieces, cut
from exactsweep.procedures.neighbors import leave_out_overlapped
from exactsweep.procedures.segments import ContactSegment, find_contact_segments
from exactsweep.procedures.walk import FreeBoundary, OverlapTest, find_free


class FreeRegions(NamedTuple):
    """The positions of a part inside a container.

    Attributes:
        regions: the free regions, each with its exterior and the loops around overlap inside it,
            all counter-clockwise; sorted by area.
        fits: the exact fits, as for `FreeBoundary`.
    """

    regions: list[tuple[list[Point], list[list[Point]]]]
    fits: list[Fit]


def find_no_fit(stationary: Rings, orbiting: Rings, scale: int = 1) -> FreeBoundary:
    """Find the no-fit polygon of two shapes, D and G, with its holes and exact fits.

    Rings have the interior on the left. Positions of G's origin are divided by the scale.

    Cost: O(k log k + c + q m n) for k <= 2 m n contact segments, c <= k^2 crossings, and q overlap
    tests of loops and exact fits. Real outlines have few of both.

    >>> square = [[(0, 0), (1, 0), (1, 1), (0, 1)]]
    >>> [(int(x), int(y)) for x, y in find_no_fit(square, square).around[0]]
    [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    """
    return find_sum(stationary, reflect(orbiting), scale)


def find_sum(stationary: Rings, moving: Rings, scale: int = 1) -> FreeBoundary:
    """Find the boundary of the sum of two shapes, or of a shape and a path.

    The exact fits are points of the closed sum that are not in the sum of the interiors. A path has
    the rings of `path_rings`. Scale and cost are those of `find_no_fit`.

    >>> square, path = [[(0, 0), (1, 0), (1, 1), (0, 1)]], path_rings([(0, 0), (2, 1)])
    >>> [(int(x), int(y)) for x, y in find_sum(square, path).around[0]]
    [(0, 0), (1, 0), (3, 1), (3, 2), (2, 2), (0, 1)]
    """
    segments = find_contact_segments(stationary, moving, leave_out_overlapped)
    (ax, ay), (bx, by) = (min(chain.from_iterable(rings)) for rings in (stationary, moving))
    least = to_homogeneous(ax + bx, ay + by)
    free = find_free(*_prepare(segments, [stationary], [moving]), scale, least=least)
    # O is connected.
    assert len(free.around) == 1
    return free


def find_no_fit_union(
    stationary: Sequence[Rings], orbiting: Sequence[Rings], scale: int = 1
) -> FreeRegions:
    """Find the positions where any orbiting shape overlaps any stationary one; all move together.

    Each region bounds one component of the positions of overlap, with their exact fits inside.
    Scale and cost are those of `find_no_fit`, for all pairs.

    >>> one, other = [[(0, 0), (1, 0), (1, 1), (0, 1)]], [[(3, 0), (4, 0), (4, 1), (3, 1)]]
    >>> found = find_no_fit_union([one, other], [one]).regions
    >>> [[(int(x), int(y)) for x, y in exterior] for exterior, _ in found]
    [[(-1, -1), (1, -1), (1, 1), (-1, 1)], [(2, -1), (4, -1), (4, 1), (2, 1)]]
    """
    moving = [reflect(rings) for rings in orbiting]
    solid, moved = ([*chain.from_iterable(rings)] for rings in (stationary, moving))
    segments = find_contact_segments(solid, moved, leave_out_overlapped)
    free = find_free(*_prepare(segments, stationary, moving), scale, around_overlap=True)
    return _nest(free.around, free.within, free.fits)


def find_inner_fit(
    container: Rings,
    part: Rings,
    scale: int = 1,
    placed: Sequence[Rings] = (),
    attached: Sequence[Rings] = (),
) -> FreeRegions:
    """Find the positions of a part inside a container, free of placed shapes.

    Attached shapes move with the part. Defects are clockwise holes of the container. Scale and cost
    are those of `find_no_fit`, restricted to contact segments near possible positions.

    >>> square, unit = [[(0, 0), (3, 0), (3, 1), (0, 1)]], [[(0, 0), (1, 0), (1, 1), (0, 1)]]
    >>> [tuple(int(c) for p in fit for c in p) for fit in find_inner_fit(square, unit).fits]
    [(0, 0, 2, 0)]
    """
    (west, east, south, north) = EdgeIndex(container).box
    moving = [reflect(rings) for rings in (part, *attached)]
    left, right, low, high = EdgeIndex([*part, *chain.from_iterable(attached)]).box
    # The container's box encloses the part's box only at positions in this rectangle.
    room = west - left, east - right, south - low, north - high
    if room[0] > room[1] or room[2] > room[3]:
        return FreeRegions([], [])
    outside, *defects = (ring[::-1] for ring in container)
    width, height = right - left, high - low
    frame = west - width, east + width, south - height, north + height
    obstacles = [find_outside(container[0], frame), *([ring] for ring in defects), *placed]
    solid = [outside, *defects, *chain.from_iterable(placed)]
    segments = find_contact_segments(solid, [*chain.from_iterable(moving)], leave_out_overlapped)
    segments = [segment for segment in segments if boxes_meet(segment.box, room)]
    free = find_free(*_prepare(segments, obstacles, moving), scale)
    return _nest(free.within, free.around, free.fits)


def _nest(exteriors: list[list[Point]], holes: list[list[Point]], fits: list[Fit]) -> FreeRegions:
    """Assign holes to their exteriors, sorted by area."""
    found = FreeRegions([], fits)
    for exterior in sorted(exteriors, key=find_doubled_area):
        found.regions.append((exterior, []))
    for loop in holes:
        # Exteriors cross neither each other nor the loop, so the smallest one around it is its own.
        shape, area = EdgeIndex([loop]), find_doubled_area(loop)
        next(
            inside
            for exterior, inside in found.regions
            if find_doubled_area(exterior) > area
            and relate(EdgeIndex([exterior]), shape) is Relation.OVERLAP
        ).append(loop)
    return found


def path_rings(points: Sequence[Vertex], *, closed: bool = False) -> list[list[Vertex]]:
    """Return the rings of a path of two points or more, which run back and forth."""
    return [[*points], [*points[::-1]]] if closed else [[*points, *points[-2:0:-1]]]


def reflect(rings: Rings) -> list[list[Vertex]]:
    """Return I(G)."""
    return [inverse(ring) for ring in rings]


def _prepare(
    segments: Sequence[ContactSegment], obstacles: Sequence[Rings], moving: Sequence[Rings]
) -> tuple[Pieces, OverlapTest]:
    """Return the pieces that may bound free positions, and the test of a position."""
    segments = leave_out_covered(segments, obstacles, moving)
    parts = [EdgeIndex(reflect(rings)) for rings in moving]
    pairs = [(EdgeIndex(rings), part) for rings in obstacles for part in parts]

    def overlaps(position: HomogeneousPoint) -> bool:
        for k, pair in enumerate(pairs):
            if relate(*pair, *position) is Relation.OVERLAP:
                # The last pair to overlap is likely to overlap again.
                pairs.insert(0, pairs.pop(k))
                return True
        return False

    return cut(segments), overlaps
