"""Help pages, and the limits on file sizes and digits that all readers have."""

from inspect import cleandoc

import click

from exactsweep.cli.options import as_usage_errors
from exactsweep.numbers.error import quote
from exactsweep.numbers.limits import DEFAULT_DIGITS, DEFAULT_MIB, limits
from exactsweep.words import suggest


class ReadingOption(click.Option):
    """An option for reading files, documented by `exactsweep help reading` instead of --help."""

    def get_help_record(self, ctx: click.Context) -> None:
        return None

    def describe(self, ctx: click.Context) -> tuple[str, str]:
        record = super().get_help_record(ctx)
        assert record
        return record


def add_examples(command: click.Command) -> None:
    """Move the examples of a command, and of the commands of a group, below the options."""
    if isinstance(command, click.Group):
        for inner in command.commands.values():
            add_examples(inner)
        return
    text, _, examples = cleandoc(command.help or "").partition("\n\nExample:\n")
    # \b keeps click from wrapping indented paragraphs.
    command.help = text.replace("\n\n    ", "\n\n\b\n    ")
    heading = "Examples" if "\n" in examples else "Example"
    command.epilog = f"\b\n{heading}:\n{examples}"


def name_reading_options(command: click.Command) -> None:
    if isinstance(command, click.Group):
        for inner in command.commands.values():
            name_reading_options(inner)
        return
    names = [option.opts[-1] for option in command.params if isinstance(option, ReadingOption)]
    if names:
        line = f"Also {' '.join(names)}: see 'exactsweep help reading'."
        command.epilog = f"{line}\n\n{command.epilog or ''}"


@click.command("help")
@click.argument("topic", required=False)
@click.pass_context
def help_command(ctx: click.Context, topic: str | None) -> None:
    """Show the help of a command, or of the options for reading files.

    TOPIC is a command, or 'reading'. Without TOPIC, lists all commands.

    Example:
      exactsweep help reading
      exactsweep help nfp
    """
    whole = ctx.find_root()
    assert isinstance(whole.command, click.Group)
    if topic is None:
        click.echo(whole.get_help())
        return
    if topic == "reading":
        click.echo(_describe_reading(whole.command, whole))
        return
    command = whole.command.get_command(whole, topic)
    if command is None:
        near = suggest(topic, [*whole.command.commands, "reading"])
        raise click.UsageError(f"No such command or topic {quote(topic)}{near or '.'}")
    click.echo(command.get_help(click.Context(command, info_name=topic, parent=whole)))


def _describe_reading(group: click.Group, ctx: click.Context) -> str:
    command = group.get_command(ctx, "convert")  # any command with these options
    assert command
    formatter = ctx.make_formatter()
    formatter.write_text("All commands that read polygons have these options.")
    formatter.write_paragraph()
    options = [option for option in command.params if isinstance(option, ReadingOption)]
    formatter.write_dl([option.describe(ctx) for option in options])
    return formatter.getvalue().rstrip("\n")


_READING_NOTHING = {"corpus", "example", "help", "lesson", "reproduce"}


def _raise_limit(ctx: click.Context, option: click.Parameter, value: float | None) -> None:
    if value is not None and not ctx.resilient_parsing:
        with as_usage_errors():
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
    if command.name not in _READING_NOTHING:
        for option in _LIMITS:
            option(command)
