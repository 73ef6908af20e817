"""Counts over doubling sizes, compared with bounds, for the rows in counts.toml."""

from __future__ import annotations

from collections.abc import Iterator
from pkgutil import resolve_name

from exactsweep.corpus.generator import growing
from exactsweep.paper.claim import Effort
from exactsweep.paper.costs import RUNS
from exactsweep.paper.counting import count_by, grow
from exactsweep.paper.growth import BOUNDS, Growth
from exactsweep.paper.toml import read_toml


def count_all(row: str, effort: Effort) -> Iterator[Growth]:
    """Count everything that counts.toml lists for a row of the ledger."""
    for group in read_toml("counts.toml")["count"]:
        for series in group.pop("series") if group.pop("row") == row else ():
            read = group | series
            (a, b), (c, d) = read.pop("m", (1, 0)), read.pop("n", (1, 0))
            sizes = [(a * k + b, c * k + d) for k, _ in effort.sizes(*read.pop("sizes", ()))]
            name, bound = read.pop("count"), read.pop("bound")
            read["count"] = (
                count_by("vertices", RUNS[name])
                if name in RUNS
                else resolve_name(f"{__package__}.checks.{name}")
            )
            read["family"] = getattr(growing, read["family"])
            yield grow(bound=BOUNDS.get(bound, bound), sizes=sizes, **read)
