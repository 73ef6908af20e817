"""A rectangle of the plane, and the conversion of exact coordinates to pixels."""

from collections.abc import Iterable
from fractions import Fraction
from typing import NamedTuple, Self

from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Vertex

MAX_ASPECT = 12
"""The aspect ratio above which the axes have different units."""
# Pixels are clamped to this distance from 0.
_FAR = 100_000


class DrawError(ExactSweepError):
    """A picture that cannot be drawn or saved."""


class Window(NamedTuple):
    """A rectangle of the plane, drawn as `width` by `height` pixels, from the top down."""

    left: Fraction
    bottom: Fraction
    right: Fraction
    top: Fraction
    width: int
    height: int

    @classmethod
    def around(cls, points: Iterable[Vertex], width: int, height: int, margin: int = 0) -> Self:
        """Return the smallest window that shows all points with a margin in pixels.

        Both axes have the same unit, unless the aspect ratio of the points exceeds 12.

        >>> window = Window.around([(0, 0), (10, 5)], 120, 120, 10)
        >>> window.place((0, 0)), window.place((10, 5))
        ((10.0, 85.0), (110.0, 35.0))
        """
        xs, ys = [], []
        for x, y in points:
            xs.append(x)
            ys.append(y)
        if not xs:
            raise DrawError("there is nothing to draw")
        across, up = Fraction(max(xs) - min(xs)), Fraction(max(ys) - min(ys))
        if 0 < MAX_ASPECT * min(across, up) < max(across, up):
            x_unit, y_unit = across / (width - 2 * margin), up / (height - 2 * margin)
        else:
            x_unit = y_unit = max(
                across / (width - 2 * margin), up / (height - 2 * margin)
            ) or Fraction(1)
        x, y = (Fraction(max(values) + min(values)) / 2 for values in (xs, ys))
        half_x, half_y = width * x_unit / 2, height * y_unit / 2
        return cls(x - half_x, y - half_y, x + half_x, y + half_y, width, height)

    def flipped(self) -> Self:
        return self._replace(bottom=self.top, top=self.bottom)

    @property
    def is_true(self) -> bool:
        return (self.right - self.left) * self.height == (self.top - self.bottom) * self.width

    @property
    def longest(self) -> Fraction:
        return max(self.right - self.left, self.top - self.bottom)

    def place(self, point: Vertex) -> tuple[float, float]:
        x, y = point
        return (
            _limit((x - self.left) * self.width / (self.right - self.left)),
            _limit((self.top - y) * self.height / (self.top - self.bottom)),
        )


def _limit(pixel: Fraction) -> float:
    return float(max(Fraction(-_FAR), min(Fraction(_FAR), pixel)))
