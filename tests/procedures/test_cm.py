"""The CM procedures on chains."""

from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.numbers.point import Vertex
from exactsweep.procedures.chain import split
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm

Pair = tuple[Polygon, Polygon]
Chain = list[Vertex]
usually = examples(100)


@given(own.pairs("CM"), st.data())
@usually
def test_collinear_runs_and_repeated_points_change_nothing(pair: Pair, data: st.DataObject) -> None:
    (g_bottom, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    run: list[Vertex] = []
    for (px, py), (qx, qy) in pairwise(bottom):
        run += [(px, py)] * data.draw(own.tiny(1, 2))
        if data.draw(st.booleans()):
            run.append((Fraction(px + 2 * qx) / 3, Fraction(py + 2 * qy) / 3))
    run.append(bottom[-1])
    assert list(trajectory_cm(g_top, run)) == list(trajectory_cm(g_top, bottom))
    outer = sweep_outer_cm(g_top, g_bottom, run)
    assert list(outer) == list(sweep_outer_cm(g_top, g_bottom, bottom))


@given(own.pairs("CM"))
@usually
def test_sources_number_the_convex_parts_from_left_to_right(pair: Pair) -> None:
    (_, g_top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    sources = trajectory_cm(g_top, bottom).sources
    assert sources == sorted(sources)


@pytest.mark.parametrize("unit", [1, Fraction(1, 9)])
@pytest.mark.parametrize("sign", [1, -1])
@pytest.mark.parametrize(
    ("directrix", "inner"),
    [
        (
            [(0, 2), (2, 3), (3, 2), (4, 4), (4, 9), (8, 3)],
            [
                (0, 2),
                ("4/3", "8/3"),
                ("7/3", "8/3"),
                (3, 2),
                (4, 4),
                (4, "15/2"),
                (5, "15/2"),
                (8, 3),
            ],
        ),
        (
            [(0, 4), (2, 9), (2, 6), (3, 0), (5, 4)],
            [(0, 4), (1, "13/2"), (2, "13/2"), (2, 6), (3, 0), (5, 4)],
        ),
        (
            [(-1, 3), (0, 1), (2, 0), (4, 1), (6, 1), (6, 0), (8, 1), (8, 2), (10, 1), (11, 2)],
            [
                *[(-1, 3), (0, 1), (2, 0), (4, 1), (6, 1), (6, 0), (8, 1)],
                *[(8, "3/2"), (9, "3/2"), (10, 1), (11, 2)],
            ],
        ),
        (
            [(0, 0), (4, 4), (4, 6), (9, 1)],
            [(0, 0), (4, 4), (4, 5), (5, 5), (9, 1)],
        ),
    ],
)
def test_a_lid_comes_to_rest_beside_a_wall(
    directrix: list[Vertex], inner: list[tuple[str, str]], sign: int, unit: Fraction
) -> None:
    """One corner of it inside an edge, the other one at the end of one."""

    def place(chain: Any) -> Chain:
        placed: Chain = [(sign * unit * Fraction(x), unit * Fraction(y)) for x, y in chain]
        return placed[::sign]

    assert sweep_inner_cm([(unit, unit), (0, unit)], place(directrix)) == place(inner)
