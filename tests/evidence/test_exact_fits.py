"""Exact fits: slots exactly as wide as G, compared with the definition and with `classify`."""

import random
from fractions import Fraction

import families
import pytest
import strategies as own
from definition import is_exact_fit
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Point, Polygon, sweep
from exactsweep.paper.counting import make_counted, watch_operations
from exactsweep.paper.definition import reference_exact_fits
from exactsweep.paper.kernel import invert_top
from exactsweep.procedures.chain import Chain
from exactsweep.procedures.exact_fit import find_exact_fits
from exactsweep.procedures.mm import trajectory_mm

Pair = tuple[Polygon, Polygon]

often = examples(100)


@st.composite
def rectilinear_pairs(draw: st.DrawFn) -> Pair:
    """On one small grid, so that about half of the pairs have a fit."""
    generatrix = draw(own.rectilinear_rings() | st.just([(0, 0), (1, 0), (1, 1), (0, 1)]))
    directrix = Polygon(draw(own.rectilinear_rings()))
    return Polygon(generatrix), draw(st.sampled_from([directrix, directrix.reflected()]))


@given(own.turned_pairs("MM") | own.turned_pairs("CM"))
@often
def test_fits_match_the_definition_in_any_direction(
    turned: tuple[Polygon, Polygon, tuple[int, int]],
) -> None:
    generatrix, directrix, direction = turned
    expected = reference_exact_fits(generatrix, directrix, direction)
    assert sweep(generatrix, directrix).exact_fits == expected


def test_fits_of_many_rectilinear_pairs_match_the_definition() -> None:
    """Ends and midpoint touch, positions next to them overlap; and fits are frequent enough."""
    found = 0
    for number in range(150):
        rng = random.Random(f"fits:{number}")
        pair = families.random_pair(rng, ["rectilinear", "mould"])
        s = sweep(pair.generatrix, pair.directrix)
        expected = reference_exact_fits(pair.generatrix, pair.directrix, pair.direction)
        assert s.exact_fits == expected, number
        shapes = pair.generatrix, pair.directrix
        assert all(is_exact_fit(*shapes, f) for f in s.exact_fits)
        found += len(s.exact_fits)
    assert found > 50


@given(rectilinear_pairs(), own.matrices())
@often
def test_linear_maps_commute(pair: Pair, matrix: own.Matrix) -> None:
    (a, b), (c, d) = matrix
    s = sweep(*pair)
    image = sweep(*(own.mapped(polygon, matrix) for polygon in pair))
    mapped = [tuple(Point(a * x + b * y, c * x + d * y) for x, y in fit) for fit in s.exact_fits]
    assert [*image.exact_fits] == sorted(mapped)


def comb(teeth: int) -> list[tuple[int, int]]:
    """Return a top chain, from right to left, of teeth 6 wide with gaps of 2."""
    steps = [[(8 * k, 0), (8 * k + 2, 0), (8 * k + 2, 10), (8 * k + 8, 10)] for k in range(teeth)]
    return [vertex for step in steps for vertex in step][::-1]


def test_a_long_comb_is_lifted_with_all_above_it() -> None:
    """A former version walked along all of G wherever two pairs of walls meet."""
    tongue = [(-3, 0), (0, 0), (0, -9), (2, -9), (2, 0), (5, 0)]
    found = []
    for teeth in (50, 100):
        generatrix, directrix = (
            invert_top(make_counted(comb(teeth))),
            Chain.of(make_counted(tongue)),
        )
        trajectory = trajectory_mm(generatrix, directrix).chain()
        with watch_operations() as tally:
            fits = find_exact_fits(generatrix, directrix, trajectory)
        assert len(fits) == teeth - 1
        found.append(tally.total)
    assert found[1] < 2.5 * found[0]


@pytest.mark.parametrize(
    ("lid", "ceiling", "rim", "fit"),
    [
        ([], [], 1, (1, 9)),
        ([], [("3/2", 5)], 0, (0, 5)),
        ([("1/2", 4)], [], 0, (0, 5)),
        ([("1/4", 3), ("3/4", 5)], [("5/4", 7), ("7/4", 8)], 0, (0, 3)),
    ],
    ids=["unequal rims", "low in the middle", "a tip", "a tip and a slope"],
)
def test_a_lid_slides_up_a_slot_until_it_is_blocked(
    lid: list[tuple[str, int]], ceiling: list[tuple[str, int]], rim: int, fit: tuple[int, int]
) -> None:
    """The slot is one unit wide and 9 high at both walls; both ends of the lid are at height 0."""
    top = [(Fraction(x), y) for x, y in [("1", 0), *lid[::-1], ("0", 0)]]
    slot = [("0", 0), ("1", 0), ("1", 9), *ceiling, ("2", 9), ("2", rim), ("4", rim)]
    bottom = [(Fraction(x), y) for x, y in slot]
    hanging, inside = fit
    generatrix, directrix = invert_top(top), Chain.of(bottom)
    trajectory = trajectory_mm(generatrix, directrix).chain()
    fits = find_exact_fits(generatrix, directrix, trajectory)
    assert fits == [((1, hanging), (1, inside))]


def test_chains_without_walls_compare_only_their_ends() -> None:
    def zigzag(size: int) -> list[tuple[int, int]]:
        return [(k, k % 2) for k in range(size)]

    found = []
    for size in (50, 100):
        generatrix = invert_top(make_counted(zigzag(size)[::-1]))
        directrix = Chain.of(make_counted(zigzag(size)))
        trajectory = trajectory_mm(generatrix, directrix).chain()
        with watch_operations() as tally:
            assert find_exact_fits(generatrix, directrix, trajectory) == []
        found.append(tally.total)
    assert found[1] < 2.5 * found[0]
