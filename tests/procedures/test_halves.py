"""Laws of the lower half that hold for the procedures of all classes."""

from collections.abc import Callable
from fractions import Fraction

import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon, sweep
from exactsweep.numbers.number import Vertex
from exactsweep.paper.kernel import (
    sweep_inner_cc,
    sweep_inner_cm,
    sweep_mm,
    sweep_outer_cc,
    sweep_outer_cm,
    trajectory_cc,
    trajectory_cm,
    trajectory_mm,
)
from exactsweep.procedures.chain import inverse, split

Half = list[Vertex]
Trajectory = Callable[[Half, Half], Half]
Boundaries = Callable[[Half, Half, Half], tuple[Half, Half]]
usually = examples(60)

# Trajectories of G's top and D's bottom; boundaries of G's top and bottom and D's bottom.
TRAJECTORY: dict[str, Trajectory] = {
    "CC": trajectory_cc,
    "CM": lambda top, wall: list(trajectory_cm(top, wall)),
    "MM": lambda top, wall: list(trajectory_mm(top, wall)),
}
BOUNDARIES: dict[str, Boundaries] = {
    "CC": lambda top, floor, wall: (sweep_inner_cc(top, wall), sweep_outer_cc(top, floor, wall)),
    "CM": lambda top, floor, wall: (
        sweep_inner_cm(top, wall),
        list(sweep_outer_cm(top, floor, wall)),
    ),
    "MM": sweep_mm,
}
KINDS: list[own.Kind] = ["CC", "CM", "MM"]


def chains(kind: own.Kind) -> st.SearchStrategy[tuple[Half, Half, Half]]:
    """Draw the upper and lower chains of G and the lower chain of D, on a lattice."""

    def take(pair: tuple[Polygon, Polygon]) -> tuple[Half, Half, Half]:
        (floor, top), (wall, _) = (split(polygon.lattice()[1]) for polygon in pair)
        return top, floor, wall

    return own.pairs(kind).map(take)


@pytest.mark.parametrize("kind", KINDS)
def test_halves_match_the_whole_sweep(kind: own.Kind) -> None:
    @given(own.pairs(kind))
    @usually
    def check(pair: tuple[Polygon, Polygon]) -> None:
        (floor, top), (wall, _) = (split(polygon.vertices) for polygon in pair)
        s = sweep(*pair, direction=(1, 0))
        found = TRAJECTORY[kind](top, wall), *BOUNDARIES[kind](top, floor, wall)
        for chain, loop in zip(found, (s.trajectory, s.inner, s.outer), strict=True):
            assert chain == split(loop.vertices)[0]

    check()


@pytest.mark.parametrize(("kind", "other"), [("CC", "CM"), ("CC", "MM"), ("CM", "MM")])
def test_procedures_of_wider_classes_agree(kind: own.Kind, other: own.Kind) -> None:
    @given(chains(kind))
    @usually
    def check(drawn: tuple[Half, Half, Half]) -> None:
        top, _, wall = drawn
        assert TRAJECTORY[other](top, wall) == TRAJECTORY[kind](top, wall)
        assert BOUNDARIES[other](*drawn) == BOUNDARIES[kind](*drawn)

    check()


@pytest.mark.parametrize("kind", KINDS)
def test_outer_boundary_is_the_trajectory_swept_by_the_inverse(kind: own.Kind) -> None:
    """The outer loop bounds T plus G: Lemma 5.3."""

    @given(chains(kind))
    @usually
    def check(drawn: tuple[Half, Half, Half]) -> None:
        top, floor, wall = drawn
        _, outer = BOUNDARIES[kind](*drawn)
        assert TRAJECTORY[kind](inverse(floor), TRAJECTORY[kind](top, wall)) == outer

    check()


@pytest.mark.parametrize("kind", KINDS)
def test_sweeping_the_inner_boundary_again_changes_nothing(kind: own.Kind) -> None:
    """The inner boundary is its own inner boundary and has the same trajectory."""

    @given(chains(kind))
    @usually
    def check(drawn: tuple[Half, Half, Half]) -> None:
        top, floor, wall = drawn
        inner, outer = BOUNDARIES[kind](*drawn)
        assert (inner[0], inner[-1]) == (wall[0], wall[-1])
        assert BOUNDARIES[kind](top, floor, inner) == (inner, outer)
        assert TRAJECTORY[kind](top, inner) == TRAJECTORY[kind](top, wall)

    check()


@pytest.mark.parametrize("kind", KINDS)
def test_ints_and_fractions_agree(kind: own.Kind) -> None:
    def shrink(chain: Half) -> Half:
        return [(Fraction(x) / 7, Fraction(y) / 7) for x, y in chain]

    @given(chains(kind))
    @usually
    def check(drawn: tuple[Half, Half, Half]) -> None:
        top, _, wall = drawn
        small = [shrink(chain) for chain in drawn]
        assert shrink(TRAJECTORY[kind](top, wall)) == TRAJECTORY[kind](small[0], small[2])
        inner, outer = map(shrink, BOUNDARIES[kind](*drawn))
        assert BOUNDARIES[kind](*small) == (inner, outer)

    check()
