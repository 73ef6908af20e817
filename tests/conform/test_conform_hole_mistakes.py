"""Mistakes in the holes of no-fit polygons and in inner fits, by programs that take any shape."""

from collections.abc import Callable
from fractions import Fraction
from itertools import islice
from typing import Any

import pytest
from shipped_cases import shipped_cases

from exactsweep import Point, Polygon
from exactsweep.conform import compare
from exactsweep.conform.judge.witness import list_exact_rings
from exactsweep.corpus import cases

Rings = list[Any]
HOLED = [*islice((c for c in cases(kind="SS") if len(c.holes) > 0), 4)]
MANY = [*islice((c for c in cases(kind="SS") if len(c.holes) > 1), 3)]
CONTAINERS = [*islice((c for c in shipped_cases() if c.inner_regions), 4)]


def shift(ring: Any, by: Fraction) -> list[Point]:
    return [Point(p.x + by, p.y) for p in ring]


def shrink(ring: Any) -> list[Point]:
    """The ring at half its size, about its first vertex."""
    a = ring[0]
    return [Point((a.x + p.x) / 2, (a.y + p.y) / 2) for p in ring]


def drop_smallest(rings: Rings) -> Rings:
    smallest = min(rings[1:], key=lambda ring: Polygon(ring).area)
    return [ring for ring in rings if ring is not smallest]


@pytest.mark.parametrize(
    ("change", "verdicts", "says"),
    [
        (lambda rings: rings[:1], {"conservative"}, "lacks the holes"),
        (lambda rings: [*rings[:-1], shrink(rings[-1])], {"conservative", "wrong"}, "|"),
        (lambda rings: [*rings[:-1], shift(rings[-1], Fraction(1, 10**9))], {"wrong"}, "neither"),
        (lambda rings: rings[1:], {"unsound", "wrong", "conservative"}, "exact no-fit polygon"),
        (lambda rings: [*rings, rings[-1]], {"malformed"}, "overlap"),
    ],
)
def test_a_mistake_in_a_hole_is_convicted(
    change: Callable[[Rings], Rings], verdicts: set[str], says: str
) -> None:
    assert len(HOLED) == 4
    for case in HOLED:
        rings = list(list_exact_rings(case, "no_fit"))
        assert compare(case, {"no_fit": rings, "exact_fits": case.exact_fits}).verdict == "exact"
        found = compare(case, {"no_fit": change(rings), "exact_fits": case.exact_fits})
        assert found.verdict in verdicts, (case.id, found.reason)
        assert any(word in found.reason for word in says.split("|")), found.reason


def test_the_smallest_of_several_holes_cannot_be_dropped() -> None:
    assert len(MANY) == 3
    for case in MANY:
        rings = drop_smallest(list(list_exact_rings(case, "no_fit")))
        found = compare(case, {"no_fit": rings, "exact_fits": case.exact_fits})
        assert found.verdict == "conservative", (case.id, found.reason)


def test_a_region_of_an_inner_fit_cannot_be_dropped_moved_or_invented() -> None:
    assert len(CONTAINERS) == 4
    for case in CONTAINERS:
        fits = {"inner_exact_fits": case.inner_exact_fits}
        rings = list(list_exact_rings(case, "inner_fit"))
        assert compare(case, {"inner_fit": rings, **fits}).verdict == "exact", case.id
        moved = [shift(rings[0], Fraction(1, 10**9)), *rings[1:]]
        assert compare(case, {"inner_fit": rings[:-1], **fits}).verdict != "exact"
        for wrong, good in ((rings[:-1], {"conservative"}), (moved, {"unsound", "wrong"})):
            found = compare(case, {"inner_fit": wrong, **fits})
            assert found.verdict in good, (case.id, found.verdict, found.reason)
        low, high = case.directrix.bounding_box
        away = [(high.x + 9, low.y), (high.x + 10, low.y), (high.x + 9, low.y + 1)]
        assert compare(case, {"inner_fit": [*rings, away], **fits}).verdict == "unsound"
