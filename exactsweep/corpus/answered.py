"""A pair of polygons with the exact answers."""

from collections.abc import Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from math import lcm
from typing import Literal, get_args

from exactsweep.corpus.representable import find_types
from exactsweep.geometry.frame import Kind
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.number import Fit, Loop, Point
from exactsweep.sweep import Sweep, sweep

Shapes = Literal["convex", "monotone", "simple", "any"]
SHAPES: tuple[Shapes, ...] = get_args(Shapes)
"""The kinds of pairs; each includes those before it. "simple": without holes."""
_SHAPES_OF: dict[Kind, Shapes] = {
    "CC": "convex",
    "CM": "monotone",
    "MM": "monotone",
    "SS": "simple",
}


@dataclass(frozen=True, kw_only=True)
class AnsweredPair:
    """A pair of polygons with the exact answers.

    Attributes:
        directrix_ring: the exterior of D as given: an open tuple of Point, with the orientation,
            collinear vertices and repeated vertices of the input.
        generatrix_ring: the exterior of G as given.
        reference: the reference point of G, whose path is the trajectory.
        kind: "CC", "CM", "MM" or "SS".
        trajectory: the exact trajectory, a Polygon.
        inner: the exact inner loop, a Polygon.
        outer: the exact outer loop, a Polygon.
        exact_fits: the exact fits, as in `Sweep.exact_fits`.
        area: the swept area.
        directrix_holes: the holes of D as given.
        generatrix_holes: the holes of G as given.
        holes: the holes of the no-fit polygon, whose exterior is the trajectory.
        unswept: additional holes of the swept area.
        inner_regions: the regions of positions of G inside D; None if the case does not have them.
            Cases of class "SS" and containers have them.
        inner_exact_fits: the exact fits of G inside D.
    """

    directrix_ring: Loop
    generatrix_ring: Loop
    reference: Point
    kind: Kind
    trajectory: Polygon
    inner: Polygon
    outer: Polygon
    exact_fits: tuple[Fit, ...]
    area: Fraction
    directrix_holes: tuple[Loop, ...] = ()
    generatrix_holes: tuple[Loop, ...] = ()
    holes: tuple[Polygon, ...] = ()
    unswept: tuple[Polygon, ...] = ()
    inner_regions: tuple[Region, ...] | None = None
    inner_exact_fits: tuple[Fit, ...] = ()

    @property
    def directrix_rings(self) -> tuple[Loop, ...]:
        """The exterior and the holes of D as given."""
        return (self.directrix_ring, *self.directrix_holes)

    @property
    def generatrix_rings(self) -> tuple[Loop, ...]:
        """The exterior and the holes of G as given."""
        return (self.generatrix_ring, *self.generatrix_holes)

    @cached_property
    def directrix(self) -> AnyPolygon:
        """D in canonical form; a Region if it has holes."""
        return make_shape(self.directrix_rings)

    @cached_property
    def generatrix(self) -> AnyPolygon:
        """G in canonical form; a Region if it has holes."""
        return make_shape(self.generatrix_rings)

    def sweep(self) -> Sweep:
        """Sweep the pair."""
        return sweep(self.generatrix, self.directrix, reference=self.reference)

    @property
    def shapes(self) -> Shapes:
        """The least of SHAPES that includes the pair."""
        if self.directrix_holes or self.generatrix_holes:
            return "any"
        return _SHAPES_OF[self.kind]

    @property
    def size(self) -> int:
        """The number of vertices of all rings as given."""
        return sum(map(len, (*self.directrix_rings, *self.generatrix_rings)))

    @cached_property
    def integer_scale(self) -> int:
        """The least scale at which D, G and the reference point are integers."""
        return lcm(*(c.denominator for c in self.list_input()))

    @cached_property
    def representable(self) -> frozenset[str]:
        """The number types that represent the input exactly, integers at `integer_scale`."""
        return find_types(list(self.list_input()), self.integer_scale)

    @cached_property
    def answer_representable(self) -> frozenset[str]:
        """The number types that represent the answer exactly, integers at `integer_scale`."""
        return find_types(list(self.list_answer()), self.integer_scale)

    def list_input(self) -> Iterator[Fraction]:
        """List the coordinates of D, of G and of the reference point."""
        rings = *self.directrix_rings, *self.generatrix_rings, (self.reference,)
        return chain(*chain(*rings))

    def list_answer(self) -> Iterator[Fraction]:
        """List the coordinates of all loops and exact fits of the answer."""
        loops = (self.trajectory, self.inner, self.outer, *self.holes, *self.unswept)
        rings = [shape.vertices for shape in (*loops, *(self.inner_regions or ()))]
        return chain(*chain(*rings, *self.exact_fits, *self.inner_exact_fits))


def make_shape(rings: tuple[Loop, ...]) -> AnyPolygon:
    """Return a Polygon, or a Region if there are holes."""
    exterior, *holes = rings
    return Region(exterior, holes) if holes else Polygon(exterior)
