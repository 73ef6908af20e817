"""Cases as JSON data: every number a string, a reduced rational."""

from __future__ import annotations

import json
from collections.abc import Iterable
from fractions import Fraction
from typing import Any

from exactsweep.corpus.case import KINDS, Case, CaseError
from exactsweep.corpus.representable import NUMBER_TYPES
from exactsweep.formats.exact_json import described, read_number, read_point, read_vertices
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.number import format_fraction, quoted
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon


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
        CaseError: anything else, and a case that `case_to_json` would write otherwise: with
            numbers that are not reduced, loops that are not canonical, counts or number types that
            contradict the rest. The message starts with the path to what is wrong.

    Cost: linear, and O(n log n) for each polygon.

    Example:
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> case = Case.of("mine-1", "a square around itself", square, square)
        >>> case_from_json(case_to_json(case)) == case
        True
    """
    try:
        case = _read(data)
        _require_same(case_to_json(case), data, "$")
    except ValueError as error:
        raise CaseError(str(error)) from None
    return case


def _read(data: object) -> Case:
    expected = _member(data, "expected", "$")
    kind = _text(_member(data, "class", "$"), "$.class")
    if kind not in KINDS:
        raise CaseError(f"$.class is {described(kind)}, not one of {', '.join(KINDS)}")
    fits = []
    for k, fit in enumerate(_list(expected, "exact_fits", "$.expected")):
        ends = read_vertices(fit, f"$.expected.exact_fits[{k}]")
        if len(ends) != 2:
            raise CaseError(f"$.expected.exact_fits[{k}] has {len(ends)} ends, not 2")
        fits.append((ends[0], ends[1]))
    d, g = (_ring(data, name, "$")[0] for name in ("directrix", "generatrix"))
    trajectory, inner, outer = (
        _ring(expected, name, "$.expected")[1] for name in ("trajectory", "inner", "outer")
    )
    return Case(
        id=_text(_member(data, "id", "$"), "$.id"),
        title=_text(_member(data, "title", "$"), "$.title"),
        directrix_ring=d,
        generatrix_ring=g,
        reference=read_point(_member(data, "reference", "$"), "$.reference"),
        kind=kind,
        flags=tuple(
            _text(flag, f"$.flags[{k}]") for k, flag in enumerate(_list(data, "flags", "$"))
        ),
        trajectory=trajectory,
        inner=inner,
        outer=outer,
        exact_fits=tuple(fits),
        area=read_number(_member(expected, "area", "$.expected"), "$.expected.area"),
    )


def _require_same(right: Any, found: object, path: str) -> None:
    """Refuse what is written otherwise than a case is: not reduced, not canonical, miscounted."""
    if isinstance(right, dict):
        for name, part in right.items():
            _require_same(part, _member(found, name, path), f"{path}.{name}")
    elif isinstance(right, list) and isinstance(found, list) and len(right) == len(found):
        for k, (part, other) in enumerate(zip(right, found, strict=True)):
            _require_same(part, other, f"{path}[{k}]")
    elif found != right:
        raise CaseError(f"{path} is not {quoted(right)}")


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


def _member(value: object, name: str, path: str) -> object:
    if not isinstance(value, dict):
        raise CaseError(f"{path} is {described(value)}, not an object")
    if name not in value:
        raise CaseError(f"{path} has no {name!r}")
    return value[name]


def _list(value: object, name: str, path: str) -> list[object]:
    found = _member(value, name, path)
    if not isinstance(found, list):
        raise CaseError(f"{path}.{name} is {described(found)}, not a list")
    return found


def _text(value: object, path: str) -> str:
    if not isinstance(value, str):
        raise CaseError(f"{path} is {described(value)}, not a string")
    return value


def _ring(value: object, name: str, path: str) -> tuple[tuple[Point, ...], Polygon]:
    points = read_vertices(_member(value, name, path), f"{path}.{name}")
    try:
        return tuple(points), Polygon(points)
    except PolygonError as error:
        raise CaseError(f"{path}.{name}: {error}") from None


def case_to_line(case: Case) -> str:
    """Write a case as one line of JSON, its end of line included."""
    return json.dumps(case_to_json(case), separators=(",", ":")) + "\n"
