"""Polygons from text and files, in whichever format the content shows."""

import os
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Unpack

from exactsweep.formats.candidate import (
    Candidate,
    NamedPolygon,
    NamedRegion,
    allow_faults,
    choose,
    read_each,
    select,
)
from exactsweep.formats.csv import is_csv, parse_csv
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import count_vertices, parse_json, read_exact
from exactsweep.formats.files import DXF_SIGN, read_text, show_path
from exactsweep.formats.geojson import read_geojson
from exactsweep.formats.nesting import nest_candidates
from exactsweep.formats.reading import Options, Reading
from exactsweep.formats.size import ELEMENT, ENTITY, measure_text, require_text
from exactsweep.formats.wkt import parse_wkt
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.numbers.arguments import tells_arguments

# A group code 0 and the name that follows it.
_ENTITY = re.compile(r"(?m)^ *0\n[A-Z]")


@tells_arguments
def parse_polygon(
    text: str,
    choice: str | None = None,
    tolerance: object = None,
    **options: Unpack[Options],
) -> Polygon:
    """Read a polygon from exact JSON, GeoJSON, WKT, CSV, SVG or DXF.

    Args:
        text: as `parse_polygons` takes it.
        choice: the name, the index or the layer of one polygon, tried in this order; not needed
            where there is only one.
        tolerance: as for `parse_polygons`.
        options: likewise.

    Returns:
        A Polygon.

    Raises:
        FormatError: as by `parse_polygons`, or it is not clear which polygon is meant.
        PolygonError: not a simple polygon; the message names vertices by their index.

    Cost: linear in the length of the text, and that of `Polygon`.

    Example:
        >>> parse_polygon("[[0, 0], [0.5, 0], [0, 1e0]]") == parse_polygon(
        ...     "POLYGON ((0 0, 0.5 0, 0 1, 0 0))"
        ... )
        True
        >>> text = '<svg><rect id="a" width="2" height="1"/><path d="M0 0h1v1z"/></svg>'
        >>> print(parse_polygon(text, "a"), "and", parse_polygon(text, "1"))
        (0, 0) (2, 0) (2, 1) (0, 1) and (0, 0) (1, 0) (1, 1)
    """
    return choose(parse_candidates(text, tolerance, **options), choice).polygon()


@tells_arguments
def parse_polygons(
    text: str, tolerance: object = None, **options: Unpack[Options]
) -> list[NamedPolygon]:
    """Read all polygons of a text.

    Args:
        text: JSON as `exactsweep.formats.exact_json.read_exact` reads it, or a line of it for each
            polygon or result; GeoJSON; WKT POLYGONs and MULTIPOLYGONs; CSV with columns x and y; an
            SVG document; an ASCII DXF file. Numbers are decimals, exactly as they are written; in
            JSON, strings such as "-7/2" are numbers, too.
        tolerance: how far lines may be from the curves of SVG and DXF that they replace, a
            positive number as `to_fraction` reads it; None to refuse curves.
        options: "nested", "join" and "unit", as `exactsweep.formats.reading.Options` has them.

    Returns:
        list of NamedPolygon, in order.

    Raises:
        FormatError: none of these formats, or something in it that is no polygon, or one with
            holes, for which there is `parse_regions`; the message says where, by line and column or
            by JSON path.
        PolygonError: not a simple polygon; the message names vertices by their index.

    Cost: linear in the length of the text, and that of `Polygon`.

    Example:
        >>> a, b = parse_polygons("POLYGON ((0 0, 1 0, 0 1, 0 0)) POLYGON ((0 0, 2 0, 0 2, 0 0))")
        >>> print(b.polygon)
        (0, 0) (2, 0) (0, 2)
    """
    return read_each(parse_candidates(text, tolerance, **options), Candidate.named_polygon)


@tells_arguments
def parse_region(
    text: str,
    choice: str | None = None,
    tolerance: object = None,
    **options: Unpack[Options],
) -> Region:
    """Read a polygon with its holes.

    Args:
        text: as `parse_regions` takes it.
        choice: as for `parse_polygon`.
        tolerance: as for `parse_polygons`.
        options: likewise.

    Returns:
        A Region, without holes where there are none.

    Raises:
        FormatError: as by `parse_regions`, or it is not clear which polygon is meant.
        PolygonError: not a region; the message names rings, and vertices by their index.

    Cost: linear in the length of the text, and that of `Region`.

    Example:
        >>> parse_region("POLYGON ((0 0, 4 0, 0 4, 0 0), (1 1, 2 1, 1 2, 1 1))").area
        Fraction(15, 2)
    """
    return choose(parse_candidates(text, tolerance, **options), choice).region()


@tells_arguments
def parse_regions(
    text: str, tolerance: object = None, **options: Unpack[Options]
) -> list[NamedRegion]:
    """Read all polygons of a text with their holes.

    Args:
        text: as for `parse_polygons`, and with inner rings: in JSON, an object with a list of
            vertices as "exterior" and a list of these as "holes"; a path of SVG with several closed
            subpaths, of which its fill rule decides which are holes.
        tolerance: as for `parse_polygons`.
        options: likewise.

    Returns:
        list of NamedRegion, in order.

    Raises:
        FormatError: as by `parse_polygons`, holes excepted, or a path that draws several regions.
        PolygonError: not a region; the message names rings, and vertices by their index.

    Cost: linear in the length of the text, and that of `Region`; for paths with several subpaths
        and with `nested` that of `exactsweep.formats.nesting.nest`.

    Example:
        >>> path = '<path fill-rule="evenodd" d="M0 0H4V4H0z M1 1h1v1z"/>'
        >>> [part.region.area for part in parse_regions(f"<svg>{path}</svg>")]
        [Fraction(31, 2)]
    """
    return read_each(parse_candidates(text, tolerance, **options), Candidate.named_region)


@tells_arguments
def read_polygon(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> Polygon:
    """Read a polygon from a file, or from standard input.

    Args:
        path: a path, or "-" for standard input; after it, where the file holds several polygons,
            "#" and the name, the index or the layer of one.
        tolerance: as for `parse_polygons`.

    Returns:
        A Polygon, as `parse_polygon` does.

    Raises:
        FormatError: anything wrong with the file or in it; the message names the file.
    """
    file, choice = split_choice(path)
    with name_file(file):
        return parse_polygon(read_text(file), choice, tolerance, **options)


@tells_arguments
def read_region(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> Region:
    """Read a polygon with its holes from a file, or from standard input.

    Args:
        path: as for `read_polygon`.
        tolerance: as for `parse_polygons`.
        options: likewise.

    Returns:
        A Region, as `parse_region` does.

    Raises:
        FormatError: anything wrong with the file or in it; the message names the file.
    """
    file, choice = split_choice(path)
    with name_file(file):
        return parse_region(read_text(file), choice, tolerance, **options)


@tells_arguments
def read_polygons(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> list[NamedPolygon]:
    """Read all polygons of a file, or of standard input.

    Args:
        path: as for `read_polygon`; with a choice, only those that it names.
        tolerance: as for `parse_polygons`.

    Returns:
        list of NamedPolygon, in order.

    Raises:
        FormatError: anything wrong with the file or in it; the message names the file.
    """
    candidates = read_candidates(path, tolerance, **options)
    with name_file(split_choice(path)[0]):
        return read_each(candidates, Candidate.named_polygon)


@tells_arguments
def read_regions(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> list[NamedRegion]:
    """Read all polygons of a file, or of standard input, with their holes.

    Args:
        path: as for `read_polygon`; with a choice, only those that it names.
        tolerance: as for `parse_polygons`.
        options: likewise.

    Returns:
        list of NamedRegion, in order, as by `parse_regions`.

    Raises:
        FormatError: anything wrong with the file or in it; the message names the file.
    """
    candidates = read_candidates(path, tolerance, **options)
    with name_file(split_choice(path)[0]):
        return read_each(candidates, Candidate.named_region)


def read_candidates(
    path: str | os.PathLike[str], tolerance: object = None, **options: Unpack[Options]
) -> Sequence[Candidate]:
    """Find the polygons of a file as `read_polygons` does, but read none of them yet."""
    file, choice = split_choice(path)
    with name_file(file):
        candidates = parse_candidates(read_text(file), tolerance, **options)
        return candidates if choice is None else select(candidates, choice)


def parse_candidates(
    text: str, tolerance: object = None, **options: Unpack[Options]
) -> Sequence[Candidate]:
    """Find the polygons of a text as `parse_regions` does, but read none of them yet."""
    if not isinstance(text, str):
        raise FormatError(f"{type(text).__name__} is not text")
    reading = Reading(tolerance, **options)
    found = _parse(text, reading)
    return nest_candidates(found) if reading.nested else found


def _parse(text: str, reading: Reading) -> Sequence[Candidate]:
    first = text.lstrip()[:1]
    if not first:
        raise FormatError("empty")
    if first == "<":
        from exactsweep.formats.curved.svg import parse_svg

        return parse_svg(text, reading)
    if DXF_SIGN.match(text):
        from exactsweep.formats.curved.dxf import parse_dxf

        return parse_dxf(text, reading)
    # No other format says in which unit its numbers are.
    reading.scale(None)
    if first in "[{":
        return _read_json(text)
    require_text(text, _count_vertices(text))
    if is_csv(text):
        return parse_csv(text)
    if first.isalpha():
        return parse_wkt(text)
    raise FormatError(f"starts with {first!a}: neither JSON, GeoJSON, WKT, CSV, SVG nor DXF")


def _count_vertices(text: str) -> int:
    return text.count("\n" if is_csv(text) else ",")


def measure_written(text: str) -> int:
    r"""Count the bytes that a text of `format_polygons` counts for where it is read, or some more.

    Args:
        text: JSON of any other kind, too.

    Returns:
        A number of bytes.

    Cost: linear.

    Example:
        >>> measure_written("[[0,0],[1,0],[0,1]]"), measure_written("0,0\n1,0\n0,1\n")
        (64, 48)
    """
    first = text.lstrip()[:1]
    if first == "<":
        return max(measure_text(text, text.count(",")), ELEMENT * text.count("<"))
    if DXF_SIGN.match(text):
        return max(measure_text(text, 0), ENTITY * sum(1 for _ in _ENTITY.finditer(text)))
    vertices = count_vertices if first in "[{" else _count_vertices
    return measure_text(text, vertices(text))


def _read_json(text: str) -> Sequence[Candidate]:
    """Read one JSON document, or a document a line."""
    try:
        document = parse_json(text)
    except FormatError as error:
        lines = [(k, line) for k, line in enumerate(text.splitlines(), 1) if line.strip()]
        if "Extra data" not in str(error) or not _is_json(lines[0][1]):
            raise
        return allow_faults(found for k, line in lines for found in _read_line(line, k))
    return find_candidates(document)


def _is_json(text: str) -> bool:
    try:
        parse_json(text)
    except FormatError:
        return False
    return True


def _read_line(line: str, number: int) -> Sequence[Candidate]:
    """Read a line of several; one that is bad concerns no other."""
    try:
        return find_candidates(parse_json(line), f"line {number}: $")
    except FormatError as error:
        reason = str(error).removeprefix("line 1, ")
        named = "" if reason.startswith("line ") else f"line {number}: "
        return [Candidate.refused(f"{named}{reason}")]


def find_candidates(document: object, path: str = "$") -> Sequence[Candidate]:
    """Find the polygons of a JSON document that `parse_json` returned: exact JSON or GeoJSON.

    Args:
        document: the document.
        path: where it is, for messages.
    """
    if isinstance(document, dict) and "type" in document and "vertices" not in document:
        found = read_geojson(document, path)
        return found if len(found) > 1 else [one._replace(place="") for one in found]
    return read_exact(document, path)


def split_choice(path: str | os.PathLike[str]) -> tuple[str, str | None]:
    """Split a path from the choice after it; both may have the sign "#" in their names."""
    if isinstance(path, os.PathLike):
        path = os.fspath(path)
    if not isinstance(path, str):
        raise FormatError(f"{type(path).__name__} is not a path")
    if os.path.lexists(path):
        return path, None
    places = [k for k, letter in enumerate(path) if letter == "#" and k > 0]
    if not places:
        return path, None
    # The file is the longest one that there is; if there is none, the message names the shortest.
    there = (k for k in reversed(places) if path[:k] == "-" or os.path.lexists(path[:k]))
    k = next(there, places[0])
    return path[:k], path[k + 1 :]


@contextmanager
def name_file(file: str) -> Iterator[None]:
    """Put the name of the file before the message of every refusal."""
    try:
        yield
    except ValueError as error:
        raise FormatError(f"{show_path(file)}: {error}") from None
