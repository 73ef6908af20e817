"""The pair that a command works on: its files and options."""

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import wraps
from typing import Any

import click

from exactsweep import (
    InnerFit,
    NoFitPolygon,
    Point,
    Region,
    inner_fit_polygon,
    no_fit_polygon,
    sweep,
)
from exactsweep.cli.parts import find_parts, read_named, say_all, say_left_out
from exactsweep.cli.working import working
from exactsweep.formats import NamedRegion, show_path
from exactsweep.formats import reading as how
from exactsweep.formats.folder import bring_to_one
from exactsweep.formats.part_list import Coordinates
from exactsweep.formats.polygons import name_file, read_choice, split_choice
from exactsweep.geometry.direction import DirectionError, Vector, read_direction
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.error import name_refusals
from exactsweep.numbers.number import to_fraction

# A house that cannot reach the bottom of a lopsided notch: a CM sweep with one undercut. All
# loops have finite decimal coordinates, so that every output format can hold them.
GENERATRIX = Polygon([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)])
DIRECTRIX = Polygon([(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)])

# Not checked by click, for which a file that cannot be read is a mistake in the usage.
PATH = click.Path(allow_dash=True, readable=False)


ReadingOptions = dict[str, Any]
"""The arguments "tolerance" and `Options` of what reads files."""

SAME_LAYER = "layer"
"""The value of --nested that `give_values` adds where there is none."""

_COORDINATES = "exactsweep.coordinates"


def give_values(arguments: Sequence[str]) -> list[str]:
    """Give --nested a value where the next word is none, for it need not have one.

    >>> give_values(["--nested", "a.dxf", "--nested", "all", "--nested", "OUTER,INNER"])
    ['--nested=layer', 'a.dxf', '--nested', 'all', '--nested', 'OUTER,INNER']
    """
    after = [*arguments, ""][1:]
    return [
        f"--nested={SAME_LAYER}" if one == "--nested" and word != "all" and "," not in word else one
        for one, word in zip(arguments, after, strict=True)
    ]


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
    @takes_reading
    @wraps(command)
    def with_pair(
        generatrix: str | None,
        directrix: str | None,
        direction: Vector | None,
        reference: Point,
        reading: ReadingOptions,
        **options: Any,
    ) -> None:
        if generatrix is not None and directrix is None:
            raise click.UsageError("Give both GENERATRIX and DIRECTRIX, or neither.")
        asked = _ASKED.get(options.pop("asked", "sweep"))
        if generatrix is None or directrix is None:
            g, d = Region(GENERATRIX), Region(DIRECTRIX)
            g, d = (d, g) if asked else (g, d)
        else:
            g, d = read_two(generatrix, directrix, reading)
        if asked:
            if direction is not None:
                raise click.UsageError("--direction is for sweeps.")
            command(asked(g, d, reference=reference), **options)
            return
        try:
            result = sweep(g, d, direction=direction, reference=reference)
        except DirectionError as error:
            if generatrix is None or directrix is None:
                raise
            raise DirectionError(
                f"{show_path(generatrix)}, {show_path(directrix)}: {error}"
            ) from None
        command(result, **options)

    return with_pair


_ASKED: dict[str, Callable[..., NoFitPolygon | InnerFit]] = {
    "nfp": no_fit_polygon,
    "ifp": inner_fit_polygon,
}


def takes_question(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command of `takes_pair` the option --of, by which its result is no sweep."""
    option = click.option(
        "--of",
        "asked",
        type=click.Choice(["sweep", *_ASKED]),
        default="sweep",
        help="Show a sweep, or the no-fit polygon of STATIONARY and ORBITING, or the inner fit of "
        "CONTAINER and PART, the files in this order.",
    )
    return option(command)


def name_files_of_pair() -> tuple[str, str] | None:
    """The files of G and of D of the command that runs; None for the built-in example."""
    named = click.get_current_context().params
    generatrix, directrix = named.get("generatrix"), named.get("directrix")
    return None if generatrix is None or directrix is None else (generatrix, directrix)


def coordinates_of_files() -> Coordinates:
    """The meaning of the coordinates that the command that runs has read: of Y, and the unit."""
    ctx = click.get_current_context()
    coordinates: Coordinates = ctx.meta.get(
        _COORDINATES, Coordinates(bool(ctx.params.get("y_down")))
    )
    return coordinates


def takes_shapes(
    first: str, second: str, *, several: bool = False, others: str = ""
) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Give a command two polygons, of which the second one moves, as positional arguments.

    Args:
        first: what the file of the one that stays is called.
        second: what the file of the other one is called.
        several: whether each may be several files with several polygons.
        others: the name of an option that reads further polygons, if there is one.

    Returns:
        A decorator for a function of two Regions, or of two lists of NamedRegion, and of options,
        of which "reference" is one.
    """

    def decorated(command: Callable[..., None]) -> Callable[..., None]:
        @click.argument("stays", metavar=first, type=PATH)
        @click.argument("moves", metavar=second, type=PATH)
        @click.option(
            "--reference",
            nargs=2,
            default=("0", "0"),
            callback=_to_point,
            metavar="X Y",
            help=f"The point of {second} whose positions are told; 0 0 if left out.",
        )
        @takes_reading
        @wraps(command)
        def with_shapes(stays: str, moves: str, reading: ReadingOptions, **options: Any) -> None:
            read = _read_each if several else read_two
            shapes = read(stays, moves, reading)
            if others:
                options[others] = _read_all(options[others], reading)
            command(*shapes, **options)

        if not others:
            return with_shapes
        return click.option(
            f"--{others}",
            multiple=True,
            type=PATH,
            metavar="FILE",
            help=f"Polygons that {second} must not overlap either; may be repeated.",
        )(with_shapes)

    return decorated


def keep_coordinates(coordinates: Coordinates, notes: Iterable[str] = ()) -> None:
    """Keep the meaning of the coordinates for what the command writes, and say what changed."""
    click.get_current_context().meta[_COORDINATES] = coordinates
    say_all(notes)


def _require_one_input(first: str, second: str) -> None:
    if first == second == "-":
        raise click.UsageError("Only one polygon can be read from standard input.")


def _read_each(
    first: str, second: str, reading: ReadingOptions
) -> tuple[list[NamedRegion], list[NamedRegion]]:
    _require_one_input(first, second)
    found = [(show_path(path), read_named([path], reading)) for path in (first, second)]
    keep_coordinates(*bring_to_one(found))
    return found[0][1], found[1][1]


def _read_all(paths: Sequence[str], reading: ReadingOptions) -> list[Region]:
    """Read all polygons of files, with Y as in the pair; none may be left out as not simple."""
    regions: list[Region] = []
    listing = find_parts(paths, reading) if paths else None
    for part in listing.parts if listing else ():
        with name_refusals(part.file):
            regions.append(part.candidate.named_region().region)
    if listing and listing.coordinates.y_down != coordinates_of_files().y_down:
        say_all([f"{', '.join(map(show_path, paths))}: Y turned, to point as in the other files"])
        regions = [region.scaled((1, -1)) for region in regions]
    return regions


def read_two(first: str, second: str, reading: ReadingOptions) -> tuple[Region, Region]:
    """Read two polygons, each from a file, with Y the same way up, and say what is left out."""
    _require_one_input(first, second)
    with working("reading"):
        files = [(path, read_choice(path, **reading)) for path in (first, second)]
    keep_coordinates(*bring_to_one([(show_path(path), found) for path, found in files]))
    regions = []
    for path, found in files:
        name = split_choice(path)[0]
        say_left_out([f"{show_path(name)}: {reason}" for reason in found.left_out])
        say_all(f"{show_path(name)}: {note}" for note in found.notes)
        with working("reading"), name_file(name):
            regions.append(found[0].region())
    return regions[0], regions[1]


def takes_reading(command: Callable[..., None]) -> Callable[..., None]:
    """Give a command the options of how files are read, as `reading`, a dict of arguments."""

    @click.option(
        "--flatten",
        "tolerance",
        callback=_to_positive,
        metavar="TOLERANCE",
        help="Read curves of SVG and DXF as lines no farther from them than this; refused if "
        "left out.",
    )
    @click.option(
        "--join",
        callback=_to_positive,
        metavar="DISTANCE",
        help="Join ends of lines of SVG and DXF that are no farther apart; only equal ends if left "
        "out.",
    )
    @click.option(
        "--nested",
        metavar="[all|OUTER,INNER]",
        help="Closed outlines inside others of their layer are holes, which DXF has no other way "
        "to draw; with 'all', of any layer; with names of layers, of any of these.",
    )
    @click.option("--hidden", is_flag=True, help="Read hidden geometry of SVG and DXF, too.")
    @click.option(
        "--y-down/--y-up",
        default=None,
        help="Whether Y points down in the files; if left out, it does in SVG only.",
    )
    @click.option(
        "--unit",
        type=click.Choice(list(how.UNITS)),
        help="Scale SVG and DXF that say their unit to this one; numbers as they stand if left "
        "out.",
    )
    @wraps(command)
    def with_reading(
        tolerance: Fraction | None,
        join: Fraction | None,
        nested: str | None,
        unit: str | None,
        hidden: bool,
        y_down: bool | None,
        **options: Any,
    ) -> None:
        reading = {"tolerance": tolerance, "join": join, "unit": unit, "hidden": hidden}
        reading |= {"nested": nested == SAME_LAYER or nested or False, "y_down": y_down}
        command(reading=reading, **options)

    return with_reading


def _to_positive(ctx: click.Context, option: click.Parameter, text: str | None) -> Fraction | None:
    """Read the tolerance of curves, or the distance of ends."""
    try:
        if option.name == "join":
            return how.Reading(join=text).join
        return how.Reading(text).tolerance
    except ValueError as error:
        raise click.BadParameter(str(error)) from None


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
