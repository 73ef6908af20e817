"""Storage that moves to disk as a run grows: outcomes in order, and names once seen."""

from __future__ import annotations

import json
import sqlite3
from array import array
from collections.abc import Iterator
from contextlib import suppress
from tempfile import SpooledTemporaryFile
from weakref import finalize

from exactsweep.conform.run.outcome import Outcome, outcome_from_json
from exactsweep.numbers.error import ExactSweepError

_IN_MEMORY = 2**20
"""The number of bytes kept in memory; the rest goes to an anonymous file."""


class SpoolError(ExactSweepError):
    """The temporary file cannot be written; the message says why."""


class Spool:
    """A sequence of outcomes that grows; memory is eight bytes an outcome.

    Example:
        >>> from exactsweep.conform.judge.verdict import Verdict
        >>> spool = Spool()
        >>> spool.add(Outcome("a", "CC", (), Verdict.EXACT))
        >>> len(spool), spool[0].id, [outcome.verdict.value for outcome in spool]
        (1, 'a', ['exact'])
    """

    def __init__(self) -> None:
        self._file = SpooledTemporaryFile(_IN_MEMORY)  # noqa: SIM115
        # It closes with the spool, which is used as a sequence and has no other end.
        finalize(self, _close, self._file)
        self._starts = array("Q")
        self._end = 0

    def add(self, outcome: Outcome) -> None:
        """Take in an outcome, at the end.

        Raises:
            SpoolError: there is no room for it.
        """
        line = json.dumps(outcome.to_json()).encode() + b"\n"
        try:
            self._file.seek(self._end)
            self._file.write(line)
            self._file.flush()
        except OSError as error:
            raise SpoolError(f"temporary files: {error.strerror or error}") from None
        self._starts.append(self._end)
        self._end += len(line)

    def __len__(self) -> int:
        return len(self._starts)

    def __getitem__(self, index: int) -> Outcome:
        return self._read(self._starts[index])

    def __iter__(self) -> Iterator[Outcome]:
        return map(self._read, self._starts)

    def _read(self, start: int) -> Outcome:
        self._file.seek(start)
        return outcome_from_json(json.loads(self._file.readline()))


class SeenNames:
    """A growing set of names in an anonymous file; memory is bounded.

    Example:
        >>> seen = SeenNames()
        >>> [seen.add(name) for name in ("a", "b", "a")]
        [True, True, False]
    """

    def __init__(self) -> None:
        # The garbage collector may close the connection in another thread.
        self._table = sqlite3.connect("", check_same_thread=False)
        finalize(self, self._table.close)
        self._table.execute("CREATE TABLE seen (name BLOB PRIMARY KEY) WITHOUT ROWID")

    def add(self, name: str) -> bool:
        """Take in a name; return whether it is new.

        Raises:
            SpoolError: there is no room for it.
        """
        try:
            self._table.execute(
                "INSERT INTO seen VALUES (?)", (name.encode(errors="surrogatepass"),)
            )
        except sqlite3.IntegrityError:
            return False
        except sqlite3.OperationalError as error:
            raise SpoolError(f"temporary files: {error}") from None
        return True


def _close(file: SpooledTemporaryFile[bytes]) -> None:
    # A failed write would fail again.
    with suppress(OSError):
        file.close()
