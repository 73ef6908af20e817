"""The journal of a run: a JSON line for each outcome."""

import json
from collections.abc import Mapping
from contextlib import ExitStack, suppress
from pathlib import Path
from typing import Any, Self

from exactsweep.conform.run.outcome import Outcome, outcome_from_json
from exactsweep.conform.run.process import Terms
from exactsweep.conform.run.protocol import Hello
from exactsweep.formats import show_path
from exactsweep.formats.files import prefix_os_errors
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.limits import get_limits
from exactsweep.processes import lock

FORMAT = "exactsweep conform"
VERSION = 2
_WORDS = {"hello": "implementation", "seconds": "timeout"}


class JournalError(ExactSweepError):
    """A journal that cannot be started, resumed or read."""


class Journal:
    """A context manager that writes a journal; resuming drops an incomplete last line."""

    def __init__(self, path: Path, terms: Terms, hello: Hello, *, resume: bool = False) -> None:
        self._path, self._name = str(path), show_path(str(path))
        # Offsets and lengths of earlier outcomes, by the digest of their case.
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
        if path.exists() and not resume:
            raise JournalError(f"{self._name} already exists; continue with --resume, or delete it")
        with prefix_os_errors(self._path, JournalError), ExitStack() as on_error:
            self._file = on_error.enter_context(path.open("a+b"))  # appends
            self._begin(head)
            on_error.pop_all()

    def add(self, outcome: Outcome) -> None:
        self._write(outcome.to_json())

    def find(self, digest: str) -> Outcome | None:
        place = self._places.get(digest)
        if place is None:
            return None
        start, length = place
        self._file.seek(start)
        return outcome_from_json(json.loads(self._file.read(length)))

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        # A failed write would fail again.
        with suppress(OSError):
            self._file.close()

    def _begin(self, head: Mapping[str, Any]) -> None:
        """Write the head, or resume after the last complete line."""
        if not lock(self._file):
            raise JournalError(f"{self._name}: another run is writing to it")
        self._file.seek(0)
        whole = self._read(head)
        self._file.truncate(whole)
        if whole == 0:
            self._write(head)

    def _read(self, head: Mapping[str, Any]) -> int:
        """Index earlier outcomes; return the end of the last complete line."""
        whole, most = 0, get_limits().max_bytes
        for number, line in enumerate(iter(lambda: self._file.readline(most), b""), start=1):
            is_cut = not line.endswith(b"\n") and len(line) < most
            # A file without a complete line may not be a journal.
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
                raise JournalError(f"{self._name}, line {number}: not a journal record") from None
            whole += len(line)
        return whole

    def _require_same(self, found: Mapping[str, Any], head: Mapping[str, Any]) -> None:
        for name, value in head.items():
            if found.get(name) != value:
                what = _WORDS.get(name, name)
                raise JournalError(f"{self._name} is the journal of a different {what}")

    def _write(self, data: Mapping[str, Any]) -> None:
        with prefix_os_errors(self._path, JournalError):
            self._file.write(_line(data))
            self._file.flush()


def _line(data: Mapping[str, Any]) -> bytes:
    return json.dumps(data).encode() + b"\n"
