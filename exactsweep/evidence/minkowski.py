"""Minkowski sums of two shapes, or of a shape and a path.

A + B is the no-fit polygon of A and -B, as a closed set: its exact fits are limits of positions of
overlap, so they belong to the sum.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import chain
from typing import Any

from exactsweep.evidence.certificate import claim_sum
from exactsweep.evidence.sweep import Solution, claim_pair, place_loop, solve
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.frame import find_shared_direction
from exactsweep.geometry.polyline import Polyline
from exactsweep.geometry.reading import lcm_within
from exactsweep.geometry.region import AnyPolygon, Region, Vertices, to_region, to_shape
from exactsweep.numbers.error import explain_type_errors
from exactsweep.numbers.number import Vertex, ratio
from exactsweep.procedures.positions import find_sum, path_rings


class MinkowskiSum(Region):
    """A Minkowski sum, a Region with a certificate; its images are plain Regions.

    Attributes:
        summands: two shapes, or a Region and a Polyline.
    """

    __slots__ = ("summands",)

    summands: tuple[AnyPolygon, AnyPolygon | Polyline]

    def __init__(self, found: Region, shape: AnyPolygon, other: AnyPolygon | Polyline) -> None:
        super().__init__(found)
        object.__setattr__(self, "summands", (shape, other))

    def __reduce__(self) -> tuple[object, ...]:
        return MinkowskiSum, (Region(self), *self.summands)

    def certificate(self) -> dict[str, Any]:
        """Return plain JSON data that proves the sum to `check/standalone.py`.

        For two shapes, the certificate proves the no-fit polygon of a and -b, which has the same
        boundary. Raises PolygonError if the path is a single point. Cost: as for
        `evidence.proof.add_proof`.

        >>> swept = minkowski_sum([(0, 0), (1, 0), (0, 1)], Polyline([(0, 0), (2, 2)]))
        >>> swept.certificate()["path"]
        [['0', '0'], ['2', '2']]
        """
        from exactsweep.evidence.proof import add_proof

        return add_proof(self._claim())

    def _claim(self) -> dict[str, Any]:
        shape, other = self.summands
        if isinstance(other, Polyline):
            if len(other) == 1:
                raise PolygonError(
                    "the path is a single point: the sum is the translated shape, and needs no "
                    "certificate"
                )
            points = [*other.points, *other.points[:1]] if other.closed else other.points
            return claim_sum(Region(shape), points, self)
        reflected = other.reflected()
        return claim_pair(Region(shape), Region(reflected), solve_pair(shape, reflected))


@explain_type_errors
def minkowski_sum(a: Region | Vertices | Polyline, b: Region | Vertices | Polyline) -> MinkowskiSum:
    """Find the Minkowski sum of two shapes, or of a shape and a path: all sums of their points.

    Args:
        a: a Polygon, a Region or the vertices of a polygon; or a Polyline.
        b: the other summand, in any of these forms; at most one of the two is a Polyline.

    Returns:
        The sum, a Region with a certificate; points in its holes are not sums.

    Raises:
        PolygonError: a polygon is not simple, or both are paths.
        NumberError: a coordinate is not an exact number. Messages begin with "a" or "b".

    Cost: as for `no_fit_polygon`; for a shape and a path, O(m n log(m n) + c) for c crossings of
    contact segments.

    Source: section 3 for two convex polygons, otherwise Behar and Lien 2011.

    Example:
        >>> from exactsweep import Polyline
        >>> square = [(0, 0), (2, 0), (2, 2), (0, 2)]
        >>> print(minkowski_sum(square, [(0, 0), (1, 0), (0, 1)]))
        (0, 0) (3, 0) (3, 2) (2, 3) (0, 3)
        >>> minkowski_sum(square, Polyline([(0, 0), (9, 0), (9, 9), (0, 9)], closed=True)).holes
        (Polygon([(2, 2), (9, 2), (9, 9), (2, 9)]),)
    """
    if isinstance(a, Polyline):
        if isinstance(b, Polyline):
            raise PolygonError("a and b are both paths; one of them must be a polygon")
        shape = to_region(b, "b")
        return MinkowskiSum(_add_path(shape, a), shape, a)
    if isinstance(b, Polyline):
        shape = to_region(a, "a")
        return MinkowskiSum(_add_path(shape, b), shape, b)
    first, second = to_shape(a, "a"), to_shape(b, "b")
    found = solve_pair(first, second.reflected())
    region = Region(place_loop(found.trajectory), map(place_loop, found.holes))
    return MinkowskiSum(region, first, second)


def solve_pair(stationary: AnyPolygon, orbiting: AnyPolygon) -> Solution:
    """Return the Solution of a pair in its class, with positions of the origin."""
    direction: Vector | None = None
    if not (stationary.holes or orbiting.holes):
        direction = find_shared_direction(orbiting.exterior, stationary.exterior)
    return solve(orbiting, stationary, direction)


def _add_path(shape: Region, path: Polyline) -> Region:
    if len(path) == 1:
        return shape.translated(path.points[0])
    own, rings = shape.lattice()
    points = path.points
    common = lcm_within([own, *(c.denominator for c in chain.from_iterable(points))])
    scale = common or own
    times = scale // own

    def enter(ring: Sequence[Vertex], by: int) -> list[Vertex]:
        return [(ratio(x * by, 1), ratio(y * by, 1)) for x, y in ring]

    walked = path_rings(enter(points, scale), closed=path.closed and len(path) > 2)
    found = find_sum([enter(ring, times) for ring in rings], walked, scale)
    (exterior,) = map(place_loop, found.around)
    return Region(exterior, map(place_loop, found.within))
