"""Limits of a command on the size of files and the length of numbers."""

import click

from exactsweep.cli.help import ReadingOption
from exactsweep.cli.options import name_mistakes
from exactsweep.numbers.limits import DEFAULT_DIGITS, DEFAULT_MIB, limits

_READING_NOTHING = {"corpus", "example", "help", "lesson", "reproduce"}


def _raise_limit(ctx: click.Context, option: click.Parameter, value: float | None) -> None:
    """Change a limit for as long as the command runs."""
    if value is not None and not ctx.resilient_parsing:
        with name_mistakes():
            ctx.with_resource(limits(**{str(option.name): value}))  # type: ignore[arg-type]


_LIMITS = (
    click.option(
        "--max-mib",
        type=click.FloatRange(min=0, min_open=True),
        expose_value=False,
        is_eager=True,  # before options that are numbers
        callback=_raise_limit,
        metavar="MIB",
        help="Read files up to this size, where each vertex counts for at least 16 bytes; by "
        f"default {DEFAULT_MIB}.",
        cls=ReadingOption,
    ),
    click.option(
        "--max-digits",
        type=click.IntRange(min=1),
        expose_value=False,
        is_eager=True,
        callback=_raise_limit,
        metavar="N",
        help="Read numbers with up to N digits above and below the fraction bar, or 32 times as "
        f"many if they are written out; by default {DEFAULT_DIGITS}.",
        cls=ReadingOption,
    ),
)


def add_limits(command: click.Command) -> None:
    """Give a command that reads files the options --max-mib and --max-digits."""
    if command.name not in _READING_NOTHING:
        for option in _LIMITS:
            option(command)
