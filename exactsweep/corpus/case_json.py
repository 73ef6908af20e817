"""Cases as JSON data: every number a string, a reduced rational."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import Any

from exactsweep.corpus.case import KINDS, Case, CaseError
from exactsweep.corpus.representable import NUMBER_TYPES
from exactsweep.formats.exact_json import describe_kind, read_point, read_vertices
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.arguments import tells_arguments
from exactsweep.numbers.number import format_fraction, quote
from exactsweep.numbers.point import Fit, Loop, Point

GivenRing = tuple[Loop, Polygon]


@tells_arguments
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
    data: dict[str, Any] = {
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
    for name in ("directrix_holes", "generatrix_holes"):
        if holes := getattr(case, name):
            data[name] = [_points(hole) for hole in holes]
    if case.kind == "SS":
        for name in ("holes", "unswept"):
            data["expected"][name] = [_points(loop.vertices) for loop in getattr(case, name)]
    if case.inner_regions is not None:
        data["expected"]["inner_fit"] = {
            "regions": [_region(region) for region in case.inner_regions],
            "exact_fits": [_points(fit) for fit in case.inner_exact_fits],
        }
    if case.note:
        data["note"] = case.note
    if case.version != 1:
        data["version"] = case.version
    return data


@tells_arguments
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


def _read(document: object) -> Case:
    data = _object(document, "$")
    expected = _object(_member(data, "expected", "$"), "$.expected")
    kind = _text(_member(data, "class", "$"), "$.class")
    if kind not in KINDS:
        raise CaseError(f"$.class is {describe_kind(kind)}, not one of {', '.join(KINDS)}")
    d, g = (_ring(data, name, "$")[0] for name in ("directrix", "generatrix"))
    trajectory, inner, outer = (
        _ring(expected, name, "$.expected")[1] for name in ("trajectory", "inner", "outer")
    )
    d_holes, g_holes = (
        _rings(data, name, "$") if name in data else ()
        for name in ("directrix_holes", "generatrix_holes")
    )
    inside = expected.get("inner_fit")
    holes, unswept = (
        _rings(expected, name, "$.expected") if kind == "SS" else ()
        for name in ("holes", "unswept")
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
        exact_fits=_fits(expected, "$.expected"),
        # The reader compares the area in the document, of any length, with this one.
        area=outer.area - add_up(loop.area for loop in (inner, *(p for _, p in unswept))),
        directrix_holes=tuple(points for points, _ in d_holes),
        generatrix_holes=tuple(points for points, _ in g_holes),
        holes=tuple(hole for _, hole in holes),
        unswept=tuple(loop for _, loop in unswept),
        inner_regions=None if inside is None else _regions(inside, "$.expected.inner_fit"),
        inner_exact_fits=() if inside is None else _fits(inside, "$.expected.inner_fit"),
        note=_text(data["note"], "$.note") if "note" in data else "",
        version=_whole(data.get("version", 1), "$.version"),
    )


def _regions(value: object, path: str) -> tuple[Region, ...]:
    regions = []
    for k, region in enumerate(_list(value, "regions", path)):
        place = f"{path}.regions[{k}]"
        _, exterior = _ring(region, "exterior", place)
        holes = [hole for _, hole in _rings(region, "holes", place)]
        try:
            regions.append(Region(exterior, holes))
        except PolygonError as error:
            raise CaseError(f"{place}: {error}") from None
    return tuple(regions)


def _fits(value: object, path: str) -> tuple[Fit, ...]:
    fits = []
    for k, fit in enumerate(_list(value, "exact_fits", path)):
        ends = read_vertices(fit, f"{path}.exact_fits[{k}]")
        if len(ends) != 2:
            raise CaseError(f"{path}.exact_fits[{k}] has {len(ends)} ends, not 2")
        fits.append((ends[0], ends[1]))
    return tuple(fits)


def _require_same(right: Any, found: object, path: str) -> None:
    """Refuse what is written otherwise than a case is: not reduced, not canonical, miscounted."""
    if isinstance(right, dict):
        for name, part in right.items():
            _require_same(part, _member(found, name, path), f"{path}.{name}")
    elif isinstance(right, list) and isinstance(found, list) and len(right) == len(found):
        for k, (part, other) in enumerate(zip(right, found, strict=True)):
            _require_same(part, other, f"{path}[{k}]")
    elif found != right:
        raise CaseError(f"{path} is not {quote(right)}")


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


def _region(region: Region) -> dict[str, Any]:
    exterior, *holes = map(_points, region.rings)
    return {"exterior": exterior, "holes": holes}


def _object(value: object, path: str) -> dict[str, object]:
    if not isinstance(value, dict):
        raise CaseError(f"{path} is {describe_kind(value)}, not an object")
    return value


def _member(value: object, name: str, path: str) -> object:
    found = _object(value, path)
    if name not in found:
        raise CaseError(f"{path} has no {name!r}")
    return found[name]


def _list(value: object, name: str, path: str) -> list[object]:
    found = _member(value, name, path)
    if not isinstance(found, list):
        raise CaseError(f"{path}.{name} is {describe_kind(found)}, not a list")
    return found


def _text(value: object, path: str) -> str:
    if not isinstance(value, str):
        raise CaseError(f"{path} is {describe_kind(value)}, not a string")
    return value


def _whole(value: object, path: str) -> int:
    if not isinstance(value, int) or isinstance(value, bool) or value < 1:
        raise CaseError(f"{path} is {describe_kind(value)}, not a positive integer")
    return value


def _ring(value: object, name: str, path: str) -> GivenRing:
    return _loop(_member(value, name, path), f"{path}.{name}")


def _rings(value: object, name: str, path: str) -> tuple[GivenRing, ...]:
    found = enumerate(_list(value, name, path))
    return tuple(_loop(ring, f"{path}.{name}[{k}]") for k, ring in found)


def _loop(value: object, path: str) -> GivenRing:
    """Read a ring as it is given, and as a Polygon."""
    points = read_vertices(value, path)
    try:
        return tuple(points), Polygon(points)
    except PolygonError as error:
        raise CaseError(f"{path}: {error}") from None


FITS = {"exact_fits": "no_fit", "inner_exact_fits": "inner_fit"}
"""Parts of an answer that are segments, each with the part on whose rings they may hang."""
OF_POSITIONS = ("trajectory", "no_fit", "inner_fit", *FITS)
"""Parts of an answer that are positions of the reference point."""


def list_expected_rings(data: Mapping[str, Any], name: str) -> list[Any]:
    """Return the rings, or the segments, of a part of the answer, as a case has them as JSON.

    Args:
        data: as by `case_to_json`.
        name: "trajectory", "inner", "outer", "no_fit", "inner_fit", or a key of FITS.

    Example:
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> data = case_to_json(Case.of("mine-1", "a square around itself", square, square))
        >>> list_expected_rings(data, "no_fit")
        [[['-1', '-1'], ['1', '-1'], ['1', '1'], ['-1', '1']]]
    """
    expected = data["expected"]
    inside = expected.get("inner_fit", {"regions": [], "exact_fits": []})
    if name == "inner_fit":
        return [ring for r in inside["regions"] for ring in (r["exterior"], *r["holes"])]
    parts: dict[str, list[Any]] = {
        "trajectory": [expected["trajectory"]],
        "inner": [expected["inner"], *expected.get("unswept", ())],
        "outer": [expected["outer"]],
        "no_fit": [expected["trajectory"], *expected.get("holes", ())],
        "exact_fits": expected["exact_fits"],
        "inner_exact_fits": inside["exact_fits"],
    }
    return parts[name]


def case_to_line(case: Case) -> str:
    """Write a case as one line of JSON, its end of line included."""
    return json.dumps(case_to_json(case), separators=(",", ":")) + "\n"
