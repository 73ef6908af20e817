"""Records as a Parquet file, by pyarrow."""

from __future__ import annotations

import json
from collections.abc import Iterator
from itertools import islice
from pathlib import Path
from typing import Any

from exactsweep.batch.record import COLUMNS, Quantities
from exactsweep.formats.error import needs

_ROWS = 1024
_NAMES = ("error", "id", "generatrix", "directrix")


def require_pyarrow() -> None:
    """Refuse to begin what could not be finished."""
    with needs("pyarrow", "parquet", "Parquet"):
        import pyarrow.parquet  # noqa: F401


def write_parquet(records: Path, output: Path, what: Quantities) -> None:
    """Turn records into a table.

    Args:
        records: a file with a record a line.
        output: the file to be written: a column for each member that a record may have, "index" an
            int64, all others strings, null where a record has none; directions, vertices and exact
            fits are JSON.
        what: the quantities of the batch.

    Cost: linear; a thousand records are in memory at a time.
    """
    import pyarrow
    import pyarrow.parquet

    columns = (*_NAMES, *COLUMNS[what])
    fields = [("index", pyarrow.int64()), *((name, pyarrow.string()) for name in columns)]
    schema = pyarrow.schema(fields)
    with open(records, "rb") as lines, pyarrow.parquet.ParquetWriter(output, schema) as writer:
        while rows := list(islice(_rows(lines), _ROWS)):
            table = {name: [row.get(name) for row in rows] for name in columns}
            table["index"] = [row["index"] for row in rows]
            writer.write_table(pyarrow.table(table, schema=schema))


def _rows(lines: Iterator[bytes]) -> Iterator[dict[str, Any]]:
    for line in lines:
        # Numbers, the components of a direction, stay the text that they are.
        record: dict[str, Any] = json.loads(line, parse_int=_Digits)
        index = int(record.pop("index"))
        yield {"index": index, **{name: _text(value) for name, value in record.items()}}


class _Digits(str):
    """An integer of any length."""


def _text(value: str | list[Any] | None) -> str | None:
    if value is None:
        return None
    if isinstance(value, str):
        return str(value)
    if all(isinstance(part, _Digits) for part in value):
        return f"[{', '.join(value)}]"
    return json.dumps(value)
