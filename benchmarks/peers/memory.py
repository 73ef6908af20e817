"""Peak memory of one trajectory, measured in a process of its own.

    python -m benchmarks.peers.memory FAMILY M N

The process' peak comes from the system, and is read before tracemalloc starts, whose own peak
comes from a second run.
"""

from __future__ import annotations

import json
import sys
import tracemalloc
from pathlib import Path

from benchmarks.families import FAMILIES
from exactsweep import sweep


def peak() -> int:
    """The most bytes that this process has held in memory."""
    described = Path("/proc/self/status")
    if described.exists():
        # The result of getrusage on Linux includes the parent, up to the start of this program.
        for line in described.read_text(encoding="utf-8").splitlines():
            if line.startswith("VmHWM:"):
                return 1024 * int(line.split()[1])
    import resource

    unit = 1 if sys.platform == "darwin" else 1024
    return unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def main() -> None:
    family, m, n = sys.argv[1:]
    generatrix, directrix = FAMILIES[family](int(m), int(n), 0)
    vertices = len(sweep(generatrix, directrix).trajectory.vertices)
    process = peak()
    tracemalloc.start()
    swept = sweep(generatrix, directrix).trajectory
    assert len(swept.vertices) == vertices
    traced = tracemalloc.get_traced_memory()[1]
    json.dump({"vertices": vertices, "process": process, "traced": traced}, sys.stdout)


if __name__ == "__main__":
    main()
