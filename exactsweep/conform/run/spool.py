"""Storage that moves to disk as a run grows: outcomes in order, and names once seen."""

from __future__ import annotations

import json
import sqlite3
from collections.abc import Iterator
from weakref import finalize

from exactsweep.conform.run.outcome import Outcome, outcome_from_json
from exactsweep.numbers.error import ExactSweepError


class SpoolError(ExactSweepError):
    """The temporary file cannot be written; the message says why."""


class _AnonymousTable:
    """A table of one column in an anonymous file, of which SQLite keeps a bounded part in memory.

    Args:
        declared: the column and the end of the declaration in SQL.
    """

    def __init__(self, declared: str) -> None:
        # The garbage collector may close the connection in another thread.
        self._file = sqlite3.connect("", check_same_thread=False)
        finalize(self, self._file.close)
        self._file.execute(f"CREATE TABLE kept ({declared}")

    def _insert(self, value: str | bytes) -> None:
        try:
            self._file.execute("INSERT INTO kept VALUES (?)", (value,))
        except sqlite3.OperationalError as error:
            raise SpoolError(f"temporary files: {error}") from None


class Spool(_AnonymousTable):
    """A sequence of outcomes that grows.

    Example:
        >>> from exactsweep.conform.judge.verdict import Verdict
        >>> spool = Spool()
        >>> spool.add(Outcome("a", "CC", (), Verdict.EXACT))
        >>> len(spool), spool[0].id, [outcome.verdict.value for outcome in spool]
        (1, 'a', ['exact'])
    """

    def __init__(self) -> None:
        super().__init__("line TEXT)")
        self._length = 0

    def add(self, outcome: Outcome) -> None:
        """Take in an outcome, at the end.

        Raises:
            SpoolError: there is no room for it.
        """
        self._insert(json.dumps(outcome.to_json()))
        self._length += 1

    def __len__(self) -> int:
        return self._length

    def __getitem__(self, index: int) -> Outcome:
        (found,) = self._read("WHERE rowid = ?", range(1, self._length + 1)[index])
        return found

    def __iter__(self) -> Iterator[Outcome]:
        return self._read("ORDER BY rowid")

    def _read(self, which: str, *values: int) -> Iterator[Outcome]:
        for (line,) in self._file.execute(f"SELECT line FROM kept {which}", values):
            yield outcome_from_json(json.loads(line))


class SeenNames(_AnonymousTable):
    """A growing set of names.

    Example:
        >>> seen = SeenNames()
        >>> [seen.add(name) for name in ("a", "b", "a")]
        [True, True, False]
    """

    def __init__(self) -> None:
        super().__init__("name BLOB PRIMARY KEY) WITHOUT ROWID")

    def add(self, name: str) -> bool:
        """Take in a name; return whether it is new.

        Raises:
            SpoolError: there is no room for it.
        """
        try:
            self._insert(name.encode(errors="surrogatepass"))
        except sqlite3.IntegrityError:
            return False
        return True
