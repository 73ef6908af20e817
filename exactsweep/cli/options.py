from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from inspect import signature
from typing import Any

import click

Decorator = Callable[[Callable[..., None]], Callable[..., None]]

# Unreadable files are errors of the readers, not usage errors of click.
PATH = click.Path(allow_dash=True, readable=False)


@contextmanager
def as_usage_errors() -> Iterator[None]:
    """Turn a ValueError into a usage error that names the option."""
    try:
        yield
    except ValueError as error:
        raise click.BadParameter(str(error)) from None


def checked(read: Callable[[Any], object]) -> Callable[..., object]:
    """Make an option callback that converts a value; a ValueError becomes a usage error."""

    def callback(ctx: click.Context, option: click.Parameter, given: Any) -> object:
        with as_usage_errors():
            return None if given is None else read(given)

    return callback


def gather(name: str, make: Callable[..., object], *options: Decorator) -> Decorator:
    """Make a decorator that adds options to a command and passes their values as `make(...)`."""
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


def requires_output(help: str, read: Callable[[Any], object] = str) -> Decorator:
    names = ("-o", "--output")
    return click.option(
        *names, type=PATH, required=True, callback=checked(read), metavar="FILE", help=help
    )
