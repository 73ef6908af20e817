import json
import sys
from pathlib import Path
from typing import Any

import pyarrow.parquet
import pytest
from partlist import part_list

from exactsweep.batch import Part, Rounding, run, take_all_pairs
from exactsweep.batch.output import Output
from exactsweep.batch.table import write_parquet
from exactsweep.formats import FormatError, NamedPolygon

PARTS: list[NamedPolygon | Part] = [*part_list(8), Part("bad", "no polygon")]


@pytest.mark.parametrize("what", ["trajectory", "loops", "areas", "nfp"])
@pytest.mark.parametrize(("rows", "rounding"), [(1, None), (5, Rounding(2)), (1000, None)])
def test_a_table_has_the_same_records(
    tmp_path: Path, what: str, rows: int, rounding: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("exactsweep.batch.table._ROWS", rows)
    job = take_all_pairs(PARTS, PARTS[:3], what, rounding)
    lines = b"".join(line for chunk in job.chunks(0) for line in job.work.lines(chunk))
    path, part = tmp_path / "out.parquet", tmp_path / "out.parquet.part"
    with Output(str(path), job):
        part.write_bytes(lines)
    assert run(job, str(path)).resumed == 27
    assert list(tmp_path.iterdir()) == [path]
    table = pyarrow.parquet.read_table(path).to_pylist()
    for line, row in zip(lines.splitlines(), table, strict=True):
        record = {name: value for name, value in json.loads(line).items() if value is not None}
        given = {
            name: json.loads(value) if str(value).startswith("[") else value
            for name, value in row.items()
            if value is not None
        }
        assert given == record


def test_a_table_interrupted_while_it_is_written_is_written_again(tmp_path: Path) -> None:
    job = take_all_pairs(PARTS, PARTS[:3], "areas")
    lines = b"".join(line for chunk in job.chunks(0) for line in job.work.lines(chunk))
    path = tmp_path / "out.parquet"
    with Output(str(path), job):
        (tmp_path / "out.parquet.part").write_bytes(lines)
    (tmp_path / "out.parquet.tmp").write_bytes(b"half")
    path.write_bytes(b"half")
    run(job, str(path))
    assert pyarrow.parquet.read_table(path).num_rows == 27


def test_directions_of_any_length_and_ids_are_text(tmp_path: Path) -> None:
    records = tmp_path / "records"
    digits = "9" * 5000
    records.write_text(
        f'{{"index": 0, "id": 7, "kind": "CC", "direction": [{digits}, -1]}}\n'
        '{"index": 1, "error": "no", "id": "a"}\n'
    )
    write_parquet(records, tmp_path / "table", "loops")
    first, second = pyarrow.parquet.read_table(tmp_path / "table").to_pylist()
    assert first["direction"] == f"[{digits}, -1]"
    assert (first["id"], second["id"], second["error"]) == ("7", "a", "no")


def test_only_parquet_needs_pyarrow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", None)
    job = take_all_pairs(PARTS[:2], PARTS[:1], "areas")
    for name in ("out.jsonl", "out.csv"):
        run(job, str(tmp_path / name))
        assert (tmp_path / name).read_bytes().count(b"\n") >= 2
    with pytest.raises(FormatError, match="Parquet"):
        run(job, str(tmp_path / "out.parquet"))
    # Before any pair is computed.
    assert not [*tmp_path.glob("*.part")]
