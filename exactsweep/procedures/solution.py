"""The record of the results of the procedures for a pair (G, D) of any shape."""

from __future__ import annotations

from typing import Literal

from exactsweep.geometry.frame import Frame
from exactsweep.numbers.point import Fit, Point, Vertex
from exactsweep.procedures.made_once import made_once

Kind = Literal["CC", "CM", "MM", "SS"]
"""The classes of the paper, and "SS" for polygons of any shape."""


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
