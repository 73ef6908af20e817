"""Functions that run a batch in a process and find its workers."""

import subprocess
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path

from command import EXACTSWEEP, eventually

from exactsweep.formats import NamedPolygon, format_polygons


def all_of(parts: Sequence[NamedPolygon], folder: Path) -> list[str]:
    """Return the command that sweeps all pairs of a part list, with files in a folder."""
    listed = folder / "parts.json"
    listed.write_text(format_polygons(parts, "json"))
    output = folder / "out.jsonl"
    return [EXACTSWEEP, "batch", "--all", str(listed), str(listed), "-o", str(output)]


def start(command: list[str]) -> subprocess.Popen[str]:
    # A separate process group can be killed with its workers.
    return subprocess.Popen(
        command, start_new_session=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


def size(path: Path) -> int:
    return path.stat().st_size if path.exists() else 0


def wait_for(condition: Callable[[], object], process: subprocess.Popen[str]) -> None:
    """Wait until a condition holds or the process has ended."""
    eventually(lambda: condition() or process.poll() is not None)


def children(pid: int) -> list[int]:
    """List the child processes by /proc, without the resource tracker of multiprocessing."""
    found = []
    for path in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            fields = path.read_text().rpartition(")")[2].split()
            line = path.with_name("cmdline").read_bytes()
            if int(fields[1]) == pid and b"resource_tracker" not in line and fields[0] != "Z":
                found.append(int(path.parent.name))
    return found
