"""No-fit and inner-fit positions of polygons of any shape, with or without holes (kind "SS").

The paper does not treat this case, but its sets carry over. The positions of overlap are O = int D
+ int I(G), an open set, and all others are free. The boundary of the free positions lies on the
contact segments of the pair (see `contact_lines`), cut at their crossings. Exact tests whether two
polygons overlap decide the remaining pieces (see `free_positions`). The method needs neither a
partition of the polygons nor a union.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain
from typing import NamedTuple

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.overlap import Overlap, Rings
from exactsweep.numbers.number import ORIGIN, Fit, Point, Vertex
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.contact_lines import Stretch, find_contact_stretches
from exactsweep.procedures.cover import leave_out_covered
from exactsweep.procedures.crossings import cut_at_crossings
from exactsweep.procedures.free_positions import Free, find_free_positions
from exactsweep.procedures.leeway import find_leeway, frame_outside
from exactsweep.procedures.obstacles import Obstacles
from exactsweep.procedures.solution import pause_collector


class FreeRegions(NamedTuple):
    """The positions of a part inside a container.

    Attributes:
        regions: the free regions, each with its exterior and the loops around overlap inside it,
            all counter-clockwise.
        fits: the exact fits, as for `Free`.
    """

    regions: list[tuple[list[Point], list[list[Point]]]]
    fits: list[Fit]


def no_fit_ss(directrix: Rings, generatrix: Rings, scale: int = 1) -> Free:
    """Find the no-fit polygon of two shapes, with its holes and exact fits.

    Args:
        directrix: the rings of D, interior on the left.
        generatrix: the rings of G.
        scale: the divisor of the positions when they leave the lattice of the rings.

    Returns:
        Positions of G's origin: one loop around all overlap, the loops within it, sorted, and the
        exact fits.

    Cost: O(k log k + c + q m n) for k contact segments, c crossings, and q overlap tests of loops
    and exact fits. k <= 2 m n and c <= k^2; real outlines have few of both.

    >>> square = [[(0, 0), (1, 0), (1, 1), (0, 1)]]
    >>> [(int(x), int(y)) for x, y in no_fit_ss(square, square).around[0]]
    [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    """
    moving, overlap = _turn(generatrix), Overlap(directrix, generatrix).at
    with pause_collector():
        stretches = find_contact_stretches(directrix, moving)
        free = _find_free(
            stretches, directrix, moving, overlap, scale, _find_least(directrix, moving)
        )
    (_,) = free.around
    return free._replace(within=sorted(free.within))


def inner_fit_ss(
    container: Rings, part: Rings, scale: int = 1, placed: Sequence[Rings] = ()
) -> FreeRegions:
    """Find the positions of a part inside a container, free of placed shapes.

    Args:
        container: its rings, interior on the left: the exterior, and defects as clockwise holes.
        part: the rings of the part.
        scale: as for `no_fit_ss`.
        placed: the rings of each shape that the part must not overlap.

    Returns:
        Positions of the part's origin; empty if the part does not fit.

    Cost: as for `no_fit_ss`, where k counts contact segments near the leeway only, and each overlap
    test covers the shapes nearby.

    >>> square, unit = [[(0, 0), (3, 0), (3, 1), (0, 1)]], [[(0, 0), (1, 0), (1, 1), (0, 1)]]
    >>> [tuple(int(c) for p in fit for c in p) for fit in inner_fit_ss(square, unit).fits]
    [(0, 0, 2, 0)]
    """
    leeway = find_leeway(container, part)
    if leeway.is_empty:
        return FreeRegions([], [])
    outside, moving = [ring[::-1] for ring in container], _turn(part)
    others = list(chain.from_iterable(placed))
    solid = [*frame_outside(container), *others]
    with pause_collector():
        near = find_contact_stretches([*outside, *others], moving, leeway)
        stretches = [piece for stretch in near if (piece := stretch.within(leeway))]
        free = _find_free(stretches, solid, moving, Obstacles(outside, placed, part).at, scale)
    inside: list[list[list[Point]]] = [[] for _ in free.within]
    for loop in free.around:
        inside[_find_holder(loop, free.within)].append(loop)
    return FreeRegions(list(zip(free.within, inside, strict=True)), free.fits)


def _turn(shape: Rings) -> Rings:
    """Return I(G), a shape after half a turn."""
    return [inverse(ring) for ring in shape]


def _find_least(stationary: Rings, moving: Rings) -> Vertex:
    """Find the least point of the sum of two shapes."""
    (ax, ay), (bx, by) = min(stationary[0]), min(moving[0])
    return ax + bx, ay + by


def _find_free(
    stretches: list[Stretch],
    solid: Rings,
    moving: Rings,
    overlap: Callable[[Point], bool],
    scale: int,
    least: Vertex | None = None,
) -> Free:
    """Find the loops and fits that contact segments bound, after dropping covered pieces."""
    stretches = leave_out_covered(stretches, solid, moving)
    cut_at_crossings(stretches)
    return find_free_positions(stretches, overlap, scale, least)


def _find_holder(loop: list[Point], exteriors: Sequence[list[Point]]) -> int:
    """Find the smallest exterior around a loop.

    No exterior crosses another one or the loop. Those that overlap it lie around it or inside it.
    """
    size = find_doubled_area(loop)
    around = [
        (area, k)
        for k, other in enumerate(exteriors)
        if (area := find_doubled_area(other)) > size and Overlap([other], [loop]).at(ORIGIN)
    ]
    return min(around)[1]
