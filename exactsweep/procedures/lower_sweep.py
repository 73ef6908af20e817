"""The lower sweep (G_t, D_b), by the procedures of its class (end of Section 2)."""

from __future__ import annotations

from functools import lru_cache

from exactsweep.geometry.frame import Frame
from exactsweep.geometry.lattice import Lattice
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Vertex
from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import KeptChain, split
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.made_once import made_once
from exactsweep.procedures.mm import outer_mm, trajectory_mm
from exactsweep.procedures.mm_inner import inner_mm
from exactsweep.procedures.solution import Kind

KEPT_VERTICES = 256
"""The largest number of vertices of a polygon with cached chains."""
KEPT_POLYGONS = 512
"""The number of polygons with cached chains, the last ones used; up to 1 kB per vertex."""


class LowerSweep:
    """The sweep (G_t, D_b), or (G_b, D_t) turned by half a turn, of one of the paper's classes.

    Args:
        kind: "CC", "CM" or "MM".
        top: G_t, from right to left.
        bottom: G_b, from left to right.
        directrix: D_b, from left to right.
    """

    def __init__(
        self, kind: Kind, top: list[Vertex], bottom: list[Vertex], directrix: list[Vertex]
    ) -> None:
        self.kind = kind
        self.top = top
        self.bottom = bottom
        self.directrix = directrix

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
            return Envelope.of_convex(self.path)
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


def split_polygon(polygon: Polygon, frame: Frame) -> tuple[list[Vertex], list[Vertex]]:
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


def _split(lattice: Lattice, frame: Frame) -> tuple[list[Vertex], list[Vertex]]:
    return split(frame.enter(*lattice))


@lru_cache(KEPT_POLYGONS)
def _keep(lattice: Lattice, frame: Frame) -> tuple[KeptChain, KeptChain]:
    bottom, top = _split(lattice, frame)
    return KeptChain(bottom), KeptChain(top)
