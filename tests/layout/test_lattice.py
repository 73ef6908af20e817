"""Solids on lattices: laws for each step of the search, as well as for its result."""

from fractions import Fraction

from hypothesis import example, given
from hypothesis import strategies as st
from layouts import box, lay, put
from tiers import examples

from exactsweep import Region
from exactsweep.layout import judge_layout
from exactsweep.layout.pieces import find_normal
from exactsweep.layout.solid import LatticeForm, Solid, make_form, share_scale
from exactsweep.layout.verdict import find_witness

steps = st.integers(-6, 6)
vertices = st.tuples(steps, steps)


@given(st.integers(1, 6), st.integers(1, 6), vertices)
def test_a_finer_lattice_keeps_the_position(scale: int, factor: int, move: tuple[int, int]) -> None:
    form = LatticeForm([[(0, 0), (4, 1), (3, 5)]])
    solid = Solid(form, *move, scale, Fraction(1, 7))
    finer = solid.on(scale * factor)
    assert (finer.scale, finer.slack) == (scale * factor, solid.slack)
    assert [finer.to_point(x, y) for piece in finer.pieces for x, y in piece] == [
        solid.to_point(x, y) for piece in solid.pieces for x, y in piece
    ]
    assert [one.scale for one in share_scale(solid, finer)] == [finer.scale] * 2


@examples(60)
@given(vertices, vertices)
@example((-6, -6), (-6, -6))
def test_nearest_parts_are_translation_invariant(
    move: tuple[int, int], by: tuple[int, int]
) -> None:
    (x, y), (u, v) = move, by
    near = {"a": box(x, y, x + 1, y + 1), "b": box(u, v, u + 1, v + 1)}
    for left, low in ((-4, -8), (-8, -4)):
        places = put("a", (-8 - x, -8 - y)), put("b", (left - u, low - v))
        nearest = judge_layout(lay(box(-20, -20, 20, 20), near, *places)).distance
        assert nearest is not None
        assert (nearest.square, nearest.placements) == (Fraction(9), (0, 1))


def test_the_nearest_pair_may_come_last() -> None:
    places = (put("t", (x, 0)) for x in (0, 2, Fraction(7, 2)))
    nearest = judge_layout(lay(box(0, 0, 9, 9), {"t": box(0, 0, 1, 1)}, *places)).distance
    assert nearest is not None
    assert (nearest.square, nearest.placements) == (Fraction(1, 4), (1, 2))


def test_parts_whose_boxes_meet_may_be_farther_than_others() -> None:
    parts = {"a": [(0, 0), (4, 0), (0, 4)], "b": [(4, 3), (4, 4), (3, 4)], "c": box(-2, 0, -1, 1)}
    nearest = judge_layout(lay(box(-9, -9, 9, 9), parts, *map(put, parts))).distance
    assert nearest is not None
    assert (nearest.square, nearest.placements) == (Fraction(1), (0, 2))


def test_a_witness_may_be_as_deep_as_the_slack_allows() -> None:
    scale, form = make_form(Region(box(0, 0, 4, 4)))

    def witness(slack: Fraction) -> object:
        return find_witness(Solid(form, 0, 0, scale, slack), Solid(form, 0, 0, scale, slack))

    # The center is at distance 2 from each side.
    assert witness(Fraction(199, 100)) is not None
    assert witness(Fraction(2)) is None


@given(st.integers(0, 2), st.integers(0, 2))
def test_any_edge_may_separate_two_pieces(first: int, second: int) -> None:
    """A corner touches the middle of an edge, whose normal is the only separating one."""
    wall, wedge = [(7, 2), (1, 8), (1, 2)], [(4, 5), (10, 6), (5, 11)]
    wall, wedge = wall[first:] + wall[:first], wedge[second:] + wedge[:second]
    nothing = Fraction(0)
    assert find_normal(wall, wedge, nothing) == (1, 1)
    assert find_normal(wedge, wall, nothing) == (-1, -1)


def test_distances_are_exact_without_a_common_lattice() -> None:
    """Boxes of half a unit, translated by a number with more bits than a lattice may have."""
    move = 1 + Fraction(1, 2**9000)
    places = put("b", (0, 0)), put("b", (str(move), 0))
    judgement = judge_layout(lay(box(-9, -9, 9, 9), {"b": box(0, 0, "1/2", "1/2")}, *places))
    nearest = judgement.distance
    assert nearest is not None
    assert nearest.square == (move - Fraction(1, 2)) ** 2
