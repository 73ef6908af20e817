"""Themes: their builders, and their files."""

import json
from hashlib import sha256
from importlib import import_module
from typing import Any

from builders.entry import Entry
from exactsweep.corpus import Case, case_from_json, case_to_json
from exactsweep.corpus.case import given_ring
from exactsweep.geometry.reading import read_point

_NAMES = (
    "directions",
    "failures",
    "figures",
    "fits",
    "identical",
    "lower_bounds",
    "near_parallel",
    "parallel",
    "parts",
    "reference",
    "sampled",
    "sizes",
    "slivers",
    "spelling",
    "tangent",
    "touching",
    "undercuts",
    "vertical",
    "worked",
)
THEMES = {name.replace("_", "-"): import_module(f"builders.{name}") for name in _NAMES}


class BuilderError(ValueError):
    """A builder that contradicts itself or what is shipped."""


def built(theme: str) -> dict[str, Entry]:
    """What the builder of a theme says, by id."""
    found: dict[str, Entry] = {}
    for entry in THEMES[theme].entries():
        id = f"{theme}-{entry.slug}"
        if id in found:
            raise BuilderError(f"{id} is there twice")
        found[id] = entry
    return found


def with_answers(entries: dict[str, Entry], old: str, renew: bool) -> list[Case]:
    """The cases of a theme: those of the old file, unless renewed, and what is new."""
    shipped = {data["id"]: case_from_json(data) for data in json.loads(old)["cases"]} if old else {}
    for id, case in shipped.items():
        if id not in entries or not _same_input(entries[id], case):
            raise BuilderError(f"{id} is shipped, and its builder has another input")
    cases = []
    for id, entry in entries.items():
        if id in shipped and not renew:
            cases.append(shipped[id])
        else:
            cases.append(Case.of(id, entry.title, entry.d, entry.g, entry.reference, entry.flags))
    return cases


def _same_input(entry: Entry, case: Case) -> bool:
    rings = given_ring(entry.d), given_ring(entry.g)
    reference = read_point(entry.reference, "reference")
    return (*rings, reference) == (case.directrix_ring, case.generatrix_ring, case.reference)


def digest(case: Case) -> str:
    """A short digest of what must never change under one id."""
    data = case_to_json(case)
    text = json.dumps([data[part] for part in ("directrix", "generatrix", "reference")])
    return sha256(text.encode()).hexdigest()[:12]


def written(theme: str, cases: list[Case]) -> str:
    """The file of a theme: a name a line, and long lists in one line each."""
    head = f'{{\n "theme": {json.dumps(theme)},\n "title": {json.dumps(THEMES[theme].TITLE)},\n'
    texts = ",\n  ".join(_lines(case_to_json(case), "  ") for case in cases)
    return f'{head} "cases": [\n  {texts}\n ]\n}}\n'


def _lines(data: dict[str, Any], indent: str) -> str:
    lines = []
    for name, value in data.items():
        if name == "expected":
            text = _lines(value, f"{indent} ")
        else:
            text = json.dumps(value, separators=(",", ":"))
        lines.append(f"{indent} {json.dumps(name)}: {text}")
    return "{\n" + ",\n".join(lines) + f"\n{indent}}}"
