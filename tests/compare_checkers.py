"""Compare the two checkers: `python -m tests.compare_checkers`.

Certificates of random pairs and layouts, true ones and changed ones, are given to `standalone.py`
and to the checker that is extracted from the proof in Coq. With --weaken, single conditions of the
extracted checker are dropped, and some answer has to change for each.
"""

from __future__ import annotations

import json
import re
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from typing import Any

import click

from exactsweep.check.claims import to_claim
from exactsweep.check.extracted import PROOF, ask, build_checker
from exactsweep.check.standalone import Refused, prove
from exactsweep.check.terms import TheoremError, write_numbers

# Tests import each other by bare names, as under pytest.
sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parent / "support"))
from falsify import LAYOUTS, ROUNDED, SHAPES, SUMS, change, mix

# Reasons of `standalone.py` that concern the form of a certificate: `claims.py` reads more forms.
FORM = re.compile(
    "not an? |lowest terms|neither true nor false|id missing|duplicate|below 0|unknown part"
    "|repeated point|fewer than three|not rounded pieces alone|no pieces|unit circle"
)
CONJUNCTION = "(&&)"
SOURCES = "checker.mli", "checker.ml", "driver.ml"
DROPPED = "(fun x _ -> x)", "(fun _ y -> y)"


def draw(rng: Random, changes: int) -> Iterator[tuple[str, Any]]:
    """Draw certificates and changes of them; yield each with a name for what was changed."""
    family = rng.choice([SHAPES, SHAPES, SUMS, LAYOUTS, ROUNDED])
    known = list(family.draw(rng))
    for one in known:
        yield "unchanged", one
    for n in range(changes if known else 0):
        one, other = known[n % len(known)], known[-1 - n % len(known)]
        share = rng.random()
        try:
            if share < 0.2:
                yield family.adversary(one, rng)
            elif share < 0.3 and one.get("claim") == other.get("claim"):
                yield "mixture", mix(one, other, rng)
            else:
                yield change(one, rng)
        except Exception:  # whatever keeps the finder from ending with a proof
            continue


def compare(certificate: Any, seconds: float) -> str:
    """Return the answers of both checkers, as one of a few phrases."""
    try:
        prove(certificate)
    except Refused as refused:
        reason = str(refused)
    else:
        reason = ""
    answer = ask(certificate, seconds=seconds)
    if answer == "out of time":
        return f"{answer}, {'refused' if reason else 'proved'} in Python"
    if (answer == "accepted") == (not reason):
        return "both prove" if not reason else "both refuse"
    if not reason and answer == "malformed":
        try:
            to_claim(certificate)
        except TheoremError as error:
            return f"proved in Python, no claim in Coq: {error}"
    if reason and FORM.search(reason):
        return "refused in Python for its form"
    return f"DIFFERENT: {f'refused in Python, {reason}' if reason else f'{answer} in Coq'}"


def list_weakened(source: str) -> Iterator[str]:
    """List the sources of the extracted checker in which one side of a conjunction is dropped."""
    parts = source.split(CONJUNCTION)
    for k in range(1, len(parts)):
        for dropped in DROPPED:
            yield CONJUNCTION.join(parts[:k]) + dropped + CONJUNCTION.join(parts[k:])


def answers(program: Path, lines: str) -> str:
    """Return the answers to claims, one a line, and the exit code."""
    try:
        done = subprocess.run(
            [program], input=lines, capture_output=True, text=True, timeout=300, check=False
        )
    except subprocess.TimeoutExpired:
        return "out of time"
    return f"{done.stdout} {done.returncode}"


def weaken(lines: str, every: int) -> Iterator[tuple[int, bool]]:
    """Weaken the extracted checker; yield the number of a weakening, and whether answers change."""
    source = (build_checker().parent / "checker.ml").read_text(encoding="utf-8")
    expected = answers(build_checker(), lines)
    with TemporaryDirectory() as folder:
        for name in ("checker.mli", "driver.ml"):
            shutil.copy(PROOF / "extracted" / name, folder)
        command = (
            "ocamlfind ocamlopt -w -a -package zarith -linkpkg checker.mli checker.ml driver.ml"
        )
        for k, weaker in list(enumerate(list_weakened(source)))[::every]:
            (Path(folder) / "checker.ml").write_text(weaker, encoding="utf-8")
            built = subprocess.run(
                [*command.split(), "-o", "weak"], cwd=folder, capture_output=True
            )
            is_built = built.returncode == 0
            yield k, not is_built or answers(Path(folder) / "weak", lines) != expected


def line_of(certificate: Any) -> str:
    try:
        return write_numbers(to_claim(certificate)) + "\n"
    except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError):
        return ""


@click.command()
@click.option("--count", default=200, show_default=True, help="Number of certificates.")
@click.option("--changes", default=40, show_default=True, help="Changes of each drawn question.")
@click.option("--seed", default=1, show_default=True)
@click.option("--seconds", default=5.0, show_default=True, help="Time limit of the extracted one.")
@click.option("--weaken", "is_weakened", is_flag=True, help="Weaken the extracted checker.")
@click.option("--every", default=1, show_default=True, help="With --weaken: each one of so many.")
def main(
    count: int, changes: int, seed: int, seconds: float, is_weakened: bool, every: int
) -> None:
    """Compare the answers of both checkers; exit code 1 if they differ, or none changes."""
    found = Counter[str]()
    drawn = (one for k in range(count) for one in draw(Random(f"{seed} {k}"), changes))
    if is_weakened:
        lines = "".join(line_of(one) for _, (_, one) in zip(range(count), drawn, strict=False))
        for k, is_noticed in weaken(lines, every):
            found["noticed" if is_noticed else f"UNNOTICED: {k}"] += 1
    else:
        for _, (name, one) in zip(range(count), drawn, strict=False):
            kind = compare(one, seconds)
            found[kind] += 1
            if kind.startswith("DIFFERENT"):
                click.echo(f"{name}: {kind}\n{json.dumps(one)}", err=True)
    for kind, number in sorted(found.items()):
        click.echo(f"{number:7}  {kind}")
    sys.exit(any(kind.startswith(("DIFFERENT", "UNNOTICED")) for kind in found))


if __name__ == "__main__":
    main()
