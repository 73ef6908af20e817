"""Bezier curves and elliptical arcs, with rational points on a decimal grid.

Parameters are integers from 0 to 2**30, which stand for the interval from 0 to 1.

(1) Between parameters at distance h, a curve C and its chord differ by at most h**2 / 8 * max |C''|
    (linear interpolation).
(2) (1 - t**2, 2 t) / (1 + t**2) is a rational point of the unit circle, at the angle 2 atan(t), so
    a float t only determines the position along the arc. With the angle as parameter, |C''| is at
    most the greatest radius. Float angles have errors below 2**-45, covered by the share of the
    tolerance for chords.
(3) A curve is stored in a canonical direction, so its reverse has the same points.
"""

from cmath import rect
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from itertools import pairwise
from math import atan2, ceil, floor, isqrt, lcm, pi, sin, tan
from typing import NamedTuple, Protocol

from exactsweep.formats.curved.affine import Affine
from exactsweep.numbers.number import Point

BITS = 30  # of a parameter
WHOLE = 1 << BITS  # the parameter at the end of a curve
_TURN_BITS = 40
_MARGIN = Fraction(1 + 2**-20)


class Curve(Protocol):
    """A curve without its endpoints."""

    def bend(self) -> Fraction:
        """Bound the length of the second derivative."""

    def min_chords(self) -> int: ...

    def points(self, parameters: Iterable[int], grid: int) -> list[Point]:
        """Return the points at the given parameters, rounded to multiples of 1 / grid."""

    def sampler(self) -> Callable[[int], complex]:
        """Return a function from parameters to float points relative to the start."""


class Bezier(NamedTuple):
    """A Bezier curve with three or more control points, and positive weights if rational."""

    controls: Sequence[Point]
    weights: Sequence[Fraction] = ()

    def bend(self) -> Fraction:
        """Bound the length of the second derivative.

        With weights, C = N / W for Bezier curves N and W, so W C' = N' - W' C and
        W C'' = N'' - 2 W' C' - W'' C. A control point as the origin keeps |C| small.
        """
        scale, points = self._lattice()
        n = len(points) - 1
        x, y = points[0]
        moved = [(p - x, q - y) for p, q in points]
        if not self.weights:
            return Fraction(n * (n - 1) * _largest(_differences(_differences(moved))), scale)
        weights = self.weights
        lifted = [(p * w, q * w) for (p, q), w in zip(moved, weights, strict=True)]
        heights = [(w, 0) for w in weights]
        first, first_w = _differences(lifted), _differences(heights)
        second, second_w = _differences(first), _differences(first_w)
        least, reach = min(weights), _largest(moved)
        speed = n * (_largest(first) + _largest(first_w) * reach) / least
        twice = n * (n - 1) * (_largest(second) + _largest(second_w) * reach)
        return (twice + 2 * n * _largest(first_w) * speed) / least / scale

    def min_chords(self) -> int:
        return 1

    def _lattice(self) -> tuple[int, list[tuple[int, int]]]:
        scale = lcm(*(number.denominator for point in self.controls for number in point))
        return scale, [(int(x * scale), int(y * scale)) for x, y in self.controls]

    def points(self, parameters: Iterable[int], grid: int) -> list[Point]:
        scale, controls = self._lattice()
        columns: list[Sequence[int]] = [*zip(*controls, strict=True)]
        if self.weights:
            common = lcm(*(w.denominator for w in self.weights))
            weights = [int(w * common) for w in self.weights]
            columns = [[v * w for v, w in zip(c, weights, strict=True)] for c in columns]
            columns.append(weights)
        degree = len(controls) - 1
        forms = [_to_power_basis(column) for column in columns]
        xs, ys = [], []
        whole = scale << (BITS * degree)
        for parameter in parameters:
            x, y, *rest = (_evaluate(form, parameter) for form in forms)
            w = rest[0] * scale if rest else whole
            xs.append((2 * x * grid + w) // (2 * w))
            ys.append((2 * y * grid + w) // (2 * w))
        return [Point(Fraction(x, grid), Fraction(y, grid)) for x, y in zip(xs, ys, strict=True)]

    def sampler(self) -> Callable[[int], complex]:
        x, y = self.controls[0]
        weights = [*map(float, self.weights)] or [1.0] * len(self.controls)
        lifted = [
            (complex(p - x, q - y) * w, w) for (p, q), w in zip(self.controls, weights, strict=True)
        ]

        def near(parameter: int) -> complex:
            t, row = parameter / WHOLE, lifted
            while len(row) > 1:
                row = [(a + t * (b - a), v + t * (w - v)) for (a, v), (b, w) in pairwise(row)]
            point, weight = row[0]
            return point / weight

        return near


class Arc(NamedTuple):
    """The image of a unit circle arc: counter-clockwise by `span` <= 2 pi radians from `first`."""

    image: Affine
    first: float
    span: float

    @property
    def radius(self) -> Fraction:
        """A bound on the greatest radius."""
        a, b, c, d = self.image[:4]
        # The map is the sum of two similarities; the factors add up in some direction.
        sums = (
            round_root_up((a + d) ** 2 + (b - c) ** 2),
            round_root_up((a - d) ** 2 + (b + c) ** 2),
        )
        return (sums[0] + sums[1]) / 2

    def bend(self) -> Fraction:
        return self.radius * Fraction(self.span) ** 2 * _MARGIN

    def min_chords(self) -> int:
        return max(1, ceil(self.span / (pi / 2) - 2**-30))

    def points(self, parameters: Iterable[int], grid: int) -> list[Point]:
        image = self.image[:6]
        scale = lcm(*(number.denominator for number in image))
        a, b, c, d, e, f = (int(number * scale) for number in image)
        xs, ys = [], []
        for parameter in parameters:
            cosine, sine, w = _find_unit_point(self.first + self.span * (parameter / WHOLE))
            x, y = a * cosine + c * sine + e * w, b * cosine + d * sine + f * w
            w *= scale
            xs.append((2 * x * grid + w) // (2 * w))
            ys.append((2 * y * grid + w) // (2 * w))
        return [Point(Fraction(x, grid), Fraction(y, grid)) for x, y in zip(xs, ys, strict=True)]

    def sampler(self) -> Callable[[int], complex]:
        a, b, c, d = map(float, self.image[:4])

        def near(parameter: int) -> complex:
            # A difference of cosines would cancel for small arcs.
            half = self.span * (parameter / WHOLE) / 2
            step = 2j * sin(half) * rect(1, self.first + half)
            return complex(a * step.real + c * step.imag, b * step.real + d * step.imag)

        return near


def _find_unit_point(angle: float) -> tuple[int, int, int]:
    """Return a point of the unit circle near an angle: two numerators and the denominator."""
    quarters = floor(angle / (pi / 2) + 0.5)
    t = round(tan((angle - quarters * (pi / 2)) / 2) * (1 << _TURN_BITS))
    one, square = 1 << 2 * _TURN_BITS, t * t
    cosine, sine = one - square, t << (_TURN_BITS + 1)
    match quarters % 4:
        case 1:
            cosine, sine = -sine, cosine
        case 2:
            cosine, sine = -cosine, -sine
        case 3:
            cosine, sine = sine, -cosine
    return cosine, sine, one + square


def find_angle(x: Fraction, y: Fraction) -> float:
    """Return the angle of a vector in [0, 2 pi)."""
    scale = max(abs(x), abs(y))
    angle = atan2(y / scale, x / scale)
    return angle + 2 * pi if angle < 0 else angle


def round_root_up(square: Fraction, scale: int = 1) -> Fraction:
    """Return the square root, rounded up by less than 1/scale plus a relative 2**-30."""
    n, d = square.as_integer_ratio()
    # sqrt(n / d) = sqrt(n d) / d; scale short arguments for more digits.
    widen = scale * (1 << max(0, 60 - (n * d).bit_length()) // 2)
    widened = n * d * widen * widen
    root = isqrt(widened)
    return Fraction(root + (root * root < widened), d * widen)


def find_arc_center(start: Point, end: Point, height: Fraction) -> Point:
    """Return the center of an arc, `height` half chords left of the chord's midpoint."""
    dx, dy = (end.x - start.x) / 2, (end.y - start.y) / 2
    return Point(start.x + dx - height * dy, start.y + dy + height * dx)


def make_round_arc(
    center: Point, start: Point, end: Point, image: Affine, *, left: bool
) -> tuple[Arc, bool]:
    """Return the image of a circular arc, or a full circle if its ends are equal."""
    if not left:
        start, end = end, start
    x, y, p, q = start.x - center.x, start.y - center.y, end.x - center.x, end.y - center.y
    span = find_angle(x * p + y * q, x * q - y * p) or 2 * pi
    (ux, uy), (vx, vy) = image.vector(x, y), image.vector(-y, x)
    return Arc(Affine(ux, uy, vx, vy, *image.point(*center)), 0.0, span), left


def make_bezier(controls: Sequence[Point], weights: Sequence[Fraction] = ()) -> tuple[Bezier, bool]:
    if [*controls] <= [*controls[::-1]]:
        return Bezier(controls, weights), True
    return Bezier(controls[::-1], weights[::-1]), False


def _to_power_basis(column: Sequence[int]) -> list[int]:
    found, row, binomial = [], [*column], 1
    degree = len(column) - 1
    for k in range(degree + 1):
        found.append(row[0] * binomial)
        row = [b - a for a, b in pairwise(row)]
        binomial = binomial * (degree - k) // (k + 1)
    return found[::-1]


def _evaluate(powers: Sequence[int], parameter: int) -> int:
    """Evaluate by Horner's rule; the result is scaled by WHOLE to the degree."""
    value, shift = powers[0], 0
    for power in powers[1:]:
        shift += BITS
        value = value * parameter + (power << shift)
    return value


def _differences(points: Sequence[tuple[Fraction | int, ...]]) -> list[tuple[Fraction | int, ...]]:
    return [(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(points)]


def _largest(vectors: Sequence[tuple[Fraction | int, ...]]) -> Fraction:
    return round_root_up(Fraction(max((x * x + y * y for x, y in vectors), default=0)))
