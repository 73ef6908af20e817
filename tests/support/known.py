"""What the answers worked by hand have in common."""

from fractions import Fraction
from typing import Any

from exactsweep import Sweep

Loop = list[tuple[Any, Any]]
half, third = Fraction(1, 2), Fraction(1, 3)

UNIT: Loop = [(0, 0), (1, 0), (1, 1), (0, 1)]
ROOF: Loop = [(0, 0), (2, 2), (4, 0), (4, 4), (0, 4)]


def check(s: Sweep, kind: str, trajectory: Loop, inner: Loop, outer: Loop) -> None:
    """The loops as lists from their least vertex on, counter-clockwise."""
    assert s.kind == kind
    assert list(s.trajectory.vertices) == trajectory
    assert list(s.inner.vertices) == inner
    assert list(s.outer.vertices) == outer
