"""The leeway of a part in the bounds of its container; nothing beyond it is examined."""

from fractions import Fraction
from itertools import pairwise
from typing import Any

import pytest
from covered import find_free, list_corners, rings
from hypothesis import given
from hypothesis import strategies as st
from polyominoes import Cells, polyominoes
from tiers import examples

from exactsweep import Polygon, sweep
from exactsweep.geometry.overlap import Overlap, Rings
from exactsweep.numbers.number import Rational, Vertex
from exactsweep.procedures import ss
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.contact_lines import Stretch, find_contact_stretches
from exactsweep.procedures.cover import Cover
from exactsweep.procedures.crossings import cut_at_crossings
from exactsweep.procedures.leeway import Leeway, find_leeway, frame_outside

MATRICES = st.sampled_from([(1, 0, 0, 1), (7, 0, 0, 7), (5, 3, -2, 9), (8, 8, 0, 4), (6, -1, 6, 5)])
SMALL = st.integers(-6, 6)
HALVES = st.integers(-12, 12).map(lambda n: Fraction(n, 2))


def place(stretch: Stretch, at: Rational) -> tuple[Fraction, Fraction]:
    xn, xd, yn, yd = stretch.vertex(at.as_integer_ratio())
    return Fraction(xn, xd), Fraction(yn, yd)


@st.composite
def stretches(draw: st.DrawFn) -> Stretch:
    line = draw(st.sampled_from([(0, 1), (1, 0), (1, 1), (1, -1), (3, -2), (1, 50), (50, 1)]))
    low, high = sorted(draw(st.sets(HALVES, min_size=2, max_size=2)))
    return Stretch((*line, draw(st.integers(-40, 40))), low, high, True, False)


@given(stretches(), SMALL, st.integers(0, 4), SMALL, st.integers(0, 4))
@examples(150)
def test_what_is_cut_away_lies_outside(
    stretch: Stretch, left: int, width: int, low: int, height: int
) -> None:
    leeway = Leeway(left, left + width, low, low + height)
    kept = stretch.within(leeway)
    start, end = Fraction(*stretch.low), Fraction(*stretch.high)
    ends = [start, end]
    if kept is not None:
        low_end, high_end = Fraction(*kept.low), Fraction(*kept.high)
        ends += [low_end, high_end]
        assert start <= low_end < high_end <= end
        # Just inside of an end that is cut, there is overlap: it is outside of the leeway.
        assert kept.low_covered == (low_end != start)
        assert kept.high_covered == (high_end != end)
        for at, is_cut in ((low_end, kept.low_covered), (high_end, kept.high_covered)):
            assert not (is_cut and is_within(place(kept, at), leeway))
        if kept is not stretch:
            assert start < low_end or high_end < end
        # No end is farther outside than pieces are to extend, with room for rounding.
        for at in (low_end, high_end):
            x, y = place(kept, at)
            assert left - 2 <= x <= left + width + 2
            assert low - 2 <= y <= low + height + 2
    for a, b in pairwise(sorted({*ends, *(start + (end - start) * k / 40 for k in range(41))})):
        middle = (a + b) / 2
        if is_within(place(stretch, middle), leeway):
            assert kept is not None
            assert Fraction(*kept.low) < middle < Fraction(*kept.high)


def is_within(point: tuple[Fraction, Fraction], leeway: Leeway) -> bool:
    x, y = point
    return leeway.left <= x <= leeway.right and leeway.low <= y <= leeway.high


def test_a_leeway_by_hand() -> None:
    container: Rings = [[(0, 0), (7, 0), (7, 5), (0, 5)], [(3, 2), (3, 3), (4, 3), (4, 2)]]
    assert find_leeway(container, [[(-1, 0), (2, 0), (0, 4)]]) == (1, 5, 0, 1)
    assert frame_outside(container) == [
        [(0, 0), (7, 0), (7, 5), (0, 5)],
        [(0, 5), (7, 5), (7, 0), (0, 0)],
        [(4, 2), (4, 3), (3, 3), (3, 2)],
    ]


@pytest.mark.parametrize(
    ("part", "empty"), [((7, 5), False), ((8, 1), True), ((1, 6), True), ((1, 1), False)]
)
def test_a_part_that_is_too_long_or_too_high_has_no_leeway(
    part: tuple[int, int], empty: bool
) -> None:
    a, b = part
    container, moved = [[(0, 0), (7, 0), (7, 5), (0, 5)]], [[(0, 0), (a, 0), (a, b), (0, b)]]
    assert find_leeway(container, moved).is_empty is empty
    assert ss.inner_fit_ss(container, moved).regions == [] or not empty


@given(polyominoes(14, 4), polyominoes(4, 2), MATRICES, st.integers(1, 20))
@examples(60)
def test_what_is_beyond_or_covered_does_not_matter(
    d: Cells, g: Cells, matrix: tuple[int, int, int, int], columns: int
) -> None:
    container, part = rings(d, matrix), rings(g, matrix)
    outside, moving = [ring[::-1] for ring in container], [inverse(ring) for ring in part]
    overlap = Overlap(outside, part, unbounded=True)
    leeway = find_leeway(container, part)
    cover = Cover(frame_outside(container), moving, columns)
    whole = find_contact_stretches(outside, moving)
    near = find_contact_stretches(outside, moving, leeway)
    clipped = [kept for stretch in near if (kept := stretch.within(leeway)) is not None]
    left = [piece for stretch in clipped for piece in cover.uncovered(stretch)]
    assert find_free(whole, overlap) == find_free(left, overlap)


def test_each_corner_of_a_square_that_is_covered_is_outside() -> None:
    # A hexagon in a plate with a defect: its centre is where squares of the frame are, or of the
    # defect, moved by points of the hexagon.
    container: Rings = [
        [(0, 0), (40, 0), (40, 40), (0, 40)],
        [(15, 15), (15, 25), (25, 25), (25, 15)],
    ]
    part: Rings = [[(-6, 0), (-3, -5), (3, -5), (6, 0), (3, 5), (-3, 5)]]
    cover = Cover(frame_outside(container), [inverse(ring) for ring in part], 40)
    overlap = Overlap([ring[::-1] for ring in container], part, unbounded=True)
    corners = list(list_corners(cover))
    assert len(corners) > 400
    assert all(map(overlap.at, corners))


def test_only_segments_near_the_leeway_are_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    # A saw of n teeth around a hook that it cannot leave: of all pairs of teeth those matter that
    # are near each other.
    hook = [(0, 0), (6, 0), (6, 6), (1, 6), (1, 3), (2, 3), (2, 5), (5, 5), (5, 1), (0, 1)]
    counts: list[tuple[int, int, int]] = []
    asked: list[Any] = []

    def find(*given: Any) -> list[Stretch]:
        asked[:] = given
        return find_contact_stretches(*given)

    def count(stretches: list[Stretch]) -> None:
        every, near = find_contact_stretches(*asked[:2]), find_contact_stretches(*asked)
        counts.append((len(every), len(near), len(stretches)))
        cut_at_crossings(stretches)

    for n in (80, 160):
        teeth: list[Vertex] = [(2 * i, 2000 + i * i * 37 % 101) for i in range(n)]
        swept = sweep(Polygon([(0, 0), (2 * n - 2, 0), *teeth[::-1]]), Polygon(hook))
        assert swept.trajectory
        with monkeypatch.context() as patched:
            patched.setattr(ss, "find_contact_stretches", find)
            patched.setattr(ss, "cut_at_crossings", count)
            assert swept.inner
    (few, near, left), (more, still_near, still_left) = counts
    assert more > 3 * few
    assert still_near < 2 * near < few / 4
    assert still_left < 2 * left < few / 4
