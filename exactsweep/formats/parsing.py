"""Format detection and parsing."""

import re
from collections.abc import Sequence
from contextlib import suppress
from itertools import chain
from typing import Unpack

from exactsweep.formats import csv, plain, size
from exactsweep.formats.candidate import Candidate, limit_faults
from exactsweep.formats.choice import keep_layers
from exactsweep.formats.depth import nest_candidates
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import count_vertices, parse_json
from exactsweep.formats.files import DXF_SIGN
from exactsweep.formats.json_polygons import find_candidates
from exactsweep.formats.part_list import Coordinates, PartList
from exactsweep.formats.reading import Options, Reading
from exactsweep.formats.wkt import parse_wkt
from exactsweep.numbers.error import quote

# Keys of nesting instances.
_INSTANCES = {"items", "item_types"}
_WKT = re.compile(
    r"\s*(SRID|EMPTY|(MULTI)?(POINT|LINESTRING|POLYGON|CURVE|SURFACE)|GEOMETRY\w*|CIRCULARSTRING|"
    r"COMPOUNDCURVE|CURVEPOLYGON|TRIANGLE|TIN|POLYHEDRALSURFACE)",
    re.I,
)
# Group code 0 and a name.
_ENTITY = re.compile(r"(?m)^ *0\n[A-Z]")


def parse_candidates(
    text: str, tolerance: object = None, **options: Unpack[Options]
) -> PartList[Candidate]:
    """Find the polygons in text, like `parse_regions`, without parsing their numbers."""
    if not isinstance(text, str):
        raise FormatError(f"expected text, not {type(text).__name__}")
    return parse_with(text, Reading(tolerance, **options))


def parse_with(text: str, reading: Reading) -> PartList[Candidate]:
    candidates = keep_layers(_parse(text, reading), reading)
    if reading.nested:
        candidates = nest_candidates(candidates)
    if reading.clean:
        candidates = [one._replace(clean=reading.clean) for one in candidates]
    y_down = reading.is_svg if reading.y_down is None else reading.y_down
    coordinates = Coordinates(y_down, reading.found_unit)
    return PartList(candidates, coordinates, reading.list_hidden(), reading.notes)


def _parse(text: str, reading: Reading) -> Sequence[Candidate]:
    first = text.lstrip()[:1]
    if not first:
        raise FormatError("empty")
    if first == "<":
        from exactsweep.formats.curved.svg import read_svg
        from exactsweep.formats.curved.xml import parse_xml
        from exactsweep.formats.esicup import is_esicup, read_esicup

        plain.reject_unsupported(text)
        root = parse_xml(text)
        if is_esicup(root):
            reading.scale(None)
            return read_esicup(root)
        reading.is_svg = True
        return read_svg(root, reading)
    if DXF_SIGN.match(text):
        from exactsweep.formats.curved.dxf import parse_dxf

        return parse_dxf(text, reading)
    # Other formats state no unit.
    reading.scale(None)
    plain.reject_unsupported(text)
    if first in "[{":
        return _read_json(text, reading)
    size.require_text(text, _count_vertices(text))
    if csv.is_csv(text):
        return csv.parse_csv(text)
    if plain.is_plain(text):
        if first == "(":
            return find_candidates(parse_json(plain.to_json_text(text)))
        return plain.parse_numbers(text)
    if _WKT.match(text):
        return parse_wkt(text, reading.notes)
    csv.reject_placements(re.split(r"[,;\t]", text.lstrip()[:1000].partition("\n")[0]), "line 1")
    raise FormatError(
        f"unknown format, starts with {quote(text.split(maxsplit=1)[0])}; expected JSON, GeoJSON, "
        "WKT, SVG, DXF, or CSV with columns x and y"
    )


def measure_written(text: str) -> int:
    """Bound the size that a reader charges for output of `format_polygons`, or for JSON."""
    first = text.lstrip()[:1]
    if first == "<":
        return max(size.measure_text(text, text.count(",")), size.ELEMENT * text.count("<"))
    if DXF_SIGN.match(text):
        return max(size.measure_text(text, 0), size.ENTITY * sum(1 for _ in _ENTITY.finditer(text)))
    return size.measure_text(text, count_vertices(text) if first in "[{" else _count_vertices(text))


def _count_vertices(text: str) -> int:
    return csv.count_vertices(text) if csv.is_csv(text) else text.count(",")


def _read_json(text: str, reading: Reading) -> Sequence[Candidate]:
    """Read one JSON document, one document per line, or tuples and braces."""
    notes = reading.notes
    try:
        document = parse_json(text)
    except FormatError as error:
        if plain.is_plain(text):
            with suppress(FormatError):
                return find_candidates(parse_json(plain.to_json_text(text)))
        if "Extra data" not in str(error):
            raise
        lines = [(k, line) for k, line in enumerate(text.splitlines(), 1) if line.strip()]
        try:
            parse_json(lines[0][1])
        except FormatError:
            raise error from None
        found = (_read_line(line, k, notes) for k, line in lines)
        return [*limit_faults(chain.from_iterable(found))]
    if isinstance(document, dict) and _INSTANCES & document.keys():
        from exactsweep.formats.layouts.instances import read_parts

        parts = read_parts(document, reading)
        if parts is not None:
            return parts
    rows = document
    if isinstance(document, dict) and len(document) == 1:
        (rows,) = document.values()
    if isinstance(rows, list) and rows and isinstance(rows[0], dict):
        is_flat = not any(isinstance(value, list | dict) for value in rows[0].values())
        csv.reject_placements([*rows[0]] if is_flat else [], "the first entry")
    return find_candidates(document, notes=notes)


def _read_line(line: str, number: int, notes: dict[str, None]) -> Sequence[Candidate]:
    try:
        return find_candidates(parse_json(line), f"line {number}: $", notes)
    except FormatError as error:
        reason = str(error).removeprefix("line 1, ")
        named = "" if reason.startswith("line ") else f"line {number}: "
        return [Candidate.from_error(f"{named}{reason}")]
