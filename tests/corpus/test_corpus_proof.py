"""Every shipped case is proved again: by a new sweep, by its certificate, by another program."""

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest
from builders.theme import unproved
from command import PATIENCE

from exactsweep.corpus import Case, cases, themes
from exactsweep.corpus.case_json import case_to_line

# Flags that cannot be seen from a pair.
TOLD = {
    "figure",
    "generated",
    "lower-bound",
    "near-fit",
    "part",
    "past-failure",
    "reported",
    "sliver",
    "tangent",
}


# Certificates of larger pairs of any shape take minutes; they were proved when they were built.
PROVED_QUICKLY = 150


@pytest.mark.parametrize("theme", themes())
def test_answers_and_flags_are_those_of_a_sweep_whose_certificate_is_proved(theme: str) -> None:
    for case in cases(prefix=f"{theme}-"):
        given = {name: getattr(case, name) for name in ("directrix_holes", "generatrix_holes")}
        again = Case.of(
            case.id,
            case.title,
            case.directrix_ring,
            case.generatrix_ring,
            case.reference,
            TOLD & {*case.flags},
            inner_fit=case.inner_regions is not None,
            note=case.note,
            **given,
        )
        assert again == case, case.id
        if case.kind != "SS" or case.size <= PROVED_QUICKLY:
            assert list(unproved(case)) == [], case.id


@pytest.mark.skipif(
    importlib.util.find_spec("pysfcgal") is None, reason="pysfcgal is not installed"
)
def test_answers_are_those_of_another_exact_program() -> None:
    done = subprocess.run(
        [sys.executable, Path(__file__).parents[1] / "support" / "sfcgal_sweep.py"],
        input="".join(map(case_to_line, cases())),
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    assert done.stdout.splitlines() == [case.id for case in cases()], done.stderr
    assert done.returncode == 0
