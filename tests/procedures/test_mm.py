"""The MM procedures on chains: Lemmas 5.1 and 5.3."""

import random

import families
import pytest
import strategies as own
from hypothesis import given
from tiers import examples

from exactsweep import Polygon, sweep
from exactsweep.numbers.number import Vertex
from exactsweep.paper.definition import reference_loops
from exactsweep.paper.kernel import (
    find_convex_parts,
    sweep_mm,
    to_graph,
    trajectory_cc,
    trajectory_mm,
)
from exactsweep.procedures import ceiling
from exactsweep.procedures.chain import complement, inverse, split
from exactsweep.procedures.graph import lower_envelope_mm

Pair = tuple[Polygon, Polygon]
usually = examples(100)


def envelope_of_all_pairs(top: list[Vertex], bottom: list[Vertex]) -> list[Vertex]:
    """Compute the envelope of all pairs of convex parts."""
    chains = [
        trajectory_cc(inverse(part), other)
        for part in find_convex_parts(inverse(top))
        for other in find_convex_parts(bottom)
    ]
    return list(lower_envelope_mm([to_graph(chain) for chain in chains]))


@pytest.mark.parametrize("strips", [1, ceiling.STRIPS])
@pytest.mark.parametrize("first", range(0, 40, 20))
@pytest.mark.long
def test_no_pair_of_convex_parts_is_missed(
    first: int, strips: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Lemma 5.1, three times: pairs that are not swept do not reach the envelope."""
    monkeypatch.setattr(ceiling, "STRIPS", strips)
    for number in range(first, first + 20):
        rng = random.Random(f"all pairs:{number}")
        (g_bottom, g_top), (bottom, _) = (
            split(Polygon(families.long(rng)).lattice()[1]) for _ in "gd"
        )
        trajectory = list(trajectory_mm(g_top, bottom))
        assert trajectory == envelope_of_all_pairs(g_top, bottom), number
        inner, outer = sweep_mm(g_top, g_bottom, bottom)
        assert outer == envelope_of_all_pairs(inverse(g_bottom), trajectory), number
        inside = envelope_of_all_pairs(g_top, inverse(complement(trajectory)))
        left, right = bottom[0][0], bottom[-1][0]
        closed = [v for v in inverse(complement(inside)) if left < v[0] < right]
        assert closed == [v for v in inner if left < v[0] < right], number


@given(own.pairs("MM"))
@examples(40)
def test_nearly_equal_slopes_are_distinguished(pair: Pair) -> None:
    """Squeezed in y, all slopes have the same bounds, so all comparisons are exact."""
    squeezed = [Polygon([(x, y / 2**99) for x, y in polygon.vertices]) for polygon in pair]
    s, t = sweep(*pair, direction=(1, 0)), sweep(*squeezed, direction=(1, 0))
    for loop, other in zip(
        (s.trajectory, s.inner, s.outer), (t.trajectory, t.inner, t.outer), strict=True
    ):
        assert [(x, y / 2**99) for x, y in loop.vertices] == list(other.vertices)


def test_a_run_may_be_above_a_piece_that_is_in_it() -> None:
    """A piece starts below the run and crosses a step of it, above the envelope.

    The chain right of the step is cut at its left end, where it would be even lower.
    """
    pair = (
        Polygon([(5, 16), (3, 25), (1, 4), (0, 0)]),
        Polygon([(30, -6), (31, -11), (32, -15), (33, -15), (21, 22)]),
    )
    s = sweep(*pair, direction=(1, 0))
    loops = s.trajectory.vertices, s.inner.vertices, s.outer.vertices
    assert loops == reference_loops(*pair)
