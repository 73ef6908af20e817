"""The overlap of two shapes, its area and depth: known answers, and the definition."""

from collections import Counter
from fractions import Fraction
from random import Random
from typing import Any

import pytest
import shapely
import small_pairs
from hypothesis import given
from polyominoes import Cells, polyominoes, region
from strategies import points
from tiers import examples

from exactsweep import Overlap, Point, Polygon, PolygonError, Region, distance_squared, overlap
from exactsweep.check import classify
from exactsweep.numbers.number import ORIGIN

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]


def summary(o: Overlap) -> tuple[object, ...]:
    return o.verdict, o.area, o.distance_squared, o.depth_squared


def box(left: int, low: int, right: int, high: int) -> list[tuple[int, int]]:
    return [(left, low), (right, low), (right, high), (left, high)]


def test_two_squares() -> None:
    o = overlap(SQUARE, box(2, 2, 6, 6))
    assert summary(o) == ("OVERLAP", 4, 0, 4)
    assert o.move in points((0, 2), (2, 0))
    assert o.witness is not None
    assert 2 < o.witness.x < 4
    assert 2 < o.witness.y < 4


def test_touching_and_disjoint_shapes() -> None:
    o = overlap(SQUARE, box(4, 1, 6, 2))
    assert summary(o) == ("CONTACT", 0, 0, 0)
    assert o.witness is not None
    assert o.witness.x == 4
    assert 1 <= o.witness.y <= 2
    assert o.nearest == (o.witness, o.witness)
    o = overlap(SQUARE, box(7, 8, 9, 9))
    assert summary(o) == ("FREE", 0, 25, 0)
    assert o.witness is None
    assert o.nearest == points((4, 4), (7, 8))


def test_a_part_in_a_hole_is_free() -> None:
    plate = Region(box(0, 0, 9, 9), [box(2, 2, 7, 7)])
    assert overlap(plate, box(3, 3, 4, 4)).verdict == "FREE"
    assert overlap(plate, box(2, 3, 4, 4)).verdict == "CONTACT"
    # The shortest translation moves the shape into the hole, which it fills.
    o = overlap(plate, box(3, 2, 8, 7))
    assert summary(o) == ("OVERLAP", 5, 0, 1)
    assert (o.move,) == points((-1, 0))
    assert overlap(plate, plate).area == plate.area


def test_a_touching_hole_hides_no_witness() -> None:
    """A hole of b touches the midpoint of the longest segment of the common boundary."""
    plate = Region(box(0, 0, 8, 8), [[(4, 0), (3, 4), (5, 4)]])
    o = overlap(box(-9, -9, 20, 20), plate)
    assert o.area == plate.area == 60
    assert o.witness is not None
    assert plate.contains(o.witness)


def test_polygons_of_shapely_count_with_their_holes() -> None:
    plate = shapely.box(0, 0, 9, 9).difference(shapely.box(2, 2, 7, 7))
    assert overlap(plate, shapely.box(3, 3, 4, 4)).verdict == "FREE"
    assert overlap(a=plate, b=shapely.box(1, 1, 4, 4)).area == 5


def test_answers_are_values_and_rejections_name_the_shape() -> None:
    assert overlap(SQUARE, SQUARE) == overlap(Polygon(SQUARE), SQUARE[::-1])
    assert len({overlap(SQUARE, SQUARE), overlap(Region(SQUARE), SQUARE)}) == 1
    other: Any = SQUARE
    assert overlap(SQUARE, SQUARE) != other
    assert repr(overlap(SQUARE, SQUARE)) == "<Overlap of 4 and 4 vertices: OVERLAP>"
    with pytest.raises(PolygonError, match=r"^b: "):
        overlap(SQUARE, [(0, 0), (1, 1)])


def check(o: Overlap) -> None:
    """Check an answer by an independent test of single positions."""
    a, b = o.a, o.b
    assert classify(a, b, ORIGIN).verdict == o.verdict
    assert (o.area > 0) == (o.depth_squared > 0) == (o.verdict == "OVERLAP")
    assert (o.distance_squared > 0) == (o.verdict == "FREE")
    assert o.distance_squared == distance_squared(a, b).value
    x, y = o.move
    assert classify(a, b, o.move).verdict == ("FREE" if o.verdict == "FREE" else "CONTACT")
    if o.verdict == "OVERLAP":
        assert o.witness is not None
        assert a.contains(o.witness)
        assert b.contains(o.witness)
        # Shorter translations leave overlap.
        for p, q in [(x, y), (-x, -y), (-y, x), (y, -x)]:
            nearer = Point(p * Fraction(99, 100), q * Fraction(99, 100))
            assert classify(a, b, nearer).verdict == "OVERLAP"


def test_random_pairs() -> None:
    rng = Random(11)
    seen: Counter[str] = Counter()
    for number in range(160):
        pair = (small_pairs.draw_shapeless if number % 2 else small_pairs.draw)(rng)
        g, d = (Region(shape[0], shape[1:]) for shape in pair)
        move = Point(*(Fraction(rng.randint(-8, 8), rng.choice([1, 2, 3])) for _ in range(2)))
        o = overlap(d, g.translated(move))
        check(o)
        seen[o.verdict] += 1
        other = overlap(g.translated(move), d)
        assert summary(other) == summary(o)
    assert min(seen.values()) >= 10


@given(polyominoes(12, 4), polyominoes(8, 3))
@examples(20)
def test_the_area_of_common_cells_is_their_number(a: Cells, b: Cells) -> None:
    matrix = (1, 0, 0, 1)
    o = overlap(region(a, matrix), region(b, matrix))
    assert o.area == len({*a} & {*b})
    check(o)


@given(polyominoes(12, 4), polyominoes(8, 3))
@examples(20)
def test_the_area_under_a_map_and_a_half_step(a: Cells, b: Cells) -> None:
    """Four quarters of each cell, one of them moved by half a cell."""
    matrix = (3, 1, -1, 2)
    moved = region(b, matrix).translated((Fraction(3, 2), Fraction(-1, 2)))
    found = overlap(region(a, matrix), moved).area

    def halves(cells: Cells, step: int) -> set[tuple[int, int]]:
        return {(2 * x + i + step, 2 * y + j) for x, y in cells for i in (0, 1) for j in (0, 1)}

    assert found == Fraction(len(halves(a, 0) & halves(b, 1)) * 7, 4)
