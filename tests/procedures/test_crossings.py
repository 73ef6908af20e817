"""Crossings of stretches, and what is left of stretches by them: small cases, all of them."""

from collections.abc import Iterator
from fractions import Fraction
from itertools import pairwise, product
from random import Random

import pytest

from exactsweep.geometry import near
from exactsweep.numbers.number import Point, Rational
from exactsweep.procedures.contact_lines import Cut, Stretch, _rank
from exactsweep.procedures.crossings import cross, cut_at_crossings
from exactsweep.procedures.free_positions import (
    _find_left_over,
    _find_next,
    _hang,
)

BOTH = [(False, False), (False, True), (True, False), (True, True)]
WAYS = [(1, 0), (2, 1), (1, 1), (1, 2), (0, 1), (1, -2), (1, -1), (3, -1)]


def through(x: Rational, y: Rational, way: tuple[int, int], before: int, after: int) -> Stretch:
    """From so many steps before a point to so many after it."""
    dx, dy = way
    at, step = (x, dx) if dx else (y, dy)
    line = dx, dy, dx * y - dy * x
    return Stretch(line, at - before * step, at + after * step, True, False)


def meet(one: Stretch, other: Stretch, x: Rational, y: Rational) -> tuple[bool, bool, bool]:
    """Decide whether the other proves overlap just before and after, and on both sides."""
    place = Fraction(x if other.dx else y)
    sides: tuple[bool, bool] | None = other.left, other.right
    if place == Fraction(*other.low):
        sides = other.low_through
    elif place == Fraction(*other.high):
        sides = other.high_through
    left, right = sides or (False, False)
    comes_from_left = other.dx * one.dy - other.dy * one.dx < 0
    twice = other.left and other.right
    return (left, right, twice) if comes_from_left else (right, left, twice)


@pytest.mark.parametrize(
    ("x", "y"),
    [(0, 0), (3, -5), (Fraction(1, 2), Fraction(1, 2)), (Fraction(3, 4), Fraction(1, 2))],
)
def test_two_stretches_note_what_is_beside_the_other(x: Rational, y: Rational) -> None:
    rng = Random(f"{x}")
    spans = [(0, 2), (1, 1), (2, 0)]
    for way, other_way, span, other_span in product(WAYS, WAYS, spans, spans):
        one, other = through(x, y, way, *span), through(x, y, other_way, *other_span)
        for stretch in one, other:
            stretch.left, stretch.right = rng.choice(BOTH)
            stretch.low_through = rng.choice([None, *BOTH])
            stretch.high_through = rng.choice([None, *BOTH])
        cross(one, other)
        if way == other_way:
            assert one.cuts == other.cuts == []
            continue
        for stretch, crossed in (one, other), (other, one):
            ((key, (n, d), *noted),) = stretch.cuts
            place = Fraction(n) / d
            assert place == (x if stretch.dx else y)
            assert key == place * 2**32
            assert tuple(noted) == meet(stretch, crossed, x, y)


def test_stretches_that_end_before_they_meet_have_no_cuts() -> None:
    for way, other_way in product(WAYS, WAYS):
        for span, other_span in [((-1, 2), (1, 1)), ((2, -1), (0, 2)), ((1, 1), (-1, 2))]:
            one, other = through(1, 2, way, *span), through(1, 2, other_way, *other_span)
            cross(one, other)
            assert one.cuts == other.cuts == []


def test_a_piece_of_a_stretch_is_covered_where_it_was_cut() -> None:
    whole = Stretch((1, 0, 0), 2, 9, True, False)
    whole.low_through, whole.high_through = (True, False), (False, True)
    for low, high in product((1, 2, 3), (8, 9, 1)):
        piece = whole.between(low, high)
        assert (piece.low, piece.high) == ((low, 1), (high, 1))
        assert (piece.low_covered, piece.high_covered) == (low != 2, high != 9)
        assert (piece.low_through, piece.high_through) == ((True, False), (False, True))


def test_directions_that_are_nearly_one_are_in_order_of_slope() -> None:
    near = [(2**41, 1), (2**40, 3), (2**40, 5)]
    assert _rank(near[::-1]) == (near, {u: k for k, u in enumerate(near)})
    others = [(1, -1), *near, (1, 1), (0, 1)]
    assert _rank(others[::-1]) == (others, {u: k for k, u in enumerate(others)})


def stretches() -> list[Stretch]:
    rng = Random(7)
    return [
        through(rng.randint(-6, 6), rng.randint(-6, 6), rng.choice(WAYS), 0, rng.randint(1, 3))
        for _ in range(60)
    ]


@pytest.mark.parametrize("few", [1, 6, 1000])
def test_all_that_cross_are_cut(monkeypatch: pytest.MonkeyPatch, few: int) -> None:
    """With ends and lines between the points of the grid, too."""
    monkeypatch.setattr(near, "_FEW", few)
    found, expected = stretches(), stretches()
    for shift in 0, Fraction(1, 3):
        for stretch in (*found, *expected):
            # Each line moved by as much.
            stretch.c, stretch.e = (Fraction(stretch.c, stretch.e) + shift).as_integer_ratio()
            stretch.low, stretch.high = (
                (Fraction(*place) + shift).as_integer_ratio()
                for place in (stretch.low, stretch.high)
            )
            stretch.cuts.clear()
        cut_at_crossings(found)
        for k, one in enumerate(expected):
            for other in expected[:k]:
                cross(one, other)
        assert sum(len(stretch.cuts) for stretch in found) > 100
        for one, other in zip(found, expected, strict=True):
            assert sorted(one.cuts) == sorted(other.cuts)


def test_the_key_of_a_cut_is_no_greater_than_its_place() -> None:
    one, other = Stretch((5, 3, 1), -9, 9, True, False), Stretch((7, -4, 2), -9, 9, True, False)
    cross(one, other)
    ((key, (n, d), *_),), ((other_key, (m, e), *_),) = one.cuts, other.cuts
    assert Fraction(n, d) == Fraction(m, e) == Fraction(3, 41)
    assert key == other_key == 3 * 2**32 // 41


def cuts(rng: Random) -> Iterator[Cut]:
    for _ in range(rng.randint(0, 5)):
        place = rng.randint(0, 4)
        scale = rng.randint(1, 3)
        # One key for two places.
        before, after, twice = (rng.random() < 0.3 for _ in range(3))
        yield place // 2, (place * scale, scale), before, after, twice


def test_what_is_left_of_a_stretch_is_what_no_cut_covers() -> None:
    """Of all places at which something may begin or end, each once."""
    rng = Random(1)
    for _ in range(600):
        stretch = Stretch((1, 0, 0), 0, 4, *rng.choice(BOTH[1:]))
        stretch.low_covered, stretch.high_covered = rng.random() < 0.2, rng.random() < 0.2
        stretch.cuts = [*cuts(rng)]
        at: dict[Fraction, list[Cut]] = {Fraction(0): [], Fraction(4): []}
        for cut in stretch.cuts:
            at.setdefault(Fraction(*cut[1]), []).append(cut)
        places = sorted(at)
        covered_after = {p for p in places if any(cut[3] for cut in at[p])}
        covered_before = {p for p in places if any(cut[2] for cut in at[p])}
        covered_after |= {places[0]} if stretch.low_covered else set()
        # A cut at the end says itself what is before it.
        covered_before |= {places[-1]} if stretch.high_covered and not at[places[-1]] else set()
        expected = [
            (p, q)
            for p, q in pairwise(places)
            if p not in covered_after and q not in covered_before
        ]
        twice = stretch.left and stretch.right
        suspected = {
            p for p, here in at.items() if len(here) > 1 or (twice and any(cut[4] for cut in here))
        }
        suspects: set[tuple[int, int, int, int]] = set()
        left = _find_left_over(stretch, suspects)
        assert [(Fraction(*p), Fraction(*q)) for p, q in left] == expected
        assert suspects == {(int(p), 1, 0, 1) for p in suspected}


COMPASS = [(1, 0), (2, 1), (1, 1), (0, 1), (-1, 1), (-1, 0), (-2, -1), (-1, -1), (0, -1), (1, -1)]


@pytest.mark.parametrize("turns", [1, -1])
def test_the_next_piece_is_the_first_counter_clockwise_from_the_way_back(turns: int) -> None:
    """Never the way back itself, if there is another one."""
    for back, first, second in product(range(10), repeat=3):
        if first == second:
            continue
        (x, y), *ways = (COMPASS[k] for k in (back, first, second))
        here = (0, 1, 0, 1)
        pieces = [(here, here, -x, -y), *((here, here, dx, dy) for dx, dy in ways)]
        found = _find_next(pieces, pieces[0], [1, 2][::turns])
        expected = min((1, 2), key=lambda k: ((first, second)[k - 1] - back - 1) % 10)
        assert found == expected


def test_the_end_on_a_loop_comes_first_if_only_one_is() -> None:
    p, q = (0, 1, 0, 1), (1, 1, 3, 2)
    near, far = Point(Fraction(0), Fraction(0)), Point(Fraction(1, 5), Fraction(3, 10))
    there, back = (near, far), (far, near)
    for bounding, expected in [({p}, there), ({q}, back), ({p, q}, there), (set(), there)]:
        assert _hang((p, q), bounding, 5) == expected
