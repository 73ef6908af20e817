"""The polygons of a command: its files and reading options."""

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import Any

import click

from exactsweep import InnerFit, NoFitPolygon, Point, Region, Sweep
from exactsweep.cli.help import ReadingOption
from exactsweep.cli.options import PATH, Decorator, checked, gather
from exactsweep.cli.parts import find_parts, print_notes, read_named, report_error, report_skipped
from exactsweep.cli.working import working
from exactsweep.formats import NamedRegion, show_path
from exactsweep.formats import reading as how
from exactsweep.formats.candidate import Candidate
from exactsweep.formats.depth import separate_holes
from exactsweep.formats.folder import unify_coordinates
from exactsweep.formats.part_list import Coordinates, PartList, Remarks
from exactsweep.formats.polygons import prefix_path, read_choice, read_single, split_choice
from exactsweep.geometry.direction import DirectionError, Vector, read_direction
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.error import prefix_errors
from exactsweep.numbers.number import to_fraction
from exactsweep.sweep import inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.words import count

# The example: a CM sweep with one undercut, whose loops have finite decimal coordinates, so that
# every output format can represent them.
GENERATRIX = Polygon([(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)])
DIRECTRIX = Polygon([(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)])

ReadingOptions = dict[str, Any]

_COORDINATES = "exactsweep.coordinates"
_ERRORS = "exactsweep.errors"
_NONE = Fraction(0)


def to_point(pair: Iterable[str]) -> Point:
    return Point(*map(to_fraction, pair))


def _make_reading(
    tolerance: object,
    join: object,
    nested: bool | None,
    layers: tuple[str, ...],
    ignored_layers: tuple[str, ...],
    unit: str,
    hidden: bool,
    y_down: bool,
    clean: object,
) -> ReadingOptions:
    reading = {"tolerance": tolerance, "join": join, "unit": unit, "hidden": hidden, "clean": clean}
    layered = {"layers": layers, "ignored_layers": ignored_layers}
    return reading | layered | {"nested": nested, "y_down": y_down}


takes_reading = gather(
    "reading",
    _make_reading,
    click.option(
        "--flatten",
        "tolerance",
        callback=checked(lambda text: how.Reading(text).tolerance),
        metavar="TOLERANCE",
        help="Flatten curves of SVG and DXF within this distance; default: about a thousandth of "
        "the size of each outline. All results state the error.",
        cls=ReadingOption,
    ),
    click.option(
        "--join",
        callback=checked(lambda text: how.Reading(join=text).join),
        metavar="DISTANCE",
        help="Join line ends of SVG and DXF within this distance. Default: only equal ends.",
        cls=ReadingOption,
    ),
    click.option(
        "--nested/--flat",
        default=None,
        help="Nested: outlines inside others are holes, outlines in a hole are polygons, and so "
        "on. Flat: each outline is a polygon. Default: flat, except in 'exactsweep layout'.",
        cls=ReadingOption,
    ),
    click.option(
        "--layer",
        "layers",
        multiple=True,
        metavar="NAME",
        help="Read only this layer of SVG and DXF; repeatable.",
        cls=ReadingOption,
    ),
    click.option(
        "--ignore-layer",
        "ignored_layers",
        multiple=True,
        metavar="NAME",
        help="Skip a layer of SVG and DXF, such as engraving; repeatable.",
        cls=ReadingOption,
    ),
    click.option(
        "--clean",
        callback=checked(lambda text: how.Reading(clean=text).clean),
        metavar="AREA",
        help="Skip and report polygons with a smaller area.",
        cls=ReadingOption,
    ),
    click.option(
        "--hidden",
        is_flag=True,
        help="Also read hidden geometry of SVG and DXF.",
        cls=ReadingOption,
    ),
    click.option(
        "--y-down/--y-up",
        default=None,
        help="Direction of Y in the files; default: down in SVG, up in other formats.",
        cls=ReadingOption,
    ),
    click.option(
        "--unit",
        type=click.Choice(list(how.UNITS)),
        help="Convert SVG and DXF files with a unit to this unit. Default: keep the numbers.",
        cls=ReadingOption,
    ),
)


def _make_reference(help: str) -> Decorator:
    return click.option(
        "--reference",
        nargs=2,
        default=("0", "0"),
        callback=checked(to_point),
        metavar="X Y",
        help=f"{help}; default: 0 0.",
    )


_ASKED: dict[str, Callable[..., NoFitPolygon | InnerFit]] = {
    "nfp": no_fit_polygon,
    "ifp": inner_fit_polygon,
}


def _answer(
    generatrix: str | None,
    directrix: str | None,
    direction: Vector | None,
    reference: Point,
    reading: ReadingOptions,
    asked: str = "sweep",
) -> Sweep | NoFitPolygon | InnerFit:
    answer = _ASKED.get(asked)
    if generatrix is not None and directrix is not None:
        g, d = read_two(generatrix, directrix, reading)
    elif generatrix is None:
        g, d = map(Region, (DIRECTRIX, GENERATRIX) if answer else (GENERATRIX, DIRECTRIX))
    else:
        raise click.UsageError("One file is missing: give both files, or none for the example.")
    if answer:
        if direction is not None:
            raise click.UsageError("--direction is for sweeps.")
        return answer(g, d, reference=reference)
    try:
        return sweep(g, d, direction=direction, reference=reference)
    except DirectionError as error:
        if files := name_files_of_pair():
            raise DirectionError(f"{', '.join(map(show_path, files))}: {error}") from None
        raise


takes_pair = gather(
    "result",
    _answer,
    click.argument("generatrix", required=False, type=PATH),
    click.argument("directrix", required=False, type=PATH),
    click.option(
        "--direction",
        nargs=2,
        callback=checked(read_direction),
        metavar="P Q",
        help="Shared direction of monotonicity; default: chosen automatically.",
    ),
    _make_reference("Point of the generatrix whose path is the trajectory"),
    takes_reading,
)


takes_question = click.option(
    "--of",
    "asked",
    type=click.Choice(["sweep", *_ASKED]),
    default="sweep",
    help="Show a sweep; the no-fit polygon of STATIONARY and ORBITING; or the inner fit of "
    "CONTAINER and PART, in this order.",
)


def takes_shapes(
    first: str, second: str, read: Callable[..., object], *options: Decorator
) -> Decorator:
    """Add a stationary and a moving polygon, which `read` converts to the argument `shapes`."""
    return gather(
        "shapes",
        read,
        *options,
        click.argument("stays", metavar=first, type=PATH),
        click.argument("moves", metavar=second, type=PATH),
        _make_reference(f"Point of {second} whose positions are computed"),
        takes_reading,
    )


def name_files_of_pair() -> tuple[str, str] | None:
    """Return the files of G and D, or None for the built-in example."""
    named = click.get_current_context().params
    generatrix, directrix = named.get("generatrix"), named.get("directrix")
    return None if generatrix is None or directrix is None else (generatrix, directrix)


def name_files() -> dict[str, str]:
    """Return the files of the current command by role, if any."""
    ctx = click.get_current_context()
    named = {one.name: one.human_readable_name.lower() for one in ctx.command.params}
    roles = {"generatrix": "moves", "directrix": "stays", "stays": "stays", "moves": "moves"}
    return {
        role: f"{show_path(path)} ({named[name]})"
        for name, role in roles.items()
        if (path := ctx.params.get(name)) is not None
    }


def coordinates_of_files() -> Coordinates:
    ctx = click.get_current_context()
    coordinates: Coordinates = ctx.meta.get(
        _COORDINATES, Coordinates(bool(ctx.params.get("y_down")))
    )
    return coordinates


def keep_coordinates(coordinates: Coordinates, notes: Iterable[str] = ()) -> None:
    """Store the direction of Y and the unit for the output; print notes."""
    click.get_current_context().meta[_COORDINATES] = coordinates
    print_notes(notes)


def keep_errors(stays: Fraction, moves: Fraction = _NONE) -> None:
    """Store the errors of curves for the output."""
    known = errors_of_files()
    errors = max(stays, known[0]), max(moves, known[1])
    click.get_current_context().meta[_ERRORS] = errors


def errors_of_files() -> tuple[Fraction, Fraction]:
    meta = click.get_current_context().meta
    found: tuple[Fraction, Fraction] = meta.get(_ERRORS, (_NONE, _NONE))
    return found


def _require_one_input(first: str, second: str) -> None:
    if first == second == "-":
        raise click.UsageError("Only one file can be standard input (-).")


def read_each(
    stays: str, moves: str, reading: ReadingOptions, *, whole: bool = False
) -> tuple[PartList[NamedRegion], PartList[NamedRegion]]:
    _require_one_input(stays, moves)
    found = [(show_path(path), read_named([path], reading, whole=whole)) for path in (stays, moves)]
    keep_coordinates(*unify_coordinates(found))
    return found[0][1], found[1][1]


def read_placed(
    stays: str, moves: str, placed: Sequence[str], reading: ReadingOptions
) -> tuple[Region, list[Region], list[Region]]:
    """Read a container, a part and placed shapes; touching holes become placed shapes."""
    ((one, *_), file), (others_of, its_file) = _choose_two(stays, moves, reading, groups=True)
    with working("reading"), prefix_path(file):
        first, regions = separate_holes(one)
    with working("reading"), prefix_path(its_file):
        second = [read_single(one, Candidate.region) for one in others_of]
    if not placed:
        return first, second, regions
    layouts = {path: found for path in placed if (found := _read_layout(path, reading))}
    regions += [region for found in layouts.values() for region in found]
    files = [path for path in placed if path not in layouts]
    if not files:
        return first, second, regions
    listing = find_parts(files, reading)
    remarks = Remarks([], [])
    others: list[Region] = []
    errors = [Fraction(0)]
    for part in listing.parts:
        # Skipping placed shapes that are not simple would permit overlaps.
        with prefix_errors(part.file):
            shapes = part.candidate.named_regions(remarks)
        others += [one.region for one in shapes]
        errors += [one.error for one in shapes]
    report_skipped(remarks.left_out)
    print_notes(remarks.notes)
    keep_errors(max(errors))
    if listing.coordinates.y_down != coordinates_of_files().y_down:
        print_notes(
            [f"{', '.join(map(show_path, files))}: Y axis flipped to match the other files"]
        )
        others = [region.scaled((1, -1)) for region in others]
    # The drawing of a nest may include its sheet.
    kept = [one for one in others if one.holes or one.exterior != first.exterior]
    if len(kept) < len(others):
        print_notes([f"{', '.join(map(show_path, files))}: skipped the outline of the container"])
    return first, second, regions + kept


def _read_layout(path: str, reading: ReadingOptions) -> list[Region]:
    """Read the placed parts and the defects of a JSON layout; return [] for other files."""
    file = split_choice(path)[0]
    if not file.lower().endswith(".json"):
        return []
    from exactsweep.formats.exact_json import parse_json
    from exactsweep.formats.files import read_text
    from exactsweep.formats.layouts import read_layouts
    from exactsweep.layout import Layout
    from exactsweep.layout.board import Board
    from exactsweep.layout.rounded import to_region

    with prefix_path(file):
        data = parse_json(read_text(file))
    if not isinstance(data, dict) or data.keys().isdisjoint(("placements", "solution", "bins")):
        return []
    found: list[Region] = []
    for one in read_layouts(path, **reading):
        with prefix_errors(show_path(path)):
            layout = Layout.from_json(one.data)
        board = Board(layout)
        found += [board.turned(k).translated(layout.placements[k].move) for k in board.placed]
        found += [to_region(defect.shape) for defect in layout.defects]
        if any(part.pieces for part in layout.parts):
            print_notes([f"{show_path(path)}: rounded parts are replaced by enclosing polygons"])
        print_notes([f"{show_path(path)}: {count(len(board.placed), 'placed part')}"])
    return found


def read_two(stays: str, moves: str, reading: ReadingOptions) -> tuple[Region, Region]:
    regions = []
    for (candidate, *_), file in _choose_two(stays, moves, reading):
        with working("reading"), prefix_path(file):
            regions.append(read_single(candidate, Candidate.region))
    return regions[0], regions[1]


def _choose_two(
    stays: str, moves: str, reading: ReadingOptions, *, groups: bool = False
) -> list[tuple[PartList[Candidate], str]]:
    _require_one_input(stays, moves)
    with working("reading"):
        first = stays, read_choice(stays, **reading)
        files = [first, (moves, read_choice(moves, groups=groups, **reading))]
    keep_coordinates(*unify_coordinates([(show_path(path), found) for path, found in files]))
    chosen = []
    for path, found in files:
        name = split_choice(path)[0]
        report_skipped([f"{show_path(name)}: {reason}" for reason in found.left_out])
        print_notes(f"{show_path(name)}: {note}" for note in found.notes)
        chosen.append((found, name))
    errors = [max(one.error for one in found) for found, _ in chosen]
    keep_errors(*errors)
    report_error(max(errors), reading)
    return chosen
