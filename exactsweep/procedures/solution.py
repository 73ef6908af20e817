"""Common parts of solutions: the classes of pairs, results computed once, positions placed."""

from __future__ import annotations

import gc
from collections.abc import Iterable, Sequence
from functools import cached_property
from typing import Any, Literal, Self, TypeVar, overload

from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import ORIGIN, Fit, Point

Kind = Literal["CC", "CM", "MM", "SS"]
"""The classes of the paper, and "SS" for polygons of any shape."""


T_co = TypeVar("T_co", covariant=True)


class made_once(cached_property[T_co]):  # noqa: N801
    """`functools.cached_property` without the lock that it takes before Python 3.12.

    The lock costs 1 µs each time, which is a fifteenth of a small trajectory. Threads that read one
    answer at once may compute a value twice. Both values are equal, and no code depends on which of
    them is kept.
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
    kernel makes no cycles. The outer loop of Figure 10 for (64, 64), of 15,900 vertices, takes 94
    ms without the pause, and 45 ms with it.
    """

    def __enter__(self) -> None:
        self.runs = gc.isenabled()
        gc.disable()

    def __exit__(self, *error: object) -> None:
        if self.runs:
            gc.enable()


def place_loop(loop: Sequence[Point], reference: Point = ORIGIN) -> Polygon:
    """Convert a canonical loop of positions of G's origin to a Polygon for a reference point."""
    return Polygon._trust(_move(loop, reference))


def place_fits(fits: Iterable[Fit], reference: Point) -> tuple[Fit, ...]:
    """Convert exact fits from positions of G's origin to positions of a reference point."""
    return tuple((p, q) for p, q in (_move(fit, reference) for fit in fits))


def _move(points: Sequence[Point], by: Point) -> Sequence[Point]:
    if by == ORIGIN:
        return points
    dx, dy = by
    return [Point(x + dx, y + dy) for x, y in points]
