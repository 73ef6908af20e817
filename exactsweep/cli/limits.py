"""Limits on file sizes and on digits of numbers."""

import click

from exactsweep.cli.help import ReadingOption
from exactsweep.cli.options import name_mistakes
from exactsweep.numbers.limits import DEFAULT_DIGITS, DEFAULT_MIB, limits

_READING_NOTHING = {"corpus", "example", "help", "lesson", "reproduce"}


def _raise_limit(ctx: click.Context, option: click.Parameter, value: float | None) -> None:
    """Set a limit while the command runs."""
    if value is not None and not ctx.resilient_parsing:
        with name_mistakes():
            ctx.with_resource(limits(**{str(option.name): value}))  # type: ignore[arg-type]


_LIMITS = (
    click.option(
        "--max-mib",
        type=click.FloatRange(min=0, min_open=True),
        expose_value=False,
        is_eager=True,  # before options with numbers
        callback=_raise_limit,
        metavar="MIB",
        help="Maximum file size in MiB; each vertex counts as at least 16 bytes. "
        f"Default: {DEFAULT_MIB}.",
        cls=ReadingOption,
    ),
    click.option(
        "--max-digits",
        type=click.IntRange(min=1),
        expose_value=False,
        is_eager=True,
        callback=_raise_limit,
        metavar="N",
        help="Maximum number of digits of a numerator and a denominator; numbers without an "
        f"exponent may have 32 times as many. Default: {DEFAULT_DIGITS}.",
        cls=ReadingOption,
    ),
)


def add_limits(command: click.Command) -> None:
    """Add --max-mib and --max-digits to a command that reads files."""
    if command.name not in _READING_NOTHING:
        for option in _LIMITS:
            option(command)
