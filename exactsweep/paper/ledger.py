"""The rows of the ledger, in the order of the paper."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import fields
from difflib import get_close_matches
from functools import cache, partial
from pkgutil import resolve_name
from typing import Any

from exactsweep.numbers.error import ExactSweepError, quote
from exactsweep.paper import read_toml
from exactsweep.paper.claim import Claim, ClaimVerdict, Effort, Evidence, Observation
from exactsweep.paper.laws import expect_none, search_grid, try_laws

MEASURES = {
    "counts": "costs.count_all",
    "outputs": "costs.compare_outputs",
    "costs": "costs.measure_costs",
}
CHECKS, FIGURES = "exactsweep.paper.checks", "exactsweep.paper.figures"


class UnknownClaimError(ExactSweepError):
    """A name that is not in the ledger."""


def examine(row: Mapping[str, Any], effort: Effort) -> Iterator[Observation]:
    """Test a row's laws on random pairs, run its searches and checks, and measure its costs."""
    laws = row.get("laws", {}).items()
    yield try_laws(((resolve_name(f"{CHECKS}.{law}"), pairs) for law, pairs in laws), effort)
    for law, side, most, generatrix, directrix, *none in row.get("search", ()):
        fails = resolve_name(f"{CHECKS}.{law}")
        searched = search_grid(side, most, generatrix, directrix, fails)
        yield expect_none(searched) if none else searched
    if "check" in row:
        yield from resolve_name(f"{CHECKS}.{row['check']}")(effort)
    if "figure" in row:
        yield Evidence(_join(row["against"]))
        yield from resolve_name(f"{FIGURES}.figure.check_figure")(row["figure"])
    yield Evidence(row.get("counts", ""))
    for kind, measure in MEASURES.items():
        if kind in row:
            yield from resolve_name(f"exactsweep.paper.{measure}")(row["name"], effort)


_FIELDS = {field.name for field in fields(Claim)}


def _join(text: str) -> str:
    return " ".join(text.split())


def _read(row: Mapping[str, Any]) -> Claim:
    read: dict[type, Callable[[Any], Any]] = {str: _join, list: tuple, int: int}
    given = {name: read[type(row[name])](row[name]) for name in _FIELDS & row.keys()}
    checked = {"verdict": ClaimVerdict(row["verdict"]), "check": partial(examine, row)}
    return Claim(**given | checked)


@cache
def _load() -> dict[str, Any]:
    return read_toml("ledger.toml")


def read_rows() -> list[dict[str, Any]]:
    rows: list[dict[str, Any]] = _load()["claim"]
    return rows


ABSTRACT = _join(_load()["abstract"])
KINDS, WEIGHTS = _load()["kinds"], _load()["weights"]
OPEN = tuple((question["name"], _join(question["words"])) for question in _load()["open"])
CLAIMS: tuple[Claim, ...] = tuple(map(_read, read_rows()))
_BY_NAME = {claim.name: claim for claim in CLAIMS}


def find(name: str) -> Claim:
    """Look up a claim by name, ignoring case; an UnknownClaimError suggests similar names.

    >>> find("lemma 5.3").name
    'Lemma 5.3'
    >>> find("Lema 5.3")
    Traceback (most recent call last):
    exactsweep.paper.ledger.UnknownClaimError: no claim 'Lema 5.3'; did you mean 'Lemma 5.3'?
    """
    wanted = " ".join(name.lower().split())
    names = {known.lower(): known for known in _BY_NAME}
    if wanted in names:
        return _BY_NAME[names[wanted]]
    close = [known for known in names if wanted and wanted in known]
    close += [known for known in get_close_matches(wanted, names, 1) if known not in close]
    meant = " or ".join(f"'{names[known]}'" for known in close[:3])
    hint = f"did you mean {meant}?" if meant else "--list shows all names"
    raise UnknownClaimError(f"no claim {quote(name)}; {hint}")
