"""The command line: `exactsweep`, a module for each of its commands."""

import click

from exactsweep import __version__
from exactsweep.cli.explain import explain_command
from exactsweep.cli.sweep import sweep_command
from exactsweep.cli.verify import verify_command


class _Commands(click.Group):
    """Commands that answer a refusal with one line on standard error and exit code 1."""

    def invoke(self, ctx: click.Context) -> object:
        try:
            return super().invoke(ctx)
        except ValueError as error:
            raise click.ClickException(str(error)) from None
        except MemoryError:
            raise click.ClickException("out of memory") from None


@click.group(cls=_Commands)
@click.version_option(__version__, prog_name="exactsweep")
def main() -> None:
    """Sweep polygons around polygons, in exact arithmetic."""


main.add_command(sweep_command)
main.add_command(explain_command)
main.add_command(verify_command)
