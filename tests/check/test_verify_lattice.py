"""Certificates are checked on a lattice where there is one of use, and without, with one result."""

from collections import Counter
from fractions import Fraction
from random import Random

import pytest
import tampering
from small_pairs import draw

from exactsweep import Polygon, sweep
from exactsweep.check import loop, size, verify
from exactsweep.check.chain import Line
from exactsweep.check.sums import count_steps
from exactsweep.numbers.point import ORIGIN, Point


@pytest.mark.parametrize("kind", ["CC", "CM", "MM"])
def test_without_a_lattice_the_same_is_proved_and_refused(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """True and changed certificates, with the same reasons and witnesses."""
    rng = Random(f"lattice {kind}")
    seen = Counter[bool]()
    while seen[True] < 3:
        generatrix, directrix = draw(rng)
        thirds, halves = (
            [(Fraction(x, over), Fraction(y, over + 4)) for x, y in shape[0]]
            for over, shape in ((3, generatrix), (2, directrix))
        )
        s = sweep(thirds, halves)
        if s.kind != kind:
            continue
        certificate = s.certificate()
        for _, listed in [("", certificate), *tampering.changes(certificate, rng)]:
            monkeypatch.undo()
            expected = verify(listed)
            for name in ("_SHORT", "_FEW"):
                monkeypatch.setattr(size, name, 0)
            assert verify(listed) == expected
            seen[expected.proved] += 1
    assert seen[False] > 90


def test_numbers_stay_as_long_as_those_of_a_few_points(monkeypatch: pytest.MonkeyPatch) -> None:
    """Once all of 40 were over the product of all denominators: 66 seconds instead of two."""
    longest = 0
    reduce = loop.reduce_line

    def watch(a: int, b: int, c: int) -> Line:
        nonlocal longest
        longest = max(longest, *(abs(n).bit_length() for n in (a, b, c)))
        return reduce(a, b, c)

    monkeypatch.setattr(loop, "reduce_line", watch)
    rng = Random(40)
    parabola = [
        tuple(c + Fraction(1, rng.getrandbits(400) | 1) for c in (k, k * k)) for k in range(24)
    ]
    certificate = sweep(parabola, [(2 * x, 3 * y) for x, y in parabola]).certificate()
    assert verify(certificate).proved
    assert 400 < longest < 20 * 400


def test_exact_fits_are_found_without_a_lattice(monkeypatch: pytest.MonkeyPatch) -> None:
    """A slot, and what fits into it, at unrelated places, of unlike denominators."""
    monkeypatch.setattr(size, "_SHORT", 0)
    monkeypatch.setattr(size, "_FEW", 0)
    left, wide, high = Fraction(1, 5), Fraction(5, 7), Fraction(33, 10)
    low, right = Fraction(51, 97), left + wide
    slot = [(0, 0), (2, 0), (2, high), (right, high), (right, low), (left, low), (left, 4), (0, 4)]
    part = [(x + Fraction(1, 11), y + Fraction(1, 13)) for x in (0, wide) for y in (0, 1)]
    s = sweep([part[0], part[2], part[3], part[1]], slot)
    assert s.exact_fits
    assert verify(s.certificate()).proved
    assert not verify({**s.certificate(), "exact_fits": []}).proved


def test_the_work_is_the_same_without_a_lattice() -> None:
    rng = Random(3)
    compared = 0
    while compared < 20:
        g, d = (
            [Point(Fraction(x, over), Fraction(y, 3)) for x, y in shape[0]]
            for over, shape in zip((3, 7), draw(rng), strict=True)
        )
        s = sweep(g, d)
        if s.kind == "CC" or s.direction != (1, 0):
            continue
        steps = []
        for scale in (1, 21):
            frame = loop.NodeFrame((1, 0), scale)
            trajectory, own, other = (
                loop.MonotoneLoop(frame.enter(p.vertices, ORIGIN), "", frame)
                for p in (s.trajectory, s.generatrix, s.directrix)
            )
            steps.append(count_steps(trajectory, other, own.turn_half()))
        assert steps[0] == steps[1] > 0
        compared += 1


def test_the_shorter_of_two_chains_is_walked_along() -> None:
    """Of a comb around a triangle, all of the comb was walked along at each of its corners."""
    frame = loop.NodeFrame((1, 0), 1)
    triangle = Polygon([(0, 0), (7, 1), (3, 9)])
    found = []
    for teeth in (40, 80):
        steps = [
            (8 * k + x, y) for k in range(teeth) for x, y in ((0, 9), (3, 9), (3, 19), (8, 19))
        ]
        comb = Polygon([(0, 0), (8 * teeth, 0), *steps[::-1]])
        trajectory, own, other = (
            loop.MonotoneLoop(frame.enter(p.vertices, ORIGIN), "", frame)
            for p in (sweep(comb, triangle).trajectory, comb, triangle)
        )
        found.append(count_steps(trajectory, other, own.turn_half()))
        assert found[-1] == count_steps(trajectory, own.turn_half(), other)
    assert found[1] < 2.2 * found[0]
