"""The loops of the area that a generatrix of any shape sweeps along its trajectory (kind "SS").

G travels along the loop T, the exterior of the no-fit polygon, and covers S = T + G. A point p is
left out exactly if I(G) + p misses T, and so lies inside of T or outside. The first are the
positions in which I(G) fits into T; the second those around which T's inside is a no-fit polygon.
So the two sides of S are one question each of those that `ss` answers.
"""

from __future__ import annotations

from functools import cached_property
from itertools import pairwise
from typing import Any

from exactsweep.evidence.no_fit import Fit, NoFitPolygon, Pair
from exactsweep.evidence.shape_certificate import write_points
from exactsweep.evidence.swept import Swept
from exactsweep.geometry.number import format_fraction
from exactsweep.geometry.overlap import is_inside
from exactsweep.geometry.point import ORIGIN, Point
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.procedures.ss import inner_fit_ss, no_fit_ss


class SweptShape(Swept):
    """The sweep of two shapes, with holes or without, that share no direction of monotonicity.

    Attributes are those of `Swept`; `direction` is None. Each loop is computed when it is first
    read.
    """

    generatrix: Region  # type: ignore[assignment]
    directrix: Region  # type: ignore[assignment]
    direction: None  # type: ignore[assignment]

    def __init__(self, generatrix: Region, directrix: Region, reference: Point) -> None:
        self.generatrix = generatrix
        self.directrix = directrix
        self.reference = reference
        self.direction = None
        self.kind = "SS"

    @cached_property
    def _no_fit(self) -> NoFitPolygon:
        return NoFitPolygon(self.directrix, self.generatrix, self.reference, None)

    @property
    def trajectory(self) -> Polygon:
        """The path of the reference point of G: the exterior of the no-fit polygon."""
        return self._no_fit.exterior

    @property
    def exact_fits(self) -> tuple[Fit, ...]:
        """Exact fits anywhere, in caves and holes, too: those of the no-fit polygon."""
        return self._no_fit.exact_fits

    @cached_property
    def _path(self) -> Pair:
        """T's inside, and I(G), which misses T where a point is not swept."""
        x, y = self.reference
        path = Region(self.trajectory.translated((-x, -y)))
        return Pair(path, self.generatrix.reflected(), ORIGIN)

    @cached_property
    def _outside(self) -> tuple[Polygon, tuple[Polygon, ...]]:
        found = no_fit_ss(self._path.fixed, self._path.moved)
        return self._path.polygon(found.exterior), self._path.polygons(found.holes)

    @cached_property
    def _inside(self) -> tuple[Polygon, ...]:
        found = inner_fit_ss(self._path.fixed, self._path.moved)
        return self._path.polygons([loop for loop, _ in found.regions])

    @property
    def outer(self) -> Polygon:
        """The outer loop of the swept area."""
        return self._outside[0]

    @cached_property
    def inner(self) -> Polygon:
        """The loop around D of what is not swept: D with its undercuts and holes closed."""
        return next(loop for loop in self._inside if _holds(loop, self.directrix.exterior))

    @cached_property
    def unswept(self) -> tuple[Polygon, ...]:
        """The other holes of the swept area, sorted."""
        others = [loop for loop in self._inside if loop is not self.inner]
        return tuple(sorted((*others, *self._outside[1]), key=lambda loop: loop.vertices))

    def certificate(self) -> dict[str, Any]:
        """Plain JSON data from which anyone can check the sweep, positions told of G's origin."""
        return {
            **self._no_fit.certificate(),
            "claim": "sweep",
            "kind": "SS",
            "inner": write_points(self.inner.vertices),
            "outer": write_points(self.outer.vertices),
            "unswept": [write_points(loop.vertices) for loop in self.unswept],
            "area": format_fraction(self.area),
        }


def _holds(loop: Polygon, directrix: Polygon) -> bool:
    """Whether D, which lies in one of several loops without common inner points, is in this one."""
    if loop == directrix:
        return True
    ring = directrix.vertices
    points = [(2 * x, 2 * y) for x, y in ring]
    points += [(p.x + q.x, p.y + q.y) for p, q in pairwise((*ring, ring[0]))]
    return any(is_inside(point, [loop.vertices]) for point in points)
