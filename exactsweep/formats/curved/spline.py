"""Exact conversion of B-splines to Bezier curves, by polar forms.

The polar form of a piece of degree p is symmetric in p arguments, affine in each, and equals the
curve where all are equal. Its values at (u, ..., u, v, ..., v) are the Bezier control points of the
piece from u to v (L. Ramshaw, Computer Aided Geometric Design 6, 1989).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import accumulate, groupby, pairwise
from math import dist
from typing import NamedTuple

from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.curved.curves import make_bezier
from exactsweep.formats.curved.path import Path, map_points
from exactsweep.formats.error import FormatError
from exactsweep.numbers.number import Point

MAX_DEGREE = 11  # CAD programs use no higher one
_Lifted = tuple[Fraction, ...]


class Spline(NamedTuple):
    """A B-spline: len(points) + degree + 1 knots, and positive weights or ()."""

    degree: int
    points: Sequence[Point]
    knots: Sequence[Fraction]
    weights: Sequence[Fraction] = ()

    @classmethod
    def through(cls, points: Sequence[Point]) -> Spline:
        """Return the natural cubic spline through fit points, as CAD programs draw it.

        Parametrized by chord length, its second derivatives m are 0 at the ends, and
        m[k-1] a + 2 m[k] (a + b) + m[k+1] b = 6 (d[k+1] - d[k]), for the lengths a and b of the
        chords before and after point k and the slopes d.
        """
        points = [p for p, _ in groupby(points)]
        if len(points) < 2:
            raise FormatError("neither control points nor two fit points")
        try:
            places = [(float(x), float(y)) for x, y in points]
            lengths = [dist(p, q) for p, q in pairwise(places)]
            bends = [_solve([place[i] for place in places], lengths) for i in (0, 1)]
            controls = [points[0]]
            for k, h in enumerate(lengths):
                for one, other in ((k, k + 1), (k + 1, k)):
                    inner = (
                        (2 * places[one][i] + places[other][i]) / 3
                        - h * h * (2 * m[one] + m[other]) / 18
                        for i, m in enumerate(bends)
                    )
                    controls.append(Point(*map(Fraction, inner)))
                controls.append(points[k + 1])
        except (ArithmeticError, ValueError) as error:
            raise FormatError(f"no spline through these points: {error}") from None
        ends = [Fraction(0), *accumulate(map(Fraction, lengths))]
        return cls(3, controls, [ends[0], *(u for u in ends for _ in range(3)), ends[-1]])

    def validate(self) -> None:
        size = len(self.points)
        if not 1 <= self.degree <= MAX_DEGREE:
            raise FormatError(f"the degree must be 1 to {MAX_DEGREE}, not {self.degree}")
        if size <= self.degree:
            raise FormatError(
                f"{size} control points; degree {self.degree} needs {self.degree + 1}"
            )
        if len(self.knots) != size + self.degree + 1:
            raise FormatError(f"{len(self.knots)} knots, expected {size + self.degree + 1}")
        if any(u > v for u, v in pairwise(self.knots)):
            raise FormatError("the knots are not in order")
        if self.knots[self.degree] == self.knots[size]:
            raise FormatError("all knots are equal")
        if self.weights and (len(self.weights) != size or min(self.weights) <= 0):
            raise FormatError("expected one positive weight for each control point")

    def pieces(self) -> Iterator[tuple[list[Point], list[Fraction]]]:
        weights = self.weights or [Fraction(1)] * len(self.points)
        lifted = [(x * w, y * w, w) for (x, y), w in zip(self.points, weights, strict=True)]
        for k in range(self.degree, len(self.points)):
            u, v = self.knots[k], self.knots[k + 1]
            if u == v:
                continue
            values = self._bezier(lifted, k)
            points = [Point(x / w, y / w) for x, y, w in values]
            yield points, [w for _, _, w in values] if self.weights else []

    def _bezier(self, lifted: Sequence[_Lifted], k: int) -> list[_Lifted]:
        """Return the polar form at (u, ..., u, v, ..., v) for the piece from u to v.

        First replace the knots before the piece by u, keeping the last value of each row; then
        those after it by v, keeping the first values.
        """
        p, knots = self.degree, self.knots
        u, v = knots[k], knots[k + 1]
        row, last = list(lifted[k - p : k + 1]), [lifted[k]]
        for step in range(1, p + 1):
            ends = ((knots[i], knots[i + p - step + 1]) for i in range(k - p + step, k + 1))
            row = [
                _interpolate(a, b, (u - low) / (high - low))
                for (low, high), (a, b) in zip(ends, pairwise(row), strict=True)
            ]
            last.append(row[-1])
        row, found = last[::-1], [last[-1]]
        while len(row) > 1:
            shares = [(v - u) / (knots[k + i] - u) for i in range(1, len(row))]
            row = [_interpolate(a, b, t) for (a, b), t in zip(pairwise(row), shares, strict=True)]
            found.append(row[0])
        return found

    def draw(self, image: Affine) -> Path:
        found = Path()
        for points, weights in self.pieces():
            mapped = map_points(points, image)
            if not found.points:
                found.points.append(mapped[0])
            if self.degree == 1:
                found.points += mapped[1:]
            elif any(point != mapped[0] for point in mapped):
                curve, forward = make_bezier(tuple(mapped), tuple(weights))
                found.add_curve(curve, mapped[-1], forward=forward)
        if image.error:
            found.error = image.bound_error(self.points)
        if self.degree > 1:
            # Joints of pieces, and the start of a closed spline, may be rounded.
            found.soft = {*range(0 if found.is_closed else 1, len(found.points) - 1)}
            if found.is_closed:
                found.soft.add(len(found.points) - 1)
        return found


def _solve(values: Sequence[float], lengths: Sequence[float]) -> list[float]:
    """Solve the tridiagonal system of the natural cubic spline by elimination."""
    slopes = [(q - p) / h for (p, q), h in zip(pairwise(values), lengths, strict=True)]
    rows = [(0.0, 0.0)]
    for (a, b), (d, e) in zip(pairwise(lengths), pairwise(slopes), strict=True):
        share, right = rows[-1]
        pivot = 2 * (a + b) - a * share
        rows.append((b / pivot, (6 * (e - d) - a * right) / pivot))
    found = [0.0]
    for share, right in reversed(rows):
        found.append(right - share * found[-1])
    return found[::-1]


def _interpolate(a: _Lifted, b: _Lifted, t: Fraction) -> _Lifted:
    return tuple(p + t * (q - p) for p, q in zip(a, b, strict=True))
