"""Reading, extending and writing the files of the shipped corpus, and digests of inputs."""

import json
import lzma
from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from hashlib import sha256
from typing import Any

from exactsweep import inner_fit_polygon
from exactsweep.check import verify
from exactsweep.corpus import Case, case_from_json, case_to_json, themes
from exactsweep.corpus.publish import VERSION

# Flags that cannot be computed from a pair.
GIVEN = {
    "figure",
    "generated",
    "lower-bound",
    "near-fit",
    "part",
    "past-failure",
    "reported",
    "sliver",
    "tangent",
}


class ShippingError(ValueError):
    """A new case that contradicts a shipped one, or whose answer is not proved."""


def with_answers(
    theme: str, old: str, new: Iterable[dict[str, Any]], renew: bool = False
) -> list[Case]:
    """Read the shipped cases of a theme, recompute their answers if requested, and add new ones."""
    cases = [case_from_json(data) for data in json.loads(old)["cases"]]
    shipped = {case.id for case in cases}
    if renew:
        cases = [again(case) for case in cases]
    for data in new:
        case = Case.of(
            data["id"],
            data["title"],
            data["directrix"],
            data["generatrix"],
            data.get("reference", (0, 0)),
            data.get("flags", ()),
            directrix_holes=data.get("directrix_holes", ()),
            generatrix_holes=data.get("generatrix_holes", ()),
            inner_fit=data.get("inner_fit", False),
            note=data.get("note", ""),
        )
        case = replace(case, version=VERSION)
        if case.id in shipped:
            raise ShippingError(f"{case.id} is shipped; a new case needs another id")
        if not case.id.startswith(f"{theme}-"):
            raise ShippingError(f"{case.id} does not start with the name of its theme, {theme}")
        for claim, reason in unproved(case):
            raise ShippingError(
                f"{case.id}: the certificate of its {claim} is not proved: {reason}"
            )
        shipped.add(case.id)
        cases.append(case)
    return cases


def again(case: Case) -> Case:
    """Compute the answers and facts of a case from its input."""
    made = Case.of(
        case.id,
        case.title,
        case.directrix_ring,
        case.generatrix_ring,
        case.reference,
        GIVEN & {*case.flags},
        directrix_holes=case.directrix_holes,
        generatrix_holes=case.generatrix_holes,
        inner_fit=case.inner_regions is not None,
        note=case.note,
    )
    return replace(made, version=case.version)


def unproved(case: Case) -> Iterator[tuple[str, str]]:
    """Yield each claim of a case that its certificates do not prove, with the reason.

    The certificate of a sweep also claims the no-fit polygon.
    """
    claims: dict[str, Callable[[], dict[str, Any]]] = {"sweep": case.sweep().certificate}
    if case.inner_regions is not None:
        f = inner_fit_polygon(case.directrix, case.generatrix, reference=case.reference)
        claims["inner fit"] = f.certificate
    for claim, certificate in claims.items():
        if not (found := verify(certificate())).proved:
            yield claim, found.reason


def digest(case: Case) -> str:
    """Return a short digest of the data that must never change for an id."""
    data = case_to_json(case)
    parts = "directrix", "generatrix", "reference", "directrix_holes", "generatrix_holes"
    text = json.dumps([data[part] for part in parts if part in data])
    return sha256(text.encode()).hexdigest()[:12]


COMPRESSED = ("large",)


def encoded(theme: str, text: str) -> tuple[str, bytes]:
    """Return the name and the content of the file of a theme."""
    if theme in COMPRESSED:
        return f"{theme}.json.xz", lzma.compress(text.encode(), preset=9)
    return f"{theme}.json", text.encode()


def written(theme: str, cases: list[Case]) -> str:
    """Write the file of a theme: one name per line, and each long list on one line."""
    head = f'{{\n "theme": {json.dumps(theme)},\n "title": {json.dumps(themes()[theme])},\n'
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
