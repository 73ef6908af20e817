"""Killed batches resume, with the records of an uninterrupted run."""

import json
import os
import signal
import subprocess
import sys
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from random import Random

import pytest
from batches import all_of, children, size, start, wait_for
from command import PATIENCE, eventually
from partlist import part_list

from exactsweep.batch import BatchError, run, take_all_pairs
from exactsweep.batch.output import Output
from exactsweep.processes import lock

PARTS = part_list(24)
JOB = take_all_pairs(PARTS, PARTS)


@pytest.fixture
def command(tmp_path: Path) -> list[str]:
    return all_of(PARTS, tmp_path)


@pytest.fixture(scope="module")
def whole() -> list[bytes]:
    """Compute the records of the batch in this process."""
    return [line for chunk in JOB.chunks(0) for line in JOB.work.lines(chunk)]


def longer(path: Path, length: int) -> Callable[[], bool]:
    return lambda: size(path) > length


@pytest.mark.long
def test_batches_killed_at_random_resume(
    tmp_path: Path, command: list[str], whole: list[bytes]
) -> None:
    random = Random(5)
    output, part = tmp_path / "out.jsonl", tmp_path / "out.jsonl.part"
    kills = 0
    while True:
        process = start([*command, "--workers", "2"])
        if kills < 2:
            wait_for(longer(part, size(part) + random.randrange(1, 150_000)), process)
            with suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
        out, err = process.communicate(timeout=PATIENCE)
        if process.returncode == 0:
            break
        assert (process.returncode, out, err) == (-signal.SIGKILL, "", "")
        assert not output.exists()
        kills += 1
    assert kills > 0
    assert output.read_bytes() == b"".join(whole)
    assert "records already existed" in out
    assert {path.name for path in tmp_path.iterdir()} == {"out.jsonl", "parts.json"}


@pytest.mark.parametrize("done", [0, 1])
def test_failed_batches_leave_their_records(tmp_path: Path, whole: list[bytes], done: int) -> None:
    output, part = tmp_path / "out.jsonl", tmp_path / "out.jsonl.part"

    def fail() -> None:
        with Output(str(output), JOB) as records:
            records.write(whole[:done])
            raise RuntimeError

    with pytest.raises(RuntimeError):
        fail()
    assert part.exists() == (done > 0)
    assert len([*tmp_path.iterdir()]) == 2 * done


def test_truncated_records_are_resumed(tmp_path: Path, whole: list[bytes]) -> None:
    everything = b"".join(whole)
    output, part = tmp_path / "out.jsonl", tmp_path / "out.jsonl.part"
    random = Random(3)
    for place in [0, 1, len(whole[0]) - 1, len(whole[0]), len(everything) - 1] + [
        random.randrange(len(everything)) for _ in range(20)
    ]:
        with Output(str(output), JOB):
            part.write_bytes(everything[:place])
        with Output(str(output), JOB) as records:
            assert part.read_bytes() == b"".join(whole[: records.done])
            assert records.done == everything[:place].count(b"\n")
            assert records.refused == sum(b'"error"' in line for line in whole[: records.done])


@pytest.mark.parametrize(
    "garbage", [b"\0" * 5000, b"x\n", b'{"index": 7, "kind": "CC"}\n', b"\n\n"]
)
def test_incomplete_records_are_dropped(tmp_path: Path, garbage: bytes, whole: list[bytes]) -> None:
    output, part = tmp_path / "out.jsonl", tmp_path / "out.jsonl.part"
    with Output(str(output), JOB):
        part.write_bytes(whole[0] + garbage + whole[1])
    with Output(str(output), JOB) as records:
        assert records.done == 1
        assert part.read_bytes() == whole[0]


def test_a_complete_part_file_is_only_renamed(tmp_path: Path, whole: list[bytes]) -> None:
    output, part = tmp_path / "out.jsonl", tmp_path / "out.jsonl.part"
    with Output(str(output), JOB):
        part.write_bytes(b"".join(whole))
    assert run(JOB, str(output)).resumed == len(whole)
    assert output.read_bytes() == b"".join(whole)


def test_records_of_another_batch_are_not_mixed_in(tmp_path: Path, whole: list[bytes]) -> None:
    output, part = tmp_path / "out.jsonl", tmp_path / "out.jsonl.part"
    others = [take_all_pairs(PARTS, PARTS[:9]), take_all_pairs(PARTS, PARTS, "areas"),
              take_all_pairs([p._replace(name="x") for p in PARTS], PARTS)]  # fmt: skip
    with Output(str(output), JOB):
        part.write_bytes(whole[0])
    for other in others:
        with pytest.raises(BatchError, match="holds records of a different batch or input; "):
            Output(str(output), other)
    assert part.read_bytes() == whole[0]
    with Output(str(output), others[0], restart=True) as records:
        assert records.done == 0
    note = tmp_path / "out.jsonl.job"
    for text in ("", "[]", "{}", "x"):
        note.write_text(text)
        part.write_bytes(whole[0])
        with pytest.raises(BatchError, match="holds records of a different batch"):
            Output(str(output), JOB)


def test_concurrent_runs_are_rejected(tmp_path: Path) -> None:
    output = str(tmp_path / "out.jsonl")
    message = r"out.jsonl: another batch is writing to it$"
    with Output(output, JOB), pytest.raises(BatchError, match=message):
        Output(output, JOB)
    with Output(output, JOB) as records:
        assert records.done == 0


@pytest.mark.usefixtures("heed_interrupts")
def test_control_c_prints_one_line_and_leaves_no_process(
    tmp_path: Path, command: list[str], whole: list[bytes]
) -> None:
    process = start([*command, "--workers", "2"])
    wait_for(lambda: size(tmp_path / "out.jsonl.part"), process)
    workers = children(process.pid)
    os.killpg(process.pid, signal.SIGINT)
    out, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, out) == (1, "")
    assert err.startswith("Error: interrupted after ")
    assert err.endswith(" of 576 pairs; run the same command to resume\n")
    assert len(workers) == 2
    wait_until_gone(workers)


def wait_until_gone(pids: list[int]) -> None:
    eventually(lambda: not any(Path(f"/proc/{pid}").exists() for pid in pids))


@pytest.mark.long
def test_workers_end_with_the_process_that_started_them(tmp_path: Path, command: list[str]) -> None:
    process = start([*command, "--workers", "2"])
    wait_for(lambda: size(tmp_path / "out.jsonl.part"), process)
    workers = children(process.pid)
    process.kill()
    process.communicate(timeout=PATIENCE)
    assert len(workers) == 2
    wait_until_gone(workers)


LOCKED = """
import os, signal, sys
from exactsweep.processes import Pool, lock

with open(sys.argv[1], "w") as file:
    assert lock(file)
    pool = Pool(1, forks=True)
    worker = pool.submit(os.getpid).result()
    os.kill(worker, signal.SIGSTOP)
    print(worker, file=file, flush=True)
    os.kill(os.getpid(), signal.SIGKILL)
"""


def test_locks_end_with_their_process_before_its_workers(tmp_path: Path) -> None:
    path = tmp_path / "locked"
    subprocess.run([sys.executable, "-c", LOCKED, str(path)], timeout=PATIENCE, check=False)
    worker = int(path.read_text())
    try:
        with path.open() as file:
            assert lock(file)
    finally:
        with suppress(ProcessLookupError):
            os.kill(worker, signal.SIGCONT)


@pytest.mark.long
def test_a_killed_worker_costs_no_record(
    tmp_path: Path, command: list[str], whole: list[bytes]
) -> None:
    process = start([*command, "--workers", "2"])
    part = tmp_path / "out.jsonl.part"
    wait_for(lambda: size(part), process)
    os.kill(children(process.pid)[0], signal.SIGKILL)
    _, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, err) == (0, "")
    assert (tmp_path / "out.jsonl").read_bytes() == b"".join(whole)


DEADLY = """
import os, sys
from exactsweep.batch import run, take_all_pairs
from exactsweep.batch.work import Work
from exactsweep.formats import NamedPolygon
from exactsweep import Polygon

class Deadly(Work):
    def line(self, index, pair):
        return os._exit(9) if index == 21 else super().line(index, pair)

if __name__ == "__main__":
    square = NamedPolygon(Polygon([(0, 0), (1, 0), (1, 1), (0, 1)]), "s")
    job = take_all_pairs([square] * 8, [square] * 5)
    work = Deadly(job.work.what, job.work.generatrices, job.work.directrices)
    print(*run(job._replace(work=work), sys.argv[1], workers=2))
"""


def test_a_pair_that_kills_its_process_is_an_error_record(tmp_path: Path) -> None:
    script, output = tmp_path / "deadly.py", tmp_path / "out.jsonl"
    script.write_text(DEADLY)
    command = [sys.executable, str(script), str(output)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    assert (done.stdout, done.stderr) == ("40 1 0\n", "")
    records = [json.loads(line) for line in output.read_text().splitlines()]
    assert [record["index"] for record in records] == list(range(40))
    (bad,) = [record for record in records if "error" in record]
    assert bad == {
        "index": 21,
        "error": "every process that tried this pair was killed",
        # Equal names get a number.
        "generatrix": "s-5",
        "directrix": "s-2",
    }
