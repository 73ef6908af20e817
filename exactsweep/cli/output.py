"""The output of a command: a file, a pipe or a terminal."""

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
    """Return the size of the terminal that the output goes to, or None if that is none."""
    if output == "-" and sys.stdout is not None and sys.stdout.isatty():
        return get_terminal_size()
    return None


def measure_columns(output: str) -> int | None:
    """Return the columns of the terminal that the output goes to, or None if that is none."""
    terminal = measure_terminal(output)
    return terminal and terminal.columns


def write_readable(text: str, output: str) -> None:
    """Write what commands read again, and say under which limit if they do not without one."""
    write(text, output)
    say_limit(measure_written(text), output)


def say_limit(size: int, output: str) -> None:
    """Say on standard error which limit reads what has been written, if there has to be one.

    Args:
        size: for how many bytes it counts.
        output: the file, or "-".
    """
    needed = find_needed_mib(size)
    if needed is not None:
        name = "standard output" if output == "-" else show_path(output)
        click.echo(f"{name}: large; commands read it with --max-mib {needed}", err=True)


@contextmanager
def beside(output: str) -> Iterator[str]:
    """Yield the name of a new file beside the output, which takes its place when it is whole.

    A device, and a file in a folder where no other can be made, is written in place.
    """
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
    """Write to a file, or to standard output.

    Raises FormatError when that fails, with the name of the file and the reason.
    """
    try:
        if output != "-":
            with beside(output) as path:
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
            # What could not be written is still in the buffer and would fail again on exit.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            name = "standard output"
        raise FormatError(f"{name}: {error.strerror or error}") from None
