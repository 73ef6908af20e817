"""Reading of certificates: strict, and without exceptions for any content."""

from __future__ import annotations

import copy
import json
from contextlib import suppress
from random import Random
from typing import Any

import pytest
from certified import Certificate, certificates, two_ls
from tampering import put

from exactsweep.check import verify
from exactsweep.check.standalone import WORK, Refused, load, number, prove

JUNK: list[Any] = [None, True, False, 0, -1, 10**5000, 1.5, float("nan"), "", "x", "0", "1/0", "-0"]
JUNK += [
    "9" * 5000,
    [],
    [[]],
    ["0"],
    ["0", "0"],
    {},
    {"exterior": []},
    [{}],
    "\ud800",
    b"0",
    (),
    {1},
]


def list_places(item: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    entries = item.items() if type(item) is dict else enumerate(item) if type(item) is list else ()
    return [path, *(found for key, value in entries for found in list_places(value, (*path, key)))]


@pytest.mark.parametrize("name", ["cave", "SS", "island", "layout"])
def test_every_certificate_is_rejected_or_proved(name: str) -> None:
    rng = Random(name)
    certificate = two_ls() if name == "layout" else certificates()[name]
    places = list_places(certificate)[1:]
    for _ in range(150):
        changed = copy.deepcopy(certificate)
        for _ in range(rng.choice([1, 1, 2])):
            path = rng.choice(places)
            with suppress(KeyError, IndexError, TypeError, AttributeError):
                changed = put(changed, path, rng.choice(JUNK))
        try:
            prove(changed)
        except Refused:
            continue


@pytest.mark.parametrize(
    "item", [*JUNK[:-3], object(), type, lambda: 0], ids=lambda i: str(type(i))
)
def test_other_values_are_rejected(item: Any) -> None:
    verdict = verify(item)
    assert not verdict.proved
    assert not verify({**two_ls(), "layout": item}).proved


def test_recursive_lists_are_rejected() -> None:
    ring: list[Any] = []
    ring += [ring] * 3
    certificate: Certificate = {**two_ls(), "turns": ring}
    with pytest.raises(Refused, match="not a list of 2 entries"):
        prove(certificate)


class Liar(str):
    """A string that equals everything."""

    __slots__ = ()

    def __eq__(self, other: object) -> bool:
        return True

    __hash__ = str.__hash__


@pytest.mark.parametrize("key", ["format", "claim"])
def test_non_json_types_are_rejected(key: str) -> None:
    certificate = certificates()["cave"]
    assert not verify({**certificate, key: Liar("no_fit")}).proved
    assert not verify({**certificate, "version": 3.0}).proved


FORMS = "+1, 1,1 ,1\n,2/2,1/1,01,1.0,1e0,\u0661,--1,-0,0/1,,1/0,1_0,1/2/3,-,/2,1/,2/4,-0/1,0/5"


@pytest.mark.parametrize("text", FORMS.split(","))
def test_numbers_have_one_form(text: str) -> None:
    with pytest.raises(Refused):
        number("x", text)


@pytest.mark.parametrize("digits", [5, 4300, 4301, 20_000])
def test_long_numbers_are_read(digits: int) -> None:
    assert number("x", "1" + "0" * digits) == 10**digits
    assert number("x", "-1/1" + "0" * digits) * 10**digits == -1
    with pytest.raises(Refused, match="not a number in a string"):
        number("x", "1" * 100_001)


def test_the_step_limit_depends_on_the_size_or_the_caller() -> None:
    certificate = certificates()["SS"]
    assert prove(certificate, 10**6)
    with pytest.raises(Refused, match="too large"):
        prove(certificate, 10**3)
    long = put(certificate, ("exterior", 0, 0), "1" * 9000)
    with pytest.raises(Refused):
        prove(long)


def test_letters_that_json_escapes_do_not_raise_the_limit() -> None:
    limits = set[float]()
    for letter in "a\x7f\u0663":
        with suppress(Refused):  # the placements are of no part
            prove(put(two_ls(), ("layout", "parts", 0, "id"), letter * 10**6))
        limits.add(WORK.get()[0])
    assert len(limits) == 1


def test_duplicate_keys_are_rejected() -> None:
    text = json.dumps(two_ls())
    assert prove(load(text))
    with pytest.raises(Refused, match="duplicate key"):
        load(text.replace('"turns": [[', '"turns": [], "turns": [[', 1))


@pytest.mark.parametrize("name", ["inside", "layout"])
def test_frames_of_long_numbers_are_read(name: str) -> None:
    certificate = two_ls() if name == "layout" else certificates()[name]
    far = "1" + "0" * 5000
    changed = put(certificate, ("proof", "frame"), ["-" + far, "-" + far, far, far])
    with pytest.raises(Refused, match="do not cancel"):
        prove(changed)
