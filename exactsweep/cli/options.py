"""Building blocks of options: value checks, and options combined into one argument."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from inspect import signature
from typing import Any

import click

Decorator = Callable[[Callable[..., None]], Callable[..., None]]
"""One or more click options or arguments."""

# The readers report unreadable files; click would report a usage error.
PATH = click.Path(allow_dash=True, readable=False)


@contextmanager
def name_mistakes() -> Iterator[None]:
    """Turn a ValueError into a usage error that names the option."""
    try:
        yield
    except ValueError as error:
        raise click.BadParameter(str(error)) from None


def checked(read: Callable[[Any], object]) -> Callable[..., object]:
    """Make an option callback that converts a value, turning a ValueError into a usage error."""

    def callback(ctx: click.Context, option: click.Parameter, given: Any) -> object:
        with name_mistakes():
            return None if given is None else read(given)

    return callback


def gather(name: str, make: Callable[..., object], *options: Decorator) -> Decorator:
    """Make a decorator that adds options to a command and combines their values into one argument.

    `make` receives the values by name. `options` may include other such decorators.
    """
    wanted = signature(make).parameters

    def decorated(command: Callable[..., None]) -> Callable[..., None]:
        @wraps(command)
        def with_options(**given: Any) -> None:
            values = {word: given.pop(word) for word in wanted if word in given}
            command(**{name: make(**values)}, **given)

        found: Callable[..., None] = with_options
        for option in reversed(options):
            found = option(found)
        return found

    return decorated


def takes_file(name: str, help: str) -> Decorator:
    return click.option(*name.split(), type=PATH, metavar="FILE", help=help)


def takes_workers(help: str) -> Decorator:
    return click.option("--workers", type=click.IntRange(1, 1024), metavar="N", help=help)


takes_output = click.option(
    "-o", "--output", type=PATH, default="-", metavar="FILE", help="Write to a file."
)
"""Decorator: the option -o FILE, as `output`, with default "-"."""


def requires_output(help: str, read: Callable[[Any], object] = str) -> Decorator:
    """Add the required option -o FILE, checked by `read`."""
    names = ("-o", "--output")
    return click.option(
        *names, type=PATH, required=True, callback=checked(read), metavar="FILE", help=help
    )
