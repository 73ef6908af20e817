"""Conversion to the frame of a pair and back; lattice points become pairs of ints."""

from fractions import Fraction

import pytest

from exactsweep import Point, Polygon
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.frame import Frame, to_homogeneous
from exactsweep.geometry.reading import lcm_within, reduce_lattice, to_lattice
from exactsweep.numbers.number import ORIGIN, Vertex

HALF = Fraction(1, 2)
SHIFT = Point(Fraction(1, 3), Fraction(-2))
TRIANGLE = Polygon([(0, 0), (2, HALF), (1, 3)])


@pytest.mark.parametrize("direction", [(1, 0), (0, 1), (2, -1), (1, 3)])
@pytest.mark.parametrize("scale", [2, 4, 6])
def test_entering_and_leaving_a_frame_is_the_identity(direction: Vector, scale: int) -> None:
    frame = Frame(direction, scale)
    p, q = direction
    entered = frame.enter(*TRIANGLE.lattice())
    assert entered == [
        (scale * (p * x + q * y), scale * (p * y - q * x)) for x, y in TRIANGLE.vertices
    ]
    assert {type(c) for vertex in entered for c in vertex} == {int}
    for shift in (ORIGIN, SHIFT, Point(Fraction(0), HALF), Point(HALF, Fraction(0))):
        left = [frame.leave_point(point, shift) for point in entered]
        assert left == [Point(x + shift.x, y + shift.y) for x, y in TRIANGLE.vertices]
        assert {type(c) for point in left for c in point} == {Fraction}
        assert [frame.enter_point(point, shift) for point in left] == entered
    on_lattice = frame.enter_point(Point(HALF, Fraction(7, 2)), ORIGIN)
    assert {*map(type, on_lattice)} == {int}
    off = Point(Fraction(1, 7), Fraction(2, 77))
    x, y = frame.enter_point(off, SHIFT)
    assert (x, y) == (
        scale * (p * (off.x - SHIFT.x) + q * (off.y - SHIFT.y)),
        scale * (p * (off.y - SHIFT.y) - q * (off.x - SHIFT.x)),
    )
    crossings: list[Vertex] = [(x, y), (5, y), (x, 5), (5, -3)]
    left = frame.leave(to_homogeneous(*point) for point in crossings)
    for (u, v), place in zip(crossings, left, strict=True):
        square = scale * (p * p + q * q)
        assert place == ((p * u - q * v) / Fraction(square), (q * u + p * v) / Fraction(square))


def test_a_lattice_is_reduced_by_the_common_divisor() -> None:
    assert reduce_lattice(12, ((6, 3), (9, 15))) == (4, ((2, 1), (3, 5)))
    assert reduce_lattice(4, ((2, 8), (6, 3))) == (4, ((2, 8), (6, 3)))
    assert reduce_lattice(4, ((-4, 8), (0, 12))) == (1, ((-1, 2), (0, 3)))
    assert reduce_lattice(1, ((4, 8), (6, 2))) == (1, ((4, 8), (6, 2)))
    assert reduce_lattice(5, ((0, 5), (0, 3))) == (5, ((0, 5), (0, 3)))


def test_the_longest_scale_has_8192_bits() -> None:
    assert lcm_within([2**8191, 2]) == 2**8191
    assert lcm_within([2**8192 - 1]) == 2**8192 - 1
    assert lcm_within([2**8192]) is None
    assert lcm_within([]) == 1
    for bits, scale in ((8191, 2**8191), (8192, 1)):
        unit = Fraction(1, 2**bits)
        assert to_lattice([Point(unit, Fraction(0)), Point(Fraction(1), unit)])[0] == scale
