"""Cases as JSON data, with numbers as strings, in lowest terms."""

import json
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from exactsweep.corpus.answered import NUMBER_TYPES
from exactsweep.corpus.case import KINDS, Case, CaseError
from exactsweep.formats.exact_json import describe_kind, read_point, read_vertices
from exactsweep.formats.node import JsonNode
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.digits import to_plain
from exactsweep.numbers.error import explain_type_errors, prefix_errors, quote
from exactsweep.numbers.number import Fit, Loop
from exactsweep.words import suggest

# Permitted members that `case_to_json` omits.
_DEFAULTS: dict[str, object] = {
    "version": 1,
    "note": "",
    "directrix_holes": [],
    "generatrix_holes": [],
}


@explain_type_errors
def case_to_json(case: Case) -> dict[str, Any]:
    """Write a case as a dict for `json.dump` in the format of `schema.json`."""
    expected: dict[str, Any] = {
        "trajectory": case.trajectory.vertices,
        "inner": case.inner.vertices,
        "outer": case.outer.vertices,
        "exact_fits": case.exact_fits,
        "area": case.area,
        "counts": {
            name: len(getattr(case, name))
            for name in ("trajectory", "inner", "outer", "exact_fits")
        },
        "representable": _types(case.answer_representable),
    }
    data: dict[str, Any] = {
        "id": case.id,
        "title": case.title,
        "class": case.kind,
        "flags": case.flags,
        "directrix": case.directrix_ring,
        "generatrix": case.generatrix_ring,
        "reference": case.reference,
        "representable": _types(case.representable),
        "integer_scale": Fraction(case.integer_scale),
        "expected": expected,
    }
    for name in ("directrix_holes", "generatrix_holes"):
        if holes := getattr(case, name):
            data[name] = holes
    if case.kind == "SS":
        for name in ("holes", "unswept"):
            expected[name] = [loop.vertices for loop in getattr(case, name)]
    if case.inner_regions is not None:
        expected["inner_fit"] = {
            "regions": [
                {"exterior": region.rings[0], "holes": region.rings[1:]}
                for region in case.inner_regions
            ],
            "exact_fits": case.inner_exact_fits,
        }
    if case.note:
        data["note"] = case.note
    if case.version != 1:
        data["version"] = case.version
    return to_plain(data)


@explain_type_errors
def case_from_json(data: object) -> Case:
    """Read a case without computing the sweep again.

    Args:
        data: the result of `case_to_json` or `json.load`.

    Raises:
        CaseError: the data differs from the result of `case_to_json`, for example in unreduced
        fractions or unknown members. The message starts with the path to the error.

    Example:
        >>> square = [(0, 0), ("1/2", 0), ("1/2", 1), (0, 1)]
        >>> case = Case.of("mine-1", "a square around itself", square, square)
        >>> data = case_to_json(case)
        >>> data["directrix"][1], data["integer_scale"], case_from_json(data) == case
        (['1/2', '0'], '2', True)
    """
    try:
        case = _read(JsonNode(data))
        _require_same(case_to_json(case), JsonNode(data))
    except ValueError as error:
        raise CaseError(str(error)) from None
    return case


def _read(data: JsonNode) -> Case:
    expected, kind, version = data / "expected", (data / "class").text, data.get("version", 1)
    if kind not in KINDS:
        raise CaseError(f"$.class is {describe_kind(kind)}, not one of {', '.join(KINDS)}")
    if type(version.value) is not int or version.value < 1:
        version.fail(f"{describe_kind(version.value)}, not a positive integer")
    trajectory, inner, outer = (
        _polygon(expected / name) for name in ("trajectory", "inner", "outer")
    )
    holes, unswept = (
        tuple(map(_polygon, (expected / name).each())) if kind == "SS" else ()
        for name in ("holes", "unswept")
    )
    inside = expected / "inner_fit" if expected.has("inner_fit") else None
    return Case(
        id=(data / "id").text,
        title=(data / "title").text,
        directrix_ring=_given(data / "directrix"),
        generatrix_ring=_given(data / "generatrix"),
        reference=read_point(*(data / "reference")),
        kind=kind,
        flags=tuple(flag.text for flag in (data / "flags").each()),
        trajectory=trajectory,
        inner=inner,
        outer=outer,
        exact_fits=_fits(expected),
        # `_require_same` compares the area in the document with this one.
        area=outer.area - add_up(loop.area for loop in (inner, *unswept)),
        directrix_holes=tuple(map(_given, data.get("directrix_holes", []).each())),
        generatrix_holes=tuple(map(_given, data.get("generatrix_holes", []).each())),
        holes=holes,
        unswept=unswept,
        inner_regions=None if inside is None else tuple(map(_region, (inside / "regions").each())),
        inner_exact_fits=() if inside is None else _fits(inside),
        note=data.get("note", "").text,
        version=version.value,
    )


def _given(ring: JsonNode) -> Loop:
    points = read_vertices(*ring)
    with prefix_errors(ring.path):
        Polygon(points)
    return tuple(points)


def _polygon(ring: JsonNode) -> Polygon:
    return Polygon(_given(ring))


def _region(region: JsonNode) -> Region:
    exterior, holes = _polygon(region / "exterior"), map(_polygon, (region / "holes").each())
    with prefix_errors(region.path):
        return Region(exterior, [*holes])


def _fits(answer: JsonNode) -> tuple[Fit, ...]:
    fits = []
    for fit in (answer / "exact_fits").each():
        ends = read_vertices(*fit)
        if len(ends) != 2:
            raise CaseError(f"{fit.path} has {len(ends)} ends, not 2")
        fits.append((ends[0], ends[1]))
    return tuple(fits)


def _require_same(right: Any, found: JsonNode) -> None:
    """Reject data that differs from the canonical JSON of the case."""
    if isinstance(right, dict):
        for name, part in right.items():
            _require_same(part, found / name)
        assert isinstance(found.value, Mapping)
        defaults = _DEFAULTS if found.path == "$" else {}
        for name, value in found.value.items():
            if name not in right and (name not in defaults or value not in (None, defaults[name])):
                known = (*right, *defaults)
                raise CaseError(
                    f"{found.path} has an unknown key {quote(name)}{suggest(name, known)}"
                )
        return
    value = found.value
    if isinstance(right, list) and isinstance(value, list) and len(right) == len(value):
        for part, other in zip(right, found.each(), strict=True):
            _require_same(part, other)
    elif value != right:
        raise CaseError(f"{found.path} is not {quote(right)}")


def _types(held: Iterable[str]) -> list[str]:
    return [name for name in NUMBER_TYPES if name in held]


def case_to_line(case: Case) -> str:
    return json.dumps(case_to_json(case), separators=(",", ":")) + "\n"
