"""Every shipped case is proved again: by a new sweep, by its certificate, by another program."""

import importlib.util
from dataclasses import replace
from fractions import Fraction
from itertools import islice

import pytest
from builders.shipping import again, unproved
from campaign import ask_sfcgal
from tiers import few_or_all

from exactsweep import Point, Polygon
from exactsweep.check import reference_inner_fit, reference_no_fit
from exactsweep.corpus import cases, themes
from exactsweep.numbers.number import Fit

# Certificates of larger pairs take up to minutes; they were proved when they were built.
PROVED_QUICKLY = {"CC": 300, "CM": 150, "MM": 150, "SS": 32}
BY_DEFINITION = 24
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
        if case.size <= PROVED_QUICKLY[case.kind]:
            assert list(unproved(case)) == [], case.id


@needs_sfcgal
@pytest.mark.long
def test_answers_are_those_of_another_exact_program() -> None:
    asked = [case for case in cases(max_size=SUMMED_QUICKLY) if case.id not in CRASHING]
    assert {c.id: said for c, said in zip(asked, ask_sfcgal(asked), strict=True) if said} == {}


@needs_sfcgal
def test_the_other_program_notices_what_is_wrong_and_goes_on_after_a_crash() -> None:
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


@few_or_all
@pytest.mark.parametrize("theme", themes())
def test_fits_and_positions_inside_are_those_of_the_definition(theme: str, step: int) -> None:
    """Of these the other program says nothing, or crashes."""
    for case in islice(cases(prefix=f"{theme}-", max_size=BY_DEFINITION), None, None, step):
        if case.inner_regions is None:
            continue
        back = (-case.reference.x, -case.reference.y)
        around = reference_no_fit(case.directrix, case.generatrix)
        inside = reference_inner_fit(case.directrix, case.generatrix)
        assert moved(case.exact_fits, back) == around.exact_fits, case.id
        assert moved(case.inner_exact_fits, back) == inside.exact_fits, case.id
        regions = tuple(region.translated(back).rings for region in case.inner_regions)
        assert regions == tuple((exterior, *holes) for exterior, holes in inside.regions), case.id


def moved(fits: tuple[Fit, ...], by: tuple[Fraction, Fraction]) -> tuple[Fit, ...]:
    (dx, dy) = by
    return tuple((Point(p.x + dx, p.y + dy), Point(q.x + dx, q.y + dy)) for p, q in fits)
