"""Ends of contact segments that adjacent edges prove to be overlapped."""

from fractions import Fraction

import pytest
from pruned import Overlaps

from exactsweep.geometry.edges import Rings
from exactsweep.numbers.number import Point, Vertex
from exactsweep.procedures.crossings import find_point
from exactsweep.procedures.neighbors import leave_out_overlapped
from exactsweep.procedures.positions import find_no_fit, reflect
from exactsweep.procedures.segments import ContactSegment, find_contact_segments


def zigzag(size: int) -> list[Vertex]:
    """Return a thin zigzag strip."""
    up = [(2 * i, 400 if i % 2 else 0) for i in range(size // 2)]
    return [*up, *((x, y + 3) for x, y in reversed(up))]


def saw(size: int) -> list[Vertex]:
    """Return a saw with tall teeth, which fill half of its bounds."""
    teeth = [(x, 100 if x % 2 else 3) for x in range(size)]
    return [(0, 0), (size - 1, 0), *reversed(teeth)]


def find_left(stationary: Rings, moving: Rings) -> list[ContactSegment]:
    return find_contact_segments(stationary, moving, leave_out_overlapped)


# Zigzags leave two rows of 40 teeth in each direction; saws leave an octagon.
@pytest.mark.parametrize(
    ("ring", "contacts", "few", "corners"), [(zigzag(80), 3200, 236, 236), (saw(81), 3284, 164, 8)]
)
def test_crossing_spikes_leave_little_more_than_the_answer(
    ring: list[Vertex], contacts: int, few: int, corners: int
) -> None:
    moving = [[(y, -x) for x, y in ring]]
    whole, left = find_contact_segments([ring], moving), find_left([ring], moving)
    assert len(whole) == contacts
    assert len(left) <= few
    found = find_no_fit([ring], reflect(moving))
    assert ([len(loop) for loop in found.around], found.within, found.fits) == ([corners], [], [])


@pytest.mark.parametrize("factor", [1, Fraction(1, 3)])
def test_overlap_is_just_inside_each_cut(factor: int | Fraction) -> None:
    strips: Rings = [[(factor * x, factor * y) for x, y in zigzag(60)]]
    orbiting: Rings = [[(-y, x) for x, y in strips[0]]]
    moving = reflect(orbiting)
    overlap = Overlaps(strips, orbiting)
    whole, left = find_contact_segments(strips, moving), find_left(strips, moving)
    natural = {(s.line, end) for s in whole for end in (s.low, s.high)}
    cut = [
        find_point(segment.line, *end.as_integer_ratio())
        for segment in left
        for end in (segment.low, segment.high)
        if (segment.line, end) not in natural
    ]
    assert len(cut) > 10
    assert all(overlap.at(Point(Fraction(x, w), Fraction(y, w))) for x, y, w in cut)
