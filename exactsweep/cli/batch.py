"""`exactsweep batch`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

import click

from exactsweep.cli.export import takes_rounding
from exactsweep.cli.options import PATH, checked, requires_output, takes_file, takes_workers
from exactsweep.cli.output import say_limit, write
from exactsweep.cli.pair import ReadingOptions, takes_reading
from exactsweep.cli.parts import find_parts
from exactsweep.cli.working import show_bar
from exactsweep.formats import FormatError, show_path
from exactsweep.formats.exact_json import measure_file
from exactsweep.formats.folder import find_files
from exactsweep.formats.polygons import split_choice
from exactsweep.formats.size import FAULT
from exactsweep.numbers.digits import format_fraction
from exactsweep.words import count

if TYPE_CHECKING:
    from collections.abc import Sequence

    from exactsweep.batch import Part, Rounding


def _to_degrees(text: str) -> list[str]:
    from exactsweep.geometry.turn import TURN_BITS, read_turn

    found = text.split(",")
    for word in found:
        turn = read_turn(word)
        if turn.exact is None:
            cosine, sine = map(format_fraction, turn.near()[:2])
            click.echo(
                f"{word} degrees: turned by the cosine {cosine} and the sine {sine}, which are off "
                f"by at most 2^-{TURN_BITS}",
                err=True,
            )
    return found


@click.command("batch")
@click.argument("pairs", required=False, type=PATH)
@click.option(
    "--all",
    "lists",
    nargs=2,
    type=PATH,
    metavar="GENERATRICES DIRECTRICES",
    help="All pairs of the polygons of two files, folders, or patterns such as 'parts/*.dxf'.",
)
@takes_file("--parts", "Polygons that PAIRS names.")
@click.option(
    "--compute",
    "what",
    type=click.Choice(["trajectory", "loops", "areas", "nfp"]),
    default="loops",
    help="The trajectory alone, all loops (the default), just areas, or no-fit polygons.",
)
@takes_workers("The number of processes; by default one per processor.")
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Compute on the workers of a Dask scheduler; 'local' starts a cluster on this machine.",
)
@click.option(
    "--rotations",
    callback=checked(_to_degrees),
    metavar="DEGREES",
    help="With --all: turn each generatrix by these degrees, such as 0,90,180,270. For angles "
    "other than multiples of 90, standard error states the rational turn nearby.",
)
@click.option("--restart", is_flag=True, help="Discard the records of an interrupted batch.")
@takes_rounding
@takes_reading
@requires_output("The file of the records, one line of JSON each; with .parquet or .csv a table.")
def batch_command(
    pairs: str | None,
    lists: tuple[str, str] | None,
    parts: str | None,
    what: str,
    workers: int | None,
    scheduler: str | None,
    rotations: list[str] | None,
    restart: bool,
    rounding: Rounding | None,
    reading: ReadingOptions,
    output: str,
) -> None:
    """Sweep very many pairs.

    PAIRS has a line of JSON for each pair, {"generatrix": ..., "directrix": ...}, perhaps with
    "id", "direction" and "reference". A polygon is a list of pairs or another form of JSON that
    'exactsweep sweep' reads, or the name of a polygon in the file of --parts. Instead of PAIRS,
    --all sweeps each polygon of GENERATRICES around each of DIRECTRICES. A folder means all files
    in it; the names of polygons consist of file, layer and id. Standard error lists the elements
    that are left out because they are not polygons.

    --round rounds all numbers of the records to decimals, which other programs read as numbers.
    With --round-outward no loop moves to where it would permit an overlap.

    A record of --compute nfp has the exterior, the holes and the exact fits of the no-fit polygon,
    as 'exactsweep nfp --json' writes them; the generatrix is the orbiting polygon.

    The records have the order of the pairs. The record of a refused pair has the reason, and the
    batch continues. After an interruption of any kind, the same command continues the batch. Until
    the batch is complete, its records are in FILE.part. If all pairs were refused, the exit code
    is 1.

    Example:
      exactsweep batch --all parts.dxf sheets.json -o results.jsonl
      exactsweep batch pairs.jsonl --parts parts.svg --compute areas -o areas.parquet
      exactsweep batch --all drawings 'sheets/*.dxf' --flatten 0.01 --compute areas --round 3 -o areas.csv
      exactsweep batch --all parts.json parts.json --compute nfp --rotations 0,90,180,270 -o nfp.jsonl
    """  # noqa: E501
    if (pairs is None) == (lists is None):
        raise click.UsageError("Give either PAIRS or --all.")
    if pairs is None and parts is not None:
        raise click.UsageError("--parts goes with PAIRS.")
    if lists is None and rotations is not None:
        raise click.UsageError("--rotations goes with --all.")
    if "-" in (pairs, output):
        raise click.UsageError("PAIRS and the output are files: a batch may have to be resumed.")
    from exactsweep.batch import run, take_all_pairs, take_listed_pairs
    from exactsweep.batch.parts import rotate_parts

    if scheduler is not None:
        import logging

        # Dask tells a long story of each connection that it loses.
        logging.disable(logging.CRITICAL)
    _require_new(output, [path for path in (pairs, parts, *(lists or ())) if path is not None])
    if lists is None:
        assert pairs is not None
        listed = () if parts is None else _parts(parts, reading)
        job = take_listed_pairs(pairs, listed, what, rounding)
    else:
        first = _parts(lists[0], reading)
        second = first if lists[0] == lists[1] else _parts(lists[1], reading)
        turned = first if rotations is None else rotate_parts(first, rotations)
        job = take_all_pairs(turned, second, what, rounding)
    done = 0
    try:
        with show_bar(job.total) as show:

            def note(number: int) -> None:
                nonlocal done
                done = number
                show(number, "")

            summary = run(
                job,
                output,
                workers=workers,
                scheduler=scheduler,
                restart=restart,
                progress=note,
            )
    except KeyboardInterrupt:
        raise click.ClickException(
            f"interrupted after {done} of {count(job.total, 'pair')}; "
            "the same command goes on from there"
        ) from None
    text = f"{count(summary.pairs, 'pair')}, {summary.refused} refused"
    if summary.resumed:
        text += f"; {summary.resumed} of the records were there already"
    write(f"{text}\n", "-")
    if output.endswith(".jsonl"):
        say_limit(max(measure_file(output), FAULT * summary.refused), output)
    if summary.pairs and summary.refused == summary.pairs:
        raise click.ClickException(f"all pairs were refused; {show_path(output)} says why")


def _require_new(output: str, paths: Sequence[str]) -> None:
    """Refuse to write over what is read."""
    files = (file for path in paths for file in find_files(split_choice(path)[0]))
    read = {os.path.realpath(file) for file in files if file != "-"}
    for name in (output, f"{output}.part", f"{output}.job"):
        if os.path.realpath(name) in read:
            raise FormatError(f"{show_path(name)}: read and written by the same batch")


def _parts(path: str, reading: ReadingOptions) -> Sequence[Part]:
    """Read the parts of files, and say what is left out."""
    from exactsweep.batch.parts import make_parts

    return make_parts(find_parts([path], reading))
