"""The resumable output file of a batch.

Records go to FILE.part in order; when complete, it is renamed to FILE. FILE.job identifies the
batch, and is locked while the batch runs.
"""

import json
import os
from collections.abc import Iterable
from contextlib import ExitStack, suppress
from pathlib import Path
from stat import S_IFREG, S_ISDIR, S_ISREG
from types import TracebackType
from typing import Self

from exactsweep.batch.job import Job
from exactsweep.batch.record import is_error, is_record
from exactsweep.batch.work import BatchError
from exactsweep.formats.files import prefix_os_errors, show_path
from exactsweep.processes import lock

PARQUET, CSV = ".parquet", ".csv"


class Output:
    """The records of a batch; records of an earlier run are kept unless `restart`."""

    def __init__(self, path: str, job: Job, *, restart: bool = False) -> None:
        self.path, self.job = Path(path), job
        try:
            mode = self.path.stat().st_mode
        except (FileNotFoundError, NotADirectoryError):
            mode = S_IFREG
        except (OSError, ValueError) as error:
            # For example, a name that is too long or contains a null byte.
            reason = error.strerror if isinstance(error, OSError) else str(error)
            raise BatchError(f"{show_path(path)}: {reason}") from None
        if S_ISDIR(mode):
            raise BatchError(f"{show_path(path)}: Is a directory")
        if not S_ISREG(mode):
            raise BatchError(f"{show_path(path)}: a pipe or a device; write to a regular file")
        self.is_table = self.path.suffix.lower() in (PARQUET, CSV)
        self.part = self.path.with_name(f"{self.path.name}.part")
        self.note = self.path.with_name(f"{self.path.name}.job")
        self.done = self.refused = 0
        if self.path.suffix.lower() == PARQUET:
            from exactsweep.batch.table import require_pyarrow

            require_pyarrow()
        with ExitStack() as opened:
            try:
                self.lock = opened.enter_context(open(self.note, "a+", encoding="utf-8"))
                if not lock(self.lock):
                    raise BatchError(f"{show_path(path)}: another batch is writing to it")
                self._check_owner(restart)
                self.file = opened.enter_context(open(self.part, "r+b"))
                self._resume()
            except OSError as error:
                raise BatchError(f"{show_path(path)}: {error.strerror or error}") from None
            self.opened = opened.pop_all()

    def _check_owner(self, restart: bool) -> None:
        """Check that existing records belong to this batch, or start a new file."""
        self.lock.seek(0)
        noted = self.lock.read()
        if self.part.exists() and self.part.stat().st_size and not restart:
            try:
                ours = json.loads(noted)["digest"] == self.job.digest
            except (ValueError, TypeError, KeyError):
                ours = False
            if not ours:
                raise BatchError(
                    f"{show_path(str(self.part))} holds records of a different batch or input; "
                    "--restart discards them"
                )
        else:
            self.part.write_bytes(b"")
            self.lock.truncate(0)
            self.lock.write(json.dumps({"digest": self.job.digest, "pairs": self.job.total}))
            self.lock.flush()

    def _resume(self) -> None:
        """Count the complete records, and drop an incomplete last one."""
        end = 0
        for line in self.file:
            if not is_record(line, self.done) or self.done == self.job.total:
                break
            self._count(line)
            end += len(line)
        self.file.seek(end)
        self.file.truncate()

    def _count(self, line: bytes) -> None:
        self.done += 1
        self.refused += is_error(line)

    def write(self, lines: Iterable[bytes]) -> None:
        """Append records and flush, so that they survive the process."""
        with prefix_os_errors(str(self.part), BatchError):
            for line in lines:
                self.file.write(line)
                self._count(line)
            self.file.flush()

    def finish(self) -> None:
        assert self.done == self.job.total
        with prefix_os_errors(str(self.path), BatchError):
            os.fsync(self.file.fileno())
            self.file.close()
            if self.is_table:
                from exactsweep.batch.table import write_csv, write_parquet

                table = self.path.with_name(f"{self.path.name}.tmp")
                work = self.job.work
                if self.path.suffix.lower() == PARQUET:
                    rounded = work.rounding is not None
                    write_parquet(self.part, table, work.what, rounded=rounded)
                else:
                    write_csv(self.part, table, work.what)
                table.replace(self.path)
                self.part.unlink()
            else:
                self.part.replace(self.path)
            self.note.unlink()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        traceback: TracebackType | None,
    ) -> None:
        # After a failed write, closing fails again.
        with suppress(OSError):
            if error is not None and not self.done:
                self.part.unlink()
                self.note.unlink()
            self.opened.close()
