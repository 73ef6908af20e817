"""Reader of tables of placements, one row per placed part; see the README for their columns."""

import csv
import os
import re
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from glob import has_magic
from io import StringIO
from typing import NamedTuple

from exactsweep.formats.choice import is_group
from exactsweep.formats.csv import name_columns
from exactsweep.formats.curved.arc import to_degrees
from exactsweep.formats.decimals import read_decimal
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import parse_json
from exactsweep.formats.files import read_text
from exactsweep.formats.folder import list_parts, make_unique
from exactsweep.formats.layouts.model import FoundLayout, write_rings, write_union
from exactsweep.formats.node import Data, JsonNode
from exactsweep.formats.polygons import prefix_path, split_choice
from exactsweep.formats.reading import Reading
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import prefix_errors, quote
from exactsweep.words import count

# With one of these columns, x and y are positions.
_PLACING = {"angle", "radians", "radius"}
_NUMBERED = re.compile(r"(.+?)[_-]\d+")
_PREFIX = re.compile(r"[A-Za-z_]+(?=[-+.]*\d)")
_SHAPE = "id", "exterior", "holes", "pieces", "error"  # without rules
_TRUE, _FALSE = {"1", "true", "yes"}, {"0", "false", "no", ""}


class _Row(NamedTuple):
    """A row: its location in the file, its cells by meaning, and the decimal separator."""

    place: str
    cells: Mapping[str, str]
    point: str = "."

    def read(self, meaning: str) -> Fraction:
        text = _PREFIX.sub("", self.cells[meaning].strip(), count=1).replace(self.point, ".")
        with prefix_errors(f"{self.place}: {meaning}", FormatError):
            return read_decimal(text)


def is_table(text: str) -> bool:
    """Return whether the column names belong to a table of placements."""
    if text.lstrip()[:1] in "{<":
        return False
    try:
        found = name_columns(_read_head(text))
    except (FormatError, csv.Error):
        return False
    return {"x", "y"} <= found.keys() and not _PLACING.isdisjoint(found)


def read_parts(path: str, reading: Reading) -> dict[str, Data]:
    text = "" if os.path.isdir(path) or has_magic(path) else read_text(split_choice(path)[0])
    if text.lstrip()[:1] == "{":
        with prefix_path(path):
            parts = parse_json(text)
            if JsonNode(parts).has("parts"):
                return {
                    one.name: {key: part[key] for key in _SHAPE if key in part}
                    for one, part in _list_parts(parts)
                }
    listing = list_parts([path], reading.tolerance, **reading.options)
    drawn = [one for one in listing.parts if not one.candidate.ornament]
    names = make_unique([one.name for one in drawn])
    if not drawn:
        raise FormatError(f"{path}: no part")
    outlines = [one.candidate for one in drawn]
    if (group := split_choice(path)[1]) and listing.files == 1 and is_group(outlines, group):
        return {group: {"id": group, **write_union(outlines)}}
    found: dict[str, Data] = {}
    for name, one in zip(names, drawn, strict=True):
        found[name] = {"id": name, **write_rings(one.candidate)}
    return found


def _list_parts(data: object) -> Iterator[tuple[JsonNode, Data]]:
    for part in (JsonNode(data) / "parts").each():
        name = part / "id"
        if isinstance(part.value, dict):
            yield name, part.value


def read_table(text: str, parts: Mapping[str, Data], *, radians: bool = False) -> list[FoundLayout]:
    """Read a table of placements, one layout for each group, without containers.

    `parts` maps ids to Layout JSON; empty for a table of discs. The conversion of radians has an
    error of at most 10^-100 degrees, covered by the slack of the judge.
    """
    rows = [*_list_rows(text)]
    if not rows:
        raise FormatError("the table has no rows")
    meanings = rows[0].cells.keys()
    if {"angle", "radians"} <= meanings:
        raise FormatError("two columns of angles, in degrees and in radians")
    missing = [name for name in ("x", "y") if name not in meanings]
    if missing:
        raise FormatError(f"the table of placements has no column {' or '.join(missing)}")
    if not parts and "radius" not in meanings:
        raise FormatError("a table of placements; --part FILE reads the outlines of its parts")
    groups: dict[str, list[_Row]] = {}
    for name, row in zip(_name_groups(rows, parts), rows, strict=True):
        groups.setdefault(name, []).append(row)
    unit = "radians" if radians or "radians" in meanings else "degrees"
    note = f"{count(len(rows), 'row')} of placements, angles in {unit}"
    found = [_make_layout(name, group, parts, radians=radians) for name, group in groups.items()]
    return [found[0]._replace(notes=(note,)), *found[1:]]


def _make_layout(
    name: str, rows: Sequence[_Row], parts: Mapping[str, Data], *, radians: bool
) -> FoundLayout:
    used: dict[str, Data] = {}
    placements: list[Data] = []
    for row in rows:
        part = _find_part(row, parts)
        used[part["id"]] = part
        move = [format_fraction(row.read(axis)) for axis in ("x", "y")]
        placed: Data = {"part": part["id"], "turn": _read_turn(row, radians=radians), "move": move}
        flag = row.cells.get("mirrored", "").strip().lower()
        if flag not in _TRUE | _FALSE:
            raise FormatError(f"{row.place}: mirrored: {quote(flag)} is neither true nor false")
        placements.append(placed | ({"mirrored": True} if flag in _TRUE else {}))
    data = {"parts": [*used.values()], "placements": placements}
    return FoundLayout(name, data, places=tuple(row.place for row in rows))


def _find_part(row: _Row, parts: Mapping[str, Data]) -> Data:
    if not parts:
        radius = format_fraction(row.read("radius"))
        pieces = [{"points": [["0", "0"]], "radius": radius}]
        return {"id": f"disc {radius}", "pieces": pieces}
    name = row.cells.get("part", row.cells.get("id", "")).strip()
    if name in parts:
        return parts[name]
    if len(parts) == 1 and "part" not in row.cells:
        return next(iter(parts.values()))
    known = ", ".join(quote(one) for one in [*parts][:4])
    raise FormatError(f"{row.place}: unknown part {quote(name)}; choose from {known}")


def _read_turn(row: _Row, *, radians: bool) -> str:
    if "radians" in row.cells:
        return format_fraction(to_degrees(row.read("radians")))
    if "angle" not in row.cells:
        return "0"
    angle = row.read("angle")
    return format_fraction(to_degrees(angle) if radians else angle)


def _name_groups(rows: Sequence[_Row], parts: Mapping[str, Data]) -> list[str]:
    """Return the group of each row: its group cell, or its id without the final number."""
    named = [row.cells["group"].strip() for row in rows if "group" in row.cells]
    if named and (len({*named}) < len(rows) or len(rows) == 1):
        return named if len({*named}) > 1 else [""] * len(rows)
    ids = [row.cells["id"].strip() for row in rows if "id" in row.cells]
    matches = [_NUMBERED.fullmatch(one) for one in ids if one not in parts]
    groups = [match[1] for match in matches if match]
    is_grouped = len(groups) == len(rows) and 1 < len({*groups}) < len(rows)
    return groups if is_grouped else [""] * len(rows)


def _list_rows(text: str) -> Iterator[_Row]:
    if text.lstrip()[:1] in "[{":
        for k, entry in enumerate(_list_objects(text)):
            if not isinstance(entry, dict):
                raise FormatError(f"entry {k}: not an object")
            columns = name_columns([*entry])
            yield _Row(
                f"entry {k}", {meaning: str(entry[name]) for meaning, name in columns.items()}
            )
        return
    reader = _read_csv(text)
    point = "." if reader.dialect.delimiter == "," else ","
    head = [cell.strip() for cell in next(reader, [])]
    places = {meaning: head.index(name) for meaning, name in name_columns(head).items()}
    try:
        for row in reader:
            if any(map(str.strip, row)):
                line = f"line {reader.line_num}"
                if len(row) <= max(places.values(), default=0):
                    raise FormatError(f"{line}: {count(len(row), 'cell')}, expected {len(head)}")
                yield _Row(line, {meaning: row[k] for meaning, k in places.items()}, point)
    except csv.Error as error:
        raise FormatError(f"line {reader.line_num}: {error}") from None


def _read_csv(text: str) -> "csv._reader":  # type: ignore[name-defined]
    first = re.sub(r'"[^"]*+"', "", text.lstrip().partition("\n")[0])
    separator = next((mark for mark in ";\t" if mark in first), ",")
    return csv.reader(StringIO(text.lstrip(), newline=""), delimiter=separator)


def _read_head(text: str) -> list[str]:
    if text.lstrip()[:1] not in "[{":
        return [cell.strip() for cell in next(_read_csv(text[:2000]), [])]
    entries = _list_objects(text)
    return [*entries[0]] if entries and isinstance(entries[0], dict) else []


def _list_objects(text: str) -> list[object]:
    data = parse_json(text)
    lists = [data] if isinstance(data, list) else []
    if isinstance(data, dict):
        lists = [value for value in data.values() if isinstance(value, list)]
    return lists[0] if len(lists) == 1 else []
