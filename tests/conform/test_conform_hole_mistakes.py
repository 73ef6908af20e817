"""The exact text of diagnoses of lost, added or moved rings."""

from fractions import Fraction
from itertools import islice
from typing import Any
from xml.sax.saxutils import escape

from exactsweep import Point, inner_fit_polygon, no_fit_polygon
from exactsweep.conform import compare, conform
from exactsweep.conform.judge.witness import list_exact_rings
from exactsweep.conform.report.ci import write_junit
from exactsweep.conform.report.text import close
from exactsweep.corpus import Case, cases

Rings = list[Any]


def shift(ring: Any, by: Fraction) -> list[Point]:
    return [Point(p.x + by, p.y) for p in ring]


# The messages on lost or added rings.


def say(case: Case, name: str, rings: Rings) -> tuple[str, ...]:
    return compare(case, {name: rings}).parts[0].diagnosis


def test_the_sum_of_boundaries_alone_is_named() -> None:
    """With G inside D, or D inside G, the boundaries are disjoint; Clipper leaves a hole there."""
    small, large = [(0, 0), (1, 0), (0, 1)], [(0, 0), (9, 0), (9, 7), (0, 5)]
    words = (
        "the sum of the boundaries only: positions with one polygon inside the other are missing"
    )
    for d, g in ((large, small), (small, large)):
        case = Case.of("inside", "", d, g, (2, 5))
        (around,) = list_exact_rings(case, "no_fit")
        inside = inner_fit_polygon(large, small).regions[0].exterior.vertices
        moved = [Point(x + 2, y + 5) if d is large else Point(2 - x, 5 - y) for x, y in inside]
        assert say(case, "no_fit", [around, moved]) == (words, "all exact rings, and 1 more")
        assert say(case, "trajectory", [moved[::-1], around])[0] == words
        assert say(case, "no_fit", [around, shift(moved, Fraction(1, 9))]) == (
            "all exact rings, and 1 more",
        )


def test_lost_rings_are_counted() -> None:
    for case in islice((c for c in cases(kind="SS") if len(c.holes) > 1), 3):
        exact = list(list_exact_rings(case, "no_fit"))
        n = len(exact) - 1
        assert say(case, "no_fit", exact[:-1]) == (f"lacks 1 of {n} holes",)
        assert say(case, "no_fit", exact[:1]) == ("lacks the holes",)
        away = shift(exact[-1], Fraction(1000))
        assert say(case, "no_fit", [*exact[:-1], away]) == (f"exact in {n} of {n + 1} rings",)
    several = next(c for c in cases() if c.inner_regions and len(c.inner_regions) == 2)
    exact = list(list_exact_rings(several, "inner_fit"))
    assert say(several, "inner_fit", []) == ("reports that G does not fit",)
    for k, ring in enumerate(exact):
        lost = exact[:k] + exact[k + 1 :]
        assert say(several, "inner_fit", lost) == (f"lacks 1 of {len(exact)} rings",)
        island = shift(ring, Fraction(1000))
        assert say(several, "inner_fit", [*exact, island]) == ("all exact rings, and 1 more",)


def test_exchanged_roles_precede_other_reference_points() -> None:
    """Shapes with rotational symmetry, at an offset without a name."""
    d, g = [(0, 0), (9, 0), (9, 4), (0, 4)], [(1, 1), (3, 1), (3, 2), (1, 2)]
    case = Case.of("symmetric", "", d, g, ("1/3", 2))
    (ring,) = list_exact_rings(case, "no_fit")
    turned = [Point(Fraction(2, 3) - x, 4 - y) for x, y in ring]
    found = say(case, "no_fit", [turned])
    assert found[0] == "exact for exchanged roles: D around G"
    assert any("translated by" in words for words in found)
    for (px, py), name in (((1, 1), "first"), ((3, 2), "rightmost")):
        turned = [Point(Fraction(1, 3) + px - x, 2 + py - y) for x, y in ring]
        first, *others = say(case, "no_fit", [turned])
        assert (
            first
            == f"exact for exchanged roles: D around G, and for G's {name} vertex as reference"
        )
        assert any(words.startswith("exact for another reference point:") for words in others)


def test_the_cause_of_all_answers_of_a_run_comes_first_in_every_report() -> None:
    square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    chosen = [
        Case.of("square", "", square, square, (1, 1)),
        Case.of("notch", "", [(0, 0), (7, 1), (9, 6), (4, 3), (1, 8)], [(2, 1), (5, 2), (3, 4)]),
        Case.of("far", "", square, [(2, 1), (5, 2), (3, 4)], ("1/2", 7)),
    ]

    def last(directrix: Any, generatrix: Any, reference: Any) -> dict[str, Any]:
        found = no_fit_polygon(directrix, generatrix, reference=generatrix[-1])
        return {"trajectory": found.exterior.vertices}

    run = conform(last, chosen, name="last", made_smaller=1)
    cause = run.summary.find_cause()
    assert cause == "exact for G's last vertex as reference"
    (fault,) = run.list_faults()
    assert (fault.count, cause in fault.name) == (3, True)
    assert all(o.reason.startswith(cause) for o in [*run.list_outcomes(), *run.show()])
    assert all(part["reason"].startswith(cause) for o in run.show() for part in o.parts[:1])
    assert write_junit(run).count(f'message="{escape(cause)}') == 3
    assert close(run).splitlines()[1].endswith("(and 2 more like it)")
