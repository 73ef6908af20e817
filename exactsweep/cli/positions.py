import json
from collections.abc import Iterator
from fractions import Fraction
from itertools import product
from typing import NamedTuple

import click

from exactsweep import InnerFit, NoFitPolygon, Point, Region, no_fit_union
from exactsweep.cli import pair
from exactsweep.cli.options import PATH, Decorator, checked, gather
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.parts import print_notes
from exactsweep.cli.result import Form, describe_error, export, takes_form, write_result
from exactsweep.cli.working import working
from exactsweep.formats import NamedRegion, show_path
from exactsweep.geometry.point_set import AffineMap
from exactsweep.geometry.turn import TURN_BITS, Turn, read_turn
from exactsweep.numbers.digits import abridge, format_fraction
from exactsweep.numbers.number import to_fraction
from exactsweep.sweep import free_positions, no_fit_polygon
from exactsweep.text.report import approximate, lay_out, make_table
from exactsweep.text.results import no_fit_to_regions, regions_to_json


class Pose(NamedTuple):
    """A rotation of a part, preceded by mirroring (x to -x) if `mirrored`."""

    turn: Turn
    mirrored: bool = False

    @property
    def name(self) -> str:
        degrees = abridge(self.turn.degrees or Fraction(0))
        return f"{degrees}, mirrored" if self.mirrored else degrees

    @property
    def _map(self) -> AffineMap:
        cosine, sine, _ = self.turn.near(TURN_BITS)
        across = -1 if self.mirrored else 1
        return AffineMap(across * cosine, -sine, across * sine, cosine)

    def place(self, part: Region) -> Region:
        return part._image(self._map)

    def place_point(self, point: Point) -> Point:
        a, b, c, d = self._map[:4]
        return Point(a * point.x + b * point.y, c * point.x + d * point.y)


def _read_turns(text: str) -> list[Turn]:
    return [read_turn(to_fraction(word.strip())) for word in text.split(",")]


def _make_poses(turns: list[Turn] | None, mirrored: bool) -> list[Pose] | None:
    if turns is None and not mirrored:
        return None
    return list(_list_poses(turns or [read_turn(0)], mirrored=mirrored))


def _list_poses(turns: list[Turn], *, mirrored: bool) -> Iterator[Pose]:
    for turn in turns:
        if turn.exact is None:
            degrees = abridge(turn.degrees or Fraction(0))
            print_notes([f"{degrees} degrees: rotated by a rational angle within 2^-{TURN_BITS}"])
        yield Pose(turn)
    if mirrored:
        yield from (Pose(turn, mirrored=True) for turn in turns)


def takes_turns(part: str) -> Decorator:
    return gather(
        "poses",
        _make_poses,
        click.option(
            "--turns",
            "--rotations",
            "turns",
            callback=checked(_read_turns),
            metavar="DEGREES,...",
            help=f"Rotate {part} counter-clockwise about its origin by each of these angles.",
        ),
        click.option(
            "--mirrored", is_flag=True, help=f"Also mirror {part} (x to -x) before rotating it."
        ),
    )


_AS_READ = Pose(read_turn(0))

_takes_together = click.option(
    "--together",
    is_flag=True,
    help="Treat all polygons of STATIONARY as one rigid shape, and all of ORBITING as another.",
)

_Rigid = tuple[NamedRegion, ...]
"""Polygons that form one rigid shape."""


def _read_shapes(
    stays: str, moves: str, together: bool, reading: pair.ReadingOptions
) -> list[list[_Rigid]]:
    shapes: list[list[_Rigid]] = []
    sides = pair.read_each(stays, moves, reading, whole=together)
    for path, side in zip((stays, moves), sides, strict=True):
        shapes.append([tuple(side)] if together or side.is_group else [(one,) for one in side])
        if len(shapes[-1]) > 1:
            number = f"{show_path(path)}: {len(side)} polygons"
            print_notes([f"{number}, handled one by one; --together treats them as one shape"])
    return shapes


@click.command("nfp")
@pair.takes_shapes("STATIONARY", "ORBITING", _read_shapes, _takes_together)
@takes_turns("ORBITING")
@takes_form("the no-fit polygon and the exact fits")
def nfp_command(
    shapes: list[list[_Rigid]], reference: Point, poses: list[Pose] | None, form: Form
) -> None:
    """Compute the no-fit polygon of a pair, or of several pairs.

    The no-fit polygon is the set of positions at which ORBITING overlaps STATIONARY. It has an
    exterior, which is the trajectory of a sweep; holes, at which ORBITING fits into a cavity or a
    hole; and exact fits: single positions, or segments of positions, with overlap all around.

        exactsweep nfp   STATIONARY ORBITING     first stays, second moves
        exactsweep sweep GENERATRIX DIRECTRIX    first moves, second stays

    With --together, all polygons of STATIONARY form one rigid shape, and so do those of ORBITING.
    FILE#group of an SVG file is always a rigid shape. The no-fit polygon may then consist of
    several regions.

    Files are read as in 'exactsweep sweep'. Each argument may also be a folder or a pattern; with
    --turns or --mirrored, each pose of ORBITING forms a pair. For several pairs, the report and
    --json have one line per pair, and --to writes all polygons.

    --wkt writes a POLYGON with its holes, and a LINESTRING or a POINT for each exact fit, if all
    coordinates are finite decimals.

    Example:
      exactsweep nfp plate.json fork.wkt
      exactsweep nfp sheet.dxf#0 parts.svg#bracket --reference 1/2 0 --json -o result.json
      exactsweep nfp plate.json fork.wkt --turns 0,90,180,270 --mirrored
      exactsweep nfp sheet.dxf#0 part.svg --to dxf --round 3 --round-outward -o nfp.dxf
    """
    pair.keep_errors(*(max(one.error for group in side for one in group) for side in shapes))
    posed = [(g, pose) for g in shapes[1] for pose in poses or (_AS_READ,)]
    if any(len(group) > 1 for side in shapes for group in side):
        if len(shapes[0]) * len(posed) > 1:
            raise click.UsageError("Groups need a single pair and pose: use # or --together.")
        ((stationary,), ((orbiting, pose),)) = shapes[0], posed
        at, moved = pose.place_point(reference), [pose.place(one.region) for one in orbiting]
        write_result(no_fit_union([one.region for one in stationary], moved, reference=at), form)
        return
    placed = [
        (pose.place_point(reference), g if poses is None else _place(g, pose))
        for (g,), pose in posed
    ]
    pairs = [(d, g) for (d,) in shapes[0] for _, g in placed]
    found = []
    with working("no-fit polygons") as update:
        for k, ((d,), (at, g)) in enumerate(product(shapes[0], placed), 1):
            update(f"no-fit polygon {k} of {len(pairs)}")
            found.append(no_fit_polygon(d.region, g.region, reference=at))
            # Results are computed on first access; do this here to show progress.
            _ = found[-1].holes
    if len(pairs) == 1:
        write_result(found[0], form)
        return
    names = [(str(d.name), str(g.name)) for d, g in pairs]
    errors = [(d.error, g.error) for d, g in pairs]
    if form.kind == "to":
        regions = [
            one._replace(name=f"{g} around {d}")
            for (d, g), result, error in zip(names, found, errors, strict=True)
            for one in no_fit_to_regions(result, *error)
        ]
        fits = [fit for result in found for fit in result.exact_fits]
        export(regions, fits, form.target, form.rounding, form.output, lambda region: "outward")
    elif form.kind == "json":
        from exactsweep.batch.record import write_result_line

        bound = Fraction(sum(pair.errors_of_files()))
        known = {"curve_error": format_fraction(bound)} if bound else {}
        lines = (
            write_result_line(k, {"generatrix": g, "directrix": d} | known, result, "nfp")
            for k, ((d, g), result) in enumerate(zip(names, found, strict=True))
        )
        write_readable(b"".join(lines).decode(), form.output)
    elif form.kind == "report":
        error = sum(pair.errors_of_files())
        write(
            _tabulate_pairs(names, found, form.output) + describe_error(Fraction(error)),
            form.output,
        )
    else:
        raise click.UsageError(f"--{form.kind} is for a single pair, not for {len(pairs)}.")


def _place(part: NamedRegion, pose: Pose) -> NamedRegion:
    name = f"{part.name} rotated by {pose.name}"
    return part._replace(name=name, region=pose.place(part.region))


def _tabulate_pairs(names: list[tuple[str, str]], found: list[NoFitPolygon], output: str) -> str:
    numbers = ("vertices", "holes", "exact fits", "approx. area")
    table = make_table(("stationary", "orbiting", "class", *numbers), numbers)
    for (d, g), n in zip(names, found, strict=True):
        sizes = (len(n.exterior), len(n.holes), len(n.exact_fits))
        table.add_row(d, g, n.kind, *map(str, sizes), approximate(n.area))
    return lay_out([table], measure_columns(output))


_takes_placed = click.option(
    "--placed",
    multiple=True,
    type=PATH,
    metavar="FILE",
    help="Polygons, or a layout, that PART must not overlap; repeatable.",
)


@click.command("ifp")
@pair.takes_shapes("CONTAINER", "PART", pair.read_placed, _takes_placed)
@takes_turns("PART")
@takes_form("the positions")
def ifp_command(
    shapes: tuple[Region, list[Region], list[Region]],
    reference: Point,
    poses: list[Pose] | None,
    form: Form,
) -> None:
    """Find all positions of a part inside a container.

        exactsweep ifp CONTAINER PART            first stays, second moves

    With --placed, PART also avoids the polygons of other files, or all placed parts of a layout.
    With --turns or --mirrored, the report and --json have one line per pose.

    PART may be a group of an SVG file, as FILE#group, whose outlines move together. Holes of
    CONTAINER are defects, which PART avoids. The answer consists of regions of positions, possibly
    with holes, and of exact fits, at which CONTAINER leaves PART no play. It is empty if PART does
    not fit.

    Files are read as in 'exactsweep sweep'. --wkt writes a POLYGON for each region and a LINESTRING
    or POINT for each exact fit, or POLYGON EMPTY if there are none. It requires coordinates that
    are finite decimals.

    Example:
      exactsweep ifp sheet.json part.wkt
      exactsweep ifp sheet.json part.wkt --placed first.wkt --placed others.dxf --json
      exactsweep ifp sheet.json part.wkt --turns 0,90,180,270 --mirrored --placed nest.json
      exactsweep ifp sheet.json part.wkt --certificate -o proof.json
    """
    container, (part, *attached), placed = shapes
    if poses is None:
        answer = free_positions(container, placed, part, reference=reference, attached=attached)
        write_result(answer, form)
        return
    if form.kind not in ("report", "json"):
        raise click.UsageError(f"--{form.kind} is for a single pose.")
    found = []
    with working("positions") as update:
        for k, pose in enumerate(poses, 1):
            update(f"pose {k} of {len(poses)}")
            at = pose.place_point(reference)
            first, *others = map(pose.place, (part, *attached))
            found.append(free_positions(container, placed, first, reference=at, attached=others))
            # Results are computed on first access; do this here to show progress.
            _ = found[-1].regions
    if form.kind == "json":
        lines = (
            {"turn": pose.turn.to_json(), "mirrored": pose.mirrored, "fits": bool(fit)}
            | json.loads(regions_to_json(fit))
            for pose, fit in zip(poses, found, strict=True)
        )
        write_readable("".join(json.dumps(line) + "\n" for line in lines), form.output)
    else:
        write(_tabulate_poses(poses, found, form.output), form.output)


def _tabulate_poses(poses: list[Pose], found: list[InnerFit], output: str) -> str:
    numbers = ("regions", "exact fits", "approx. area")
    table = make_table(("turn", "fits", *numbers, "leftmost position"), numbers)
    for pose, fit in zip(poses, found, strict=True):
        points = [p for region in fit.regions for p in region.exterior.vertices]
        points += [p for ends in fit.exact_fits for p in ends]
        first = f"({', '.join(map(approximate, min(points)))})" if points else ""
        sizes = (len(fit.regions), len(fit.exact_fits))
        fits = "yes" if fit else "no"
        table.add_row(pose.name, fits, *map(str, sizes), approximate(fit.area), first)
    return lay_out([table], measure_columns(output))
