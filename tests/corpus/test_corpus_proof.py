"""Every shipped case is proved again: by a new sweep, by its certificate, by another program."""

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest
from command import PATIENCE

from exactsweep import sweep
from exactsweep.check import verify
from exactsweep.corpus import cases, themes
from exactsweep.corpus.case_json import case_to_line
from exactsweep.corpus.facts import facts

# Flags that cannot be seen from a pair.
TOLD = {
    "figure",
    "generated",
    "lower-bound",
    "near-fit",
    "part",
    "past-failure",
    "sliver",
    "tangent",
}


@pytest.mark.parametrize("theme", themes())
def test_answers_and_flags_are_those_of_a_sweep_whose_certificate_is_proved(theme: str) -> None:
    for case in cases(prefix=f"{theme}-"):
        s = sweep(case.generatrix_ring, case.directrix_ring, reference=case.reference)
        assert s.trajectory == case.trajectory, case.id
        assert s.inner == case.inner, case.id
        assert s.outer == case.outer, case.id
        assert s.exact_fits == case.exact_fits, case.id
        assert (s.kind, s.area) == (case.kind, case.area), case.id
        seen = facts(case.directrix_ring, case.generatrix_ring, s)
        assert {*case.flags} - TOLD == seen, case.id
        assert verify(s.certificate()).reason == "proved", case.id


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
