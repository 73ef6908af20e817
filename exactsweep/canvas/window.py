"""Conversion of exact coordinates to pixels, and to floats near 1.

Coordinates are shifted and divided as Fractions before they become floats. So coordinates around
10^30, or shapes that differ in the last of 500 digits, are drawn as accurately as small integers.
"""

from collections.abc import Iterable
from fractions import Fraction
from math import ceil, floor
from typing import NamedTuple, Self

from exactsweep.numbers.digits import find_magnitude, format_fraction
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Rational, Vertex

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

        Both axes have the same scale, unless the aspect ratio of the points exceeds 12.

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


# An axis shows unscaled coordinates if the picture's size has one of these powers of ten, and
# unshifted ones if 0 is at most this many times the picture's size away.
_PLAIN = range(-2, 4)
_NEAR = 1000
_SHOWN_DIGITS = 12
_SHOWN_DECIMALS = 5


class AxisScale(NamedTuple):
    """One axis: a coordinate v is drawn at (v - origin) / 10**exponent."""

    origin: Fraction
    exponent: int

    @property
    def unit(self) -> Fraction:
        """The length drawn as 1, a power of ten."""
        return Fraction(10) ** self.exponent

    def place(self, value: Rational) -> float:
        """Return the correctly rounded position of a coordinate; raises DrawError on overflow."""
        try:
            return float((value - self.origin) / self.unit)
        except OverflowError:
            raise DrawError("a point is too far outside the picture") from None

    def label(self, name: str) -> str:
        r"""Return the label of the axis, in mathtext.

        >>> AxisScale(Fraction(0), 30).label("x")
        '$x\\,/\\,10^{30}$'
        >>> AxisScale(Fraction(7000), 0).label("y")
        '$y - 7000$'
        """
        shifted = name
        if self.origin:
            sign, size = ("-", self.origin) if self.origin > 0 else ("+", -self.origin)
            shifted = f"{name} {sign} {_size(size)}"
        if not self.exponent:
            return f"${shifted}$"
        moved = f"({shifted})" if self.origin else shifted
        return f"${moved}\\,/\\,10^{{{self.exponent}}}$"


class Scale(NamedTuple):
    """The scale of a picture, created by `Scale.of`; `is_true` if it is the same on both axes."""

    x: AxisScale
    y: AxisScale
    is_true: bool

    @classmethod
    def of(cls, *shapes: Iterable[Vertex]) -> Self:
        """Return the scale of a picture that shows all points.

        Both axes have the same scale, unless the aspect ratio of the points exceeds 12. Coordinates
        of a few digits are unchanged.

        Raises:
            DrawError: there are no points.

        Example:
            >>> Scale.of([(0, 0), (8, 5)]).x
            AxisScale(origin=Fraction(0, 1), exponent=0)
            >>> scale = Scale.of([(0, 0), (8 * 10**30, 5 * 10**30)])
            >>> scale.x
            AxisScale(origin=Fraction(0, 1), exponent=30)
            >>> scale.place((2 * 10**30, 10**30 // 2))
            (2.0, 0.5)
        """
        points = [point for shape in shapes for point in shape]
        if not points:
            raise DrawError("there is nothing to draw")
        boxes = [
            (Fraction(min(values)), Fraction(max(values))) for values in zip(*points, strict=True)
        ]
        sizes = [high - low for low, high in boxes]
        is_true = max(sizes) <= MAX_ASPECT * min(sizes) or min(sizes) == 0
        if is_true:
            sizes = [max(sizes)] * 2
        x, y = (_axis(*box, size) for box, size in zip(boxes, sizes, strict=True))
        return cls(x, y, is_true)

    def place(self, point: Vertex) -> tuple[float, float]:
        """Return the position of a point as floats."""
        x, y = point
        return self.x.place(x), self.y.place(y)

    def places(self, points: Iterable[Vertex]) -> list[tuple[float, float]]:
        """Return the positions of points."""
        return [self.place(point) for point in points]


def _axis(low: Fraction, high: Fraction, size: Fraction) -> AxisScale:
    if not size:
        size = max(abs(high), Fraction(1))
    exponent = find_magnitude(size)
    origin = Fraction(0)
    if max(abs(low), abs(high)) > _NEAR * size:
        origin = _round_number(low, high, Fraction(10) ** exponent)
    return AxisScale(origin, 0 if exponent in _PLAIN else exponent - exponent % 3)


def _round_number(low: Fraction, high: Fraction, step: Fraction) -> Fraction:
    """Return the roundest number from `low` to `high`, or else the multiple of `step` below."""
    # 0 is not between `low` and `high`, so the loop ends.
    found = floor(low / step) * step
    while (rounder := ceil(low / step) * step) <= high:
        found = rounder
        step *= 10
    return found


def _size(value: Fraction) -> str:
    """Abbreviate a positive number for mathtext; dots replace missing digits."""
    text = format_fraction(value)
    if len(text) <= _SHOWN_DIGITS:
        return text
    exponent = find_magnitude(value)
    shown = value / Fraction(10) ** (exponent - _SHOWN_DECIMALS)
    digits = str(floor(shown)).rstrip("0")
    mantissa = f"{digits[0]}.{digits[1:]}".rstrip(".")
    if floor(shown) != shown:
        mantissa += "\\ldots"
    elif mantissa == "1":
        return f"10^{{{exponent}}}"
    return f"{mantissa} \\cdot 10^{{{exponent}}}"
