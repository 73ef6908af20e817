"""The Coq development: it builds without axioms, and nothing in it is admitted."""

import fcntl
import re
import shutil
import subprocess
from pathlib import Path

import pytest

import exactsweep.check

PROOF = Path(exactsweep.check.__file__).parent / "proof"
MAIN = ["layout_sound", "no_fit_polygon_sound", "inner_fit_polygon_sound", "whole_sweep_sound"]
MAIN += ["disjoint_iff", "real_overlap", "real_at_least", "rotation_error_sound"]

needs_coq = pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed")


def without_comments(text: str) -> str:
    """Return a Coq file without its comments, which may be nested."""
    depth, kept = 0, []
    for word in re.split(r"(\(\*|\*\))", text):
        depth += (word == "(*") - (word == "*)")
        kept.append(word if depth == 0 and word != "*)" else " ")
    return "".join(kept)


def make(*targets: str) -> str:
    """Run make in the folder of the proofs, one process at a time."""
    with (PROOF / "CoqMakefile.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        done = subprocess.run(
            ["make", "-j1", *targets], cwd=PROOF, capture_output=True, text=True, check=False
        )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_nothing_is_admitted_or_assumed() -> None:
    unproved = r"\b(Admitted|admit|give_up|Axioms?|Parameters?|Conjecture|Unset Guard Checking)\b"
    files = sorted(PROOF.glob("*.v"))
    words = (PROOF / "_CoqProject").read_text(encoding="utf-8").split()
    listed = {name for name in words if name.endswith(".v")}
    assert listed
    assert listed <= {path.name for path in files}
    for path in files:
        text = without_comments(path.read_text(encoding="utf-8"))
        assert not re.findall(unproved, text), path.name
        # `Variable` and `Hypothesis` outside a section are axioms.
        depth = 0
        for word in re.findall(r"^\s*(Section|End|Variables?|Hypothes[ie]s|Context)\b", text, re.M):
            depth += (word == "Section") - (word == "End")
            assert depth > 0 or word == "End", f"{path.name}: {word} outside a section"


def test_comments_are_not_searched() -> None:
    assert without_comments("a (* b (* c *) d *) e").split() == ["a", "e"]


def test_the_page_of_statements_is_short_and_proves_nothing() -> None:
    page = (PROOF / "Statements.v").read_text(encoding="utf-8")
    assert len(page.splitlines()) < 200
    assert not re.findall(r"\b(Lemma|Theorem|Proof|Qed)\b", without_comments(page))


@needs_coq
@pytest.mark.long
def test_every_main_theorem_is_proved_without_axioms(tmp_path: Path) -> None:
    make()
    names = re.findall(r"^Print Assumptions (\w+)\.$", (PROOF / "Assumptions.v").read_text(), re.M)
    assert set(MAIN) <= set(names)
    done = subprocess.run(
        [
            "coqc",
            "-R",
            str(PROOF),
            "Exactsweep",
            "-o",
            str(tmp_path / "Assumptions.vo"),
            "Assumptions.v",
        ],
        cwd=PROOF,
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.split("\n") == ["Closed under the global context"] * len(names) + [""]
