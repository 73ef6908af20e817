"""The choice between the paper's procedures and those for any shape."""

from __future__ import annotations

from exactsweep.geometry.direction import Vector
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.procedures.any_shape import ShapeSolution
from exactsweep.procedures.monotone import MonotoneSolution
from exactsweep.procedures.solution import Solution


def solve(generatrix: AnyPolygon, directrix: AnyPolygon, direction: Vector | None) -> Solution:
    """Choose what computes a pair.

    Args:
        generatrix: G.
        directrix: D.
        direction: a direction to which both are monotone; None, if there is none.

    Returns:
        The Solution; nothing of it is computed yet.
    """
    if direction is None:
        return ShapeSolution(Region(generatrix), Region(directrix))
    return MonotoneSolution(generatrix.exterior, directrix.exterior, direction)
