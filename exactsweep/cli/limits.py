"""Limits of a command on the size of files and the length of numbers."""

import click

from exactsweep.cli.options import checked
from exactsweep.numbers.limits import DEFAULT_DIGITS, DEFAULT_MIB, limits

_READING_NOTHING = {"corpus", "example", "reproduce"}


def _raise_limit(ctx: click.Context, option: click.Parameter, value: float | None) -> None:
    """Change a limit for as long as the command runs."""
    if not ctx.resilient_parsing:
        checked(lambda most: ctx.with_resource(limits(**{str(option.name): most})))(
            ctx, option, value
        )


_LIMITS = (
    click.option(
        "--max-mib",
        type=click.FloatRange(min=0, min_open=True),
        expose_value=False,
        is_eager=True,  # before options that are numbers
        callback=_raise_limit,
        metavar="MIB",
        help="Read files that count for no more than this, by their bytes, and 16 for each vertex; "
        f"{DEFAULT_MIB} if left out.",
    ),
    click.option(
        "--max-digits",
        type=click.IntRange(min=1),
        expose_value=False,
        is_eager=True,
        callback=_raise_limit,
        metavar="N",
        help="Read numbers of up to so many digits above and below the fraction bar, and 32 times "
        f"as many where they are written out; {DEFAULT_DIGITS} if left out.",
    ),
)


def add_limits(main: click.Group) -> None:
    """Give each command that reads files the options --max-mib and --max-digits."""
    for name, command in main.commands.items():
        if name not in _READING_NOTHING:
            for option in _LIMITS:
                option(command)
