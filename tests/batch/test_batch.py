import json
import os
import re
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import strategies
from command import run
from hypothesis import given
from hypothesis import strategies as st
from partlist import part_list
from tiers import examples

from exactsweep import Polygon, limits, sweep
from exactsweep.batch import BatchError, Part, read_parts, take_all_pairs, take_listed_pairs, work
from exactsweep.batch import run as run_batch
from exactsweep.batch.job import CHUNK_PAIRS
from exactsweep.batch.work import Work
from exactsweep.formats import NamedPolygon, format_polygons

SQUARE = NamedPolygon(Polygon([(0, 0), (1, 0), (1, 1), (0, 1)]), "square")
NOTCH = NamedPolygon(Polygon([(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)]), "notch")
PARTS = (Part("square", SQUARE.polygon), Part("notch", NOTCH.polygon), Part("bad", "no polygon"))


def records(path: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def line_record(line: str | bytes, what: str = "loops") -> dict[str, Any]:
    """The record of one line of a file of pairs."""
    data = line.encode() if isinstance(line, str) else line
    found: dict[str, Any] = json.loads(pairs_of_work(what).line(0, data))
    return found


def pairs_of_work(what: str) -> Work:
    return take_all_pairs(PARTS, PARTS, what).work


def test_all_pairs_are_swept_in_order(tmp_path: Path) -> None:
    path = tmp_path / "out.jsonl"
    seen: list[int] = []
    parts = part_list(8)
    summary = run_batch(
        take_all_pairs(parts, parts[:3]), str(path), workers=1, progress=seen.append
    )
    assert (summary.pairs, summary.resumed) == (24, 0)
    assert seen == [0, CHUNK_PAIRS, 24]
    assert list(tmp_path.iterdir()) == [path]
    found = records(path)
    assert [record["index"] for record in found] == list(range(24))
    for record, (g, d) in zip(found, [(g, d) for g in parts for d in parts[:3]], strict=True):
        assert (record["generatrix"], record["directrix"]) == (g.name, d.name)
        if "error" in record:
            with pytest.raises(ValueError, match=f"^{re.escape(str(record['error']))}$"):
                sweep(g.polygon, d.polygon)
            continue
        expected = sweep(g.polygon, d.polygon)
        assert record["kind"] == expected.kind
        for name in ("trajectory", "inner", "outer"):
            assert Polygon(record[name]).vertices == getattr(expected, name).vertices
        assert Fraction(record["area"]) == expected.area
    assert summary.refused == sum("error" in record for record in found)


PAIR = '{"generatrix": "square", "directrix": "notch"'


def test_deep_pairs_and_invalid_directions_are_error_records() -> None:
    said = "the directrix is not monotone in direction (0, 1)"
    assert line_record(PAIR + ', "direction": [0, 1]}')["error"].startswith(said)
    assert line_record('{"generatrix":' + "[" * 100_000)["error"] == "nested too deeply"


def test_invalid_pairs_do_not_affect_others(tmp_path: Path) -> None:
    good = PAIR + "}\n"
    long = "[" + " " * 2**24 + "]\n"
    (tmp_path / "pairs.jsonl").write_text(f"\n{good}x\n \n{long}{good}{good[:-1]}")
    job = take_listed_pairs(str(tmp_path / "pairs.jsonl"), PARTS)
    path = tmp_path / "out.jsonl"
    assert run_batch(job, str(path), workers=1) == (5, 2, 0)
    found = records(path)
    assert [record["index"] for record in found] == [0, 1, 2, 3, 4]
    assert found[1]["error"] == "line 1, column 1: not JSON: Expecting value"
    assert found[2]["error"] == "the line is longer than 16 MiB (max_mib)"
    assert found[0] == found[3] | {"index": 0} == found[4] | {"index": 0}


@given(st.lists(strategies.monotone_polygons(), min_size=1, max_size=3), st.integers(1, 9))
@examples(12)
def test_records_do_not_depend_on_the_chunks(polygons: list[Polygon], size: int) -> None:
    named = [NamedPolygon(p) for p in polygons]
    job = take_all_pairs(named, named)
    pairs = [*enumerate(range(job.total))]
    whole = job.work.lines(pairs)
    parts = [pairs[k : k + size] for k in range(0, job.total, size)]
    assert [line for chunk in parts for line in job.work.lines(chunk)] == whole
    for pair, line in zip(pairs, whole, strict=True):
        assert job.work.lines([pair]) == [line]


def test_parts_are_read_once_and_invalid_ones_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "parts.json"
    path.write_text(
        '{"polygons": [{"id": "a", "vertices": [[0,0],[1,0],[0,1]]}, [[0,0]], [[0,1,2]]]}'
    )
    a, one, two = read_parts(str(path))
    assert a == Part("a", Polygon([(0, 0), (1, 0), (0, 1)]))
    reason = "$.polygons[1]: fewer than three distinct vertices: 1 among the 1 given"
    assert one == Part("1", reason)
    assert two == Part("2", "$.polygons[2][0] has 3 coordinates, not 2")
    record = json.loads(take_all_pairs([a, one], [two]).work.line(1, 1))
    assert record["error"] == f"generatrix: {reason}"


def test_invalid_batches_are_rejected(tmp_path: Path) -> None:
    with pytest.raises(BatchError, match=r"^'all' is not one of trajectory, loops, areas, nfp$"):
        take_all_pairs([], [], "all")
    (tmp_path / "pairs").write_text("")
    with pytest.raises(BatchError, match=r"^2 parts have the name 'square'$"):
        take_listed_pairs(str(tmp_path / "pairs"), [SQUARE, SQUARE])
    with pytest.raises(BatchError, match=r"none: No such file or directory$"):
        take_listed_pairs(str(tmp_path / "none"))
    os.mkfifo(tmp_path / "pipe")
    with pytest.raises(
        BatchError,
        match=r"pipe: a pipe or a device cannot be read twice; save the pairs to a file$",
    ):
        take_listed_pairs(str(tmp_path / "pipe"))
    for workers in (0, 1025):
        message = f"^the number of workers must be 1 to 1024, not {workers}$"
        with pytest.raises(BatchError, match=message):
            run_batch(take_all_pairs([SQUARE], [SQUARE]), str(tmp_path / "out"), workers=workers)
    for output, message in {
        str(tmp_path): "Is a directory",
        "": "'': Is a directory",
        f"{tmp_path}/none/out.jsonl": "none/out.jsonl: No such file or directory",
        f"{tmp_path}/pipe": "a pipe or a device; write to a regular file",
        f"{tmp_path}/{'x' * 300}": "x: File name too long",
    }.items():
        with pytest.raises(BatchError, match=f"{message}$"):
            run_batch(take_all_pairs(PARTS, PARTS), output)


@pytest.mark.parametrize("most", [9, 2**20])
def test_chunks_contain_all_remaining_pairs(
    most: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """No chunk exceeds the limits of pairs and, except for its last line, of bytes."""
    monkeypatch.setattr("exactsweep.batch.job._CHUNK_BYTES", most)
    lines = [b"%d\n" % (10 + k) for k in range(36)]
    (tmp_path / "pairs").write_bytes(b"\n".join(lines))
    listed, every = take_listed_pairs(str(tmp_path / "pairs")), take_all_pairs(PARTS * 4, PARTS)
    for job, pairs in ((listed, lines), (every, range(36))):
        for start in range(0, 38, 5):
            chunks = [*job.chunks(start)]
            assert [pair for chunk in chunks for pair in chunk] == [*enumerate(pairs)][start:]
            assert all(len(chunk) <= CHUNK_PAIRS for chunk in chunks)
    for chunk in [*listed.chunks(0)][:-1]:
        *before, last = (len(lines[index]) for index, _ in chunk)
        assert sum(before) <= most
        assert len(chunk) == CHUNK_PAIRS or sum(before) + last > most


def test_lines_appended_later_are_ignored(tmp_path: Path) -> None:
    pairs, path = tmp_path / "pairs.jsonl", tmp_path / "out.jsonl"
    pairs.write_text(f"{PAIR}}}\n" * 2)
    job = take_listed_pairs(str(pairs), PARTS)
    pairs.write_text(f"{PAIR}}}\n" * 40)
    assert run_batch(job, str(path), workers=1) == (2, 0, 0)
    pairs.write_text(f"{PAIR}}}\n")
    with pytest.raises(BatchError, match=r"was truncated while the batch ran$"):
        run_batch(job, str(path), workers=1)


@pytest.mark.parametrize(
    ("error", "said"),
    [
        (AssertionError("no"), "internal error: AssertionError: no"),
        (RecursionError("maximum depth"), "nested too deeply"),
        (MemoryError(), "out of memory"),
    ],
)
def test_a_bug_becomes_an_error_record(
    error: Exception, said: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object) -> None:
        raise error

    monkeypatch.setattr(work, "sweep", fail)
    assert line_record(f"{PAIR}}}") == {
        "index": 0,
        "error": said,
        "generatrix": "square",
        "directrix": "notch",
    }


def test_the_command_reads_files(tmp_path: Path) -> None:
    parts, pairs, output = (str(tmp_path / name) for name in ("parts.json", "pairs", "out"))
    Path(parts).write_text(format_polygons([SQUARE, NOTCH], "json"))
    Path(pairs).write_text(f"{PAIR}}}\nx\n")
    done = run("batch", pairs, "--parts", parts, "-o", output, "--workers", "1")
    assert (done.exit_code, done.output) == (0, "2 pairs, 1 refused\n")
    assert "outer" in records(Path(output))[0]
    done = run("batch", "--all", parts, parts, "-o", output, "--compute", "areas", "--workers", "1")
    assert (done.exit_code, done.output) == (0, "4 pairs, 0 refused\n")
    assert len(records(Path(output))) == 4


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["batch", "-o", "x"], "Give either PAIRS or --all."),
        (["batch", "p", "--all", "a", "b", "-o", "x"], "Give either PAIRS or --all."),
        (["batch", "--all", "a", "b", "--parts", "p", "-o", "x"], "--parts needs PAIRS."),
        (["batch", "-", "-o", "x"], "PAIRS and the output must be files"),
        (["batch", "p", "-o", "-"], "PAIRS and the output must be files"),
        (["batch", "p"], "Missing option '-o'"),
        (["batch", "p", "-o", "x", "--workers", "0"], "0 is not in the range"),
        (["batch", "p", "-o", "x", "--compute", "all"], "'all' is not one of"),
        (["batch", "p", "-o", "x", "--flatten", "0"], "the tolerance must be positive, not 0"),
    ],
)
def test_wrong_usage_exits_with_2(arguments: list[str], message: str) -> None:
    result = run(*arguments)
    assert (result.exit_code, result.stdout) == (2, "")
    assert message in result.stderr


def test_limits_are_part_of_the_batch_digest() -> None:
    jobs = [take_all_pairs(PARTS, PARTS)]
    for changed in ({"max_mib": 2}, {"max_mib": 3}, {"max_digits": 2}):
        with limits(**changed):
            jobs.append(take_all_pairs(PARTS, PARTS))
    assert len({job.digest for job in jobs}) == len(jobs)
