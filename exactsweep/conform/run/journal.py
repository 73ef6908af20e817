"""The journal of a run: JSON lines, one an outcome, written as they come."""

from __future__ import annotations

import json
from collections.abc import Mapping
from contextlib import suppress
from os import SEEK_END
from pathlib import Path
from typing import Any, BinaryIO, Self

from exactsweep.conform.run.outcome import Outcome, outcome_from_json
from exactsweep.conform.run.process import Terms
from exactsweep.conform.run.protocol import Hello
from exactsweep.formats import show_path
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.limits import get_max_bytes
from exactsweep.processes import lock

FORMAT = "exactsweep conform"
VERSION = 1
_WORDS = {"hello": "implementation", "seconds": "timeout"}


class JournalError(ExactSweepError):
    """A journal that cannot be begun, continued or read; the message says why."""


class Journal:
    """A journal that is written; a context manager.

    Every line is handed to the system at once, so what is in it outlives this process, however
    that ends. Only the last line can be a part of one; going on drops it.

    Args:
        path: the file.
        terms: the judged command, and what it may take; a journal on other terms is refused.
        hello: the implementation's hello, likewise.
        resume: whether the file may be there and is gone on with.

    Raises:
        JournalError: the file is there and `resume` is false; it is no journal, or one of
            something else; it cannot be read or written.
    """

    def __init__(self, path: Path, terms: Terms, hello: Hello, *, resume: bool = False) -> None:
        self._path, self._name = path, show_path(str(path))
        self._file: BinaryIO
        # Where the outcomes of before are, by the digest of their case.
        self._places: dict[str, tuple[int, int]] = {}
        head = {
            "format": FORMAT,
            "version": VERSION,
            "command": list(terms.command),
            "hello": hello.to_json(),
            "seconds": terms.seconds,
            "rounding": terms.rounding and format_fraction(terms.rounding),
            "memory": terms.most,
        }
        try:
            if resume and path.exists():
                self._go_on(head)
                return
            self._file = path.open("xb")
            self._keep_others_away(self._file)
        except FileExistsError:
            raise JournalError(
                f"{self._name} is there already; go on with it by --resume, or remove it"
            ) from None
        except OSError as error:
            raise JournalError(f"{self._name}: {error.strerror or error}") from None
        self._write(head)

    def add(self, outcome: Outcome) -> None:
        """Write an outcome.

        Raises:
            JournalError: it cannot be written.
        """
        self._write(outcome.to_json())

    def find(self, digest: str) -> Outcome | None:
        """Return the earlier outcome of a case, by its digest, or None if there is none."""
        place = self._places.get(digest)
        if place is None:
            return None
        start, length = place
        self._file.seek(start)
        line = self._file.read(length)
        self._file.seek(0, SEEK_END)
        return outcome_from_json(json.loads(line))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        # A failed write would fail again.
        with suppress(OSError):
            self._file.close()

    def _go_on(self, head: Mapping[str, Any]) -> None:
        file = self._path.open("r+b")
        try:
            self._keep_others_away(file)
            whole = self._read(file, head)
            file.truncate(whole)
            file.seek(whole)
        except BaseException:
            file.close()
            raise
        self._file = file
        if whole == 0:
            self._write(head)

    def _keep_others_away(self, file: BinaryIO) -> None:
        if not lock(file):
            raise JournalError(f"{self._name}: another run is writing it")

    def _read(self, file: BinaryIO, head: Mapping[str, Any]) -> int:
        """Read the outcomes of before; return where the last whole line ends."""
        whole, most = 0, get_max_bytes()
        for number, line in enumerate(iter(lambda: file.readline(most), b""), start=1):
            is_cut = not line.endswith(b"\n") and len(line) < most
            # Without a whole line, this may be any file, which must not be lost.
            if is_cut and (number > 1 or _line(head).startswith(line)):
                break
            try:
                data = json.loads(line)
                if number == 1:
                    self._require_same(data, head)
                else:
                    self._places[outcome_from_json(data).digest] = (whole, len(line))
            except (ValueError, AttributeError) as error:
                if isinstance(error, JournalError):
                    raise
                raise JournalError(f"{self._name}, line {number}: not of a journal") from None
            whole += len(line)
        return whole

    def _require_same(self, found: Mapping[str, Any], head: Mapping[str, Any]) -> None:
        for name, value in head.items():
            if found.get(name) != value:
                what = _WORDS.get(name, name)
                raise JournalError(f"{self._name} is the journal of another {what}")

    def _write(self, data: Mapping[str, Any]) -> None:
        try:
            self._file.write(_line(data))
            self._file.flush()
        except OSError as error:
            raise JournalError(f"{self._name}: {error.strerror or error}") from None


def _line(data: Mapping[str, Any]) -> bytes:
    return json.dumps(data).encode() + b"\n"
