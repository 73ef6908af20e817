"""Certificates that are false, of all kinds: none is proved.

`python -m tests.tampering` and `python -m tests.campaign` try as many as one likes.
"""

from collections.abc import Iterator
from random import Random
from typing import Any

import pytest
import tampering
from shape_certificates import falsified
from small_pairs import SmallPair, breed, draw, draw_shapeless

from exactsweep import Polygon, Region, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.check import verify
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import to_fraction

Certificate = dict[str, Any]
INPUT = {"generatrix", "directrix", "container", "part", "direction", "reference", "kind"}


def draw_with_room(rng: Random) -> SmallPair:
    """A pair of which G fits into D, as a rule."""
    generatrix, directrix = draw(rng)
    return SmallPair(generatrix, [[(5 * x, 5 * y) for x, y in ring] for ring in directrix])


KINDS = {
    "monotone": draw,
    "no_fit": draw_shapeless,
    "sweep": draw_shapeless,
    "inner_fit": draw_with_room,
}
ANSWERS: dict[str, Any] = {"no_fit": no_fit_polygon, "inner_fit": inner_fit_polygon}


def certificates(kind: str, count: int) -> Iterator[tuple[SmallPair, Certificate]]:
    rng = Random(f"hostile {kind}")
    for _ in range(count):
        pair = KINDS[kind](rng)
        yield pair, certificate_of(kind, pair)


def certificate_of(kind: str, pair: SmallPair) -> Certificate:
    g, d = (Region(s[0], s[1:]) if s[1:] else Polygon(s[0]) for s in pair)
    answer = ANSWERS[kind](d, g) if kind in ANSWERS else sweep(g, d)
    certificate: Certificate = answer.certificate()
    return certificate


def changed(certificate: Certificate, rng: Random) -> Iterator[tuple[str, Certificate]]:
    """Every kind of single change."""
    if "claim" in certificate:
        yield from falsified(certificate, rng)
    else:
        yield from tampering.changes(certificate, rng)


@pytest.mark.parametrize(
    ("kind", "at_least"), [("monotone", 280), ("no_fit", 50), ("sweep", 100), ("inner_fit", 15)]
)
def test_no_changed_certificate_is_proved(kind: str, at_least: int) -> None:
    tried = 0
    rng = Random(7)
    for pair, certificate in certificates(kind, 4):
        assert verify(certificate).proved, pair
        for name, false in changed(certificate, rng):
            assert not verify(false).proved, (name, pair)
            tried += 1
    assert tried >= at_least


@pytest.mark.parametrize("kind", KINDS)
def test_no_answer_to_another_question_is_proved(kind: str) -> None:
    """Pairs that differ in one vertex or two, and the answer of the one for the other."""
    rng = Random(11)
    tried = 0
    for pair, certificate in certificates(kind, 10):
        other = breed(rng, pair)
        found = certificate_of(kind, other)
        if found.keys() != certificate.keys():
            continue
        for one, two in ((certificate, found), (found, certificate)):
            spliced = {key: (one if key in INPUT else two)[key] for key in one}
            assert verify(spliced).proved == (spliced == one), (pair, other)
            tried += spliced != one
    assert tried >= 6


@pytest.mark.parametrize("kind", KINDS)
def test_no_answer_that_is_moved_or_scaled_as_a_whole_is_proved(kind: str) -> None:
    tried = 0
    for pair, certificate in certificates(kind, 8):
        for by, factor in (("1/1000000", "1"), ("0", "1000001/1000000"), ("1", "2"), ("0", "-1")):
            false = {
                key: value if key in INPUT else moved(value, by, factor, key == "area")
                for key, value in certificate.items()
            }
            if false != certificate:
                assert not verify(false).proved, (by, factor, pair)
                tried += 1
    assert tried >= 12


def moved(item: Any, by: str, factor: str, is_area: bool) -> Any:
    """All numbers of an answer, which are the strings in it, times a factor and moved."""
    if isinstance(item, list):
        return [moved(entry, by, factor, is_area) for entry in item]
    if isinstance(item, dict):
        return {key: moved(entry, by, factor, is_area) for key, entry in item.items()}
    if not isinstance(item, str) or not item.lstrip("-")[:1].isdigit():
        return item
    times = to_fraction(factor)
    if is_area:
        return format_fraction(to_fraction(item) * times**2)
    return format_fraction(to_fraction(item) * times + to_fraction(by))
