"""Readers of polygons from text and files; the content determines the format."""

import os
from collections.abc import Callable
from contextlib import AbstractContextManager
from typing import TypeVar, Unpack

from exactsweep.formats.candidate import Candidate, NamedPolygon, NamedRegion
from exactsweep.formats.choice import choose, is_group, select
from exactsweep.formats.error import FormatError
from exactsweep.formats.files import read_text, show_path
from exactsweep.formats.parsing import parse_candidates
from exactsweep.formats.part_list import PartList, Remarks, summarize
from exactsweep.formats.reading import Options
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.error import explain_type_errors, prefix_errors

_Taken = TypeVar("_Taken")
_OneRead = TypeVar("_OneRead")


@explain_type_errors
def parse_polygon(
    text: str,
    choice: str | None = None,
    tolerance: object = None,
    **options: Unpack[Options],
) -> Polygon:
    """Read one polygon from JSON, GeoJSON, WKT, CSV, SVG or DXF.

    Args:
        text: as for `parse_polygons`.
        choice: the name, index, layer or group of one polygon; None if there is only one.
        tolerance: as for `parse_polygons`, but required for curves.
        options: as for `parse_polygons`.

    Raises:
        FormatError: as for `parse_polygons`, or the choice is ambiguous.
        PolygonError: not a simple polygon; the message gives the indices of vertices.

    Example:
        >>> text = '<svg><rect id="a" width="2" height="1"/><path d="M0 0h1v1z"/></svg>'
        >>> print(parse_polygon(text, "a"), "and", parse_polygon(text, "1"))
        (0, 0) (2, 0) (2, 1) (0, 1) and (0, 0) (1, 0) (1, 1)
    """
    found = parse_candidates(text, tolerance, **options)
    return _read_one(choose(found, choice), Candidate.polygon, tolerance)


@explain_type_errors
def parse_polygons(
    text: str, tolerance: object = None, **options: Unpack[Options]
) -> PartList[NamedPolygon]:
    """Read all polygons in a string.

    Args:
        text: JSON as for `exactsweep.formats.json_polygons.read_exact`, one document or one per
            line; GeoJSON, WKT, CSV, SVG or ASCII DXF. Decimals are exact; JSON strings may be
            fractions.
        tolerance: the maximum distance between a curve and its chords, a positive number; None for
            about a thousandth of the size of each outline.
        options: see `exactsweep.formats.reading.Options`.

    Returns:
        A PartList of NamedPolygon, in file order. `left_out` lists hidden elements, rejected
        elements and polygons with holes, with their locations.

    Raises:
        FormatError: an unknown format, or no valid polygon.
        PolygonError: no valid polygon, and the first element is not a simple polygon.

    Cost: linear in the length of the text, plus the cost of `Polygon`.

    Example:
        >>> a, b = parse_polygons("POLYGON ((0 0, 1 0, 0 1, 0 0)) POLYGON ((0 0, 2 0, 0 2, 0 0))")
        >>> print(b.polygon)
        (0, 0) (2, 0) (0, 2)
    """
    return parse_candidates(text, tolerance, **options).read_each(Candidate.named_polygons)


@explain_type_errors
def parse_region(
    text: str,
    choice: str | None = None,
    tolerance: object = None,
    **options: Unpack[Options],
) -> Region:
    """Read one polygon with its holes; arguments and errors as for `parse_polygon`.

    >>> parse_region("POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1))").area
    Fraction(15, 2)
    """
    found = parse_candidates(text, tolerance, **options)
    return _read_one(choose(found, choice), Candidate.region, tolerance)


@explain_type_errors
def parse_regions(
    text: str, tolerance: object = None, **options: Unpack[Options]
) -> PartList[NamedRegion]:
    """Read all polygons in a string, with their holes, like `parse_polygons`.

    Holes are inner rings, "holes" in JSON, and SVG subpaths that the fill rule leaves empty.

    >>> path = '<path fill-rule="evenodd" d="M0 0H4V4H0z M1 1h1v1z"/>'
    >>> [part.region.area for part in parse_regions(f"<svg>{path}</svg>")]
    [Fraction(31, 2)]
    """
    return parse_candidates(text, tolerance, **options).read_each(Candidate.named_regions)


@explain_type_errors
def read_polygon(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> Polygon:
    """Read one polygon from a file, or from standard input for "-"; errors name the file.

    The path may end with "#" and a choice; other arguments as for `parse_polygon`.
    """
    return _read_file(
        path, lambda f, c: _read_one(choose(f, c), Candidate.polygon, tolerance), tolerance, options
    )


@explain_type_errors
def read_region(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> Region:
    """Read one polygon with its holes from a file, like `read_polygon`."""
    return _read_file(
        path, lambda f, c: _read_one(choose(f, c), Candidate.region, tolerance), tolerance, options
    )


@explain_type_errors
def read_polygons(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> PartList[NamedPolygon]:
    """Read all polygons in a file, or those selected by a choice after "#".

    Arguments as for `read_polygon`; returns the same as `parse_polygons`.
    """
    return _read_file(
        path, lambda f, c: _select(f, c).read_each(Candidate.named_polygons), tolerance, options
    )


@explain_type_errors
def read_regions(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> PartList[NamedRegion]:
    """Read all polygons in a file, with their holes, like `read_polygons`."""
    return _read_file(
        path, lambda f, c: _select(f, c).read_each(Candidate.named_regions), tolerance, options
    )


def read_candidates(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> PartList[Candidate]:
    return _read_file(path, _select, tolerance, options)


def read_choice(
    path: str | os.PathLike[str],
    tolerance: object = None,
    *,
    groups: bool = False,
    **options: Unpack[Options],
) -> PartList[Candidate]:
    """Find one polygon in a file, like `read_region`, or with `groups` a group of outlines."""

    def take(found: PartList[Candidate], choice: str | None) -> PartList[Candidate]:
        if groups and choice and is_group(outlines := select(found, choice), choice):
            return found.replaced(outlines)
        chosen = choose(found, choice)
        others = [one.fault for one in found if one.ornament and one is not chosen]
        return found.replaced([chosen], [] if choice else others)

    return _read_file(path, take, tolerance, options)


def _read_one(
    one: Candidate, read: Callable[[Candidate], _OneRead], tolerance: object = None
) -> _OneRead:
    """Read a polygon; reject curves without a tolerance."""
    if one.error and tolerance is None:
        raise FormatError(
            f"{one.place}: curves need a tolerance, for example 0.01; "
            "read_regions chooses one and returns the error"
        )
    return read_single(one, read)


def read_single(one: Candidate, read: Callable[[Candidate], _OneRead]) -> _OneRead:
    remarks = Remarks([], [])
    found = one.read(read, remarks)
    if len(found) == 1:
        return found[0]
    if not found:
        raise FormatError(summarize(remarks.left_out))
    hint = "'exactsweep convert' separates them, --clean drops small ones"
    raise FormatError(f"{one.place}: fills {len(found)} polygons; {hint}")


def _select(found: PartList[Candidate], choice: str | None) -> PartList[Candidate]:
    return found if choice is None else found.replaced(select(found, choice))


def _read_file(
    path: str | os.PathLike[str],
    take: Callable[[PartList[Candidate], str | None], _Taken],
    tolerance: object,
    options: Options,
) -> _Taken:
    file, choice = split_choice(path)
    with prefix_path(file):
        return take(parse_candidates(read_text(file), tolerance, **options), choice)


def split_choice(path: str | os.PathLike[str]) -> tuple[str, str | None]:
    """Split FILE#CHOICE; both parts may contain "#"."""
    if isinstance(path, os.PathLike):
        path = os.fspath(path)
    if not isinstance(path, str):
        raise FormatError(f"{type(path).__name__} is not a path")
    if os.path.lexists(path):
        return path, None
    places = [k for k, letter in enumerate(path) if letter == "#" and k > 0]
    if not places:
        return path, None
    # Prefer the longest existing path, else the shortest for the message.
    there = (k for k in reversed(places) if path[:k] == "-" or os.path.lexists(path[:k]))
    k = next(there, places[0])
    return path[:k], path[k + 1 :]


def prefix_path(file: str) -> AbstractContextManager[None]:
    return prefix_errors(show_path(file), FormatError)
