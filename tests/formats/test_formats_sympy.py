"""Polygons to and from sympy."""

from fractions import Fraction

import pytest
import strategies
import sympy
from hypothesis import given
from tiers import examples

from exactsweep import NumberError, Polygon
from exactsweep.formats import FormatError, from_sympy, to_sympy


@given(strategies.star_rings())
@examples(20)
def test_sympy_round_trip(ring: strategies.Ring) -> None:
    polygon = Polygon([(x, Fraction(y, 3)) for x, y in ring])
    assert from_sympy(to_sympy(polygon)) == polygon
    assert abs(to_sympy(polygon).area) == sympy.Rational(*polygon.area.as_integer_ratio())


def test_numbers_of_sympy_name_the_vertex() -> None:
    with pytest.raises(NumberError, match=r"^vertex 1: .* is not a rational number$"):
        from_sympy(sympy.RegularPolygon((0, 0), 1, 3))


def test_degenerate_sympy_polygons_are_rejected() -> None:
    with pytest.raises(FormatError, match=r"^a sympy Segment2D is not a polygon$"):
        from_sympy(sympy.Polygon((0, 0), (1, 1), (2, 2)))


def test_vertices_that_sympy_would_drop_are_rejected() -> None:
    minute = Polygon([(0, 0), ("1e-8", 0), (0, "1e-8")])
    with pytest.raises(FormatError, match="sympy would drop vertices"):
        to_sympy(minute)
