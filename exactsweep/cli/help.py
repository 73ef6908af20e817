"""Help pages, with examples at the end and a page on the options for reading files."""

from inspect import cleandoc

import click

from exactsweep.numbers.error import quote
from exactsweep.words import suggest


class ReadingOption(click.Option):
    """An option for reading files, described by `exactsweep help reading`."""

    def get_help_record(self, ctx: click.Context) -> None:
        """Hide the option in the help of a command."""

    def describe(self, ctx: click.Context) -> tuple[str, str]:
        """Return the option and its description."""
        record = super().get_help_record(ctx)
        assert record
        return record


def add_examples(command: click.Command) -> None:
    """Move the examples of a command, or of each command of a group, below its options."""
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
    """Add a line that names the options for reading files to the help of a command."""
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
    """Describe the options for reading files, taken from `convert`."""
    command = group.get_command(ctx, "convert")
    assert command
    formatter = ctx.make_formatter()
    formatter.write_text("All commands that read polygons have these options.")
    formatter.write_paragraph()
    options = [option for option in command.params if isinstance(option, ReadingOption)]
    formatter.write_dl([option.describe(ctx) for option in options])
    return formatter.getvalue().rstrip("\n")
