"""Crossings of segments, and the remaining pieces, in all small cases."""

from fractions import Fraction
from itertools import pairwise, product
from random import Random

import pytest

from exactsweep.geometry import near
from exactsweep.numbers.number import Rational
from exactsweep.procedures import crossings
from exactsweep.procedures.crossings import cut, find_point, measure_keys, record_crossing
from exactsweep.procedures.segments import ContactSegment, Cut, Sides

BOTH: list[Sides] = [(False, False), (False, True), (True, False), (True, True)]
DIRECTIONS = [(1, 0), (2, 1), (1, 1), (1, 2), (0, 1), (1, -2), (1, -1), (3, -1)]


def through(
    x: Rational, y: Rational, direction: tuple[int, int], before: int, after: int
) -> ContactSegment:
    """Return a segment from k steps before a point to j steps after it."""
    dx, dy = direction
    at, step = (x, dx) if dx else (y, dy)
    c, e = Fraction(dx * y - dy * x).as_integer_ratio()
    low, high = at - before * step, at + after * step
    return ContactSegment((e * dx, e * dy, c), low, high, (True, False))


def expect(
    one: ContactSegment, other: ContactSegment, x: Rational, y: Rational
) -> tuple[bool, bool, Sides]:
    """Return the record of a cut: overlap before, after and on both sides of the other segment."""
    place = x if other.line[0] else y
    left, right = other.sides
    if place == other.low:
        left, right = other.low_sides
    elif place == other.high:
        left, right = other.high_sides
    comes_from_left = other.line[0] * one.line[1] - other.line[1] * one.line[0] < 0
    return (left, right, other.sides) if comes_from_left else (right, left, other.sides)


@pytest.mark.parametrize(
    ("x", "y"),
    [(0, 0), (3, -5), (Fraction(1, 2), Fraction(1, 2)), (Fraction(3, 4), Fraction(1, 2))],
)
def test_two_segments_record_the_sides_of_the_other(x: Rational, y: Rational) -> None:
    rng = Random(f"{x}")
    spans = [(0, 2), (1, 1), (2, 0)]
    for direction, other_direction, span, other_span in product(
        DIRECTIONS, DIRECTIONS, spans, spans
    ):
        one, other = through(x, y, direction, *span), through(x, y, other_direction, *other_span)
        for segment in one, other:
            segment.sides, segment.low_sides, segment.high_sides = rng.choices(BOTH, k=3)
        bits = measure_keys([one, other])
        record_crossing(one, other, bits)
        if direction == other_direction:
            assert one.cuts == other.cuts == []
            continue
        for segment, crossed in (one, other), (other, one):
            ((key, n, d, *noted),) = segment.cuts
            place = Fraction(n, d)
            assert place == (x if segment.line[0] else y)
            assert key == place * 2**bits // 1
            assert tuple(noted) == expect(segment, crossed, x, y)


def test_segments_that_end_before_they_meet_have_no_cuts() -> None:
    for direction, other_direction in product(DIRECTIONS, DIRECTIONS):
        for span, other_span in [((-1, 2), (1, 1)), ((2, -1), (0, 2)), ((1, 1), (-1, 2))]:
            one, other = (
                through(1, 2, direction, *span),
                through(1, 2, other_direction, *other_span),
            )
            record_crossing(one, other, measure_keys([one, other]))
            assert one.cuts == other.cuts == []


def test_parameters_that_nearly_agree_have_different_keys() -> None:
    """Two lines cross a third one at parameters that differ by about 2 / (u v)."""
    third = ContactSegment((1, 0, 0), 0, 5, (True, False))
    for u, v in [(2**40, 2**40 + 1), (2**40 - 1, 2**40), (10**30, 10**30 + 1)]:
        third.cuts.clear()
        others = [ContactSegment((w, 2 * w + 1, -2 * w - 2), 0, 5, (True, False)) for w in (u, v)]
        bits = measure_keys([third, *others])
        for other in others:
            record_crossing(third, other, bits)
        (first, n, d, *_), (last, m, e, *_) = third.cuts
        assert first != last
        assert (first < last) == (Fraction(n, d) < Fraction(m, e))


def segments(shift: Rational) -> list[ContactSegment]:
    rng = Random(7)
    return [
        through(
            rng.randint(-6, 6) + shift,
            rng.randint(-6, 6) + shift,
            rng.choice(DIRECTIONS),
            0,
            rng.randint(1, 3),
        )
        for _ in range(60)
    ]


@pytest.mark.parametrize("few", [1, 6, 1000])
@pytest.mark.parametrize("shift", [0, Fraction(1, 3)])
def test_crossing_segments_are_cut(
    shift: Rational, few: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With ends and lines between the points of the grid, too."""
    monkeypatch.setattr(near, "PER_ROW", few)
    found, expected = segments(shift), segments(shift)
    cut(found)
    bits = measure_keys(expected)
    for k, one in enumerate(expected):
        for other in expected[:k]:
            record_crossing(one, other, bits)
    assert sum(len(segment.cuts) for segment in found) > 100
    for one, other in zip(found, expected, strict=True):
        assert sorted(one.cuts) == sorted(other.cuts)


def test_boxes_contain_the_ends() -> None:
    for shift in (0, Fraction(1, 3), Fraction(-2, 7)):
        for segment in segments(shift):
            left, right, low, high = segment.box
            ends = [
                find_point(segment.line, *end.as_integer_ratio())
                for end in (segment.low, segment.high)
            ]
            xs, ys = ([Fraction(end[k], end[2]) for end in ends] for k in (0, 1))
            assert 0 <= min(xs) - left < 1 > right - max(xs) >= 0
            assert 0 <= min(ys) - low < 1 > high - max(ys) >= 0


def test_remaining_pieces_match_those_without_cuts() -> None:
    """Each point at which a piece may begin or end, once."""
    rng = Random(1)
    for _ in range(600):
        segment = ContactSegment((1, 0, 0), 0, 4, rng.choice(BOTH[1:]))
        segment.keys = 0, 4
        cuts: list[Cut] = [
            (place, place * scale, scale, rng.random() < 0.3, rng.random() < 0.3, rng.choice(BOTH))
            for place, scale in (
                (rng.randint(0, 4), rng.randint(1, 3)) for _ in range(rng.randint(0, 5))
            )
        ]
        segment.cuts = cuts
        at: dict[int, list[Cut]] = {0: [], 4: []}
        for noted in cuts:
            at.setdefault(noted[0], []).append(noted)
        places = sorted(at)
        covered_after = {p for p in places if any(noted[4] for noted in at[p])}
        covered_before = {p for p in places if any(noted[3] for noted in at[p])}
        expected = [
            (p, q)
            for p, q in pairwise(places)
            if p not in covered_after and q not in covered_before
        ]
        is_two_sided = segment.sides == (True, True)
        suspected = {
            p
            for p, here in at.items()
            if len(here) > 1 or (is_two_sided and any(noted[5] == (True, True) for noted in here))
        }
        meetings: set[tuple[int, int, int]] = set()
        left = crossings._find_remaining(segment, meetings)
        assert [(p[0], q[0]) for p, q in left] == expected
        assert meetings == {(p, 0, 1) for p in suspected}
