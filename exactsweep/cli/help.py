"""Examples at the end of the help of each command."""

from inspect import cleandoc

import click


def add_examples(command: click.Command) -> None:
    """Move the examples at the end of a docstring, of each command of a group, below its options.

    Args:
        command: that of the whole program, or part of it.
    """
    if isinstance(command, click.Group):
        for inner in command.commands.values():
            add_examples(inner)
        return
    text, _, examples = cleandoc(command.help or "").partition("\n\nExample:\n")
    # \b keeps click from wrapping what follows: here, paragraphs that are indented.
    command.help = text.replace("\n\n    ", "\n\n\b\n    ")
    heading = "Examples" if "\n" in examples else "Example"
    command.epilog = f"\b\n{heading}:\n{examples}"
