"""Reports for continuous integration, and the recipes of CI.md."""

import json
import os
import re
import shlex
import subprocess
import sys
import venv
from pathlib import Path

import pytest
from command import ROOT, run
from judged import CONVEX, CORRECT, EXAMPLES, FAULTY, SLOT, SQUARE

from exactsweep.conform import conform
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.report.ci import MAX_ANNOTATIONS, write_annotations, write_badge
from exactsweep.conform.report.html import write_html
from exactsweep.conform.report.unit_test import guess_language, write_unit_test
from exactsweep.corpus import Case, cases

THIRD = [(0, 0), ("1/3", 0), ("1/3", 1), (0, 1)]
CASES = [Case.of("slot", "", SLOT, SQUARE), Case.of("slot-third", "", SLOT, THIRD)]
PAGE = (ROOT / "exactsweep/conform/CI.md").read_text(encoding="utf-8")


def test_a_badge_counts_exact_answers() -> None:
    run = conform(lambda d, g, r: d, cases(max_size=6), name="mine")
    badge = json.loads(write_badge(run))
    assert badge["message"] == f"0 of {run.summary.judged} exact"
    assert (badge["schemaVersion"], badge["color"]) == (1, "red")

    def nearly(d: object, g: object, r: object) -> object:
        from exactsweep import no_fit_polygon

        loop = no_fit_polygon(d, g, reference=r).exterior.vertices  # type: ignore[arg-type]
        return [(float(x), float(y)) for x, y in loop]

    run = conform(nearly, CASES, name="mine", numbers="binary64", accepted=Verdict.WITHIN)
    assert run.passed
    badge = json.loads(write_badge(run))
    # The loop at thirds is scaled to integers; lost exact fits do not count.
    assert badge["message"] == "2 of 2 exact"
    assert badge["color"] == "brightgreen"


def test_annotations_are_lines_of_the_worst_faults() -> None:
    def answer(d: object, g: object, r: object) -> object:
        raise ValueError(f"100%\nof ::error:: {len(str(d)) % 37 * 'x'}")

    run = conform(answer, cases(max_size=9), name="mine")
    lines = write_annotations(run).splitlines()
    assert len(lines) == MAX_ANNOTATIONS
    pattern = r"::error title=[\w-]+ crash::ValueError: 100%25 of ::error:: x*(%0Aand \d+ more.*)?"
    assert all(re.fullmatch(pattern, line) for line in lines)
    run = conform(lambda d, g, r: d, CASES, name="a,b: c")
    assert write_annotations(run).count("%0Aat (") == 1
    run = conform(answer, [], name="a,b: c")
    assert write_annotations(run) == "::error title=a%2Cb%3A c::no case was judged\n"


@pytest.mark.long
def test_the_command_writes_them(tmp_path: Path) -> None:
    badge = str(tmp_path / "badge")
    ours = ("conform", "--filter", "id=worked-s", "--annotations", "--badge", badge, "--")
    done = run(*ours, *FAULTY, "hull")
    assert done.exit_code == 1
    assert done.stdout.splitlines()[-1].startswith("::error title=worked-")
    assert " exact" in json.loads(Path(badge).read_text())["message"]
    done = run(*ours, *CORRECT)
    assert (done.exit_code, "::error" in done.stdout) == (0, False)
    # The report on standard output stays complete.
    done = run(
        "conform", "--filter", "id=worked-s", "--annotations", "--badge", "-", "--", *CORRECT
    )
    assert json.loads(done.stdout)["color"] == "brightgreen"


# Failures as text.


@pytest.mark.parametrize(
    ("command", "name", "language"),
    [
        (["node", "a.js"], "x", "JavaScript"),
        (["./nfp"], "nfp.rs 1", "Rust"),
        (["target/release/nfp"], "nfp", "Rust"),
        ([sys.executable, "-m", "nfp"], "nfp", "Python"),
        ([], "mine.py", "Python"),
        (["./nfp"], "nfp", "C++"),
    ],
)
def test_the_command_determines_the_language(command: list[str], name: str, language: str) -> None:
    assert guess_language(command, name) == language


@pytest.mark.parametrize("numbers", ["binary64", "int64", "rational"])
def test_both_loops_can_be_pasted(numbers: str) -> None:
    rings = [CASES[1].directrix_ring, CASES[1].generatrix_ring]
    if numbers == "int64":
        rings = [tuple(p._replace(x=3 * p.x) for p in ring) for ring in rings]
    text = write_unit_test([("exact", rings)], "Python", numbers, "why")
    found: dict[str, object] = {}
    exec(text, found)
    kinds = {"binary64": float, "int64": int, "rational": str}
    (x, _), *_ = found["exact"][0]  # type: ignore[index]
    assert type(x) is kinds[numbers]
    exact = [[(kinds[numbers](x), kinds[numbers](y)) for x, y in ring] for ring in rings]
    assert found["exact"] == exact
    assert ("# exact, exactly: " in text) == (numbers == "binary64")
    assert text.startswith("# why\n")
    for language in ("C++", "Rust", "JavaScript"):
        written = write_unit_test([("exact", rings)], language, numbers, "why")
        numbers_of = re.findall(r"[\w.]+", text.splitlines()[1])[1:]
        assert all(number in written for number in numbers_of)


def test_the_page_has_the_text_of_each_failure() -> None:
    run = conform(lambda d, g, r: d, CASES, name="mine.js")
    page = write_html(run)
    assert page.count("const exact = [[[") == page.count("const theirs = [[[") >= 1
    run = conform(lambda a, b: a, CASES, name="mine.py", questions=["minkowski_sum"])
    assert "\nb = [[(" in write_html(run)


# The recipes.


def list_steps(recipe: str) -> list[str]:
    """Return the commands of a recipe as a service runs them."""
    return re.findall(r"^ +- (?:run: )?((?:pip|make|exactsweep) .*)$", recipe, re.M)


RECIPES = re.findall(r"^```yaml\n(.*?)^```$", PAGE, re.M | re.S)


def test_recipes_use_existing_options() -> None:
    assert len(RECIPES) == 2
    for recipe in RECIPES:
        *_, command = list_steps(recipe)
        options = command.partition(" -- ")[0]
        done = run(*shlex.split(options)[1:], "--filter", "id=nothing", "--", *CONVEX)
        assert "no theme or case 'nothing'" in done.stderr


@pytest.mark.long
def test_the_steps_of_a_recipe_run_in_a_fresh_environment(tmp_path: Path) -> None:
    """The package comes from this checkout, and the program is an example."""
    venv.create(tmp_path / "env", with_pip=True)
    program = (EXAMPLES / "doubles.py").read_text(encoding="utf-8")
    (tmp_path / "made").write_text(f"#!{tmp_path}/env/bin/python\n{program}")
    (tmp_path / "Makefile").write_text("mine: made\n\tcp made mine && chmod +x mine\n")
    bin = tmp_path / "env" / "bin"
    environment = {**os.environ, "PATH": f"{bin}{os.pathsep}{os.environ['PATH']}"}
    for step in list_steps(RECIPES[0]):
        step = step.replace("exactsweep==0.1.0", shlex.quote(str(ROOT)))
        step = step.replace(" -- ", " --filter id=worked-s -- ")
        done = subprocess.run(
            step, shell=True, cwd=tmp_path, env=environment, capture_output=True, text=True
        )
        if step.startswith("pip") and done.returncode:
            pytest.skip("the dependencies cannot be installed here")
        assert done.returncode == 0, done.stdout + done.stderr
    assert {path.name for path in tmp_path.glob("exact.*")} == {
        *("exact.xml", "exact.html", "exact.json")
    }
