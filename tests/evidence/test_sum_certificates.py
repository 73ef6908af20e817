"""Certificates of Minkowski sums: proved for shapes with holes and paths of every kind."""

import copy
import pickle
from fractions import Fraction
from random import Random
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from paths import draw_path
from polyominoes import Cells, polyominoes, region
from tiers import examples

from exactsweep import Polygon, PolygonError, Polyline, Region, minkowski_sum, no_fit_polygon
from exactsweep.check import verify
from exactsweep.corpus import PathCase, path_cases

SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
FORK = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (2, 2), (2, 6), (0, 6)]
tiny = st.tuples(st.integers(-3, 3), st.integers(-3, 3))


@given(polyominoes(14, 4), st.lists(tiny, min_size=2, max_size=7), st.booleans())
@examples(60)
def test_sums_of_cells_and_paths_are_proved(
    cells: Cells, points: list[tuple[int, int]], closed: bool
) -> None:
    shape, path = region(cells), Polyline(points, closed=closed)
    found = minkowski_sum(shape, path)
    if len(path) > 1:
        certificate = found.certificate()
        assert verify(certificate, shape=shape, path=path) == (True, "proved", None)
        assert Region(certificate["exterior"], certificate["holes"]) == found


@given(polyominoes(10, 4), st.sampled_from([(1, 2, -1, 3), (2, 1, 0, 7)]), st.randoms())
@examples(40)
def test_segments_along_edges_and_diagonals_are_proved(
    cells: Cells, matrix: tuple[int, int, int, int], rng: Random
) -> None:
    shape = region(cells, matrix)
    path = draw_path(rng, shape)
    assert verify(minkowski_sum(path, shape).certificate(), shape=shape, path=path).proved


@pytest.mark.parametrize("case", [*path_cases()], ids=lambda case: case.id)
def test_sums_of_the_corpus_are_proved(case: PathCase) -> None:
    found = minkowski_sum(case.shape, case.path)
    if len(case.path) > 1:
        assert verify(found.certificate(), shape=case.shape, path=case.path).proved
    else:
        with pytest.raises(PolygonError, match="the path is a single point"):
            found.certificate()


def test_certificates_by_hand() -> None:
    corner = minkowski_sum(SQUARE, Polyline([(0, 0), (4, 0), (4, 4)])).certificate()
    ends = [(0, 0), (6, 0), (6, 6), (4, 6), (4, 2), (0, 2)]
    assert [(int(x), int(y)) for x, y in corner["exterior"]] == ends
    assert (corner["holes"], corner["proof"]["slits"]) == ([], [])
    assert corner["path"] == [["0", "0"], ["4", "0"], ["4", "4"]]
    # The slot of the fork is as wide as the path is long: the cut is part of the sum.
    filled = minkowski_sum(FORK, Polyline([(0, 0), (2, 0)])).certificate()
    assert [(int(x), int(y)) for x, y in filled["exterior"]] == [(0, 0), (8, 0), (8, 6), (0, 6)]
    assert ["4", "6"] in filled["proof"]["slits"][0]
    assert verify(corner).proved
    assert verify(filled).proved


@pytest.mark.parametrize(
    "path",
    [
        [(0, 0), (5, 0), (0, 0)],
        [(0, 0), (5, 0), (2, 0), (8, 0)],
        [(0, 0), (6, 6), (6, 0), (0, 6)],
        [(0, 0), (6, 0), (6, 6), (0, 6), (0, 0), (3, 3), (3, 0), (3, 3)],
        [(0, 0), ("1/3", "1/7")],
        [(0, 0), (10**30, 1), (0, 2)],
    ],
)
@pytest.mark.parametrize("shape", [SQUARE, FORK, [(0, 0), (1, 0), (0, 1)]])
def test_retraced_and_crossing_paths_are_proved(shape: Any, path: Any) -> None:
    assert verify(minkowski_sum(shape, Polyline(path)).certificate(), shape=shape, path=path).proved


def test_copies_keep_the_certificate() -> None:
    found = minkowski_sum(FORK, Polyline([(0, 0), (1, 3)]))
    for other in (pickle.loads(pickle.dumps(found)), copy.copy(found), copy.deepcopy(found)):
        assert other == found
        assert other.certificate() == found.certificate()
    assert found == Region(found)
    assert repr(found) == repr(Region(found))
    assert type(found.translated((1, 0))) is Region


def test_the_certificate_of_two_shapes_is_that_of_the_no_fit_polygon() -> None:
    notched = Region(FORK).reflected()
    found = minkowski_sum(SQUARE, FORK)
    assert found.certificate() == no_fit_polygon(SQUARE, notched).certificate()
    assert verify(found.certificate(), directrix=SQUARE, generatrix=notched).proved


def test_the_area_of_a_proved_sum_is_that_of_its_loops() -> None:
    ring = minkowski_sum(SQUARE, Polyline([(0, 0), (9, 0), (9, 9), (0, 9)], closed=True))
    claimed = ring.certificate()
    assert claimed["path"][0] == claimed["path"][-1] == ["0", "0"]
    assert Region(claimed["exterior"], claimed["holes"]).area == Fraction(72)
    assert ring.holes == (Polygon([(2, 2), (9, 2), (9, 9), (2, 9)]),)
