"""Free positions among placed shapes: known answers, and the definition."""

from collections import Counter
from random import Random

import campaign
import pytest
from placed import FAMILIES, draw_scene, expected
from strategies import points

from exactsweep import (
    Point,
    PolygonError,
    Region,
    free_positions,
    inner_fit_polygon,
)

Corners = list[tuple[int, int]]


def box(left: int, low: int, right: int, high: int) -> Corners:
    return [(left, low), (right, low), (right, high), (left, high)]


UNIT = box(0, 0, 1, 1)
BIN = box(0, 0, 4, 3)


def fits(*ends: tuple[object, object]) -> tuple[tuple[Point, ...], ...]:
    found = points(*ends)
    return tuple(zip(found[::2], found[1::2], strict=True))


def test_without_placed_shapes_free_positions_are_the_inner_fit() -> None:
    assert free_positions(BIN, [], UNIT) == inner_fit_polygon(BIN, UNIT)
    assert free_positions(BIN, [], UNIT).regions == (Region(box(0, 0, 3, 2)),)


def test_a_gap_between_two_placed_shapes() -> None:
    # Two chambers, the gap between them as wide as the part.
    walls = [box(3, 0, 4, 2), box(3, 3, 4, 5)]
    f = free_positions(box(0, 0, 7, 5), walls, UNIT)
    assert f.regions == (Region(box(0, 0, 2, 4)), Region(box(4, 0, 6, 4)))
    assert f.exact_fits == fits((2, 2), (4, 2))
    # If slightly wider, it is a corridor; if slightly narrower, it is closed.
    above = [(3, "3.001"), (4, "3.001"), (4, 5), (3, 5)]
    wider = free_positions(box(0, 0, 7, 5), [walls[0], above], UNIT)
    assert (len(wider.regions), wider.exact_fits) == (1, ())
    shut = free_positions(box(0, 0, 7, 5), [walls[0], box(3, 3, 4, 5), box(3, 2, 4, 3)], UNIT)
    assert (len(shut.regions), shut.exact_fits) == (2, ())


def test_the_last_piece_of_a_jigsaw_has_one_position() -> None:
    pieces = [box(0, 0, 2, 1), box(2, 0, 3, 2), box(1, 2, 3, 3), box(0, 1, 1, 3)]
    f = free_positions(box(0, 0, 3, 3), pieces, UNIT)
    assert (f.regions, f.exact_fits) == ((), fits((1, 1), (1, 1)))
    assert f
    assert f.locate((1, 1)) == "boundary"
    assert f.locate((1, "1.000001")) == "outside"
    full = free_positions(box(0, 0, 3, 3), [*pieces, box(1, 1, 2, 2)], UNIT)
    assert (full.regions, full.exact_fits, bool(full)) == ((), (), False)


def test_placed_shapes_may_overlap_and_leave_the_container() -> None:
    # Three equal shapes, two of which would cancel by the even-odd rule.
    once = free_positions(BIN, [box(2, -5, 9, 9)], UNIT)
    twice = free_positions(BIN, [box(2, -5, 9, 9), box(2, -2, 5, 4)], UNIT)
    assert once.regions == twice.regions == (Region(box(0, 0, 1, 2)),)
    assert not free_positions(BIN, [BIN, BIN], UNIT)
    assert free_positions(BIN, [box(4, 0, 5, 9)], UNIT).regions == (Region(box(0, 0, 3, 2)),)


def test_a_part_around_a_placed_shape() -> None:
    ring = Region(box(0, 0, 5, 5), [box(1, 1, 4, 4)])
    f = free_positions(box(0, 0, 8, 5), [box(2, 2, 4, 3)], ring)
    assert (f.regions, f.exact_fits) == ((), fits((0, 0), (1, 0)))


def test_the_reference_moves_the_answer() -> None:
    f = free_positions(BIN, [box(0, 0, 1, 3)], UNIT, reference=("1/2", 5))
    assert f.regions == (Region(box(1, 0, 3, 2)).translated(("1/2", 5)),)
    assert f.locate(("3/2", 5)) == "boundary"
    assert f.locate((2, 6)) == "inside"


def test_an_error_names_the_shape() -> None:
    with pytest.raises(PolygonError, match=r"^placed shape 1: "):
        free_positions(BIN, [UNIT, [(0, 0), (1, 1)]], UNIT)
    with pytest.raises(PolygonError, match="do not cover placed shapes"):
        free_positions(BIN, [UNIT], UNIT).certificate()


def test_positions_on_a_lattice_match_the_definition() -> None:
    assert campaign.find_failures("scenes", 7, range(2)) == []


def test_scenes_have_positions_of_all_kinds() -> None:
    seen: Counter[str] = Counter()
    families: Counter[str] = Counter()
    for number in range(12):
        rng = Random(f"lattice:{number}")
        scene = draw_scene(rng)
        families[scene.family] += 1
        low, _ = scene.container.bounding_box
        for k in range(4):
            seen[expected(scene, Point(low.x + k * scene.step, low.y + k * scene.step))] += 1
    assert families.keys() == FAMILIES.keys()
    assert seen.keys() == {"inside", "boundary", "outside"}
