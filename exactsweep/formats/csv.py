"""Reader and writer of CSV: one vertex, rectangle or WKT polygon per row."""

import csv
import re
from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from io import StringIO
from itertools import chain
from sys import maxsize
from threading import RLock

from exactsweep.formats.candidate import Candidate, limit_faults
from exactsweep.formats.decimals import read_decimal
from exactsweep.formats.error import FormatError
from exactsweep.formats.size import VERTEX, require_count
from exactsweep.formats.wkt import parse_wkt
from exactsweep.numbers.error import prefix_errors, quote
from exactsweep.numbers.number import Point

_NAMES = ("name", "id", "part", "polygon")
_WKT = ("wkt", "geometry", "geom", "the_geom", "wkt_geom")
_SIZES = (("width", "height"), ("w", "h"), ("lx", "ly"))
_COLUMNS = {"x", "y", "ring", *_NAMES, *_WKT, *(one for pair in _SIZES for one in pair)}
_NUMBERS = re.compile(r"\s*\"?[-+.0-9][-+.,0-9eE]*\"?\s*[,;\t]\s*\"?[-+.0-9]")
# Column names of placement tables, by meaning.
PLACEMENT_COLUMNS = {
    "x": ("x", "tx", "dx", "pos_x", "x_pos", "center_x", "x_center", "cx"),
    "y": ("y", "ty", "dy", "pos_y", "y_pos", "center_y", "y_center", "cy"),
    "angle": (
        *("angle", "deg", "degrees", "rotation", "rot", "theta", "turn", "orientation"),
        *("angle_deg", "angle_degrees", "rotation_deg", "rot_deg", "theta_deg"),
    ),
    "radians": ("rad", "radians", "angle_rad", "angle_radians", "rotation_rad", "theta_rad"),
    "radius": ("r", "radius"),
    "mirrored": ("mirrored", "mirror", "flipped", "flip"),
    "part": ("part", "part_id", "name", "item", "item_id", "shape", "piece"),
    "group": ("group", "layout", "sheet", "bin", "case", "puzzle", "board", "n"),
    "id": ("id",),
}
_MEANINGS = {name: meaning for meaning, names in PLACEMENT_COLUMNS.items() for name in names}
# With one of these, x and y are positions.
_PLACING = {"angle", "radians", "radius", "mirrored"}
_RADII = {"diameter", "d", "rx", "ry"}
_NOT_WORD = re.compile(r"[^a-z0-9]+")

_limit_held = RLock()

_RowsByRing = dict[str, list[tuple[int, str, str]]]


def name_columns(head: Iterable[str]) -> dict[str, str]:
    """Map each meaning to its column; raise FormatError for two columns with one meaning."""
    found: dict[str, str] = {}
    for name in head:
        meaning = _MEANINGS.get(_simplify(name))
        if meaning is not None and meaning in found:
            raise FormatError(f"two columns for {meaning}: {quote(found[meaning])}, {quote(name)}")
        if meaning is not None:
            found[meaning] = name
    return found


def reject_placements(head: Sequence[str], place: str) -> None:
    meanings = [_MEANINGS.get(name, name) for name in map(_simplify, head)]
    placing = [k for k, meaning in enumerate(meanings) if meaning in _PLACING | _RADII]
    if placing and {"x", "y"} <= {*meanings}:
        part = "" if "radius" in meanings else " --part OUTLINE"
        raise FormatError(
            f"{place}: a table of placements, because of the column "
            f"{quote(head[placing[0]].strip())}; 'exactsweep layout FILE{part}' judges it"
        )


def _simplify(name: str) -> str:
    return _NOT_WORD.sub("_", name.lower()).strip("_")


def is_csv(text: str) -> bool:
    """Return whether text begins with two numbers, or with a header with x and y or WKT."""
    head = _head(text)
    is_table = {"x", "y"} <= head or not head.isdisjoint(_WKT)
    return is_table or bool(_NUMBERS.match(text.lstrip().partition("\n")[0]))


def count_vertices(text: str) -> int:
    """Bound the number of vertices by the number of rows, or of commas in WKT."""
    return text.count("\n" if {"x", "y"} <= _head(text) or _NUMBERS.match(text) else ",")


def _head(text: str) -> set[str]:
    first = text.lstrip()[:1000].partition("\n")[0]
    return {word.strip().strip('"').lower() for word in re.split(r"[,;\t]", first)}


def parse_csv(text: str) -> list[Candidate]:
    """Find the polygons of a table, by its columns; see the README for their names.

    Without a header, the first two columns are x and y. A "polygon" column distinguishes polygons
    with the same name, and a "ring" column distinguishes rings, exterior first. With semicolons or
    tabs as separators, the decimal point may be a comma.
    """
    # Numbers may exceed Python's global limit of 131,072 characters.
    with _limit_held:
        before = csv.field_size_limit()
        csv.field_size_limit(max(before, len(text)))
        try:
            return _parse(text)
        finally:
            csv.field_size_limit(before)


def _parse(text: str) -> list[Candidate]:
    sample = re.sub(r'"[^"]*+"', "", text.lstrip().partition("\n")[0])
    separator = next((mark for mark in ";\t" if mark in sample), ",")
    reader = csv.reader(StringIO(text, newline=""), delimiter=separator, skipinitialspace=True)
    rows: Iterator[tuple[int, list[str]]]
    rows = ((reader.line_num, row) for row in reader if any(map(str.strip, row)))
    first = next(rows, (0, []))
    head = [cell.strip().lower() for cell in first[1]]
    columns = {cell: k for k, cell in enumerate(head) if cell in _COLUMNS}
    twice = next((cell for cell in columns if head.count(cell) > 1), None)
    if twice:
        raise FormatError(f"line {first[0]}: duplicate column {quote(twice)}")
    needed = ["x", "y"]
    reject_placements(head, f"line {first[0]}")
    needed += next((pair for pair in _SIZES if columns.keys() >= {*pair}), ())
    if not columns.keys() >= {*needed}:
        needed = [cell for cell in _WKT if cell in columns][:1]
        if not needed:
            needed, columns, rows = ["x", "y"], {"x": 0, "y": 1}, chain([first], rows)
    places = [columns[cell] for cell in needed]
    naming = [columns[cell] for cell in _NAMES if cell in columns]
    others = [columns.get(cell, maxsize) for cell in ("polygon", "ring")]
    polygons: dict[tuple[str, str], _RowsByRing] = {}
    written: list[Candidate] = []
    found: list[Candidate] = []
    point = "," if separator == "," else "."
    for line, row in rows:
        if len(row) <= max(places):
            raise FormatError(f"line {line}: {len(row)} cells; {' or '.join(needed)} is missing")
        name = next((row[k] for k in naming if k < len(row)), "")
        cells = [row[k] for k in places]
        if len(cells) == 1:
            written += _read_wkt(cells[0], line, name or None)
            continue
        if len(cells) > 2:
            numbers = partial(_read_box, line, [cell.replace(",", point) for cell in cells])
            written.append(Candidate(f"line {line}", numbers, name or None))
            continue
        require_count(len(polygons), 3 * VERTEX, "polygons")
        polygon, ring = (row[k] if k < len(row) else "" for k in others)
        x, y = (cell.replace(",", point) for cell in cells)
        polygons.setdefault((polygon, name), {}).setdefault(ring, []).append((line, x, y))
    for (_, name), rings in polygons.items():
        readers = ((f"line {row[0][0]}", partial(_vertices, row)) for row in rings.values())
        found.append(Candidate.of_rings(readers, name=name or None))
    return [*limit_faults(written), *found]


def _read_wkt(text: str, line: int, name: str | None) -> list[Candidate]:
    try:
        found = parse_wkt(text)
    except FormatError as error:
        return [Candidate.from_error(f"line {line}: {error}", name)]
    place = f"line {line}"
    return [
        Candidate.from_error(f"{place}: {one.fault}", name)
        if one.fault
        else one._replace(name=name, place=place)
        for one in found
    ]


def _read_box(line: int, cells: Sequence[str]) -> list[Point]:
    with prefix_errors(f"line {line}", FormatError):
        x, y, width, height = (read_decimal(cell.strip()) for cell in cells)
    u, v = x + width, y + height
    return [Point(x, y), Point(u, y), Point(u, v), Point(x, v)]


def _vertices(cells: Sequence[tuple[int, str, str]]) -> list[Point]:
    found = []
    for line, x, y in cells:
        with prefix_errors(f"line {line}", FormatError):
            found.append(Point(read_decimal(x.strip()), read_decimal(y.strip())))
    return found


def write_csv_rows(rows: Iterable[Sequence[object]]) -> str:
    text = StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()
