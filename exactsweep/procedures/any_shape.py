"""The sweep of two shapes that share no direction of monotonicity, with or without holes.

G travels along the loop T, the exterior of the no-fit polygon, and covers S = T + G. A point p is
not covered if and only if I(G) + p does not meet T, and so lies inside or outside T. The positions
p with I(G) + p inside T are an inner fit of I(G) in T; those with I(G) + p outside are the free
positions of I(G) around T.
"""

from __future__ import annotations

from functools import cached_property

from exactsweep.geometry.direction import X_AXIS
from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.frame import Frame, Kind
from exactsweep.geometry.overlap import Relation, relate
from exactsweep.geometry.region import Region, share_lattice
from exactsweep.numbers.number import Fit, Point, Vertex
from exactsweep.procedures.positions import find_inner_fit, find_no_fit, find_sum, reflect
from exactsweep.procedures.walk import FreeBoundary


class ShapeSolution:
    """The loops and exact fits of a pair of any shape, with the interface of `MonotoneSolution`.

    Attributes:
        frame: the lattice of the pair, not rotated.
        generatrix, directrix: the rings of G and of D on the lattice.
    """

    kind: Kind = "SS"

    def __init__(self, generatrix: Region, directrix: Region) -> None:
        scale, (self.generatrix, self.directrix) = share_lattice((generatrix, directrix))
        self.frame = Frame(X_AXIS, scale)

    @cached_property
    def _no_fit(self) -> FreeBoundary:
        return find_no_fit(self.directrix, self.generatrix, self.frame.scale)

    @cached_property
    def trajectory(self) -> list[Point]:
        """The exterior of the no-fit polygon."""
        return self._no_fit.around[0]

    @cached_property
    def holes(self) -> list[list[Point]]:
        """The loops of positions at which G fits into a cavity or a hole of D, sorted."""
        return self._no_fit.within

    @cached_property
    def fits(self) -> list[Fit]:
        """The exact fits, including those in cavities and holes."""
        return self._no_fit.fits

    @cached_property
    def _path(self) -> list[list[Vertex]]:
        """T, with rational vertices, because a lattice of crossings would be huge."""
        return [[self.frame.enter_point(vertex) for vertex in self.trajectory]]

    @cached_property
    def _outside(self) -> FreeBoundary:
        """The positions p with I(G) + p outside T."""
        return find_sum(self._path, self.generatrix, self.frame.scale)

    @cached_property
    def _inside(self) -> list[list[Point]]:
        """The loops of positions p with I(G) + p inside T."""
        part = reflect(self.generatrix)
        regions = find_inner_fit(self._path, part, self.frame.scale).regions
        return [exterior for exterior, _ in regions]

    @cached_property
    def outer(self) -> list[Point]:
        """The outer loop of the swept area."""
        return self._outside.around[0]

    @cached_property
    def inner(self) -> list[Point]:
        """The inner loop around D: D with its undercuts and holes closed."""
        shape = EdgeIndex([list(map(self.frame.leave_point, self.directrix[0]))])
        # D lies in one of these loops, and their interiors are disjoint.
        return next(
            loop for loop in self._inside if relate(EdgeIndex([loop]), shape) is Relation.OVERLAP
        )

    @cached_property
    def unswept(self) -> list[list[Point]]:
        """The other holes of the swept area, sorted."""
        return sorted([loop for loop in self._inside if loop != self.inner] + self._outside.within)
