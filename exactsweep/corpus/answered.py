"""A pair of polygons with the exact answers."""

from collections.abc import Collection, Iterator
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import chain
from math import lcm
from typing import Literal, get_args

from exactsweep.geometry.frame import Kind
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.number import Fit, Loop, Point
from exactsweep.sweep import Sweep, sweep

INTEGER_BITS = {"int32": 32, "int64": 64}
NUMBER_TYPES = (*INTEGER_BITS, "binary64")
Shapes = Literal["convex", "monotone", "simple", "any"]
# Each kind of pairs includes those before it; "simple" means without holes.
SHAPES: tuple[Shapes, ...] = get_args(Shapes)
_SHAPES_OF: dict[Kind, Shapes] = {
    "CC": "convex",
    "CM": "monotone",
    "MM": "monotone",
    "SS": "simple",
}


def find_types(values: Collection[Fraction], scale: int) -> frozenset[str]:
    """List the number types that represent numbers exactly, integers after scaling.

    >>> sorted(find_types([Fraction(1, 3)], 3)), sorted(find_types([Fraction(1, 3)], 2))
    (['int32', 'int64'], [])
    >>> sorted(find_types([Fraction(2**31)], 1))
    ['binary64', 'int64']
    """
    held = set()
    if all(scale % value.denominator == 0 for value in values):
        scaled = [value.numerator * (scale // value.denominator) for value in values]
        low, high = min(scaled, default=0), max(scaled, default=0)
        held = {
            name
            for name, bits in INTEGER_BITS.items()
            if is_in_range(low, bits) and is_in_range(high, bits)
        }
    if all(map(_is_binary64, values)):
        held.add("binary64")
    return frozenset(held)


def is_in_range(value: Fraction | int, bits: int) -> bool:
    """Decide whether a number is in the range of signed integers with this number of bits."""
    return -(1 << bits - 1) <= value <= (1 << bits - 1) - 1


def _is_binary64(value: Fraction) -> bool:
    if value.denominator == 1 and abs(value.numerator) <= 2**53:
        return True
    # Division of ints rounds correctly.
    try:
        return Fraction(value.numerator / value.denominator) == value
    except OverflowError:
        return False


@dataclass(frozen=True, kw_only=True)
class AnsweredPair:
    directrix_ring: Loop  # the exterior of D in its input form
    generatrix_ring: Loop  # the exterior of G in its input form
    reference: Point  # the point of G whose path is the trajectory
    kind: Kind
    trajectory: Polygon
    inner: Polygon
    outer: Polygon
    exact_fits: tuple[Fit, ...]  # as in `Sweep.exact_fits`
    area: Fraction  # the swept area
    directrix_holes: tuple[Loop, ...] = ()
    generatrix_holes: tuple[Loop, ...] = ()
    holes: tuple[Polygon, ...] = ()  # of the no-fit polygon, whose exterior is the trajectory
    unswept: tuple[Polygon, ...] = ()  # additional holes of the swept area
    inner_regions: tuple[Region, ...] | None = None  # of G inside D, for SS and containers
    inner_exact_fits: tuple[Fit, ...] = ()

    @property
    def directrix_rings(self) -> tuple[Loop, ...]:
        return (self.directrix_ring, *self.directrix_holes)

    @property
    def generatrix_rings(self) -> tuple[Loop, ...]:
        return (self.generatrix_ring, *self.generatrix_holes)

    @cached_property
    def directrix(self) -> AnyPolygon:
        return make_shape(self.directrix_rings)

    @cached_property
    def generatrix(self) -> AnyPolygon:
        return make_shape(self.generatrix_rings)

    def sweep(self) -> Sweep:
        return sweep(self.generatrix, self.directrix, reference=self.reference)

    @property
    def shapes(self) -> Shapes:
        """The first of SHAPES that includes the pair."""
        if self.directrix_holes or self.generatrix_holes:
            return "any"
        return _SHAPES_OF[self.kind]

    @property
    def size(self) -> int:
        return sum(map(len, (*self.directrix_rings, *self.generatrix_rings)))

    @cached_property
    def integer_scale(self) -> int:
        """The least scale at which D, G and the reference point are integers."""
        return lcm(*(c.denominator for c in self.list_input()))

    @cached_property
    def representable(self) -> frozenset[str]:
        """The number types that represent the input exactly, integers at `integer_scale`."""
        return find_types(list(self.list_input()), self.integer_scale)

    @cached_property
    def answer_representable(self) -> frozenset[str]:
        return find_types(list(self.list_answer()), self.integer_scale)

    def list_input(self) -> Iterator[Fraction]:
        rings = *self.directrix_rings, *self.generatrix_rings, (self.reference,)
        return chain(*chain(*rings))

    def list_answer(self) -> Iterator[Fraction]:
        loops = (self.trajectory, self.inner, self.outer, *self.holes, *self.unswept)
        rings = [shape.vertices for shape in (*loops, *(self.inner_regions or ()))]
        return chain(*chain(*rings, *self.exact_fits, *self.inner_exact_fits))


def make_shape(rings: tuple[Loop, ...]) -> AnyPolygon:
    exterior, *holes = rings
    return Region(exterior, holes) if holes else Polygon(exterior)
