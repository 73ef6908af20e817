"""Programs that read and write shapes, one per line, as words separated by spaces.

A shape consists of the number of rings and, for each ring, the number of vertices and their
coordinates. An answer is a shape, or starts with "error".
"""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from math import inf
from pathlib import Path
from shutil import which

from benchmarks.peers.adapters.adapter import AskedRing, AskedShape, MissingError
from exactsweep.conform.run.channel import Channel, ClosedError
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import to_fraction


class ProgramError(Exception):
    """A failure of the program."""


class Program:
    """A program that is started on demand, and restarted after it exits."""

    def __init__(self, command: Sequence[str]) -> None:
        self._command = command
        self._channel: Channel | None = None

    def ask(self, line: str) -> list[list[tuple[str, str]]]:
        """Send a line, and read the rings of the answer."""
        self._channel = self._channel or Channel(self._command)
        self._channel.send(line)
        try:
            answer = self._channel.receive(inf)
        except ClosedError as error:
            self.close()
            raise ProgramError(f"the program {error}") from None
        if answer.startswith("error"):
            raise ProgramError(answer.removeprefix("error").strip())
        words = iter(answer.split())
        return [
            [(next(words), next(words)) for _ in range(int(next(words)))]
            for _ in range(int(next(words)))
        ]

    def close(self) -> None:
        if self._channel is not None:
            self._channel.kill()
            self._channel = None


def find_node(name: str, variable: str, file: str, what: str) -> tuple[str, Path]:
    """Find node, and a folder that an environment variable names and that contains a file."""
    node, folder = which("node"), os.environ.get(variable)
    if not (node and folder and Path(folder, file).is_file()):
        raise MissingError(f"{name} needs node, and the variable {variable} must name {what}")
    return node, Path(folder)


def write_fraction(value: object) -> str:
    return format_fraction(to_fraction(value))


def write_shape(shape: AskedShape, write: Callable[[object], str] = write_fraction) -> str:
    """Write a shape as words.

    >>> write_shape([[(0, 0), (1, 0), (0, 1)]])
    '1 3 0 0 1 0 0 1'
    """
    return " ".join([str(len(shape)), *(write_ring(ring, write) for ring in shape)])


def write_ring(ring: AskedRing, write: Callable[[object], str]) -> str:
    return " ".join([str(len(ring)), *(write(c) for point in ring for c in point)])
