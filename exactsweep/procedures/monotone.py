"""Monotone pairs: the lower and the upper half of a sweep, by section (Theorems 2.1 and 2.2).

The lower sweep (G_t, D_b) and the upper sweep (G_b, D_t) are independent. The upper sweep is the
lower sweep of both polygons after a half turn. So a polygon is stored as two bottom chains: its
own, and the inverse of its top chain. Each class uses the procedures of its own section, although
every CC sweep is a CM sweep, and every CM sweep an MM sweep.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property, lru_cache
from math import lcm
from typing import ClassVar

from exactsweep.geometry.direction import X_AXIS, Vector
from exactsweep.geometry.frame import Frame, Kind
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import Lattice
from exactsweep.numbers.number import Fit, Point, Vertex
from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import Chain, inverse, split
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm
from exactsweep.procedures.exact_fit import find_exact_fits
from exactsweep.procedures.graph import Graph
from exactsweep.procedures.mm import sweep_inner_mm, sweep_outer_mm, trajectory_mm
from exactsweep.procedures.undercuts import UndercutChains, find_undercuts


class LowerMM:
    """The lower sweep of monotone chains: reversed G_t, G_b and D_b (Section 5)."""

    kind: ClassVar[Kind] = "MM"

    def __init__(self, generatrix: Chain, bottom: Chain, directrix: Chain) -> None:
        self.generatrix, self.bottom, self.directrix = generatrix, bottom, directrix

    @cached_property
    def trajectory(self) -> Graph:
        """T(G_t, D_b) with its events."""
        return trajectory_mm(self.generatrix, self.directrix)

    @cached_property
    def path(self) -> Chain:
        """T(G_t, D_b)."""
        return self.trajectory.chain()

    @cached_property
    def inner(self) -> Chain:
        """The inner boundary (Definition 2.1)."""
        return sweep_inner_mm(self.generatrix, self.directrix, self.trajectory, self.path)

    @cached_property
    def outer(self) -> Chain:
        """The outer boundary (Definition 2.1)."""
        return sweep_outer_mm(self.bottom, self.path).chain()


class LowerCM(LowerMM):
    """The lower sweep of a convex generatrix and a monotone directrix (Section 4)."""

    kind: ClassVar[Kind] = "CM"

    @cached_property
    def trajectory(self) -> Graph:
        """T(G_t, D_b) with its events."""
        return trajectory_cm(self.generatrix, self.directrix)

    @cached_property
    def inner(self) -> Chain:
        """The inner boundary (Definition 2.1)."""
        return sweep_inner_cm(self.generatrix, self.directrix, self.trajectory)

    @cached_property
    def outer(self) -> Chain:
        """The outer boundary (Definition 2.1)."""
        return sweep_outer_cm(self.generatrix, self.bottom, self.directrix).chain()


class LowerCC(LowerMM):
    """The lower sweep of a convex generatrix and a convex directrix (Section 3)."""

    kind = "CC"

    @cached_property
    def trajectory(self) -> Graph:
        """T(G_t, D_b) with its events."""
        return trajectory_cc(self.generatrix, self.directrix)

    @cached_property
    def inner(self) -> Chain:
        """The inner boundary (Definition 2.1)."""
        return sweep_inner_cc(self.generatrix, self.directrix)

    @cached_property
    def outer(self) -> Chain:
        """The outer boundary (Definition 2.1)."""
        return sweep_outer_cc(self.generatrix, self.bottom, self.directrix).chain()


_TURN_BACK: tuple[Callable[[Sequence[Vertex]], list[Vertex]], ...] = (list, inverse)
"""Functions that map points of the lower and of the upper sweep back to the frame."""


@lru_cache(512)
def split_polygon(lattice: Lattice, frame: Frame) -> tuple[Chain, Chain]:
    """Return the bottom chain of a monotone polygon, and the inverse of its top chain, in a frame.

    Chains are cached, because nesting sweeps each part around many others.
    """
    bottom, top = split(frame.enter(*lattice))
    return Chain.of(bottom), Chain.of(inverse(top))


class MonotoneSolution:
    """The canonical loops and exact fits of a monotone pair (G, D), computed on first access.

    Positions are those of G's origin.
    """

    holes: Sequence[list[Point]] = ()
    unswept: Sequence[list[Point]] = ()

    def __init__(self, generatrix: Polygon, directrix: Polygon, direction: Vector) -> None:
        self._pair = generatrix, directrix
        self.frame = Frame(direction, lcm(generatrix.lattice()[0], directrix.lattice()[0]))
        self._class: type[LowerMM] = LowerMM
        if generatrix.is_convex:
            self._class = LowerCC if directrix.is_convex else LowerCM
        self.kind = self._class.kind

    @cached_property
    def generatrix(self) -> list[list[Vertex]]:
        """The ring of G in the frame."""
        return [self.frame.enter(*self._pair[0].lattice())]

    @cached_property
    def directrix(self) -> list[list[Vertex]]:
        """The ring of D in the frame."""
        return [self.frame.enter(*self._pair[1].lattice())]

    @cached_property
    def halves(self) -> tuple[LowerMM, LowerMM]:
        """The lower sweep, and the upper one after a half turn."""
        (g_bottom, g_top), (d_bottom, d_top) = (
            split_polygon(polygon.lattice(), self.frame) for polygon in self._pair
        )
        return self._class(g_top, g_bottom, d_bottom), self._class(g_bottom, g_top, d_top)

    def _join(self, boundary: Callable[[LowerMM], Chain]) -> list[Vertex]:
        lower, upper = (boundary(half).points for half in self.halves)
        upper = inverse(upper)
        # At each end the two chains meet at a point, or a vertical edge joins them.
        return lower + upper[upper[0] == lower[-1] : len(upper) - (upper[-1] == lower[0])]

    def _loop(self, boundary: Callable[[LowerMM], Chain]) -> list[Point]:
        points = self.frame.leave(self._join(boundary))
        first = 0 if self.frame.direction == X_AXIS else points.index(min(points))
        return points[first:] + points[:first]

    @cached_property
    def trajectory(self) -> list[Point]:
        """The path of G's origin."""
        return self._loop(lambda half: half.path)

    @cached_property
    def inner(self) -> list[Point]:
        """The inner loop: D with its undercuts closed."""
        return self._loop(lambda half: half.inner)

    @cached_property
    def outer(self) -> list[Point]:
        """The outer loop."""
        return self._loop(lambda half: half.outer)

    @cached_property
    def fits(self) -> list[Fit]:
        """The exact fits."""
        found: list[Fit] = []
        for half, turn_back in zip(self.halves, _TURN_BACK, strict=True):
            for fit in find_exact_fits(half.generatrix, half.directrix, half.path):
                hanging, inside = self.frame.leave(turn_back(fit))
                found.append((hanging, inside))
        return sorted(found)

    @cached_property
    def undercuts(self) -> list[UndercutChains]:
        """The regions between D and the inner loop, in order along the loop, in the frame."""
        return find_undercuts(self._join(lambda half: half.inner), self.directrix[0])
