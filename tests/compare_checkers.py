"""Compare the two checkers: `python -m tests.compare_checkers`.

`standalone.py` and the checker extracted from the proof in Coq check certificates of random pairs
and layouts, true and changed ones. With --weaken, one side of each conjunction of the extracted
checker is dropped, and a search looks for claims whose answer changes.
"""

from __future__ import annotations

import json
import re
import sys
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from random import Random
from typing import Any

import click

from exactsweep.check.standalone import Refused, prove
from exactsweep.theorem.extracted import ask

# Tests import each other by bare names, as under pytest.
sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parent / "support"))
from falsify import LAYOUTS, ROUNDED, SHAPES, SUMS, change, mix
from weakened_coq import weaken

# Reasons of `standalone.py` that concern the form of a certificate; `theorem/` reads more forms.
FORM = re.compile(
    "not an? |not of type|missing|lowest terms|nor false|none of|not unique|below 0|unknown part"
    "|repeated point|fewer than three|rounded pieces alone|no pieces|unit circle|not one for each"
)


def draw(rng: Random, changes: int) -> Iterator[tuple[str, Any]]:
    """Draw certificates and changes of them; yield each with the name of the change."""
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
    """Compare the answers of both checkers, as one of a few phrases."""
    try:
        prove(certificate)
    except Refused as refused:
        reason = str(refused)
    else:
        reason = ""
    answer = ask(certificate, seconds=seconds)
    if answer == "out of time":
        return f"{answer}, {'rejected' if reason else 'proved'} in Python"
    if (answer == "accepted") == (not reason):
        return "both prove" if not reason else "both reject"
    # The page on Coq explains these: parts that overlap themselves.
    if not reason and any(e["kind"] == "too close" for e in certificate.get("faults") or ()):
        return "too close: proved in Python, rejected in Coq"
    if reason and FORM.search(reason):
        return "rejected in Python for its form"
    return f"DIFFERENT: {f'rejected in Python, {reason}' if reason else f'{answer} in Coq'}"


@click.command()
@click.option("--count", default=200, show_default=True, help="Number of certificates.")
@click.option("--changes", default=40, show_default=True, help="Changes of each drawn question.")
@click.option("--seed", default=1, show_default=True)
@click.option("--seconds", default=5.0, show_default=True, help="Time limit of the extracted one.")
@click.option("--weaken", "is_weakened", is_flag=True, help="Weaken the extracted checker.")
def main(count: int, changes: int, seed: int, seconds: float, is_weakened: bool) -> None:
    """Compare the answers of both checkers; exit code 1 if they differ."""
    found = Counter[str]()
    drawn = (one for k in range(count) for one in draw(Random(f"{seed} {k}"), changes))
    if is_weakened:
        noticed, dropped = weaken(count, Random(seed))
        for k in sorted(dropped.keys() - noticed):
            click.echo(f"unnoticed: {dropped[k]}")
        click.echo(f"{len(noticed)} of {len(dropped)} dropped conditions change an answer")
        return
    for _, (name, one) in zip(range(count), drawn, strict=False):
        kind = compare(one, seconds)
        found[kind] += 1
        if kind.startswith("DIFFERENT"):
            click.echo(f"{name}: {kind}\n{json.dumps(one)}", err=True)
    for kind, number in sorted(found.items()):
        click.echo(f"{number:7}  {kind}")
    sys.exit(any(kind.startswith("DIFFERENT") for kind in found))


if __name__ == "__main__":
    main()
