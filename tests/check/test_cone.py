"""Angles that shapes fill at a point, compared with sectors of the compass."""

from fractions import Fraction
from itertools import permutations, product

from exactsweep.check.cone import (
    Cone,
    Ray,
    by_turn,
    find_common_direction,
    find_cones,
    is_between,
)

COMPASS = [(1, 0), (2, 1), (0, 3), (-1, 1), (-2, 0), (-1, -2), (0, -1), (3, -3)]
SIZE = len(COMPASS)
CONES = {
    Cone(COMPASS[i], COMPASS[(i + k) % SIZE]): {(i + n) % SIZE for n in range(k)}
    for i in range(SIZE)
    for k in range(1, SIZE)
}  # with the numbers of the sectors that it fills, sector k starting at direction k


def test_directions_are_sorted_counter_clockwise_from_the_x_axis() -> None:
    assert sorted(set(COMPASS), key=by_turn) == COMPASS
    small = [(Fraction(x, 7), Fraction(y, 7)) for x, y in COMPASS]
    assert sorted(set(small), key=by_turn) == small
    assert by_turn((1, 0)) == by_turn((2, 0)) < by_turn((-1, 0)) == by_turn((-3, 0))


def test_a_cone_contains_the_directions_in_its_sectors() -> None:
    for cone, sectors in CONES.items():
        held = {k for k in range(SIZE) if cone.holds(COMPASS[k])}
        assert held == sectors
        strictly = {k for k in range(SIZE) if cone.surrounds(COMPASS[k])}
        assert strictly == {k for k in sectors if COMPASS[k] != cone.start}


def test_cones_share_a_direction_if_they_share_a_sector() -> None:
    for one, other in product(CONES, repeat=2):
        found = find_common_direction([one], [other])
        assert (found is not None) == bool(CONES[one] & CONES[other])
        if found is not None:
            assert one.surrounds(found)
            assert other.surrounds(found)


def test_a_common_direction_is_searched_among_all_cones() -> None:
    one, other, third = Cone((1, 0), (0, 1)), Cone((-1, 0), (0, -1)), Cone((0, 1), (-1, 0))
    assert find_common_direction([one, other], [third, other]) is not None
    assert find_common_direction([third], [one, other]) is None


def test_alternating_rays_out_and_in_bound_cones() -> None:
    rays = [Ray(COMPASS[k], k % 4 == 0) for k in (0, 2, 4, 5)]
    expected = {Cone(COMPASS[0], COMPASS[2]), Cone(COMPASS[4], COMPASS[5])}
    for order in permutations(rays):
        assert set(find_cones(order)) == expected
    for order in permutations(rays[1:3]):
        assert find_cones(order) == [Cone(COMPASS[4], COMPASS[2])]


def test_a_point_is_between_two_others_on_their_segment() -> None:
    grid = list(product(range(4), range(4)))
    for (ax, ay), (bx, by) in permutations(grid, 2):
        steps = {(ax + (bx - ax) * k / 12, ay + (by - ay) * k / 12) for k in range(13)}
        inside = {p for p in grid if is_between(p, (ax, ay), (bx, by))}
        assert inside == {p for p in grid if p in steps}
