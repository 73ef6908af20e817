"""The record of the results of the procedures for a pair (G, D) of any shape, and its making."""

from __future__ import annotations

import gc
from functools import cached_property
from typing import Any, Literal, Self, TypeVar, overload

from exactsweep.geometry.frame import Frame
from exactsweep.numbers.point import Fit, Point, Vertex

Kind = Literal["CC", "CM", "MM", "SS"]
"""The classes of the paper, and "SS" for polygons of any shape."""


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


class pause_collector:  # noqa: N801
    """Disable the garbage collector in a `with` block that makes many objects.

    The collector searches all objects for cycles whenever their number has grown by some share. The
    kernel makes no cycles, but with 100,000 vertices the searches take half of the time.
    """

    def __enter__(self) -> None:
        self.runs = gc.isenabled()
        gc.disable()

    def __exit__(self, *error: object) -> None:
        if self.runs:
            gc.enable()


class Solution:
    """The loops and exact fits of a pair, each computed when it is first read.

    Positions are those of G's origin. Loops are canonical: counter-clockwise, corners only, the
    least vertex first, not closed.

    Attributes:
        kind: the class of the pair.
    """

    kind: Kind

    @made_once
    def frame(self) -> Frame:
        """The lattice of the pair, the shared direction of a monotone pair as X axis."""
        raise NotImplementedError

    @made_once
    def generatrix(self) -> list[list[Vertex]]:
        """The rings of G in the frame, its interior on the left."""
        raise NotImplementedError

    @made_once
    def directrix(self) -> list[list[Vertex]]:
        """The rings of D in the frame, its interior on the left."""
        raise NotImplementedError

    @made_once
    def trajectory(self) -> list[Point]:
        """The loop around all positions of overlap."""
        raise NotImplementedError

    @made_once
    def inner(self) -> list[Point]:
        """The inner loop of the swept area, around D."""
        raise NotImplementedError

    @made_once
    def outer(self) -> list[Point]:
        """The outer loop of the swept area."""
        raise NotImplementedError

    @made_once
    def fits(self) -> list[Fit]:
        """The exact fits, sorted. If only one end lies on a loop, it comes first."""
        raise NotImplementedError

    @made_once
    def pockets(self) -> list[list[list[Vertex]]]:
        """The regions between D and the inner loop, in the frame.

        Each consists of its bottom chain, a piece of the inner loop, and D's vertices on the way
        back.
        """
        raise NotImplementedError

    @made_once
    def holes(self) -> list[list[Point]]:
        """The loops around free positions inside the trajectory; only of kind "SS"."""
        return []

    @made_once
    def unswept(self) -> list[list[Point]]:
        """The holes of the swept area beside the inner loop; only of kind "SS"."""
        return []
