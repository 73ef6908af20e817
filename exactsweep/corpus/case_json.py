"""Cases as JSON data: every number a string, a reduced rational."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from exactsweep.corpus.case import KINDS, Case, CaseError
from exactsweep.corpus.representable import NUMBER_TYPES
from exactsweep.formats.exact_json import described
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.number import NumberError, format_fraction, to_fraction
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon

_RATIONAL = re.compile(r"0|-?[1-9][0-9]*(/[1-9][0-9]*)?")


def case_to_json(case: Case) -> dict[str, Any]:
    """Write a case as plain JSON data.

    Args:
        case: a Case.

    Returns:
        A dict ready for `json.dump`; `schema.json` beside this module describes it.

    Cost: linear.

    Example:
        >>> square = [(0, 0), ("1/2", 0), ("1/2", 1), (0, 1)]
        >>> data = case_to_json(Case.of("mine-1", "a square around itself", square, square))
        >>> data["directrix"][1], data["integer_scale"], data["expected"]["counts"]["outer"]
        (['1/2', '0'], '2', 4)
    """
    return {
        "id": case.id,
        "title": case.title,
        "class": case.kind,
        "flags": list(case.flags),
        "directrix": _points(case.directrix_ring),
        "generatrix": _points(case.generatrix_ring),
        "reference": _point(case.reference),
        "representable": _types(case.representable),
        "integer_scale": format_fraction(Fraction(case.integer_scale)),
        "expected": {
            "trajectory": _points(case.trajectory.vertices),
            "inner": _points(case.inner.vertices),
            "outer": _points(case.outer.vertices),
            "exact_fits": [_points(fit) for fit in case.exact_fits],
            "area": format_fraction(case.area),
            "counts": _counts(case),
            "representable": _types(case.answer_representable),
        },
    }


def case_from_json(data: object) -> Case:
    """Read a case; the sweep is not computed again.

    Args:
        data: what `case_to_json` returns, or `json.load`.

    Returns:
        The Case.

    Raises:
        CaseError: anything else, and a case whose counts, number types, integer scale or loops
            contradict the rest; the message starts with the path to what is wrong.

    Cost: linear, and O(n log n) for each polygon.

    Example:
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> case = Case.of("mine-1", "a square around itself", square, square)
        >>> case_from_json(case_to_json(case)) == case
        True
    """
    top = _object(data, "$")
    expected = _object(_part(top, "expected", "$"), "$.expected")
    fits = [
        _read_fit(fit, f"$.expected.exact_fits[{k}]")
        for k, fit in enumerate(_list(_part(expected, "exact_fits", "$.expected"), "$.expected"))
    ]
    kind = _text(top, "class", "$")
    if kind not in KINDS:
        raise CaseError(f"$.class is {described(kind)}, not one of {', '.join(KINDS)}")
    case = Case(
        id=_text(top, "id", "$"),
        title=_text(top, "title", "$"),
        directrix_ring=_read_points(_part(top, "directrix", "$"), "$.directrix"),
        generatrix_ring=_read_points(_part(top, "generatrix", "$"), "$.generatrix"),
        reference=_read_point(_part(top, "reference", "$"), "$.reference"),
        kind=kind,
        flags=_texts(top, "flags", "$"),
        trajectory=_read_loop(expected, "trajectory"),
        inner=_read_loop(expected, "inner"),
        outer=_read_loop(expected, "outer"),
        exact_fits=tuple(fits),
        area=_read_number(_part(expected, "area", "$.expected"), "$.expected.area"),
    )
    _require_consistent(case, top, expected)
    return case


def _require_consistent(
    case: Case, top: Mapping[str, object], expected: Mapping[str, object]
) -> None:
    for ring, name in (case.directrix_ring, "directrix"), (case.generatrix_ring, "generatrix"):
        try:
            Polygon(ring)
        except PolygonError as error:
            raise CaseError(f"$.{name}: {error}") from None
    for place, found, right in [
        ("$.representable", _texts(top, "representable", "$"), _types(case.representable)),
        (
            "$.integer_scale",
            _read_number(_part(top, "integer_scale", "$"), "$.integer_scale"),
            case.integer_scale,
        ),
        ("$.expected.counts", _part(expected, "counts", "$.expected"), _counts(case)),
        (
            "$.expected.representable",
            _texts(expected, "representable", "$.expected"),
            _types(case.answer_representable),
        ),
    ]:
        if (list(found) if isinstance(found, tuple) else found) != right:
            raise CaseError(f"{place} is not {right}")


def _counts(case: Case) -> dict[str, int]:
    return {
        "trajectory": len(case.trajectory),
        "inner": len(case.inner),
        "outer": len(case.outer),
        "exact_fits": len(case.exact_fits),
    }


def _types(held: Iterable[str]) -> list[str]:
    return [name for name in NUMBER_TYPES if name in held]


def _points(points: Iterable[Point]) -> list[list[str]]:
    return [_point(point) for point in points]


def _point(point: Point) -> list[str]:
    return [format_fraction(c) for c in point]


def _object(value: object, path: str) -> Mapping[str, object]:
    if not isinstance(value, dict):
        raise CaseError(f"{path} is {described(value)}, not an object")
    return value


def _part(value: Mapping[str, object], name: str, path: str) -> object:
    try:
        return value[name]
    except KeyError:
        raise CaseError(f"{path} has no {name!r}") from None


def _list(value: object, path: str) -> list[object]:
    if not isinstance(value, list):
        raise CaseError(f"{path} is {described(value)}, not a list")
    return value


def _text(value: Mapping[str, object], name: str, path: str) -> str:
    text = _part(value, name, path)
    if not isinstance(text, str):
        raise CaseError(f"{path}.{name} is {described(text)}, not a string")
    return text


def _texts(value: Mapping[str, object], name: str, path: str) -> tuple[str, ...]:
    found = []
    for k, text in enumerate(_list(_part(value, name, path), f"{path}.{name}")):
        if not isinstance(text, str):
            raise CaseError(f"{path}.{name}[{k}] is {described(text)}, not a string")
        found.append(text)
    return tuple(found)


def _read_loop(expected: Mapping[str, object], name: str) -> Polygon:
    path = f"$.expected.{name}"
    points = _read_points(_part(expected, name, "$.expected"), path)
    try:
        loop = Polygon(points)
    except PolygonError as error:
        raise CaseError(f"{path}: {error}") from None
    if loop.vertices != points:
        raise CaseError(f"{path} is not in canonical form")
    return loop


def _read_fit(value: object, path: str) -> tuple[Point, Point]:
    points = _read_points(value, path)
    if len(points) != 2:
        raise CaseError(f"{path} has {len(points)} ends, not 2")
    return points[0], points[1]


def _read_points(value: object, path: str) -> tuple[Point, ...]:
    return tuple(_read_point(p, f"{path}[{k}]") for k, p in enumerate(_list(value, path)))


def _read_point(value: object, path: str) -> Point:
    pair = _list(value, path)
    if len(pair) != 2:
        raise CaseError(f"{path} has {len(pair)} coordinates, not 2")
    x, y = (_read_number(c, f"{path}[{k}]") for k, c in enumerate(pair))
    return Point(x, y)


def _read_number(value: object, path: str) -> Fraction:
    if not isinstance(value, str) or not _RATIONAL.fullmatch(value):
        raise CaseError(f'{path} is {described(value)}, not a rational such as "-7/2"')
    try:
        number = to_fraction(value)
    except NumberError as error:
        raise CaseError(f"{path}: {error}") from None
    if "/" in value and format_fraction(number) != value:
        raise CaseError(f"{path} is {described(value)}, not reduced")
    return number


def case_to_line(case: Case) -> str:
    """Write a case as one line of JSON, its end of line included."""
    return json.dumps(case_to_json(case), separators=(",", ":")) + "\n"
