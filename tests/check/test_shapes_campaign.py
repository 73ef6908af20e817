"""The campaign over shapes: it begins without mismatch, and notices what is wrong."""

import random
from types import SimpleNamespace
from typing import Any

import pytest
import shapes_campaign as campaign
from cells import Holed, grid
from shape_certificates import inner_fit_certificate, no_fit_certificate, sweep_certificate
from shape_families import SHAPES, ShapePair, random_shapes

from exactsweep import Polygon
from exactsweep.check import reference_inner_fit, reference_no_fit

PAIR = ShapePair(
    "by hand", "as built", grid("#####", "#.#.#", "###.#", "#.#.#", "#####"), grid("#")
)
ROOMS = ShapePair("by hand", "as built", grid("####", "#..#", "#..#", "####"), grid("#"))


@pytest.mark.parametrize("family", SHAPES)
def test_reference_and_classify_agree_on_a_few_pairs(family: str) -> None:
    for number in range(8):
        outcome = campaign.try_shapes(2, (family,), ("classify",), number)
        assert outcome.failure == "", number


def test_pairs_are_known_by_their_seed() -> None:
    first, second = (random_shapes(random.Random("1:7")) for _ in range(2))
    assert first == second


def answer(d: Any, g: Any) -> SimpleNamespace:
    """A no-fit polygon as the kernel gives it."""
    exterior, holes, fits = reference_no_fit(d, g)
    loops = tuple(map(Polygon, holes))
    return SimpleNamespace(exterior=Polygon(exterior), holes=loops, exact_fits=fits)


def inside(container: Any, part: Any) -> SimpleNamespace:
    regions, fits = reference_inner_fit(container, part)
    made = tuple(Holed(Polygon(e), tuple(map(Polygon, holes))) for e, holes in regions)
    return SimpleNamespace(regions=made, exact_fits=fits)


@pytest.mark.parametrize(
    ("pair", "way", "changed", "failure"),
    [
        (PAIR, "no_fit", {}, ""),
        (PAIR, "no_fit", {"exact_fits": ()}, "no_fit: exact fits"),
        (ROOMS, "no_fit", {"holes": ()}, "no_fit: holes"),
        (ROOMS, "no_fit", {"exterior": PAIR.directrix.exterior}, "no_fit: exterior"),
        (ROOMS, "inner_fit", {}, ""),
        (ROOMS, "inner_fit", {"exact_fits": ()}, "inner_fit: exact fits"),
        (PAIR, "inner_fit", {"regions": (ROOMS.directrix,)}, "inner_fit: regions"),
    ],
)
def test_wrong_answers_are_noticed(
    pair: ShapePair,
    way: str,
    changed: dict[str, Any],
    failure: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def falsely(right: Any) -> Any:
        return lambda d, g: SimpleNamespace(**{**vars(right(d, g)), **changed})

    kernel = SimpleNamespace(
        Region=Holed, no_fit_polygon=falsely(answer), inner_fit_polygon=falsely(inside)
    )
    monkeypatch.setattr(campaign, "kernel", kernel)
    assert campaign.failure_of(pair, (way,), random.Random(1)) == failure


@pytest.mark.parametrize(
    ("answered", "failure"),
    [
        ("PAIR", ""),
        ("ROOMS", "certificates: no_fit: exterior: at the witness G overlaps D"),
    ],
)
def test_certificates_are_proved_and_falsified(
    answered: str, failure: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Certificates whose answer is that for another pair are not proved."""
    pair = {"PAIR": PAIR, "ROOMS": ROOMS}[answered]
    answers = no_fit_certificate(pair.directrix, pair.generatrix)
    keys = ("exterior", "holes", "exact_fits")

    def written(certificate: Any) -> SimpleNamespace:
        return SimpleNamespace(certificate=lambda: certificate)

    kernel = SimpleNamespace(
        Region=Holed,
        no_fit_polygon=lambda d, g: written(
            {**no_fit_certificate(PAIR.directrix, PAIR.generatrix), **{k: answers[k] for k in keys}}
        ),
        inner_fit_polygon=lambda d, g: written(
            inner_fit_certificate(PAIR.directrix, PAIR.generatrix)
        ),
        sweep=lambda g, d: written(sweep_certificate(PAIR.directrix, PAIR.generatrix)),
    )
    monkeypatch.setattr(campaign, "kernel", kernel)
    assert campaign.failure_of(PAIR, ("certificates",), random.Random(1)) == failure


def test_an_error_is_a_mismatch(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(campaign, "kernel", SimpleNamespace(Region=Holed))
    assert campaign.failure_of(PAIR, ("no_fit",), random.Random(1)).startswith("no_fit: Attrib")
