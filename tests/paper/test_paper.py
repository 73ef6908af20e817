"""The ledger of the paper is complete, refers to existing code, and agrees with its evidence."""

import json
import re
from itertools import pairwise, product
from pathlib import Path
from pkgutil import resolve_name
from typing import Any

import pytest
from click.testing import CliRunner
from command import ROOT
from goldens.texts import show_row
from tiers import mostly_long

from exactsweep import Polygon
from exactsweep.cli import main
from exactsweep.corpus.generator.prng import Prng
from exactsweep.paper.claim import (
    Claim,
    ClaimVerdict,
    Counterexample,
    Effort,
    Evidence,
    Finding,
    Observation,
    reproduce,
)
from exactsweep.paper.data import write_data
from exactsweep.paper.growth import Growth, Size, double
from exactsweep.paper.laws import find_violation, list_polygons, search_grid, shrink, try_laws
from exactsweep.paper.ledger import CHECKS, CLAIMS, KINDS, find, read_rows
from exactsweep.paper.pairs import SweepPair, draw_pair, draw_pairs
from exactsweep.procedures.chain import split

SLOW = {
    "Sweep_MM",
    "Corollary 5.7",
    "Corollary 5.8",
    "Number of undercuts, MM",
    "Corollary 4.6",
    "VV is incidental",
    "Levels of divide and conquer",
    "Lemma 5.2",
    "Theorem 2.1",
    "SweepI_CM",
    "Table 1",
    "Outside j_i or inside j_o",
    "Lemma 5.3",
    "Definition 1.2",
    "Definition 1.1",
    "Trajectory_MM",
    "Corollary 4.5",
    "Corollary 3.4",
    "Lemma 5.1",
    "Lemma 5.5",
    "Lemma A.1",
    "A faster inner loop",
    "Lemma 5.6",
    "Cost of step 2",
    "Theorem 2.2",
    "Two chains in linear time",
    "Local width",
}
"""Rows that take more than 0.7 s each."""

TRIANGLE = [(0, 0), (1, 0), (0, 1)]
NUMBERED = {
    "Definition": "1.1 1.2 1.3 2.1 3.1 5.1 5.2",
    "Theorem": "2.1 2.2",
    "Lemma": "3.1 3.2 4.1 4.2 5.1 5.2 5.3 5.5 5.6 A.1 A.2 A.3",
    "Corollary": "3.3 3.4 4.3 4.4 4.5 4.6 5.4 5.7 5.8 A.4",
    "Table": "1",
}
ORDER = [claim.name for claim in CLAIMS]
GOLDEN: dict[str, Any] = {
    name: row
    for line in (ROOT / "tests/goldens/ledger.txt").read_text(encoding="utf-8").splitlines()
    for name, row in json.loads(line).items()
}
"""The findings of a quick run, by row; `python -m tests.goldens` writes them."""
PROCEDURES = [
    *(f"{name}_{kind}" for name in ("Trajectory", "SweepI", "SweepO") for kind in ("CC", "CM")),
    *("Trajectory_MM", "Sweep_MM", "LowerEnvelope_CM", "LowerEnvelope_MM"),
]


def test_everything_with_a_number_or_a_name_in_the_paper_has_a_row() -> None:
    names = [f"{kind} {number}" for kind, all_ in NUMBERED.items() for number in all_.split()]
    assert set(names + PROCEDURES) <= set(ORDER)
    assert len(ORDER) == len(set(ORDER)) == len(CLAIMS)


@pytest.mark.parametrize("claim", CLAIMS, ids=ORDER)
def test_a_claim_names_code_that_exists(claim: Claim) -> None:
    assert claim.code
    for name in claim.code:
        assert (
            callable(resolve_name(name))
            or isinstance(resolve_name(name), property)
            or hasattr(resolve_name(name), "func")
        )


@pytest.mark.parametrize("claim", CLAIMS, ids=ORDER)
def test_refuted_statements_have_a_correction(claim: Claim) -> None:
    assert set(claim.evidence) <= set(KINDS)
    assert claim.words.endswith((".", ")."))
    assert claim.verdict in (ClaimVerdict.REPRODUCED, ClaimVerdict.ADDED) or claim.correction


@pytest.mark.parametrize("name", mostly_long(ORDER, [*{*ORDER} - SLOW]))
def test_the_evidence_supports_the_verdict(name: str, tmp_path: Path) -> None:
    claim = find(name)
    (row,) = reproduce([claim], Effort(seed=2, quick=True))
    assert row.disagreement == ""
    assert row.evidence.tried
    assert show_row(row) == GOLDEN[claim.name]
    last = [series.points[-1] for series in row.evidence.growth]
    for case in row.evidence.cases if last else ():
        sizes = [f"m = {p.m} and n = {p.n}" for p in last] + [f"m = n = {p.m}" for p in last]
        assert case.generatrix or any(size in case.text for size in sizes)
    write_data(tmp_path, [row], Effort(seed=2, quick=True))
    files = sorted((tmp_path / "counterexamples").iterdir())
    assert len(files) == sum(bool(case.generatrix) for case in row.evidence.cases)
    for file in files:
        result = CliRunner().invoke(main, ["sweep", f"{file}#G", f"{file}#D", "--json"])
        assert result.exit_code == 0, result.output


def test_the_readme_names_all_errata_by_weight() -> None:
    readme = (ROOT / "exactsweep/paper/README.md").read_text(encoding="utf-8")
    errata = readme.split("## Errata")[1].split("\n## ")[0]
    by_weight = sorted((c for c in CLAIMS if c.weight), key=lambda claim: claim.weight)
    assert re.findall(r"\*\*(.*?)\*\*", errata) == [claim.name for claim in by_weight]


def row_of(status: ClaimVerdict, evidence: Evidence) -> Finding:
    claim = Claim("A claim", "1", "It holds.", status, (), (), lambda effort: [evidence])
    return next(reproduce([claim], Effort()))


def test_a_failure_disagrees_with_every_verdict() -> None:
    for status in ClaimVerdict:
        assert row_of(status, Evidence("much", "it fails")).disagreement == "it fails"


def test_only_refuted_claims_have_counterexamples() -> None:
    against = Evidence("much", cases=(Counterexample("a case", "by chance"),))
    for status in ClaimVerdict:
        announced = status.contradicts_paper
        assert bool(row_of(status, Evidence("much")).disagreement) == announced
        assert bool(row_of(status, against).disagreement) != announced


def test_a_row_announces_exactly_the_evidence_found() -> None:
    def disagreement(named: tuple[str, ...], given: Evidence) -> str:
        claim = Claim(
            "A", "1", "It holds.", ClaimVerdict.REPRODUCED, named, (), lambda effort: [given]
        )
        return next(reproduce([claim], Effort())).disagreement

    assert disagreement(("sampled", "exhaustive"), Evidence("much", sampled=9, searched=9)) == ""
    assert "'sampled'" in disagreement(("sampled",), Evidence("much"))
    assert "'exhaustive'" in disagreement((), Evidence("much", searched=9))
    assert "'proved'" in disagreement(("proved",), Evidence("much"))
    assert "'counted'" in disagreement((), Evidence("much", growth=(series(1),)))
    assert "'counted'" in disagreement(
        ("counted",), Evidence("m", growth=(series(1, "bytes of f"),))
    )


def test_a_check_that_raises_fails() -> None:
    def check(effort: Effort) -> list[Observation]:
        raise ZeroDivisionError("by zero")

    claim = Claim("A claim", "1", "It holds.", ClaimVerdict.REPRODUCED, (), (), check)
    (row,) = reproduce([claim], Effort())
    assert row.disagreement == "ZeroDivisionError: by zero"


def test_names_are_found_in_any_case_and_spacing() -> None:
    assert find("  lemma   A.1").name == "Lemma A.1"


def test_pairs_depend_on_seed_class_and_number_alone() -> None:
    few, many = (list(draw_pairs(Effort(3), "MM", count)) for count in (4, 9))
    assert many[:4] == few
    assert list(draw_pairs(Effort(4), "MM", 4)) != few


@pytest.mark.parametrize("strict", [True, False])
def test_random_pairs_are_of_their_class(strict: bool) -> None:
    walls = 0
    for number in range(60):
        pair = draw_pair(Prng(str(number)), "CM", strict=strict)
        assert Polygon(pair.generatrix).is_convex
        for ring in pair:
            split(ring)
            walls += sum(p[0] == q[0] for p, q in pairwise([*ring, ring[0]]))
    assert (walls == 0) == strict


def test_all_polygons_of_a_tiny_grid_are_listed() -> None:
    # Heights over x = 0, 1, 2: 27, of which 5 are on a line; and 8, of which 2, do not touch y = 0.
    assert len(list_polygons(2, 3)) == 27 - 5 - (8 - 2)
    # Over x = 0, 1, 2 again, two heights over 1: no three on a line, at least one is zero.
    quadrilaterals = [
        heights
        for heights in product(range(3), repeat=4)
        if heights[1] < heights[2]
        and min(heights) == 0
        and 2 * heights[1] < heights[0] + heights[3] < 2 * heights[2]
    ]
    bent = 0
    for a, low, high, b in product(range(3), repeat=4):
        apart = (2 * low - a - b) * (2 * high - a - b) > 0
        bent += low < high and min(a, low, high, b) == 0 and apart
    assert len(list_polygons(2, 4)) == len(quadrilaterals) + bent
    assert all(min(x for x, _ in ring) == 0 for ring in list_polygons(2, 5))


def test_the_smallest_pair_comes_first() -> None:
    found = search_grid(2, 7, "convex", "any", lambda p: ["" if len(p[0]) < 4 else "four"])
    (against,) = found.cases
    assert against[2:] == ([(0, 0), (1, 0), (2, 1), (1, 1)], [(0, 0), (1, 0), (2, 1)])
    nothing = search_grid(2, 6, "any", "any", lambda p: [])
    assert nothing == Evidence(
        "All 256 pairs with up to 6 vertices on the 3 by 3 grid.", searched=256
    )


def test_a_broken_law_is_shown_with_a_small_pair() -> None:
    pair = SweepPair(TRIANGLE, [(0, 0), (9, 0), (9, 7), (5, 9), (0, 8)])
    least = shrink(lambda p: ["" if len(p.directrix) < 4 else "four corners"], pair)
    assert len(least.directrix) == 4
    assert max(x for x, _ in least.directrix) < 9


def test_a_law_that_raises_is_broken() -> None:
    def law(pair: SweepPair) -> list[str]:
        raise IndexError("beyond")

    assert find_violation(law, [SweepPair(TRIANGLE, TRIANGLE)]).startswith(
        "IndexError: beyond; G = "
    )


def test_a_trial_reports_the_first_failure_and_the_laws() -> None:
    def law(pair: SweepPair) -> list[str]:
        """It always fails."""
        return ["of course"]

    found = try_laws([(law, "20 CC, 20 CM weak")], Effort(quick=True))
    assert found.failure.startswith("of course; G = ")
    assert found.sampled == 4
    assert found.tried == "It always fails. Pairs: 2 CC, 2 CM with vertical edges."


def series(
    power: float, what: str = "vertices", limit: float = 1.08, side: str = "upper"
) -> Growth:
    points = tuple(Size(m, n, round(1000 * n**power), n) for m, n in double(8, 3))
    return Growth(what, "ints", "n", points, limit, side)


def test_growth_is_flat_rising_or_falling() -> None:
    assert series(1).is_flat
    assert series(1).is_attained
    assert series(1.2).failure.startswith("vertices on ints, m and n doubled: the ratio to n rose")
    assert not series(0.2).is_attained


def test_an_upper_bound_fails_above_and_a_lower_one_below() -> None:
    failing = {
        side: [bool(series(power, side=side).failure) for power in (0.2, 1, 1.2)]
        for side in ("upper", "lower", "both")
    }
    assert failing["upper"] == [False, False, True]
    assert failing["lower"] == [True, False, False]
    assert failing["both"] == [True, False, True]


def test_the_three_largest_sizes_decide_whether_a_bound_is_attained() -> None:
    def attained(*ratios: int) -> bool:
        points = (Size(2**k, 2**k, ratio << k, 2**k) for k, ratio in enumerate(ratios))
        return Growth("vertices", "ints", "n", tuple(points)).is_attained

    assert attained(90, 10, 10, 10)
    assert not attained(10, 90, 10, 10)


def test_measured_growth_is_judged_by_its_exponent() -> None:
    assert series(1.3, "seconds of f").is_flat
    assert series(1.4, "bytes of f").is_flat
    assert not series(2, "seconds of f").is_flat
    assert not series(2, "bytes of f").is_flat
    assert series(1.15, limit=0.2).is_flat
    assert not series(1.25, limit=0.2).is_flat


def test_repeated_measurements_keep_the_minimum() -> None:
    slow, fast = series(2, "seconds of f"), series(1, "seconds of f")
    assert slow.take_minima(fast).points == fast.take_minima(slow).points == fast.points
    assert not slow.take_minima(slow).is_flat


def test_docstrings_state_the_laws_of_the_ledger() -> None:
    named = {name for row in read_rows() for name in row.get("laws", {})}
    named |= {law for row in read_rows() for law, *_ in row.get("search", ())}
    assert all((resolve_name(f"{CHECKS}.{name}").__doc__ or "").endswith(".") for name in named)


@pytest.mark.parametrize("row", read_rows(), ids=ORDER)
def test_a_row_is_sampled_where_it_has_laws(row: dict[str, Any]) -> None:
    assert ("sampled" in row["evidence"]) or not row.get("laws")
    assert (
        ("figure" in row)
        == ("chosen" in row)
        == ("against" in row)
        != bool({"check", "laws", "search", "costs", "counts"} & set(row))
    )
    assert ("weight" in row) == ClaimVerdict(row["verdict"]).contradicts_paper
    assert ("measured" in row["evidence"]) == ("costs" in row)
