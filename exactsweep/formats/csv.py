"""CSV in and out: a vertex a row, in columns x and y, perhaps with the polygon's name and ring."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from io import StringIO

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.decimals import read_decimal
from exactsweep.formats.error import FormatError
from exactsweep.formats.size import VERTEX, require_count
from exactsweep.numbers.point import Point

_NAMES = ("name", "id", "part", "polygon")
_COLUMNS = {"x", "y", "ring", *_NAMES}
_NUMBERS = re.compile(r"\s*\"?[-+.0-9][-+.0-9eE]*\"?\s*[,;\t]\s*\"?[-+.0-9]")

_RowsByRing = dict[str, list[tuple[int, str, str]]]


def is_csv(text: str) -> bool:
    """Tell whether a text begins with two numbers, or with a head that has columns x and y.

    >>> is_csv("1.5,2"), is_csv("name;X;Y"), is_csv("POLYGON ((0 0")
    (True, True, False)
    """
    first = text.lstrip().partition("\n")[0]
    head = [word.strip().strip('"').lower() for word in re.split(r"[,;\t]", first[:1000])]
    return bool(_NUMBERS.match(first)) or {"x", "y"} <= set(head)


def parse_csv(text: str) -> list[Candidate]:
    r"""Find the polygons of a table of vertices.

    Args:
        text: a vertex a row, in columns x and y, or the first two where there is no head; perhaps
            a column "name", "id" or "part" of the polygon it is of, and one "polygon", which tells
            polygons of one name apart, and a column "ring", whose first value is the exterior's,
            and every other one that of a hole. Columns are
            separated by commas, semicolons or tabs; numbers are decimals.

    Returns:
        list of Candidate, in order; a ring may be closed or not.

    Raises:
        FormatError: a row that is too short; the message says in which line.

    Cost: linear.

    Example:
        >>> [(c.name, len(c.vertices())) for c in parse_csv("name,x,y\na,0,0\na,1,0\na,0,1\n")]
        [('a', 3)]
    """
    with _cells_of_any_length(len(text)):
        return _parse(text)


@contextmanager
def _cells_of_any_length(length: int) -> Iterator[None]:
    """Python's limit, 131,072 characters, is below what numbers of answers may have."""
    before = csv.field_size_limit(length)
    try:
        yield
    finally:
        csv.field_size_limit(before)


def _parse(text: str) -> list[Candidate]:
    sample = text.lstrip().partition("\n")[0]
    separator = max(",;\t", key=sample.count)
    rows = csv.reader(StringIO(text, newline=""), delimiter=separator, skipinitialspace=True)
    polygons: dict[tuple[str, str], _RowsByRing] = {}
    columns: dict[str, int] | None = None
    try:
        for row in rows:
            if not any(cell.strip() for cell in row):
                continue
            if columns is None:
                head = [cell.strip().lower() for cell in row]
                # Of two columns of one name the latter; others are of no use here.
                columns = {cell: k for k, cell in enumerate(head) if cell in _COLUMNS}
                if {"x", "y"} <= columns.keys():
                    continue
                columns = {"x": 0, "y": 1}
            if len(row) <= max(columns["x"], columns["y"]):
                raise FormatError(f"line {rows.line_num}: {len(row)} cells, without x and y")
            named = {word: row[k] for word, k in columns.items() if k < len(row)}
            name = next((named[word] for word in _NAMES if word in named), "")
            # Each has three vertices at least.
            require_count(len(polygons), 3 * VERTEX, "polygons")
            rings = polygons.setdefault((named.get("polygon", ""), name), {})
            cells = rows.line_num, row[columns["x"]], row[columns["y"]]
            rings.setdefault(named.get("ring", ""), []).append(cells)
    except csv.Error as error:
        raise FormatError(f"line {rows.line_num}: not CSV: {error}") from None
    return [_candidate(name, rings) for (_, name), rings in polygons.items()]


def _candidate(name: str, rings: _RowsByRing) -> Candidate:
    exterior, *holes = (
        Candidate(f"line {cells[0][0]}", partial(_vertices, cells)) for cells in rings.values()
    )
    return exterior._replace(name=name or None, holes=partial(tuple, holes))


def _vertices(cells: Iterable[tuple[int, str, str]]) -> Sequence[Point]:
    found = []
    for line, x, y in cells:
        try:
            found.append(Point(read_decimal(x.strip()), read_decimal(y.strip())))
        except ValueError as error:
            raise FormatError(f"line {line}: {error}") from None
    return found


def write_csv_rows(rows: Iterable[Sequence[object]]) -> str:
    """Write rows as lines of CSV."""
    text = StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue()
