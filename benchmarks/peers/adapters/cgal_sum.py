"""Minkowski sums by each of CGAL's strategies.

Promise: exact sums of simple polygons, by the kernel with exact constructions.

Question: `minkowski_sum_2(D, -G)`, or `minkowski_sum_by_full_convolution_2`, on exact rationals.
Compile `cgal_sums.cpp` in this folder as `exactsweep-cgal`:

    g++ -std=c++17 -O2 -DNDEBUG -o exactsweep-cgal cgal_sums.cpp -lgmp -lmpfr

A strategy that crashes is restarted for the next case.
"""

from __future__ import annotations

import subprocess
from pathlib import Path
from shutil import which

from benchmarks.peers.adapters.adapter import Adapter, MissingError, sum_adapter
from benchmarks.peers.adapters.program import Program, write_shape

PROGRAM = "exactsweep-cgal"
TAKE_HOLES = ("reduced", "vertical", "triangulation")  # the others need simple polygons
SOURCE = Path(__file__).with_name("cgal_sums.cpp")


def adapter(name: str) -> Adapter:
    """Make the adapter of one strategy."""
    program = which(PROGRAM)
    if program is None:
        raise MissingError(
            f"{name} is not installed: compile {SOURCE} as {PROGRAM} in a folder on the PATH"
        )
    version = subprocess.run([program, "version"], capture_output=True, text=True, check=True)
    strategy = name.removeprefix("cgal-")
    running = Program([program, strategy])
    return sum_adapter(
        f"CGAL {version.stdout.strip()}, {strategy}",
        "rational",
        lambda d, inverse: running.ask(f"{write_shape(d)} {write_shape(inverse)}"),
        shapes="any" if strategy in TAKE_HOLES else "simple",
        close=running.close,
    )
