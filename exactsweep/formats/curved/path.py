"""Paths of lines and curves, and their flattening.

Chords between rational points use less than half of the tolerance, by (1) of `curves`, rounding
less than a fifth, and moved ends a quarter. So a path and its chords differ by less than the
tolerance at each parameter.

If two curves leave a vertex in nearly the same direction, their chords might cross although the
curves do not. So both get vertices at equal distances from there, until they are far apart:
segments from one point cross only if their order around it changes. If chords of a closed path
still cross, finer tolerances are tried.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Sequence
from fractions import Fraction
from math import pi
from typing import TypeVar

from exactsweep.formats.curved.affine import IDENTITY, Affine
from exactsweep.formats.curved.curves import WHOLE, Arc, Curve, round_root_up
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.number import Point

_Found = TypeVar("_Found")
_CHORDS = Fraction(12, 25)
_LEVELS = 3
_APART = 8  # tolerances; curves are also far apart at more than 60 degrees
_SAMPLES = 8
_BISECTIONS = 32
# Divisors of the size of a path for the default tolerance, with and without curves.
CURVED, _STRAIGHT = 1000, 10**9


class _End:
    """A curve, parametrized from one of its ends."""

    def __init__(self, curve: Curve, *, at_start: bool) -> None:
        self.at_start, self._near = at_start, curve.sampler()
        self._whole = 0j if at_start else self._near(WHOLE)

    def near(self, parameter: int) -> complex:
        return self._near(parameter if self.at_start else WHOLE - parameter) - self._whole


class SimpleLines(list[Point]):
    """The vertices of a closed polyline, and its Polygon if simple."""

    def __init__(self, points: Iterable[Point], polygon: Polygon | None) -> None:
        super().__init__(points)
        self.polygon = polygon


class Path:
    """Points, with lines or curves between them; a closed path repeats its first point."""

    __slots__ = ("_lines", "curves", "error", "gap", "points", "soft")

    def __init__(
        self,
        points: Iterable[Point] = (),
        curves: dict[int, tuple[Curve, bool]] | None = None,
        error: Fraction = Fraction(0),
    ) -> None:
        self.points = [*points]
        self.error = error  # of points and curves
        self.gap = Fraction(0)  # the distance by which ends were moved to other lines
        self.curves = {} if curves is None else curves  # curve and direction by start index
        self.soft: set[int] = set()  # points that may be rounded, such as spline joints
        self._lines: tuple[Fraction, list[Point]] | None = None

    def add_curve(self, curve: Curve, end: Point, *, forward: bool) -> None:
        self.curves[len(self.points) - 1] = curve, forward
        self.points.append(end)

    def add(self, other: Path) -> None:
        shift = len(self.points) - 1
        self.points += other.points[1:]
        self.curves |= {k + shift: drawn for k, drawn in other.curves.items()}
        self.soft |= {k + shift for k in other.soft if k}
        self.error, self.gap = max(self.error, other.error), max(self.gap, other.gap)

    def reversed(self) -> Path:
        last = len(self.points) - 2
        curves = {last - k: (curve, not way) for k, (curve, way) in self.curves.items()}
        found = Path(self.points[::-1], curves, self.error)
        found.soft = {last + 1 - k for k in self.soft}
        return found

    def moved(self, start: Point, end: Point) -> Path:
        found = Path([start, *self.points[1:-1], end], self.curves.copy(), self.error)
        found.soft = self.soft - {0, len(self.points) - 1}
        if not self.is_exact:
            ends = (self.points[0], start), (self.points[-1], end)
            found.gap = max(abs(q.x - p.x) + abs(q.y - p.y) for p, q in ends)
        return found

    def closed(self) -> Path:
        found = self.moved(self.points[0], self.points[-1])
        if not self.is_closed:
            found.points.append(found.points[0])
        return found

    @property
    def key(self) -> Hashable:
        """A key of the path in either direction; () for a straight line."""
        if len(self.points) == 2 and not self.curves:
            return ()
        curves = frozenset(curve for curve, _ in self.curves.values())
        return frozenset((tuple(self.points), tuple(self.points[::-1]))), curves

    @property
    def is_closed(self) -> bool:
        return self.points[0] == self.points[-1]

    @property
    def is_exact(self) -> bool:
        return not self.curves and not self.error

    @property
    def size(self) -> Fraction:
        """The approximate length of the longer side of the bounding box."""
        xs, ys = [x for x, _ in self.points], [y for _, y in self.points]
        for k, (curve, forward) in self.curves.items():
            x, y = self.points[k if forward else k + 1]
            near = curve.sampler()
            for i in range(1, _SAMPLES):
                point = near(WHOLE * i // _SAMPLES)
                xs.append(x + Fraction(point.real))
                ys.append(y + Fraction(point.imag))
        return max(max(xs) - min(xs), max(ys) - min(ys))

    def find_tolerance(self, reading: Reading) -> Fraction:
        if self.is_exact:
            return Fraction(0)
        if reading.tolerance is not None:
            return reading.tolerance
        return default_tolerance(self.size, CURVED if self.curves else _STRAIGHT)

    def find_error(self, reading: Reading) -> Fraction:
        tolerance = self.find_tolerance(reading)
        return tolerance + (self.gap if 4 * self.gap > tolerance else 0)

    def flatten(self, reading: Reading, finer: int = 0) -> list[Point]:
        """Replace curves by chords, refined if a closed path would cross itself."""
        if self.is_exact:
            return self.points
        tolerance = self.find_tolerance(reading) / 10**finer
        if self._lines and self._lines[0] == tolerance:
            return self._lines[1]
        found = self.draw(tolerance, reading, fine=finer > 0)
        if not finer:
            if self.is_closed and self.curves:
                rings, polygon = flatten_together(
                    [self], reading, lambda rings: Polygon(rings[0]), found
                )
                found = SimpleLines(rings[0], polygon)
            self._lines = tolerance, found
        return found

    def draw(self, tolerance: Fraction, reading: Reading, *, fine: bool = False) -> list[Point]:
        grid = find_grid(tolerance / (1000 if fine else 1))
        parameters = {
            k: _divide(curve, tolerance, reading) for k, (curve, _) in self.curves.items()
        }
        if self.error * 16 > tolerance:
            raise FormatError(
                "numbers too large for an irrational rotation; try a larger --flatten"
            )
        for before in self.curves:
            after = (before + 1) % (len(self.points) - 1) if self.is_closed else before + 1
            if after in self.curves and after != before:
                self._separate(before, after, parameters, tolerance)
        points = self.points
        if self.error or self.soft:
            rounded = round_points(points, grid)
            points = [
                new if self.error or k in self.soft else old
                for k, (old, new) in enumerate(zip(points, rounded, strict=True))
            ]
        if self.is_closed:
            points = [*points[:-1], points[0]]
        found: list[Point] = []
        for k, point in enumerate(points):
            found.append(point)
            if k in self.curves:
                curve, forward = self.curves[k]
                inner = curve.points(sorted({*parameters[k]}), grid)
                found += inner if forward else inner[::-1]
        return found

    def _separate(
        self, before: int, after: int, parameters: dict[int, list[int]], tolerance: Fraction
    ) -> None:
        """Add vertices to consecutive curves at equal distances from their common point."""
        (one, one_way), (other, other_way) = self.curves[before], self.curves[after]
        try:
            ends = _End(one, at_start=not one_way), _End(other, at_start=other_way)
            firsts = [
                end.near(min(row) if end.at_start else WHOLE - max(row))
                for end, k in zip(ends, (before, after), strict=True)
                for row in [parameters[k] or [WHOLE // 2]]
            ]
            if abs(firsts[0] - firsts[1]) > max(map(abs, firsts)):
                return
            rows: list[list[tuple[float, int]]] = [
                _list_distances(end, parameters[k])
                for end, k in zip(ends, (before, after), strict=True)
            ]
            reach: float = min(row[-1][0] for row in rows)
            new: tuple[list[int], list[int]] = ([], [])
            distances: set[float] = {d for row in rows for d, _ in row}
            for distance in sorted(distances):
                if distance > reach:
                    break
                found = [
                    _find_parameter(e, row, distance) for e, row in zip(ends, rows, strict=True)
                ]
                p, q = (end.near(parameter) for end, parameter in zip(ends, found, strict=True))
                if abs(p - q) > min(_APART * float(tolerance), distance):
                    break
                for row, parameter in zip(new, found, strict=True):
                    row.append(parameter)
        except (OverflowError, ZeroDivisionError):
            return
        for k, end, row in zip((before, after), ends, new, strict=True):
            parameters[k] += [p if end.at_start else WHOLE - p for p in row if 0 < p < WHOLE]


def _divide(curve: Curve, tolerance: Fraction, reading: Reading) -> list[int]:
    """Return the parameters of vertices, so that chords use only their share of the tolerance."""
    bend = curve.bend() / (8 * _CHORDS * tolerance)
    count = max(curve.min_chords(), -(-round_root_up(bend) // 1))
    reading.charge_chords(count)
    return [WHOLE * k // count for k in range(1, count)]


def _list_distances(end: _End, parameters: Sequence[int]) -> list[tuple[float, int]]:
    """List pairs (distance from the end, parameter) while the distance grows."""
    row: list[tuple[float, int]] = [(0.0, 0)]
    ordered = sorted(parameters) if end.at_start else [WHOLE - p for p in sorted(parameters)[::-1]]
    for parameter in [*ordered, WHOLE]:
        distance = abs(end.near(parameter))
        if distance <= row[-1][0]:
            break
        row.append((distance, parameter))
    return row


def _find_parameter(end: _End, row: Sequence[tuple[float, int]], distance: float) -> int:
    low = high = 0
    for known, parameter in row:
        if known == distance:
            return parameter
        low, high = (parameter, high) if known < distance else (low, parameter)
        if known > distance:
            break
    for _ in range(_BISECTIONS):
        middle = (low + high) // 2
        low, high = (middle, high) if abs(end.near(middle)) < distance else (low, middle)
    return low


def flatten_together(
    paths: Sequence[Path],
    reading: Reading,
    use: Callable[[list[list[Point]]], _Found],
    *first: list[Point],
) -> tuple[list[list[Point]], _Found | None]:
    """Flatten paths, more finely while `use` raises PolygonError.

    Return the rings and the result of `use`; if it always fails, the coarsest rings and None.
    """
    last = ""
    found = rings = [*first] or [path.flatten(reading) for path in paths]
    for finer in range(1, _LEVELS + 2):
        try:
            return rings, use(rings)
        except PolygonError as error:
            # The same error at a finer tolerance: the curves themselves cross.
            if finer > _LEVELS or str(error) == last or not any(path.curves for path in paths):
                break
            last = str(error)
        try:
            rings = [path.flatten(reading, finer) for path in paths]
        except FormatError:
            break
    return found, None


def default_tolerance(size: Fraction, share: int) -> Fraction:
    """Return the greatest power of ten that is at most size / share, or 1 for size 0."""
    found, least = Fraction(1), size / share
    if not size:
        return found
    while found > least:
        found /= 10
    while found * 10 <= least:
        found *= 10
    return found


def find_grid(tolerance: Fraction) -> int:
    """Return the grid lines per unit, a power of ten, to round within a fifth of a tolerance."""
    grid = 1
    while tolerance * grid < 4:
        grid *= 10
    return grid


def round_points(points: Iterable[Point], grid: int) -> list[Point]:
    return [
        Point(Fraction(round(x * grid), grid), Fraction(round(y * grid), grid)) for x, y in points
    ]


def map_points(points: Sequence[Point], image: Affine) -> list[Point]:
    return [*points] if image is IDENTITY else [image.point(*point) for point in points]


def draw_lines(points: Sequence[Point], image: Affine) -> Path:
    return Path(
        map_points(points, image), error=image.bound_error(points) if image.error else Fraction(0)
    )


def draw_circle(image: Affine) -> Path:
    one, zero = Fraction(1), Fraction(0)
    start = image.point(one, zero)
    arc = Arc(image._replace(error=zero), 0.0, 2 * pi)
    return Path([start, start], {0: (arc, True)}, image.bound_error([Point(one, one)]))
