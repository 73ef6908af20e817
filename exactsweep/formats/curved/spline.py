"""B-splines as Bezier curves, exactly: each control point is a value of the polar form.

The polar form (blossom) of a polynomial piece of degree p is symmetric in p arguments, affine in
each, and gives the curve where all are equal. The Bezier points of the piece from u to v are its
values at (u, ..., u, v, ..., v), and de Boor's recursion finds it with another argument in each
step (L. Ramshaw, "Blossoms are polar forms", Computer Aided Geometric Design 6, 1989).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.curved.curves import flatten_bezier
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.numbers.point import Point

MAX_DEGREE = 15

_Lifted = tuple[Fraction, ...]


class Spline(NamedTuple):
    """A B-spline.

    Attributes:
        degree: of its pieces.
        points: the control points.
        knots: in order, as many as there are points, and degree + 1 more.
        weights: one for each point, all positive; () for 1.
    """

    degree: int
    points: Sequence[Point]
    knots: Sequence[Fraction]
    weights: Sequence[Fraction] = ()

    def require_sound(self) -> None:
        """Refuse what is no spline."""
        size = len(self.points)
        if not 1 <= self.degree <= MAX_DEGREE:
            raise FormatError(f"the degree is {self.degree}, not 1 to {MAX_DEGREE}")
        if size <= self.degree:
            raise FormatError(f"{size} control points of degree {self.degree}")
        if len(self.knots) != size + self.degree + 1:
            raise FormatError(f"{len(self.knots)} knots, not {size + self.degree + 1}")
        if any(u > v for u, v in pairwise(self.knots)):
            raise FormatError("the knots are not in order")
        if self.knots[self.degree] == self.knots[size]:
            raise FormatError("all knots are equal")
        if self.weights and (len(self.weights) != size or min(self.weights) <= 0):
            raise FormatError("the weights are not one for each control point, all positive")

    def pieces(self) -> Iterator[tuple[list[Point], list[Fraction]]]:
        """Yield the Bezier curves that it consists of: control points, and weights if it has any.

        Cost: O(p**3) for each piece of degree p.

        Example:
            >>> a, b, c, d = (Point(Fraction(x), Fraction(y)) for x, y in
            ...     [(0, 0), (2, 2), (4, 2), (6, 0)])
            >>> knots = [Fraction(u) for u in (0, 0, 0, 1, 2, 2, 2)]
            >>> for points, _ in Spline(2, [a, b, c, d], knots).pieces():
            ...     print(*(f"{x},{y}" for x, y in points))
            0,0 2,2 3,2
            3,2 4,2 6,0
        """
        weights = self.weights or [Fraction(1)] * len(self.points)
        lifted = [(x * w, y * w, w) for (x, y), w in zip(self.points, weights, strict=True)]
        for k in range(self.degree, len(self.points)):
            u, v = self.knots[k], self.knots[k + 1]
            if u == v:
                continue
            values = [
                self._polar(lifted, k, [u] * (self.degree - j) + [v] * j)
                for j in range(self.degree + 1)
            ]
            points = [Point(x / w, y / w) for x, y, w in values]
            yield points, [w for _, _, w in values] if self.weights else []

    def _polar(self, lifted: Sequence[_Lifted], k: int, arguments: Sequence[Fraction]) -> _Lifted:
        """The polar form of the piece from knot k to the next."""
        p, knots = self.degree, self.knots
        row = list(lifted[k - p : k + 1])
        for step, t in enumerate(arguments, 1):
            # Entry i of the row lies between knot k - p + step + i and the one these are off.
            off = p - step + 1
            starts = range(k - p + step, k + 1)
            row = [
                _mix(a, b, (t - knots[i]) / (knots[i + off] - knots[i]))
                for i, (a, b) in zip(starts, pairwise(row), strict=True)
            ]
        return row[0]

    def flatten(self, image: Affine, reading: Reading) -> list[Point]:
        """Turn the image of the spline into lines, as `flatten_bezier` does each piece."""
        found: list[Point] = []
        for points, weights in self.pieces():
            if self.degree == 1:
                found += [image.point(*point) for point in points]
            else:
                found += flatten_bezier(points, image, reading, weights)
        return [a for a, b in pairwise(found) if a != b] + found[-1:]


def _mix(a: _Lifted, b: _Lifted, t: Fraction) -> _Lifted:
    return tuple(p + t * (q - p) for p, q in zip(a, b, strict=True))
