"""The sweep of two polygons that are monotone to one direction (Theorems 2.1 and 2.2).

The lower sweep (G_t, D_b) and the upper sweep (G_b, D_t) are independent. The upper sweep is the
lower sweep of both polygons after half a turn.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import lcm

from exactsweep.geometry.canonical import find_least
from exactsweep.geometry.direction import X_AXIS, Vector
from exactsweep.geometry.frame import Frame
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.reading import Lattice
from exactsweep.numbers.number import Fit, Point, Vertex
from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import KeptChain, inverse, split
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.exact_fit import find_exact_fits
from exactsweep.procedures.mm import inner_mm, outer_mm, trajectory_mm
from exactsweep.procedures.pockets import find_pockets
from exactsweep.procedures.solution import Kind, made_once, pause_collector

KEPT_VERTICES = 256
"""The largest number of vertices of a polygon with cached chains."""
KEPT_POLYGONS = 512
"""The number of polygons with cached chains, the last ones used; up to 1 kB per vertex."""

_TURN_BACK: tuple[Callable[[Sequence[Vertex]], list[Vertex]], ...] = (list, inverse)
"""Functions that turn points of the lower sweep and of the upper one back to the frame."""


@dataclass(eq=False)
class LowerSweep:
    """The sweep (G_t, D_b), or (G_b, D_t) turned by half a turn, of one of the paper's classes.

    Args:
        kind: "CC", "CM" or "MM".
        top: G_t, from right to left.
        bottom: G_b, from left to right.
        directrix: D_b, from left to right.
    """

    kind: Kind
    top: list[Vertex]
    bottom: list[Vertex]
    directrix: list[Vertex]

    @made_once
    def path(self) -> list[Vertex]:
        """T(G_t, D_b) as a chain, from left to right."""
        if self.kind == "CC":
            return trajectory_cc(self.top, self.directrix)
        return list(self.trajectory)

    @made_once
    def trajectory(self) -> Envelope:
        """T(G_t, D_b)."""
        if self.kind == "CC":
            return Envelope.of(self.path)
        if self.kind == "CM":
            return trajectory_cm(self.top, self.directrix)
        return trajectory_mm(self.top, self.directrix)

    @made_once
    def inner(self) -> list[Vertex]:
        """The inner boundary, Definition 2.1."""
        if self.kind == "CC":
            return sweep_inner_cc(self.top, self.directrix)
        if self.kind == "CM":
            return sweep_inner_cm(self.top, self.directrix, self.trajectory)
        return inner_mm(self.top, self.trajectory, self.directrix)

    @made_once
    def outer(self) -> list[Vertex]:
        """The outer boundary, Definition 2.1."""
        if self.kind == "CC":
            return sweep_outer_cc(self.top, self.bottom, self.directrix)
        if self.kind == "CM":
            return list(sweep_outer_cm(self.top, self.bottom, self.directrix))
        return list(outer_mm(self.bottom, self.trajectory))


def split_polygon(polygon: Polygon, frame: Frame) -> tuple[KeptChain, KeptChain]:
    """The bottom and the top chain of a monotone polygon in a frame (Section 2, Figure 2).

    Nesting sweeps each part around many others. So the function caches the chains of the last small
    polygons (see `KeptChain`).

    Args:
        polygon: a polygon that is monotone to the direction of the frame.
        frame: the frame of a pair with this polygon.

    Returns:
        (bottom, left to right; top, right to left), which must not be changed.

    Cost: O(n).

    >>> square = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> split_polygon(square, Frame((1, 0), 2))
    ([(0, 0), (2, 0)], [(2, 2), (0, 2)])
    """
    lattice = polygon.lattice()
    return _split(lattice, frame) if len(lattice[1]) > KEPT_VERTICES else _keep(lattice, frame)


def _split(lattice: Lattice, frame: Frame) -> tuple[KeptChain, KeptChain]:
    bottom, top = split(frame.enter(*lattice))
    return KeptChain(bottom), KeptChain(top)


_keep = lru_cache(KEPT_POLYGONS)(_split)


class MonotoneSolution:
    """The loops and exact fits of a monotone pair, by the paper's procedures.

    Each is computed when it is first read. Positions are those of G's origin. Loops are canonical:
    counter-clockwise, corners only, the least vertex first, not closed.

    Args:
        generatrix: G.
        directrix: D.
        direction: the shared direction of monotonicity, a primitive integer vector.

    Attributes:
        kind: the class of the pair.
        holes: the loops around free positions inside the trajectory; none.
        unswept: the holes of the swept area beside the inner loop; none.
    """

    holes: Sequence[list[Point]] = ()
    unswept: Sequence[list[Point]] = ()

    def __init__(self, generatrix: Polygon, directrix: Polygon, direction: Vector) -> None:
        self._pair = generatrix, directrix
        g, d = self._pair
        self.kind: Kind = "MM" if not g.is_convex else "CC" if d.is_convex else "CM"
        self._direction = direction

    @made_once
    def frame(self) -> Frame:
        """The common lattice, turned so that the direction is the X axis."""
        g, d = self._pair
        return Frame(self._direction, lcm(g.lattice()[0], d.lattice()[0]))

    @made_once
    def generatrix(self) -> list[list[Vertex]]:
        """The ring of G in the frame."""
        return [self.frame.enter(*self._pair[0].lattice())]

    @made_once
    def directrix(self) -> list[list[Vertex]]:
        """The ring of D in the frame."""
        return [self.frame.enter(*self._pair[1].lattice())]

    @made_once
    def halves(self) -> tuple[LowerSweep, LowerSweep]:
        """The lower sweep, and the upper one turned by half a turn."""
        (g_bottom, g_top), (d_bottom, d_top) = (split_polygon(p, self.frame) for p in self._pair)
        return (
            LowerSweep(self.kind, g_top, g_bottom, d_bottom),
            LowerSweep(self.kind, inverse(g_bottom), inverse(g_top), inverse(d_top)),
        )

    def _loop(self, half: Callable[[LowerSweep], list[Vertex]]) -> list[Point]:
        with pause_collector():
            lower, upper = map(half, self.halves)
            upper = inverse(upper)
            # At each end the two chains meet in a point, or a vertical edge joins them.
            loop = lower + upper[upper[0] == lower[-1] : len(upper) - (upper[-1] == lower[0])]
            points = self.frame.leave(loop)
            if self._direction != X_AXIS:
                first = find_least(points)
                points = points[first:] + points[:first]
            made = self.__dict__
            if ("trajectory" in made) + ("inner" in made) + ("outer" in made) == 2:
                # This is the last of three: envelopes would hold as much as all of them.
                for side in self.halves:
                    side.__dict__.pop("trajectory", None)
                    side.__dict__.pop("outer", None)
            return points

    @made_once
    def trajectory(self) -> list[Point]:
        """The path of G's origin."""
        return self._loop(lambda half: half.path)

    @made_once
    def inner(self) -> list[Point]:
        """The inner loop: D with its undercuts closed."""
        return self._loop(lambda half: half.inner)

    @made_once
    def outer(self) -> list[Point]:
        """The outer loop."""
        return self._loop(lambda half: half.outer)

    @made_once
    def fits(self) -> list[Fit]:
        """The exact fits, in slots of D that are exactly as wide as G."""
        found: list[Fit] = []
        for half, turn_back in zip(self.halves, _TURN_BACK, strict=True):
            for fit in find_exact_fits(half.top, half.directrix, half.path):
                hanging, inside = self.frame.leave(turn_back(fit))
                found.append((hanging, inside))
        return sorted(found)

    @made_once
    def pockets(self) -> list[list[list[Vertex]]]:
        """The regions between D and the inner loop, along the inner loop."""
        found: list[list[list[Vertex]]] = []
        for half, turn_back in zip(self.halves, _TURN_BACK, strict=True):
            for pocket in find_pockets(half.inner, half.directrix):
                bottom, top = map(turn_back, pocket)
                found.append([bottom, top[-2:0:-1]])
        return found
