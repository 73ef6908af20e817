"""Options and arguments of commands: values that are checked, and several that make one."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from functools import wraps
from inspect import signature
from typing import Any

import click

Decorator = Callable[[Callable[..., None]], Callable[..., None]]
"""An option or an argument of click, or several."""

# Not checked by click, for which a file that cannot be read is a mistake in the usage.
PATH = click.Path(allow_dash=True, readable=False)


@contextmanager
def name_mistakes() -> Iterator[None]:
    """Turn a ValueError into a refusal by click, which names the option."""
    try:
        yield
    except ValueError as error:
        raise click.BadParameter(str(error)) from None


def checked(read: Callable[[Any], object]) -> Callable[..., object]:
    """Make the callback of an option, which reads its value; None stays None.

    Args:
        read: raises ValueError for a value that is refused; click names the option.
    """

    def callback(ctx: click.Context, option: click.Parameter, given: Any) -> object:
        with name_mistakes():
            return None if given is None else read(given)

    return callback


def gather(name: str, make: Callable[..., object], *options: Decorator) -> Decorator:
    """Make a decorator that gives a command options, whose values become one argument.

    Args:
        name: of the argument.
        make: a function of the values, by name; also of those that other decorators made, if
            these are among the options.
        options: what the decorator gives the command, in the order of its help.
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
    """Give a command an option that is a file; None if left out."""
    return click.option(*name.split(), type=PATH, metavar="FILE", help=help)


def takes_workers(help: str) -> Decorator:
    """Give a command the option --workers, as `workers`; None if left out."""
    return click.option("--workers", type=click.IntRange(1, 1024), metavar="N", help=help)


takes_output = click.option(
    "-o", "--output", type=PATH, default="-", metavar="FILE", help="Write to a file."
)
"""Gives a command the option -o FILE, as `output`; "-" if left out."""


def requires_output(help: str, read: Callable[[Any], object] = str) -> Decorator:
    """Give a command the option -o FILE, which must not be left out; `read` may refuse it."""
    names = ("-o", "--output")
    return click.option(
        *names, type=PATH, required=True, callback=checked(read), metavar="FILE", help=help
    )
