"""Computed flags: for each, a pair that barely has it and one that barely lacks it."""

from fractions import Fraction
from typing import Any

import pytest
import strategies as own
from hypothesis import given
from tiers import examples

from exactsweep import Polygon
from exactsweep.corpus import Case

Ring = list[tuple[Any, Any]]
UNIT: Ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
DIAMOND: Ring = [(0, 0), (2, -1), (4, 0), (2, 1)]
TRIANGLE: Ring = [(0, 0), (3, 1), (1, 4)]
SLOT: Ring = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
C: Ring = [(0, 0), (3, 0), (3, 1), (1, 1), (1, 3), (3, 3), (3, 4), (0, 4)]
E15 = 10**15


def box(width: Any, height: Any, x: Any = 0, y: Any = 0) -> Ring:
    left, bottom, width, height = map(Fraction, (x, y, width, height))
    right, top = left + width, bottom + height
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def flags(directrix: Any, generatrix: Any, reference: Any = (0, 0)) -> set[str]:
    return set(Case.of("mine-1", "mine", directrix, generatrix, reference).flags)


def leaning(by: int, side: int = E15) -> Ring:
    return [(0, 0), (side, by), (side, side)]


@pytest.mark.parametrize(
    ("flag", "inside", "outside"),
    [
        ("clockwise", (UNIT[::-1], TRIANGLE), (UNIT, TRIANGLE)),
        ("collinear-vertex", ([*UNIT, (0, "1/2")], UNIT), ([*UNIT, (0, 0)], UNIT)),
        ("repeated-vertex", ([*UNIT, (0, 1)], UNIT), ([*UNIT, (0, 0)], UNIT)),
        ("identical", (TRIANGLE, [(x + 9, y) for x, y in TRIANGLE]), (TRIANGLE, UNIT)),
        ("identical", (UNIT, box(1, 1, 5)), (UNIT, box(2, 2))),
        ("inverse", (TRIANGLE, [(7 - x, -y) for x, y in TRIANGLE]), (TRIANGLE, TRIANGLE)),
        ("touching", (UNIT, box(1, 1, 1, 1)), (UNIT, box(1, 1, "1000000001/1000000000"))),
        ("touching", (UNIT, box(1, 3, -1, -1)), (UNIT, box(3, 3, -1, -1))),
        ("turned", (C, UNIT), (UNIT, [*C[:3], (0, 2)])),
        ("exact-fit", (SLOT, UNIT), (SLOT, box("9/10", 1))),
        ("undercut", (SLOT, box(2, 1)), (SLOT, box("9/10", 1))),
        ("reference-point", (UNIT, UNIT, ("1/2", 0)), (UNIT, UNIT)),
        ("fractional-input", (UNIT, UNIT, ("1/2", 0)), (UNIT, box(2, 2), (7, 0))),
        ("vertical-edge", (DIAMOND, [*TRIANGLE[:2], (0, 9)]), (DIAMOND, TRIANGLE)),
        ("parallel-edges", (DIAMOND, [(0, 0), (4, 2), (0, 1)]), (DIAMOND, TRIANGLE)),
        ("near-parallel", (leaning(0), leaning(1)), (leaning(0), leaning(0))),
        ("near-parallel", (leaning(0), leaning(1)), (leaning(0), leaning(11))),
        (
            "near-parallel",
            (box(E15, E15), [(0, 0), (E15, 0), (E15 + 1, E15)]),
            (box(E15, E15), [(0, 0), (E15, 0), (E15 + 11, E15)]),
        ),
        (
            "near-parallel",
            (box(E15, E15), [(0, 0), (E15, 0), (E15 - 1, E15)]),
            (box(E15, E15), [(0, 0), (E15, 0), (E15 - 11, E15)]),
        ),
        ("huge", (box(2**53 + 1, 1), UNIT), (box(2**53, 1), UNIT)),
        ("huge", (UNIT, UNIT, (0, -(2**53) - 1)), (UNIT, UNIT, (0, -(2**53)))),
        (
            "tiny",
            (UNIT, box(Fraction(1, 2**30 + 1), 1)),
            (UNIT, box(Fraction(1, 2**30), 1, Fraction(1, 2**60))),
        ),
        ("overflow-int32", (box(2**31 - 1, 1), UNIT), (box(2**31 - 2, 1), UNIT)),
        ("overflow-int32", (box(1, 1, -(2**31)), UNIT), (box(1, 1, -(2**31) + 1), UNIT)),
        ("overflow-int32", (box(2**31 - 1, 1), UNIT), (box(2**31, 1), UNIT)),
        ("overflow-int64", (box(2**63 - 1, 1), UNIT), (box(2**63 - 2, 1), UNIT)),
        (
            "product-overflow-int32",
            (box(2**15, 2**15), UNIT),
            (box(2**15, 2**15 - 1), UNIT),
        ),
        (
            "product-overflow-int64",
            (box(2**31, 2**31), UNIT),
            (box(2**31, 2**31 - 1), UNIT),
        ),
        (
            "product-rounding",
            ([(0, 0), (2**27 + 1, 0), (2**27 + 1, 2**27 - 1)], UNIT),
            ([(0, 0), (2**27, 0), (2**27, 2**26 + 1)], UNIT),
        ),
        ("rounded-answer", ([(0, 0), (2, 2), (4, 0), (4, 4), (0, 4)], UNIT), (SLOT, UNIT)),
    ],
)
def test_flag_is_found(flag: str, inside: Any, outside: Any) -> None:
    assert flag in flags(*inside)
    assert flag not in flags(*outside)


@given(own.pairs("CC") | own.pairs("CM") | own.pairs("MM"), own.translations())
@examples(40)
def test_flags_are_translation_invariant(
    pair: tuple[Polygon, Polygon], by: tuple[Fraction, Fraction]
) -> None:
    placed = {"touching", "huge", "fractional-input", "rounded-answer", "product-rounding"}
    placed |= {"overflow-int32", "overflow-int64"}
    placed |= {"product-overflow-int32", "product-overflow-int64"}
    generatrix, directrix = pair
    here = flags(directrix, generatrix)
    there = flags(directrix.translated(by), generatrix.translated(by[::-1]))
    assert here - placed == there - placed
