"""Series of measurements over doubling sizes, and how they grow."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import log


@dataclass(frozen=True)
class Point:
    """One size: counted operations, size of the output, the claimed bound, time."""

    m: int
    n: int
    operations: int
    output: int
    bound: float
    milliseconds: float | None = None

    @property
    def ratio(self) -> float:
        """Operations a unit of the bound."""
        return self.operations / self.bound


@dataclass(frozen=True)
class Series:
    """One procedure on one family, one size of the pair or both being doubled."""

    procedure: str
    family: str
    varied: str
    bound: str
    points: list[Point] = field(default_factory=list)

    @property
    def sizes(self) -> list[int]:
        """The size that is doubled."""
        return [point.m if "m" in self.varied else point.n for point in self.points]

    @property
    def claimed(self) -> float:
        """The exponent of the bound over these sizes, logarithms included."""
        return exponent(self.sizes, [point.bound for point in self.points])

    @property
    def counted(self) -> float:
        """The exponent of the operations."""
        return exponent(self.sizes, [point.operations for point in self.points])

    @property
    def grown(self) -> float:
        """The exponent of the output."""
        return exponent(self.sizes, [point.output for point in self.points])

    @property
    def timed(self) -> float | None:
        """The exponent of the time; None where it was not measured."""
        times = [p.milliseconds for p in self.points if p.milliseconds is not None]
        return exponent(self.sizes, times) if len(times) == len(self.points) else None

    @property
    def last_growth(self) -> float:
        """Operations over bound at the largest size, divided by the same two doublings before."""
        return self.points[-1].ratio / self.points[-3].ratio


def exponent(sizes: Sequence[int], values: Sequence[float]) -> float:
    """The slope of the least squares line through the logarithms; nan if a value is zero.

    >>> round(exponent([2, 4, 8], [3, 12, 48]), 9)
    2.0
    """
    if min(values) <= 0:
        return float("nan")
    xs, ys = [log(size) for size in sizes], [log(value) for value in values]
    x_mean, y_mean = sum(xs) / len(xs), sum(ys) / len(ys)
    covariance = sum((x - x_mean) * (y - y_mean) for x, y in zip(xs, ys, strict=True))
    return covariance / sum((x - x_mean) ** 2 for x in xs)
