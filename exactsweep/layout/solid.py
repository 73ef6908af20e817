"""Solids: placed parts, the outside of the container and the defects, in ints on a lattice.

(1) The outside of the container, within a frame around everything, and each defect are also solids
    that no part may overlap. So the judge needs only one test, for two solids.
(2) All solids share a lattice if its scale has at most 1024 bits. With many unrelated rotations,
    the scale would be longer than the numbers themselves; then each pair has its own lattice.
(3) If a rotation has error e on the unit circle, the solid has error at most e r, where r is the
    maximum distance of the part's points from its origin. This is the *slack* of the solid, a bound
    on the Hausdorff distance from the true boundary. Certificates use bounds without roots: 3/2 e,
    which exceeds 2^(1/2) e, and |x| + |y| for r. At 256 bits or fewer, the excess is more than
    10^-79, so it also covers the error of degrees converted from radians, at most 10^-100.
(4) The error of flattened curves adds to the slack; more precise rotations do not lower it.
"""

from abc import abstractmethod
from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import chain
from math import isqrt, lcm
from typing import NamedTuple, Self

from exactsweep.geometry.convex import ConvexRing, IntRing, IntVertex, cut_to_convex
from exactsweep.geometry.edges import EdgeIndex
from exactsweep.geometry.overlap import Relation, relate
from exactsweep.geometry.region import Region
from exactsweep.geometry.vectors import find_hull
from exactsweep.layout.rounded import BodyShape, RoundedPiece
from exactsweep.numbers.number import Point

LatticeBox = tuple[int, int, int, int]  # the left, right, low and high ends
MatrixRows = tuple[int, int, int, int]  # the rows of a linear map
LatticePiece = tuple[ConvexRing, int]  # a hull, which may be a point or a segment, and its radius


class _Scalable:
    """Base class of shapes on a lattice; it caches their images on finer lattices."""

    @cached_property
    def _scaled(self) -> dict[int, Self]:
        return {1: self}

    @abstractmethod
    def mapped(self, matrix: MatrixRows) -> Self: ...

    def scaled(self, factor: int) -> Self:
        found = self._scaled.get(factor)
        if found is None:
            found = self._scaled[factor] = self.mapped((factor, 0, 0, factor))
        return found


class LatticeForm(_Scalable, EdgeIndex):
    """A shape on a lattice, shared by its solids; `cut` returns the convex pieces."""

    rings: Sequence[IntRing]  # the exterior first, with the interior on the left
    is_rounded = False

    def __init__(
        self, rings: Sequence[IntRing], cut: Callable[[], list[ConvexRing]] | None = None
    ) -> None:
        super().__init__(rings)
        self._cut = cut or (lambda: cut_to_convex(rings))

    def mapped(self, matrix: MatrixRows) -> Self:
        return type(self)(
            [_map(ring, matrix) for ring in self.rings],
            lambda: [_map(piece, matrix) for piece in self.pieces],
        )

    @cached_property
    def hull(self) -> list[IntVertex]:
        return find_hull(self.rings[0])

    @cached_property
    def pieces(self) -> list[ConvexRing]:
        return self._cut()

    @property
    def rounded(self) -> list[LatticePiece]:
        return [(piece, 0) for piece in self.pieces]


class RoundedForm(_Scalable):
    """Rounded pieces on a lattice, shared by their solids: counter-clockwise hulls with radii."""

    is_rounded = True

    def __init__(self, rounded: Sequence[LatticePiece]) -> None:
        self.rounded = [*rounded]

    def mapped(self, matrix: MatrixRows) -> Self:
        """Return the image under a similarity with a rational factor."""
        a, b, c, d = matrix
        by = isqrt(abs(a * d - b * c))
        return type(self)([(_map(hull, matrix), by * radius) for hull, radius in self.rounded])

    @cached_property
    def box(self) -> LatticeBox:
        boxes = [
            (min(xs) - radius, max(xs) + radius, min(ys) - radius, max(ys) + radius)
            for hull, radius in self.rounded
            for xs, ys in [[*zip(*hull, strict=True)]]
        ]
        lefts, rights, lows, highs = zip(*boxes, strict=True)
        return min(lefts), max(rights), min(lows), max(highs)

    @property
    def pieces(self) -> list[ConvexRing]:
        return [hull for hull, _ in self.rounded]


class OutsideForm(RoundedForm):
    """The outside of a rounded container, represented by the piece inside."""


class Solid(NamedTuple):
    """A shape on a lattice, translated by (x, y)."""

    form: LatticeForm | RoundedForm
    x: int
    y: int
    scale: int  # of the lattice
    slack: Fraction  # a bound on the error of each point, by (3) and (4)
    error: Fraction = Fraction(0)  # the part of the slack due to flattened curves

    @property
    def box(self) -> LatticeBox:
        left, right, low, high = self.form.box
        x, y = self.x, self.y
        return left + x, right + x, low + y, high + y  # type: ignore[return-value]

    def on(self, scale: int) -> Self:
        factor = scale // self.scale
        if factor == 1:
            return self
        form, x, y = self.form.scaled(factor), self.x * factor, self.y * factor
        return self._replace(form=form, x=x, y=y, scale=scale)

    @property
    def pieces(self) -> list[ConvexRing]:
        x, y = self.x, self.y
        return [[(px + x, py + y) for px, py in piece] for piece in self.form.pieces]

    @property
    def rounded(self) -> list[LatticePiece]:
        x, y = self.x, self.y
        return [([(px + x, py + y) for px, py in hull], r) for hull, r in self.form.rounded]

    def to_point(self, x: int | Fraction, y: int | Fraction) -> Point:
        """Convert lattice coordinates, which may be fractions, to a point of the plane."""
        return Point(Fraction(x) / self.scale, Fraction(y) / self.scale)


def _map(ring: IntRing, matrix: MatrixRows) -> list[IntVertex]:
    """Map a ring, and keep the interior on the left."""
    a, b, c, d = matrix
    image = [(a * x + b * y, c * x + d * y) for x, y in ring]
    return image if a * d > b * c else image[::-1]


def make_form(shape: BodyShape) -> tuple[int, LatticeForm | RoundedForm]:
    if isinstance(shape, Region):
        scale, rings = shape.lattice()
        return scale, LatticeForm(rings)  # type: ignore[arg-type]
    return make_rounded_form(shape, RoundedForm)


def make_rounded_form(
    pieces: Sequence[RoundedPiece], kind: type[RoundedForm]
) -> tuple[int, RoundedForm]:
    scale = lcm(*(piece.denominator for piece in pieces))
    rounded = [
        (
            [(int(p.x * scale), int(p.y * scale)) for p in piece.points],
            int(piece.radius * scale),
        )
        for piece in pieces
    ]
    return scale, kind(rounded)


def scale_to_int(value: Fraction, scale: int) -> int:
    n, d = value.as_integer_ratio()
    whole, rest = divmod(scale, d)
    # A number off the lattice remains a Fraction.
    return n * whole if rest == 0 else value * scale  # type: ignore[return-value]


def measure_slack(shape: BodyShape, error: Fraction) -> Fraction:
    """Bound the error of a shape by (3), given the error of its rotation."""
    points: Iterable[Point] = (
        shape.exterior.vertices
        if isinstance(shape, Region)
        else chain.from_iterable(piece.points for piece in shape)
    )
    return max(abs(x) + abs(y) for x, y in points) * error * 3 / 2


def share_scale(a: Solid, b: Solid) -> tuple[Solid, Solid]:
    if a.scale == b.scale:
        return a, b
    scale = lcm(a.scale, b.scale)
    return a.on(scale), b.on(scale)


def meet(a: Solid, b: Solid) -> Relation:
    assert isinstance(a.form, LatticeForm)
    assert isinstance(b.form, LatticeForm)
    return relate(a.form, b.form, b.x - a.x, b.y - a.y)
