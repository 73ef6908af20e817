"""Where the answer of a command goes: a file, a pipe or a terminal."""

import os
import sys
from collections.abc import Callable, Sequence
from functools import wraps
from pathlib import Path
from shutil import get_terminal_size
from typing import Any, TypeVar

import click

from exactsweep import InnerFit, NoFitPolygon, Sweep
from exactsweep.cli.pair import PATH
from exactsweep.formats import FormatError, file_name
from exactsweep.text.results import certificate_to_json

# A report of more is not read.
_MOST_REASONS = 100

_Command = TypeVar("_Command", bound=Callable[..., None])
_Result = TypeVar("_Result", Sweep, NoFitPolygon, InnerFit)


def takes_output(command: _Command) -> _Command:
    """Give a command the option -o FILE, as `output`; "-" if left out."""
    option = click.option(
        "-o", "--output", type=PATH, default="-", metavar="FILE", help="Write to a file."
    )
    return option(command)


def takes_form(wkt: str) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a command --json, --wkt and --certificate as `form`, the word, or "report".

    Args:
        wkt: what --wkt writes.
    """

    def decorated(command: Callable[..., None]) -> Callable[..., None]:
        @click.option("--json", is_flag=True, help="Write everything, exactly, as JSON.")
        @click.option("--wkt", is_flag=True, help=f"Write {wkt}, exactly, as WKT.")
        @click.option(
            "--certificate",
            is_flag=True,
            help="Write everything, and the reasons, as JSON for 'exactsweep verify'.",
        )
        @wraps(command)
        def with_form(
            *arguments: Any, json: bool, wkt: bool, certificate: bool, **options: Any
        ) -> None:
            forms = {"json": json, "wkt": wkt, "certificate": certificate}
            chosen = [form for form, given in forms.items() if given]
            if len(chosen) > 1:
                raise click.UsageError(f"--{chosen[0]} and --{chosen[1]} exclude each other.")
            command(*arguments, form=chosen[0] if chosen else "report", **options)

        return with_form

    return decorated


def write_result(
    result: _Result,
    form: str,
    output: str,
    *,
    to_json: Callable[[_Result], str],
    to_wkt: Callable[[_Result], str],
    report: Callable[[_Result, int | None], str],
) -> None:
    """Write a result in a form of `takes_form`."""
    if form == "json":
        text = to_json(result)
    elif form == "certificate":
        text = certificate_to_json(result)
    elif form == "wkt":
        try:
            text = to_wkt(result)
        except FormatError as error:
            raise FormatError(f"{error}; use --json") from None
    else:
        terminal = terminal_size(output)
        text = report(result, terminal and terminal.columns)
    write(text, output)


def say_left_out(reasons: Sequence[str]) -> None:
    """Say on standard error what was not read, and why, a line each."""
    for reason in reasons[:_MOST_REASONS]:
        click.echo(f"left out: {reason}", err=True)
    if len(reasons) > _MOST_REASONS:
        click.echo(f"left out: {len(reasons) - _MOST_REASONS} more", err=True)


def terminal_size(output: str) -> os.terminal_size | None:
    """Return the size of the terminal that the output goes to, or None if that is none."""
    if output == "-" and sys.stdout is not None and sys.stdout.isatty():
        return get_terminal_size()
    return None


def write(text: str, output: str) -> None:
    """Write to a file, or to standard output.

    Raises FormatError when that fails, with the name of the file and the reason.
    """
    try:
        if output != "-":
            Path(output).write_text(text, encoding="utf-8", newline="\n")
        elif sys.stdout is None:
            raise FormatError("standard output: closed")
        else:
            click.echo(text, nl=False)
    except BrokenPipeError:
        raise
    except OSError as error:
        name = file_name(output)
        if output == "-":
            # What could not be written is still in the buffer and would fail again on exit.
            os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
            name = "standard output"
        raise FormatError(f"{name}: {error.strerror or error}") from None
