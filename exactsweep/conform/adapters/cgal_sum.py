"""CGAL: its Minkowski sums, by every strategy that it has, in a program to be compiled.

What it promises: exact sums of simple polygons, by the kernel with exact constructions.

What it is asked: `minkowski_sum_2(D, -G)`, or `minkowski_sum_by_full_convolution_2`, on exact
rationals, nothing being rounded on the way. The program is `cgal_sums.cpp` beside this module; it
has to be compiled and to be found as `exactsweep-cgal`:

    g++ -std=c++17 -O2 -DNDEBUG -o exactsweep-cgal cgal_sums.cpp -lgmp -lmpfr

A strategy that runs forever is ended with the process that asks it, and one that crashes is started
again for the next case.
"""

from __future__ import annotations

import subprocess
from collections.abc import Iterator, Sequence
from fractions import Fraction
from math import inf
from pathlib import Path
from shutil import which

from exactsweep.conform.adapters.adapter import Adapter, MissingError, Ring, peer_hello
from exactsweep.conform.run.channel import Channel, ClosedError
from exactsweep.geometry.number import format_fraction

PROGRAM = "exactsweep-cgal"
SOURCE = Path(__file__).with_name("cgal_sums.cpp")


class CgalError(Exception):
    """What went wrong in the program."""


def adapter(name: str) -> Adapter:
    """Return the adapter of one strategy.

    Raises:
        MissingError: the program is not to be found.
    """
    program = which(PROGRAM)
    if program is None:
        raise MissingError(
            f"{name} is not installed: compile {SOURCE} to a program {PROGRAM} on the path"
        )
    version = subprocess.run([program, "version"], capture_output=True, text=True, check=True)
    strategy = name.removeprefix("cgal-")
    hello = peer_hello(f"CGAL {version.stdout.strip()}, {strategy}", "rational")
    running = _Program([program, strategy])
    return Adapter(hello, running.rings, running.close)


class _Program:
    """The running program, started when it is needed."""

    def __init__(self, command: Sequence[str]) -> None:
        self._command = command
        self._channel: Channel | None = None

    def rings(self, directrix: Ring, inverse: Ring) -> list[list[tuple[str, str]]]:
        """Ask for a sum."""
        self._channel = self._channel or Channel(self._command)
        self._channel.send(f"{_line(directrix)} {_line(inverse)}")
        try:
            line = self._channel.receive(inf)
        except ClosedError as error:
            self.close()
            raise CgalError(f"the program {error}") from None
        if line.startswith("error"):
            raise CgalError(line.removeprefix("error").strip())
        words = iter(line.split())
        return [list(_ring(words)) for _ in range(int(next(words)))]

    def close(self) -> None:
        """End it."""
        if self._channel is not None:
            self._channel.kill()
            self._channel = None


def _line(ring: Ring) -> str:
    words = (format_fraction(Fraction(c)) for point in ring for c in point)
    return f"{len(ring)} {' '.join(words)}"


def _ring(words: Iterator[str]) -> Iterator[tuple[str, str]]:
    for _ in range(int(next(words))):
        yield next(words), next(words)
