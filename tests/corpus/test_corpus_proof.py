"""Every shipped case is verified by a new sweep, by its certificate and by another program."""

import importlib.util
from dataclasses import replace
from itertools import islice

import pytest
from builders.shipping import again, unproved
from campaign import ask_sfcgal
from tiers import few_or_all

from exactsweep import Polygon
from exactsweep.corpus import cases, themes

# Proofs of larger pairs take seconds to find; they were proved when they were built.
PROVED_QUICKLY = 150
# The other program takes seconds for each larger pair: `exactsweep corpus export | python
# tests/support/sfcgal_sweep.py` asks it for all.
SUMMED_QUICKLY = 100
# SFCGAL ends with a segmentation fault.
CRASHING = {
    "jigsaw-mould-slanted",
    "plates-letters",
    "rectilinear-uneven-around-bar",
    "rectilinear-uneven-around-e",
    "sampled-combs-0",
    "sampled-mould-0",
    "sampled-rings-0",
    "spirals-inverse",
    "spirals-inverse-slanted",
    "spirals-inverse-thirds",
    "spirals-two",
    "spirals-two-thirds",
}


needs_sfcgal = pytest.mark.skipif(
    importlib.util.find_spec("pysfcgal") is None, reason="pysfcgal is not installed"
)


@few_or_all
@pytest.mark.parametrize("theme", themes())
def test_answers_and_flags_are_those_of_a_sweep_whose_certificate_is_proved(
    theme: str, step: int
) -> None:
    for case in islice(cases(prefix=f"{theme}-"), None, None, step):
        assert again(case) == case, case.id
        if case.size <= PROVED_QUICKLY:
            assert list(unproved(case)) == [], case.id


@needs_sfcgal
@pytest.mark.long
def test_answers_are_those_of_another_exact_program() -> None:
    asked = [case for case in cases(max_size=SUMMED_QUICKLY) if case.id not in CRASHING]
    assert {c.id: said for c, said in zip(asked, ask_sfcgal(asked), strict=True) if said} == {}


@needs_sfcgal
def test_the_other_program_finds_errors_and_continues_after_a_crash() -> None:
    (case,) = cases(prefix="caves-two-rooms-thirds")
    (crashing,) = cases(prefix="spirals-two-thirds")
    assert not case.unswept
    square = Polygon([(0, 0), (1, 0), (1, 1)])
    wrong = [
        replace(case, trajectory=Polygon(case.trajectory.vertices[1:])),
        replace(case, holes=case.holes[1:]),
        replace(case, holes=(*case.holes, square)),
        crashing,
        replace(case, outer=case.trajectory, area=case.trajectory.area - case.inner.area),
        replace(case, inner=square, area=case.outer.area - square.area),
        replace(case, unswept=(square,), area=case.area - square.area),
        case,
    ]
    parts = ("trajectory", "holes", "holes", "", "outer", "unswept", "unswept")
    said = [f"differs: {part}" if part else "crashes: signal 11" for part in parts]
    assert list(ask_sfcgal(wrong)) == [*said, ""]
