"""Themes: their builders, and their files."""

import json
import lzma
from collections.abc import Callable, Iterator
from hashlib import sha256
from importlib import import_module
from typing import Any

from builders.entry import Entry
from exactsweep import inner_fit_polygon, no_fit_polygon
from exactsweep.check import verify
from exactsweep.corpus import Case, case_from_json, case_to_json
from exactsweep.corpus.case import read_given_rings
from exactsweep.geometry.reading import read_point

_NAMES = (
    "caves",
    "components",
    "containers",
    "directions",
    "failures",
    "figures",
    "fits",
    "holes",
    "identical",
    "interlocking",
    "jigsaw",
    "large",
    "lower_bounds",
    "near_parallel",
    "parallel",
    "parts",
    "plates",
    "rectilinear",
    "reference",
    "reported",
    "rings",
    "sampled",
    "sizes",
    "slivers",
    "spelling",
    "spirals",
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
    """The cases of a theme: those of the old file, unless renewed, and what is new, proved."""
    shipped = {data["id"]: case_from_json(data) for data in json.loads(old)["cases"]} if old else {}
    for id, case in shipped.items():
        if id not in entries or not _same_input(entries[id], case):
            raise BuilderError(f"{id} is shipped, and its builder has another input")
    cases = []
    for id, entry in entries.items():
        if id in shipped and not renew:
            cases.append(shipped[id])
        else:
            case = Case.of(
                id,
                entry.title,
                entry.d,
                entry.g,
                entry.reference,
                entry.flags,
                directrix_holes=entry.d_holes,
                generatrix_holes=entry.g_holes,
                inner_fit=entry.inside,
                note=entry.note,
            )
            for claim, reason in unproved(case):
                raise BuilderError(f"{id}: the certificate of its {claim} is not proved: {reason}")
            cases.append(case)
    return cases


def unproved(case: Case) -> Iterator[tuple[str, str]]:
    """What a case claims and its certificates do not prove, with the reason.

    Of a pair that shares a direction the sweep is all; of others the no-fit polygon is the claim
    that holds the trajectory, its holes and the exact fits.
    """
    claims: dict[str, Callable[[], dict[str, Any]]] = {"sweep": case.sweep().certificate}
    if case.kind == "SS":
        n = no_fit_polygon(case.directrix, case.generatrix, reference=case.reference)
        claims["no-fit polygon"] = n.certificate
    if case.inner_regions is not None:
        f = inner_fit_polygon(case.directrix, case.generatrix, reference=case.reference)
        claims["inner fit"] = f.certificate
    for claim, certificate in claims.items():
        if not (found := verify(certificate())).proved:
            yield claim, found.reason


def _same_input(entry: Entry, case: Case) -> bool:
    d, g = read_given_rings(entry.d, entry.d_holes), read_given_rings(entry.g, entry.g_holes)
    reference = read_point(entry.reference, "reference")
    return (d, g, reference) == (case.directrix_rings, case.generatrix_rings, case.reference)


def digest(case: Case) -> str:
    """A short digest of what must never change under one id."""
    data = case_to_json(case)
    parts = "directrix", "generatrix", "reference", "directrix_holes", "generatrix_holes"
    text = json.dumps([data[part] for part in parts if part in data])
    return sha256(text.encode()).hexdigest()[:12]


COMPRESSED = ("large",)


def encoded(theme: str, text: str) -> tuple[str, bytes]:
    """The name and the bytes of the file of a theme."""
    if theme in COMPRESSED:
        return f"{theme}.json.xz", lzma.compress(text.encode(), preset=9)
    return f"{theme}.json", text.encode()


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
