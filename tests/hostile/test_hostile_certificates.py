"""False certificates of all kinds are not proved.

`python -m tests.falsify` tries any number of them.
"""

import copy
from collections.abc import Iterator
from functools import reduce
from random import Random
from typing import Any

import pytest
from small_pairs import SmallPair, breed, draw, draw_shapeless
from tiers import mostly_long

from exactsweep import (
    Polygon,
    Polyline,
    Region,
    inner_fit_polygon,
    minkowski_sum,
    no_fit_polygon,
    sweep,
)
from exactsweep.check import verify
from exactsweep.evidence.proof import add_proof
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import to_fraction

Certificate = dict[str, Any]
INPUT = {"generatrix", "directrix", "container", "part", "shape", "path"}
TINY = "1/1000000000000000000000"


def draw_with_room(rng: Random) -> SmallPair:
    """A pair in which G usually fits into D."""
    generatrix, directrix = draw(rng)
    return SmallPair(generatrix, [[(5 * x, 5 * y) for x, y in ring] for ring in directrix])


KINDS = {
    "monotone": draw,
    "no_fit": draw_shapeless,
    "sweep": draw_shapeless,
    "inner_fit": draw_with_room,
    "sum": draw_shapeless,
}


def add_outline(d: Any, g: Any) -> Any:
    """The sum of D and the exterior of G as a path."""
    return minkowski_sum(d, Polyline(g.exterior.vertices, closed=True))


ANSWERS: dict[str, Any] = {
    "no_fit": no_fit_polygon,
    "inner_fit": inner_fit_polygon,
    "sum": add_outline,
}


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


def list_paths(item: Any, path: tuple[Any, ...] = ()) -> Iterator[tuple[Any, ...]]:
    """List the paths to all lists and numbers in JSON data."""
    if isinstance(item, (list, dict)):
        for key, entry in item.items() if isinstance(item, dict) else enumerate(item):
            if not isinstance(entry, dict):
                yield (*path, key)
            yield from list_paths(entry, (*path, key))


def change(certificate: Certificate, path: tuple[Any, ...], kind: str) -> Certificate | None:
    """Change the value at a path: change a number, drop or repeat an entry of a list."""
    false: Certificate = copy.deepcopy(certificate)
    *way, last = path
    item: Any = reduce(lambda found, key: found[key], way, false)
    if isinstance(item[last], str) and kind in ("move", "scale"):
        by = to_fraction(TINY if kind == "move" else "1/2")
        item[last] = format_fraction(to_fraction(item[last]) + by)
    elif isinstance(item[last], list) and kind in ("drop", "repeat") and isinstance(item, list):
        item[last : last + 1] = [] if kind == "drop" else [item[last]] * 2
    else:
        return None
    return false


def changed(certificate: Certificate, rng: Random) -> Iterator[tuple[object, Certificate]]:
    """Change the answer at some paths, with the old proof and with a new one."""
    answer = certificate.keys() - INPUT - {"format", "version", "claim", "proof"}
    paths = [(key, *path) for key in sorted(answer) for path in list_paths(certificate[key])]
    paths += [("area",)] * ("area" in answer)
    for path in rng.sample(paths, min(len(paths), 12)):
        for kind in ("move", "scale", "drop", "repeat"):
            false = change(certificate, path, kind)
            if false is not None:
                yield (path, kind), false
                yield (path, kind, "new proof"), add_proof(false)


@pytest.mark.parametrize("kind", mostly_long(KINDS, ["inner_fit"]))
def test_changed_certificates_are_not_proved(kind: str) -> None:
    tried = 0
    rng = Random(7)
    for pair, certificate in certificates(kind, 4):
        assert verify(certificate).proved, pair
        for name, false in changed(certificate, rng):
            found = verify(false)
            assert not found.proved or is_repeated(name), (name, pair)
            tried += 1
    assert tried >= 40


def is_repeated(name: Any) -> bool:
    """Return whether a list repeats a point consecutively, which changes no ring."""
    return name[1] == "repeat" and name[0][0] == "regions" and len(name[0]) > 3


@pytest.mark.parametrize("kind", mostly_long(KINDS, ["no_fit"]))
def test_answers_to_other_questions_are_not_proved(kind: str) -> None:
    """Pairs that differ in one or two vertices, each with the answer for the other."""
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
def test_translated_and_scaled_answers_are_not_proved(kind: str) -> None:
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
    """Scale and translate all numbers of an answer, which are its strings."""
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
