"""The lower sweep (G_t, D_b), by the procedures of its class (end of Section 2)."""

from __future__ import annotations

from collections import deque
from functools import cached_property
from typing import Any, Literal, Self, TypeVar, overload
from weakref import ref

from exactsweep.geometry.frame import Frame
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Vertex
from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import KeptChain, split
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.mm import outer_mm, trajectory_mm
from exactsweep.procedures.mm_inner import inner_mm

Kind = Literal["CC", "CM", "MM", "SS"]
"""The classes of the paper; and "SS", of polygons of any shape, which has no lower sweep."""


KEPT_VERTICES = 256
"""Polygons of more vertices do not keep their chains: there the sweep takes far longer."""
KEPT_POLYGONS = 512
"""So many polygons keep their chains, those that came last: up to 1 kB for each vertex."""

_keeping: deque[ref[Polygon]] = deque()
"""Who keeps chains, oldest first, each once; some are gone meanwhile."""

T_co = TypeVar("T_co", covariant=True)


class made_once(cached_property[T_co]):  # noqa: N801
    """`functools.cached_property` without the lock that it takes before Python 3.12.

    The lock costs 1 µs each time, which is a fifteenth of a small trajectory.
    """

    @overload
    def __get__(self, instance: None, owner: type[Any] | None = None) -> Self: ...

    @overload
    def __get__(self, instance: object, owner: type[Any] | None = None) -> T_co: ...

    def __get__(self, instance: object, owner: type[Any] | None = None) -> Self | T_co:
        if instance is None:
            return self
        assert self.attrname is not None
        value = instance.__dict__[self.attrname] = self.func(instance)
        return value


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

    @property
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

    Who nests sweeps each part around many others. So a polygon of few vertices keeps its chains in
    the last frame, and these what was found about them (see `KeptChain`), until as many others as
    may keep theirs have come after it.

    Args:
        polygon: monotone to the direction of the frame.
        frame: of a pair of which it is one.

    Returns:
        (bottom, left to right; top, right to left), which must not be changed.

    Cost: O(n) the first time.

    >>> square = Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> split_polygon(square, Frame((1, 0), 2))
    ([(0, 0), (2, 0)], [(2, 2), (0, 2)])
    """
    kept = polygon._chains
    if kept is not None and kept[0] == frame:
        bottom, top = kept[1]
        return bottom, top
    bottom, top = split(frame.enter(polygon))
    if len(polygon) <= KEPT_VERTICES:
        bottom, top = KeptChain(bottom), KeptChain(top)
        polygon._chains = frame, (bottom, top)
        if kept is None:
            _keeping.append(ref(polygon))
        if len(_keeping) > KEPT_POLYGONS:
            oldest = _keeping.popleft()()
            if oldest is not None:
                oldest._chains = None
    return bottom, top
