"""The pair that a command sweeps: its files and options."""

from collections.abc import Callable
from functools import wraps
from typing import Any

import click

from exactsweep import Point, Sweep, examples, sweep
from exactsweep.direction import DirectionError, Vector, read_direction
from exactsweep.formats import file_name, read_polygon
from exactsweep.number import to_fraction

# Not checked by click, for which a file that cannot be read is a mistake in the usage.
PATH = click.Path(allow_dash=True, readable=False)


def takes_pair(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the arguments and options of a pair.

    Args:
        command: a function of a `Sweep`, the pair's, and of the command's own options.

    Returns:
        The same as a function of all options, for `click.command`.
    """

    @click.argument("generatrix", required=False, type=PATH)
    @click.argument("directrix", required=False, type=PATH)
    @click.option(
        "--direction",
        nargs=2,
        callback=_to_direction,
        metavar="P Q",
        help="The shared direction of monotonicity; chosen if left out.",
    )
    @click.option(
        "--reference",
        nargs=2,
        default=("0", "0"),
        callback=_to_point,
        metavar="X Y",
        help="The point of the generatrix whose path the trajectory is; 0 0 if left out.",
    )
    @wraps(command)
    def with_pair(
        generatrix: str | None,
        directrix: str | None,
        direction: Vector | None,
        reference: Point,
        **options: Any,
    ) -> None:
        if generatrix is not None and directrix is None:
            raise click.UsageError("Give both GENERATRIX and DIRECTRIX, or neither.")
        if generatrix == directrix == "-":
            raise click.UsageError("Only one polygon can be read from standard input.")
        command(_sweep_files(generatrix, directrix, direction, reference), **options)

    return with_pair


def _sweep_files(
    generatrix: str | None, directrix: str | None, direction: Vector | None, reference: Point
) -> Sweep:
    if generatrix is None or directrix is None:
        g, d = examples.GENERATRIX, examples.DIRECTRIX
        return sweep(g, d, direction=direction, reference=reference)
    g, d = read_polygon(generatrix), read_polygon(directrix)
    try:
        return sweep(g, d, direction=direction, reference=reference)
    except DirectionError as error:
        raise DirectionError(f"{file_name(generatrix)}, {file_name(directrix)}: {error}") from None


def _to_direction(
    ctx: click.Context, option: click.Parameter, pair: tuple[str, str] | None
) -> Vector | None:
    try:
        return None if pair is None else read_direction(pair)
    except ValueError as error:
        raise click.BadParameter(str(error)) from None


def _to_point(ctx: click.Context, option: click.Parameter, pair: tuple[str, str]) -> Point:
    try:
        return Point(*map(to_fraction, pair))
    except ValueError as error:
        raise click.BadParameter(str(error)) from None
