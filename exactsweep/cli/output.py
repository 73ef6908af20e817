"""Output to a file, a pipe or a terminal."""

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from shutil import copymode, get_terminal_size

import click

from exactsweep.formats import FormatError, show_path
from exactsweep.formats.parsing import measure_written
from exactsweep.formats.size import find_needed_mib


def measure_terminal(output: str) -> os.terminal_size | None:
    if output == "-" and sys.stdout is not None and sys.stdout.isatty():
        return get_terminal_size()
    return None


def measure_columns(output: str) -> int | None:
    """Return the width of the terminal, or None if the output goes elsewhere."""
    terminal = measure_terminal(output)
    return terminal and terminal.columns


def write_readable(text: str, output: str) -> None:
    """Write output that other commands read, and report the size limit that this requires."""
    write(text, output)
    report_limit(measure_written(text), output)


def report_limit(size: int, output: str) -> None:
    needed = find_needed_mib(size)
    if needed is not None:
        name = "standard output" if output == "-" else show_path(output)
        click.echo(f"{name}: large file; reading it requires --max-mib {needed}", err=True)


@contextmanager
def replace_file(output: str) -> Iterator[str]:
    """Yield a temporary file that replaces the output on success, or a device itself."""
    path = Path(output).resolve()
    folder = path.parent
    in_place = path.exists() and not (path.is_file() and os.access(folder, os.W_OK))
    if in_place or not folder.is_dir():
        yield output
        return
    new = folder / f".{os.getpid()}.part{path.suffix[:9]}"
    try:
        yield str(new)
        if path.exists():
            copymode(path, new)
        new.replace(path)
    finally:
        new.unlink(missing_ok=True)


def write(text: str, output: str) -> None:
    try:
        if output != "-":
            with replace_file(output) as path:
                Path(path).write_text(text, encoding="utf-8", newline="\n")
        elif sys.stdout is None:
            raise FormatError("standard output: closed")
        else:
            click.echo(text, nl=False)
    except BrokenPipeError:
        raise
    except OSError as error:
        name = show_path(output)
        if output == "-":
            # The buffer still holds the rest, and flushing it on exit would fail again.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            name = "standard output"
        raise FormatError(f"{name}: {error.strerror or error}") from None
