"""Polygons of any shape, with holes or without: no-fit and inner-fit positions (kind "SS").

Beyond the paper. Its sets carry over: the positions of overlap are O = int D + int I(G), an open
set, and the free positions are the rest. What bounds them is looked for where it can be, on the
contact segments of the pair (see `contact_lines`), and what is left there after their crossings is
decided by exact questions whether two polygons overlap (see `free_positions`). No part of either
polygon is made and no union, so that nothing of a partition has to be removed again.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import chain
from typing import NamedTuple

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.geometry.overlap import Overlap, Rings
from exactsweep.numbers.point import ORIGIN, Fit, Point
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.collector import pause_collector
from exactsweep.procedures.contact_lines import Stretch, find_contact_stretches
from exactsweep.procedures.cover import leave_out_covered
from exactsweep.procedures.crossings import cut_at_crossings
from exactsweep.procedures.free_positions import Free, find_free_positions
from exactsweep.procedures.leeway import find_leeway, frame_outside
from exactsweep.procedures.obstacles import Obstacles


class FreeRegions(NamedTuple):
    """The positions of a part inside a container.

    Attributes:
        regions: free regions, each as its exterior and the loops around overlap inside it, all
            counter-clockwise.
        fits: exact fits, as for `Free`.
    """

    regions: list[tuple[list[Point], list[list[Point]]]]
    fits: list[Fit]


def no_fit_ss(directrix: Rings, generatrix: Rings, scale: int = 1) -> Free:
    """The no-fit polygon of two shapes, with its holes and exact fits.

    Args:
        directrix: the rings of D, interior on the left.
        generatrix: the rings of G.
        scale: what the positions are divided by, when they leave the lattice of the rings.

    Returns:
        Positions of G's origin: one loop around all overlap, the loops within it, sorted, and the
        exact fits.

    Cost: O(k log k + c + q m n) for k contact segments, c crossings of them and q loops and
    exact fits to be decided; k <= 2 m n and c <= k^2, and few of either for real outlines.

    >>> square = [[(0, 0), (1, 0), (1, 1), (0, 1)]]
    >>> [(int(x), int(y)) for x, y in no_fit_ss(square, square).around[0]]
    [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    """
    moving, overlap = _turn(generatrix), Overlap(directrix, generatrix).at
    with pause_collector():
        stretches = find_contact_stretches(directrix, moving)
        free = _find_free(stretches, directrix, moving, overlap, scale, is_bounded=True)
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
        placed: the rings of shapes that the part must not overlap either.

    Returns:
        Positions of the part's origin; nothing where it does not fit.

    Cost: as for `no_fit_ss`; of contact segments those count that are near the leeway, and each
    question is asked of the shapes that are near.

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
    """I(G): a shape turned by half a turn."""
    return [inverse(ring) for ring in shape]


def _find_free(
    stretches: list[Stretch],
    solid: Rings,
    moving: Rings,
    overlap: Callable[[Point], bool],
    scale: int,
    *,
    is_bounded: bool = False,
) -> Free:
    """Find the loops and fits that contact segments bound, without what solid + H covers."""
    stretches = leave_out_covered(stretches, solid, moving)
    cut_at_crossings(stretches)
    return find_free_positions(stretches, overlap, scale, is_bounded=is_bounded)


def _find_holder(loop: list[Point], exteriors: Sequence[list[Point]]) -> int:
    """Find the least of some exteriors that have a loop inside.

    None crosses another one or the loop; those that overlap it lie around it or inside.
    """
    size = find_doubled_area(loop)
    around = [
        (area, k)
        for k, other in enumerate(exteriors)
        if (area := find_doubled_area(other)) > size and Overlap([other], [loop]).at(ORIGIN)
    ]
    return min(around)[1]
