"""The command line `exactsweep`."""

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from importlib import import_module
from traceback import clear_frames
from typing import Any

import click

from exactsweep import __version__
from exactsweep.cli.help import add_examples, add_limits, name_reading_options
from exactsweep.words import spell_out

# The commands, each with its module.
_COMMANDS = {
    name: name for name in ("batch", "convert", "corpus", "help", "layout", "reproduce", "verify")
}
_COMMANDS |= dict.fromkeys(("compare", "conform", "judge"), "conform")
_COMMANDS |= dict.fromkeys(("draw", "explain", "sweep", "view"), "sweep")
_COMMANDS |= dict.fromkeys(("example", "lesson"), "example")
_COMMANDS |= dict.fromkeys(("ifp", "nfp"), "positions")
_COMMANDS |= dict.fromkeys(("overlap", "sum"), "shapes")
# Maximum length of a usage error, which quotes the argument.
_LONGEST = 1000


class _Modules(Mapping[str, click.Command]):
    """The commands by name, each imported on first use."""

    def __iter__(self) -> Iterator[str]:
        return iter(sorted(_COMMANDS))

    def __len__(self) -> int:
        return len(_COMMANDS)

    def __getitem__(self, name: str) -> click.Command:
        if name not in _COMMANDS:
            raise KeyError(name)
        return _load(name)


@cache
def _load(name: str) -> click.Command:
    command: click.Command = getattr(
        import_module(f"exactsweep.cli.{_COMMANDS[name]}"), f"{name}_command"
    )
    add_examples(command)
    add_limits(command)
    name_reading_options(command)
    return command


class _Commands(click.Group):
    """A group of commands that report errors in one line on standard error, with exit code 1."""

    def make_context(self, *arguments: Any, **options: Any) -> click.Context:
        # --help and --version are handled here.
        with _report_in_one_line():
            return super().make_context(*arguments, **options)

    def invoke(self, ctx: click.Context) -> object:
        with _report_in_one_line():
            return super().invoke(ctx)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        name = args[0]
        if name not in _COMMANDS and ("." in name or "/" in name):
            ctx.fail(f"{name!r} is a file; a command comes first, as in 'exactsweep sweep A B'.")
        return super().resolve_command(ctx, args)


@contextmanager
def _report_in_one_line() -> Iterator[None]:
    try:
        yield
    except click.exceptions.NoArgsIsHelpError:
        raise
    except click.UsageError as error:
        message = error.format_message()
        if len(message) <= _LONGEST:
            raise
        raise click.UsageError(f"{message[:200]}...{message[-200:]}", error.ctx) from None
    except click.ClickException as error:
        raise click.ClickException(spell_out(error.message)) from None
    except ValueError as error:
        raise click.ClickException(spell_out(str(error))) from None
    except BrokenPipeError:
        raise  # click exits silently
    except OSError as error:
        from exactsweep.formats.files import show_path

        place = "" if error.filename is None else f"{show_path(str(error.filename))}: "
        raise click.ClickException(f"{place}{error.strerror or error}") from None
    except MemoryError as error:
        # Printing the message needs memory, so release the locals of the failed functions.
        clear_frames(error.__traceback__)
        raise click.ClickException("out of memory") from None


@click.group(
    cls=_Commands,
    commands=_Modules(),
    context_settings={"help_option_names": ["-h", "--help"]},
)
@click.version_option(__version__, prog_name="exactsweep")
def main() -> None:
    """Compute sweeps, no-fit polygons and layouts in exact arithmetic."""
