"""The command line: `exactsweep`, with one module per command."""

from collections.abc import Iterator
from contextlib import contextmanager
from traceback import clear_frames
from typing import Any

import click

from exactsweep import __version__
from exactsweep.cli.batch import batch_command
from exactsweep.cli.compare import compare_command
from exactsweep.cli.conform import conform_command
from exactsweep.cli.convert import convert_command
from exactsweep.cli.corpus import corpus_command
from exactsweep.cli.draw import draw_command
from exactsweep.cli.example import example_command
from exactsweep.cli.explain import explain_command
from exactsweep.cli.help import add_examples
from exactsweep.cli.ifp import ifp_command
from exactsweep.cli.judge import judge_command
from exactsweep.cli.layout import layout_command
from exactsweep.cli.limits import add_limits
from exactsweep.cli.nfp import nfp_command
from exactsweep.cli.pair import give_values
from exactsweep.cli.reproduce import reproduce_command
from exactsweep.cli.sweep import sweep_command
from exactsweep.cli.verify import verify_command
from exactsweep.cli.view import view_command
from exactsweep.formats.files import show_path


class _Commands(click.Group):
    """Commands that answer a refusal with one line on standard error and exit code 1."""

    def make_context(self, *arguments: Any, **options: Any) -> click.Context:
        # --help and --version write here.
        with _refuse_in_one_line():
            return super().make_context(*arguments, **options)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        name, command, rest = super().resolve_command(ctx, args)
        return name, command, give_values(rest)

    def invoke(self, ctx: click.Context) -> object:
        with _refuse_in_one_line():
            return super().invoke(ctx)


@contextmanager
def _refuse_in_one_line() -> Iterator[None]:
    try:
        yield
    except click.ClickException as error:
        if type(error) is not click.ClickException:
            raise  # of click, which writes on several lines how a command is used
        raise click.ClickException(_on_one_line(error.message)) from None
    except ValueError as error:
        raise click.ClickException(_on_one_line(str(error))) from None
    except BrokenPipeError:
        raise  # click ends without a word
    except OSError as error:
        place = "" if error.filename is None else f"{show_path(str(error.filename))}: "
        raise click.ClickException(f"{place}{error.strerror or error}") from None
    except MemoryError as error:
        # Release the locals of the failed functions, so that there is room for the message.
        clear_frames(error.__traceback__)
        raise click.ClickException("out of memory") from None


def _on_one_line(message: str) -> str:
    """The message, with what would break its line, or do worse in a terminal, spelled out."""
    return "".join(c if c.isprintable() else repr(c)[1:-1] for c in message)


@click.group(cls=_Commands)
@click.version_option(__version__, prog_name="exactsweep")
def main() -> None:
    """Sweep polygons around polygons in exact arithmetic."""


main.add_command(sweep_command)
main.add_command(nfp_command)
main.add_command(ifp_command)
main.add_command(layout_command)
main.add_command(explain_command)
main.add_command(draw_command)
main.add_command(verify_command)
main.add_command(view_command)
main.add_command(corpus_command)
main.add_command(conform_command)
main.add_command(example_command)
main.add_command(judge_command)
main.add_command(compare_command)
main.add_command(convert_command)
main.add_command(batch_command)
main.add_command(reproduce_command)
add_examples(main)
add_limits(main)
