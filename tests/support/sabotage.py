"""Faults injected into the kernel, each with the rows of the ledger that must detect it.

A sabotage is a function that maps a right procedure to a wrong one, which replaces it in every
module of the package that imports it by name. Some faults only affect the time; they need full runs
of their rows and are not in the test suite. `sabotage.toml` lists rows by fault.
"""

import sys
import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from pkgutil import resolve_name
from typing import Any, NamedTuple

from exactsweep.paper.claim import Effort, reproduce
from exactsweep.paper.figures.figure import find_computation
from exactsweep.paper.ledger import CHECKS, CLAIMS, find, read_rows

Procedure = Callable[..., Any]
Sabotage = Callable[[Procedure], Procedure]

# Import all modules first: a module imported while the kernel is broken would keep the fault.
for row in read_rows():
    for name in [*row.get("laws", ()), *([row["check"]] if "check" in row else [])]:
        resolve_name(f"{CHECKS}.{name.split('.')[0]}")
    if "figure" in row:
        find_computation(row["figure"])


class Mutation(NamedTuple):
    """A procedure, its replacement, and the rows that must detect it; `timed` if by seconds."""

    fault: str
    procedure: Procedure
    wrong: Sabotage
    rows: tuple[str, ...]
    timed: bool = False


MUTATIONS: list[Mutation] = []
ROWS = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))


def sabotage(
    fault: str, procedure: Procedure, *rows: str, timed: bool = False
) -> Callable[[Sabotage], Sabotage]:
    """Register a function as a sabotage of a procedure that some rows must detect.

    By default, these are the rows of the fault in `sabotage.toml`.
    """

    def register(wrong: Sabotage) -> Sabotage:
        MUTATIONS.append(Mutation(fault, procedure, wrong, rows or tuple(ROWS[fault]), timed))
        return wrong

    return register


@contextmanager
def mutated(mutation: Mutation) -> Iterator[None]:
    """Break the kernel inside a `with` block."""
    right = mutation.procedure
    wrong = mutation.wrong(right)
    places = [
        (module, name)
        for key, module in list(sys.modules.items())
        if key.split(".")[0] == "exactsweep"
        for name, value in list(vars(module).items())
        if value is right
    ]
    for module, name in places:
        setattr(module, name, wrong)
    try:
        yield
    finally:
        for module, name in places:
            setattr(module, name, right)


def red_rows(mutation: Mutation, effort: Effort, names: tuple[str, ...] = ()) -> list[str]:
    """Return the rows, by default among all, whose evidence fails under a mutation."""
    claims = [find(name) for name in names] or CLAIMS
    with mutated(mutation):
        return [row.claim.name for row in reproduce(claims, effort) if row.disagreement]
