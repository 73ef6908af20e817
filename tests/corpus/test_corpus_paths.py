"""Sums of a shape and a path are exact, and unions in floats have the same areas."""

import json
from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
import shapely
from command import run

from exactsweep import Point, minkowski_sum
from exactsweep.corpus import PathCase, find_path_case, path_cases

CASES = [*path_cases()]


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_sums_with_paths_are_exact(case: PathCase) -> None:
    assert minkowski_sum(case.shape, case.path) == case.sum
    assert Fraction(case.data["expected"]["area"]) == case.sum.area


def sweep_along(rings: list[list[Point]], start: Point, end: Point) -> Any:
    """Unite a shape at both ends of a segment with the areas that its edges sweep."""
    exterior, *holes = rings
    ends = [
        shapely.Polygon([move(p, by) for p in exterior], [[move(p, by) for p in h] for h in holes])
        for by in (start, end)
    ]
    covered = [
        shapely.convex_hull(shapely.MultiPoint([move(p, by) for p in edge for by in (start, end)]))
        for ring in rings
        for edge in pairwise([*ring, ring[0]])
    ]
    return shapely.union_all([*ends, *covered])


def move(point: Point, by: Point) -> tuple[float, float]:
    return float(point.x + by.x), float(point.y + by.y)


@pytest.mark.parametrize("case", CASES, ids=lambda case: case.id)
def test_unions_in_floats_have_nearly_the_same_area(case: PathCase) -> None:
    points = [*case.path.points, *case.path.points[:1]] if case.path.closed else case.path.points
    rings = [[*ring] for ring in case.shape.rings]
    whole = [sweep_along(rings, *way) for way in pairwise([*points, points[-1]])]
    assert shapely.union_all(whole).area == pytest.approx(float(case.sum.area), rel=1e-9)


def test_the_command_lists_sums_with_paths() -> None:
    assert run("corpus", "paths").stdout.count("\n") == len(CASES)
    (line,) = run("corpus", "paths", "paths-slot").stdout.splitlines()
    assert json.loads(line) == find_path_case("paths-slot").data
    assert len(run("corpus", "paths", "--json").stdout.splitlines()) == len(CASES)
    assert "did you mean 'paths-slot'?" in run("corpus", "paths", "path-slot").stderr
