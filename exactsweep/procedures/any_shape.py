"""The sweep of two shapes that share no direction of monotonicity, with or without holes.

G travels along the loop T, the exterior of the no-fit polygon, and covers S = T + G. A point p is
not covered if and only if I(G) + p does not meet T, and so lies inside or outside T. The positions
p with I(G) + p inside T are an inner fit of I(G) in T. Those with I(G) + p outside are the free
positions of I(G) around T. So `ss` solves one problem for each side of S.
"""

from __future__ import annotations

from exactsweep.geometry.direction import X_AXIS
from exactsweep.geometry.frame import Frame
from exactsweep.geometry.overlap import Overlap
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region, share_lattice
from exactsweep.numbers.number import ORIGIN, Fit, Point, Vertex
from exactsweep.procedures import ss
from exactsweep.procedures.free_positions import Free
from exactsweep.procedures.pockets import find_mouths
from exactsweep.procedures.solution import Kind, made_once


class ShapeSolution:
    """The loops and exact fits of a pair of any shape, in the form of `MonotoneSolution`.

    Args:
        generatrix: G.
        directrix: D.
        scale: the scale of their lattice; some vertices may be off the lattice.
    """

    kind: Kind = "SS"

    def __init__(self, generatrix: Region, directrix: Region, scale: int | None = None) -> None:
        self._pair = generatrix, directrix
        self._scale = scale

    @made_once
    def _lattice(self) -> tuple[int, list[list[list[Vertex]]]]:
        return share_lattice(self._pair, self._scale)

    @made_once
    def frame(self) -> Frame:
        """The lattice of the pair, not turned."""
        return Frame(X_AXIS, self._lattice[0])

    @made_once
    def generatrix(self) -> list[list[Vertex]]:
        """The rings of G on the lattice."""
        return self._lattice[1][0]

    @made_once
    def directrix(self) -> list[list[Vertex]]:
        """The rings of D on the lattice."""
        return self._lattice[1][1]

    @made_once
    def _no_fit(self) -> Free:
        return ss.no_fit_ss(self.directrix, self.generatrix, self.frame.scale)

    @made_once
    def trajectory(self) -> list[Point]:
        """The exterior of the no-fit polygon."""
        return self._no_fit.around[0]

    @made_once
    def holes(self) -> list[list[Point]]:
        """The loops of positions at which G fits into a cave or a hole of D, sorted."""
        return self._no_fit.within

    @made_once
    def fits(self) -> list[Fit]:
        """Exact fits anywhere, in caves and holes, too."""
        return self._no_fit.fits

    @made_once
    def _around_path(self) -> ShapeSolution:
        """The sweep of I(G) around T's inside, for the points that are not swept."""
        path = Region(Polygon._trust(self.trajectory))
        # A lattice with T's corners at crossings of contact segments would be huge.
        return ShapeSolution(self._pair[0].reflected(), path, self.frame.scale)

    @made_once
    def _inside(self) -> list[list[Point]]:
        found = self._around_path
        regions = ss.inner_fit_ss(found.directrix, found.generatrix, found.frame.scale).regions
        return [exterior for exterior, _ in regions]

    @made_once
    def outer(self) -> list[Point]:
        """The outer loop of the swept area."""
        return self._around_path.trajectory

    @made_once
    def inner(self) -> list[Point]:
        """The inner loop around D: D with its undercuts and holes closed."""
        ring = self._pair[1].exterior.vertices
        # D lies in one of these loops, and their interiors are disjoint.
        return next(loop for loop in self._inside if Overlap([loop], [ring]).at(ORIGIN))

    @made_once
    def unswept(self) -> list[list[Point]]:
        """The other holes of the swept area, sorted."""
        others = [loop for loop in self._inside if loop != self.inner]
        return sorted(others + self._around_path.holes)

    @made_once
    def pockets(self) -> list[list[list[Vertex]]]:
        """The regions between D and the inner loop, along the inner loop; no holes of D."""
        inner = [self.frame.enter_point(vertex) for vertex in self.inner]
        return [[bottom, top[-2:0:-1]] for bottom, top in find_mouths(inner, self.directrix[0])]
