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
from exactsweep.geometry.frame import Frame, Kind, to_homogeneous
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import Lattice
from exactsweep.numbers.number import Fit, Point
from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import Chain, inverse, split
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm
from exactsweep.procedures.exact_fit import find_exact_fits
from exactsweep.procedures.graph import Graph
from exactsweep.procedures.mm import sweep_inner_mm, sweep_outer_mm, trajectory_mm


class LowerMM:
    """The lower sweep of monotone chains: reversed G_t, G_b and D_b (Section 5)."""

    kind: ClassVar[Kind] = "MM"

    def __init__(self, generatrix: Chain, bottom: Chain, directrix: Chain) -> None:
        self.generatrix, self.bottom, self.directrix = generatrix, bottom, directrix

    @cached_property
    def trajectory(self) -> Graph:
        """T(G_t, D_b) with its events: Trajectory_MM."""
        return trajectory_mm(self.generatrix, self.directrix)

    @cached_property
    def path(self) -> Chain:
        """T(G_t, D_b) as a chain."""
        return self.trajectory.chain()

    def sweep_inner(self) -> Chain:
        """Compute the inner boundary (Definition 2.1): half of Sweep_MM."""
        return sweep_inner_mm(self.generatrix, self.directrix, self.trajectory, self.path)

    def sweep_outer(self) -> Chain:
        """Compute the outer boundary (Definition 2.1): half of Sweep_MM."""
        return sweep_outer_mm(self.bottom, self.path).chain()


class LowerCM(LowerMM):
    """The lower sweep of a convex generatrix and a monotone directrix (Section 4)."""

    kind: ClassVar[Kind] = "CM"

    @cached_property
    def trajectory(self) -> Graph:
        """T(G_t, D_b) with its events: Trajectory_CM."""
        return trajectory_cm(self.generatrix, self.directrix)

    def sweep_inner(self) -> Chain:
        """Compute the inner boundary (Definition 2.1): SweepI_CM."""
        return sweep_inner_cm(self.generatrix, self.directrix, self.trajectory)

    def sweep_outer(self) -> Chain:
        """Compute the outer boundary (Definition 2.1): SweepO_CM."""
        return sweep_outer_cm(self.generatrix, self.bottom, self.directrix).chain()


class LowerCC(LowerCM):
    """The lower sweep of a convex generatrix and a convex directrix (Section 3).

    Trajectory_CC merges edges only. The events, if needed, come from `LowerCM`.
    """

    kind: ClassVar[Kind] = "CC"

    @cached_property
    def path(self) -> Chain:
        """T(G_t, D_b) as a chain: Trajectory_CC."""
        return trajectory_cc(self.generatrix, self.directrix)

    def sweep_inner(self) -> Chain:
        """Compute the inner boundary (Definition 2.1): SweepI_CC."""
        return sweep_inner_cc(self.generatrix, self.directrix)

    def sweep_outer(self) -> Chain:
        """Compute the outer boundary (Definition 2.1): SweepO_CC."""
        return sweep_outer_cc(self.generatrix, self.bottom, self.directrix)


@lru_cache(512)
def split_polygon(lattice: Lattice, frame: Frame) -> tuple[Chain, Chain]:
    """Return the bottom chain of a monotone polygon, and the inverse of its top chain, in a frame.

    Chains are cached, because nesting sweeps each part around many others.
    """
    bottom, top = split(frame.enter(*lattice))
    lower, upper = ([to_homogeneous(*point) for point in c] for c in (bottom, inverse(top)))
    return Chain(lower), Chain(upper)


class MonotoneSolution:
    """The canonical loops and exact fits of a monotone pair (G, D), computed on first access.

    Positions are those of G's origin.
    """

    # Only a `ShapeSolution` has these.
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
    def halves(self) -> tuple[LowerMM, LowerMM]:
        """The lower sweep, and the upper one after a half turn.

        After a half turn, G_b is the reversed top chain of G, and the inverse of G_t its bottom
        chain.
        """
        (g_bottom, g_top), (d_bottom, d_top) = (
            split_polygon(polygon.lattice(), self.frame) for polygon in self._pair
        )
        return self._class(g_top, g_bottom, d_bottom), self._class(g_bottom, g_top, d_top)

    def _loop(self, boundary: Callable[[LowerMM], Chain]) -> list[Point]:
        lower, upper = map(boundary, self.halves)
        loop, back = self.frame.leave(lower.vertices), self.frame.half_turn().leave(upper.vertices)
        # At each end the two chains meet at a point, or a vertical edge joins them.
        loop += back[back[0] == loop[-1] : len(back) - (back[-1] == loop[0])]
        # Loops start at the least vertex.
        first = 0 if self.frame.direction == X_AXIS else loop.index(min(loop))
        return loop[first:] + loop[:first]

    @cached_property
    def trajectory(self) -> list[Point]:
        """The path of G's origin."""
        return self._loop(lambda half: half.path)

    @cached_property
    def inner(self) -> list[Point]:
        """The inner loop: D with its undercuts closed."""
        return self._loop(lambda half: half.sweep_inner())

    @cached_property
    def outer(self) -> list[Point]:
        """The outer loop."""
        return self._loop(lambda half: half.sweep_outer())

    @cached_property
    def fits(self) -> list[Fit]:
        """The exact fits."""
        return sorted(
            (frame.leave_point(hanging), frame.leave_point(inside))
            for half, frame in zip(self.halves, (self.frame, self.frame.half_turn()), strict=True)
            for hanging, inside in find_exact_fits(half.generatrix, half.directrix, half.path)
        )
