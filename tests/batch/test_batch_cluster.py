"""Batches on Dask workers, one of which is killed."""

import json
import os
import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest
from batches import all_of, children, size, start, wait_for
from command import PATIENCE
from partlist import part_list

from exactsweep.batch import take_all_pairs

PARTS = part_list(16)
JOB = take_all_pairs(PARTS, PARTS)


@cache
def whole() -> bytes:
    """Return the records of all pairs."""
    return b"".join(line for chunk in JOB.chunks(0) for line in JOB.work.lines(chunk))


@pytest.fixture
def command(tmp_path: Path) -> list[str]:
    return all_of(PARTS, tmp_path)


def dask(*arguments: str) -> subprocess.Popen[str]:
    return subprocess.Popen(
        [sys.executable, "-m", "distributed.cli.dask_" + arguments[0], *arguments[1:]],
        stderr=subprocess.PIPE,
        text=True,
    )


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[subprocess.Popen[str]]]]:
    """Start a scheduler and two workers without automatic restarts."""
    file = tmp_path / "scheduler.json"
    processes = [
        dask("scheduler", "--host", "127.0.0.1", "--port", "0", "--no-dashboard",
             "--scheduler-file", str(file))
    ]  # fmt: skip
    try:
        wait_for(lambda: size(file), processes[0])
        address = json.loads(file.read_text())["address"]
        for _ in range(2):
            processes.append(
                dask("worker", address, "--nthreads", "1", "--no-nanny", "--no-dashboard",
                     "--local-directory", str(tmp_path / "dask"))
            )  # fmt: skip
        yield address, processes
    finally:
        for process in processes[::-1]:
            process.kill()
            process.communicate()


@pytest.mark.long
def test_lost_workers_and_schedulers_cost_no_record(
    tmp_path: Path, command: list[str], cluster: tuple[str, list[subprocess.Popen[str]]]
) -> None:
    address, processes = cluster
    output, part = tmp_path / "out.jsonl", tmp_path / "out.jsonl.part"
    process = start([*command, "--scheduler", address])
    wait_for(lambda: size(part), process)
    processes[1].kill()
    out, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, err) == (0, "")
    assert re.fullmatch(r"256 pairs, \d+ refused\n", out)
    assert output.read_bytes() == whole()
    output.unlink()

    process = start([*command, "--scheduler", address])
    wait_for(lambda: size(part), process)
    for other in processes:
        other.kill()
    out, err = process.communicate(timeout=PATIENCE)
    if process.returncode:
        assert (process.returncode, out) == (1, "")
        assert re.fullmatch(r"Error: lost the scheduler after \d+ of 256 pairs; .*\n", err)
        subprocess.run(command, check=True, capture_output=True)
    assert output.read_bytes() == whole()


@pytest.mark.long
def test_a_local_cluster_survives_a_killed_worker(tmp_path: Path, command: list[str]) -> None:
    process = start([*command, "--scheduler", "local", "--workers", "2"])
    wait_for(lambda: size(tmp_path / "out.jsonl.part"), process)
    workers = children(process.pid)
    assert len(workers) == 2
    os.kill(workers[0], signal.SIGKILL)
    _, err = process.communicate(timeout=PATIENCE)
    assert (process.returncode, err) == (0, "")
    assert (tmp_path / "out.jsonl").read_bytes() == whole()
    assert not any(Path(f"/proc/{pid}").exists() for pid in workers)


@pytest.mark.long
def test_a_missing_scheduler_is_reported_and_leaves_no_file(
    tmp_path: Path, command: list[str]
) -> None:
    done = subprocess.run(
        [*command, "--scheduler", "tcp://127.0.0.1:9"],
        capture_output=True,
        text=True,
        timeout=PATIENCE,
    )
    assert (done.returncode, done.stdout) == (1, "")
    assert re.fullmatch(r"Error: no Dask scheduler at 'tcp://127.0.0.1:9': .*\n", done.stderr)
    assert [path.name for path in tmp_path.iterdir()] == ["parts.json"]
