"""Conversion of records to CSV or Parquet tables."""

import csv
import json
from collections.abc import Iterator
from fractions import Fraction
from itertools import islice
from math import isinf
from pathlib import Path
from typing import Any

from exactsweep.batch.record import COLUMNS, Quantities
from exactsweep.formats.error import FormatError
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.error import require_imports

_ROWS = 1024
_NAMES = ("error", "id", "generatrix", "directrix")


def require_pyarrow() -> None:
    """Fail early if pyarrow is missing."""
    with require_imports("pyarrow", "Parquet", FormatError):
        import pyarrow.parquet  # noqa: F401


def write_csv(records: Path, output: Path, what: Quantities) -> None:
    """Convert records to CSV; directions, vertices and exact fits are JSON."""
    columns = ("index", *_NAMES, *COLUMNS[what])
    with (
        open(records, "rb") as lines,
        open(output, "w", encoding="utf-8", newline="") as table,
    ):
        writer = csv.DictWriter(table, columns, lineterminator="\n")
        writer.writeheader()
        writer.writerows(_rows(lines))


def write_parquet(records: Path, output: Path, what: Quantities, *, rounded: bool = False) -> None:
    """Convert records to a Parquet table with the columns of `write_csv`.

    "index" is an int64, rounded areas are float64, and everything else is a string.
    """
    import pyarrow
    import pyarrow.parquet

    columns = (*_NAMES, *COLUMNS[what])
    floats = {name for name in columns if rounded and name.endswith("area")}
    kinds = [pyarrow.float64() if name in floats else pyarrow.string() for name in columns]
    fields = [("index", pyarrow.int64()), *zip(columns, kinds, strict=True)]
    schema = pyarrow.schema(fields)
    with open(records, "rb") as lines, pyarrow.parquet.ParquetWriter(output, schema) as writer:
        while rows := list(islice(_rows(lines), _ROWS)):
            cells: dict[str, list[Any]] = {c: [row.get(c) for row in rows] for c in columns}
            for column in floats:
                cells[column] = [None if area is None else _float(area) for area in cells[column]]
            cells["index"] = [int(row["index"] or 0) for row in rows]
            writer.write_table(pyarrow.table(cells, schema=schema))


def _float(area: str) -> float:
    found = float(area)
    if isinf(found):
        raise FormatError(
            f"the area {abridge(Fraction(area))} exceeds the range of Parquet doubles; write .csv"
        )
    return found


def _rows(lines: Iterator[bytes]) -> Iterator[dict[str, str | None]]:
    for line in lines:
        # Numbers may have any length, so they stay text.
        record: dict[str, Any] = json.loads(line, parse_int=_Digits, parse_float=_Digits)
        yield {
            name: value if value is None or type(value) is str else _text(value)
            for name, value in record.items()
        }


class _Digits(str): ...


def _text(value: Any) -> str:
    if isinstance(value, list):
        return f"[{', '.join(map(_text, value))}]"
    return str(value) if isinstance(value, _Digits) else json.dumps(value)
