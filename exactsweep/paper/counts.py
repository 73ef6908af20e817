"""Counts over doubling sizes beside bounds, as counts.toml lists them by rows of the ledger."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator, Sequence
from importlib.resources import files
from pkgutil import resolve_name

from exactsweep.corpus.generator import growing
from exactsweep.paper.claim import Effort
from exactsweep.paper.costs import RUNS
from exactsweep.paper.counting import count_by, grow
from exactsweep.paper.growth import BOUNDS, Growth


def count_all(row: str, effort: Effort) -> Iterator[Growth]:
    """Count all that counts.toml lists for a row of the ledger."""
    text = files("exactsweep.paper").joinpath("counts.toml").read_text(encoding="utf-8")
    for group in tomllib.loads(text)["count"]:
        if group.pop("row") == row:
            for series in group.pop("series"):
                yield _count(effort, **group | series)


def _count(
    effort: Effort,
    what: str,
    count: str,
    family: str,
    bound: str,
    sizes: Sequence[int] = (),
    m: Sequence[int] = (1, 0),
    n: Sequence[int] = (1, 0),
    limit: float = 1.08,
    side: str = "upper",
) -> Growth:
    """Count one series; the parameters are described at the head of counts.toml."""
    if count in RUNS:
        counter = count_by("vertices", RUNS[count])
    else:
        counter = resolve_name(f"{__package__}.checks.{count}")
    pairs = [(m[0] * k + m[1], n[0] * k + n[1]) for k, _ in effort.sizes(*sizes)]
    made, beside = getattr(growing, family), BOUNDS.get(bound, bound)
    return grow(what, made, beside, pairs, counter, limit, side)
