"""Large and noisy answers are judged with a bounded number of operations."""

import json
import math
import os
import resource
import subprocess
import sys
from fractions import Fraction
from pathlib import Path
from random import Random
from typing import Any

import pytest
from command import EXACTSWEEP, refusal, run
from hypothesis import given
from hypothesis import strategies as st
from judged import CONVEX, SLOT, SQUARE
from strategies import simple_rings
from tiers import examples

from exactsweep import Polygon
from exactsweep.check import classify
from exactsweep.conform import Verdict
from exactsweep.conform.judge import compare as comparing
from exactsweep.conform.judge import region
from exactsweep.conform.judge.compare import compare, find_fault
from exactsweep.conform.judge.region import find_differences
from exactsweep.conform.judge.rounding import BEYOND, to_double
from exactsweep.conform.judge.verdict import PartComparison
from exactsweep.corpus import Case
from exactsweep.numbers.number import ORIGIN

CASE = Case.of("slot", "", SLOT, SQUARE)
MANY = 640


def judge(loop: object, **options: Any) -> PartComparison:
    return compare(CASE, {"trajectory": loop}, **options).parts[0]


def scatter(amount: float) -> list[tuple[float, float]]:
    """Many points along the exact trajectory, each slightly off."""
    random, ring = Random(1), CASE.trajectory.vertices
    each = MANY // len(ring)
    found = []
    for k, (x, y) in enumerate(ring):
        px, py = ring[k - 1]
        for j in range(each):
            t = Fraction(j, each)
            noise = (random.uniform(-amount, amount), random.uniform(-amount, amount))
            found.append((float(px + t * (x - px)) + noise[0], float(py + t * (y - py)) + noise[1]))
    return found


@pytest.mark.parametrize(
    ("amount", "verdict"),
    [
        pytest.param(1e-13, "within", marks=pytest.mark.long),
        (1e-8, "wrong"),
        (0.1, "malformed"),
    ],
)
def test_a_large_noisy_answer_is_judged(
    amount: float, verdict: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(comparing, "MAX_MEASURED", 600)
    found = judge(scatter(amount), numbers="binary64")
    assert found.verdict == verdict
    assert found.distance_squared is None
    assert bool(found.unsound or found.conservative) == (verdict == "wrong")


@pytest.mark.parametrize("k", [-1, 1])
def test_loops_too_large_to_compare_are_wrong(k: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a comparison of regions, the verdict is "wrong", even for a conservative loop."""
    low, high = CASE.trajectory.bounding_box
    ring = [(low.x - k, low.y - k), (high.x + k, low.y - k), (high.x + k, high.y + k)]
    ring += [(low.x - k, high.y + k)]
    sound = judge(ring).verdict
    assert sound == ("conservative" if k == 1 else "wrong")
    monkeypatch.setattr(comparing, "MAX_MEASURED", 3)
    assert judge(ring).verdict == sound
    for work in (0, 4):
        monkeypatch.setattr(region, "MAX_WORK", work)
        assert judge(ring).verdict is Verdict.WRONG
    assert judge(CASE.trajectory.vertices).verdict is Verdict.EXACT


def test_rings_inside_each_other_are_judged_together(monkeypatch: pytest.MonkeyPatch) -> None:
    nested = [[(-k, -k), (k, -k), (k, k), (-k, k)] for k in range(10, 25)]
    assert judge(nested).verdict is not Verdict.MALFORMED
    assert judge([*nested, nested[0]]).verdict is Verdict.MALFORMED
    monkeypatch.setattr(region, "MAX_WORK", 3000)
    circle = [
        (20 * math.cos(2 * math.pi * k / 44), 20 * math.sin(2 * math.pi * k / 44))
        for k in range(44)
    ]
    rings = [[(x * (1 + i / 7), y * (1 + i / 7)) for x, y in circle] for i in range(20)]
    assert judge(rings).verdict is Verdict.WRONG


@given(st.lists(simple_rings(), min_size=2, max_size=3))
@examples(40)
def test_overlapping_rings_match_the_definition(rings: list[Any]) -> None:
    polygons = [Polygon(ring) for ring in rings]
    found = find_fault([polygon.vertices for polygon in polygons], "$")
    pairs = {
        (j, k)
        for k, one in enumerate(polygons)
        for j, other in enumerate(polygons[:k])
        if classify(one, other, ORIGIN).verdict == "OVERLAP"
        and len({c.first for c in find_differences([one.vertices], [other.vertices])}) != 1
    }
    said = {f"$: rings {j} and {k} overlap" for j, k in pairs}
    assert (found in said) if said else found is None


def test_very_large_loops_are_not_measured(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    far = [[9, 9], [10, 9], [9, 10]]
    small = judge(far)
    assert small.area == CASE.trajectory.area + Fraction(1, 2)
    monkeypatch.setattr(comparing, "MAX_MEASURED", 3)
    large = judge(far)
    assert (small.verdict, large.verdict) == ("wrong", "wrong")
    assert (large.distance_squared, large.area) == (None, None)


# A full disk.


def limit_files(size: int) -> None:
    _, hard = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, hard))


@pytest.mark.parametrize(
    ("option", "size"),
    [("--html", 4096), ("--json", 4096), ("--junit", 4096), ("--journal", 4096), ("--html", 1024)],
)
@pytest.mark.long
def test_a_full_disk_ends_in_one_line(tmp_path: Path, option: str, size: int) -> None:
    path = str(tmp_path / "report")
    command = ["conform", "--filter", "size=9", option, path, "--", *CONVEX]
    done = subprocess.run(
        [EXACTSWEEP, *command],
        capture_output=True,
        text=True,
        preexec_fn=lambda: limit_files(size),
        # A module compiled under the limit would stay truncated.
        env={**os.environ, "PYTHONDONTWRITEBYTECODE": "1"},
    )
    assert done.returncode == 1
    # The judging processes need a page of a file for synchronization.
    what = path if size == 4096 else "cannot start a process"
    assert done.stderr == f"Error: {what}: File too large\n"


def test_a_name_with_a_newline_is_rejected() -> None:
    hello = {"hello": "a\nb", "loops": ["inner"], "numbers": "rational", "reference": "given"}
    program = f"print({json.dumps(json.dumps(hello))})"
    said = refusal(run("conform", "--", sys.executable, "-c", program))
    assert said == '"hello" is not a name of 1 to 200 printable characters'


def test_ids_and_arguments_with_newlines_stay_on_their_line(tmp_path: Path) -> None:
    line = json.dumps({"id": "a\nb\x1b[0m", "directrix": SQUARE, "generatrix": SQUARE})
    pairs, page = tmp_path / "pairs", tmp_path / "page\n.html"
    pairs.write_text(line)
    fails = "import json, sys; exec(open(sys.argv[1]).read().replace('sums =', 'sums = 1 //'))"
    command = [sys.executable, "-c", fails, CONVEX[1], "two\nlines"]
    done = run("conform", "--pairs", str(pairs), "--html", str(page), "--", *command)
    assert "\x1b" not in done.stdout
    assert done.exit_code == 1
    assert done.stdout.partition("\n\n")[2].count("\n") == 2


def test_numbers_beyond_doubles_are_unchanged() -> None:
    assert to_double(BEYOND) == BEYOND
    assert to_double(-BEYOND) == -BEYOND
    assert to_double(BEYOND - 1) == Fraction(sys.float_info.max)
