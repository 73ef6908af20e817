"""Cached chains of polygons: they change no answer, and are computed once."""

from __future__ import annotations

import copy
import pickle
from fractions import Fraction
from typing import Any

import pytest
import strategies as own
from hypothesis import example, given
from hypothesis import strategies as st

from exactsweep import Polygon, sweep
from exactsweep.geometry.frame import Frame
from exactsweep.procedures import monotone
from exactsweep.procedures.monotone import KEPT_VERTICES, split_polygon

SCALES = [Fraction(1), Fraction(1, 3), Fraction(1, 7), Fraction(1000), Fraction(10**9 + 7, 2)]
NOTCH = Polygon([(0, 0), (6, 0), (6, 3), (4, 3), (3, 1), (2, 3), (0, 3)])
FRAME = Frame((1, 0), 1)
BARGE = Polygon([(0, 2), (1, 0), (2, 1), (3, 0), (4, 2), (2, 3)])


def list_loops(generatrix: Polygon, directrix: Polygon) -> list[tuple[Any, ...]]:
    s = sweep(generatrix, directrix)
    return [(s.direction,), *(loop.vertices for loop in (s.trajectory, s.inner, s.outer))]


def forget(polygon: Polygon) -> Polygon:
    """The same polygon, never swept."""
    return Polygon(list(polygon.vertices))


@given(
    st.lists(
        st.builds(
            Polygon.scaled, own.monotone_polygons() | own.convex_polygons(), st.sampled_from(SCALES)
        ),
        min_size=2,
        max_size=4,
    ),
    st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=2, max_size=6),
)
@example([NOTCH, BARGE, NOTCH.scaled(Fraction(1, 3))], [(0, 1), (1, 0), (2, 1), (1, 1), (1, 2)])
@example([NOTCH, BARGE.scaled(1000)], [(0, 0), (1, 0), (0, 1), (0, 0)])
@example([Polygon([(y, x) for x, y in NOTCH.vertices]), BARGE], [(0, 0), (1, 0), (0, 1)])
def test_who_was_swept_before_makes_no_difference(
    polygons: list[Polygon], pairs: list[tuple[int, int]]
) -> None:
    for i, j in pairs:
        g, d = polygons[i % len(polygons)], polygons[j % len(polygons)]
        assert list_loops(g, d) == list_loops(forget(g), forget(d))


def test_the_answer_is_that_of_the_same_direction_and_lattice() -> None:
    """Kept in one frame, asked for in others."""
    diamond = Polygon([(0, 0), (2, -1), (4, 0), (2, 1)])
    for direction in ((1, 0), (0, 1), (1, 1), (2, 1), (1, 0)):
        for other in (diamond, diamond.scaled(Fraction(1, 5)), diamond):
            again, fresh = (
                sweep(g, d, direction=direction)
                for g, d in ((diamond, other), (forget(diamond), forget(other)))
            )
            assert (again.trajectory, again.outer) == (fresh.trajectory, fresh.outer)
    kept = split_polygon(diamond, Frame((1, 0), 1))
    assert kept == ([(0, 0), (2, -1), (4, 0)], [(4, 0), (2, 1), (0, 0)])
    assert (
        split_polygon(diamond, Frame((0, 1), 1)) != kept != split_polygon(diamond, Frame((1, 0), 2))
    )


@pytest.fixture(autouse=True)
def _nothing_kept() -> None:
    monotone._keep.cache_clear()


def keeps(polygon: Polygon) -> bool:
    """Decide whether a polygon that is split is not split again."""
    return split_polygon(polygon, FRAME)[0] is split_polygon(polygon, FRAME)[0]


def test_only_polygons_of_few_vertices_keep_their_chains() -> None:
    """A large one takes its time anyway, and would keep four times its size."""
    for count in (KEPT_VERTICES, KEPT_VERTICES + 1):
        teeth = [(k, -(k % 2)) for k in range(count - 1)]
        polygon = Polygon([*teeth, (0, count)])
        assert len(polygon) == count
        assert keeps(polygon) == (count == KEPT_VERTICES)


def test_an_equal_polygon_made_anew_shares_what_is_kept() -> None:
    assert split_polygon(NOTCH, FRAME)[0] is split_polygon(forget(NOTCH), FRAME)[0]
    assert split_polygon(NOTCH, FRAME) != split_polygon(NOTCH.scaled(2), FRAME)


def test_a_swept_polygon_is_pickled_as_one_that_was_not() -> None:
    polygon = forget(NOTCH)
    before = pickle.dumps(polygon)
    assert sweep(polygon, BARGE).direction
    assert pickle.dumps(polygon) == before


def test_a_copy_of_a_swept_polygon_is_the_polygon() -> None:
    polygon = forget(NOTCH)
    before = list_loops(BARGE, polygon)
    for twin in (copy.copy(polygon), copy.deepcopy(polygon), pickle.loads(pickle.dumps(polygon))):
        assert (twin, list_loops(BARGE, twin)) == (polygon, before)
    assert list_loops(BARGE, Polygon(polygon)) == before
    assert list_loops(BARGE, polygon.translated((0, 1))) != before
