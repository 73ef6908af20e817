from __future__ import annotations

import os
from typing import TYPE_CHECKING

import click

from exactsweep.cli.options import PATH, checked, requires_output, takes_file, takes_workers
from exactsweep.cli.output import report_limit, write
from exactsweep.cli.pair import ReadingOptions, takes_reading
from exactsweep.cli.parts import find_parts
from exactsweep.cli.result import takes_rounding
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
                f"{word} degrees: rotated with the rational cosine {cosine} and sine {sine}, each "
                f"within 2^-{TURN_BITS} of the true value",
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
    help="Sweep all pairs of polygons from two files, folders or patterns such as 'parts/*.dxf'.",
)
@takes_file("--parts", "File with the polygons that PAIRS refers to by name.")
@click.option(
    "--compute",
    "what",
    type=click.Choice(["trajectory", "loops", "areas", "nfp"]),
    default="loops",
    help="Compute the trajectory, all loops (default), only areas, or no-fit polygons.",
)
@takes_workers("Number of processes; default: one per CPU.")
@click.option(
    "--scheduler",
    metavar="ADDRESS",
    help="Use the workers of a Dask scheduler; 'local' starts a cluster on this machine.",
)
@click.option(
    "--rotations",
    callback=checked(_to_degrees),
    metavar="DEGREES",
    help="With --all: rotate each generatrix by these angles, such as 0,90,180,270. If the cosine "
    "of an angle is irrational, standard error states the rational approximation.",
)
@click.option("--restart", is_flag=True, help="Discard the records of an interrupted batch.")
@takes_rounding
@takes_reading
@requires_output("Output file: JSON lines (.jsonl), or a table (.parquet or .csv).")
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
    """Sweep many pairs in parallel.

    PAIRS contains one JSON line per pair, {"generatrix": ..., "directrix": ...}, optionally with
    "id", "direction" and "reference". A polygon is any JSON that 'exactsweep sweep' reads, or the
    name of a polygon in --parts. With --all, each polygon of GENERATRICES is swept around each of
    DIRECTRICES. A folder selects all files in it. Polygons are named by file, layer and id.
    Standard error lists skipped elements.

    --round rounds all numbers to decimals; --round-outward rounds them so that no loop permits an
    overlap. --compute nfp writes the same records as 'exactsweep nfp --json', with the generatrix
    as the orbiting polygon.

    Records are in the order of the pairs; the record of a refused pair states the reason. After
    any interruption, the same command resumes the batch. Until the batch is complete, the records
    are in FILE.part. The exit code is 1 if all pairs are refused.

    Example:
      exactsweep batch --all parts.dxf sheets.json -o results.jsonl
      exactsweep batch pairs.jsonl --parts parts.svg --compute areas -o areas.parquet
      exactsweep batch --all drawings 'sheets/*.dxf' --flatten 0.01 --compute areas --round 3 -o areas.csv
      exactsweep batch --all parts.json parts.json --compute nfp --rotations 0,90,180,270 -o nfp.jsonl
    """  # noqa: E501
    if (pairs is None) == (lists is None):
        raise click.UsageError("Give either PAIRS or --all.")
    if pairs is None and parts is not None:
        raise click.UsageError("--parts needs PAIRS.")
    if lists is None and rotations is not None:
        raise click.UsageError("--rotations needs --all.")
    if "-" in (pairs, output):
        raise click.UsageError(
            "PAIRS and the output must be files, so that the batch can be resumed."
        )
    from exactsweep.batch import run, take_all_pairs, take_listed_pairs
    from exactsweep.batch.parts import rotate_parts

    if scheduler is not None:
        import logging

        # Dask logs every lost connection at length.
        logging.disable(logging.CRITICAL)
    _require_new(output, [path for path in (pairs, parts, *(lists or ())) if path is not None])
    if lists is None:
        assert pairs is not None
        listed = () if parts is None else _parts(parts, reading)
        job = take_listed_pairs(pairs, listed, what, rounding)
    else:
        first = _parts(lists[0], reading)
        second = first if lists[0] == lists[1] else _parts(lists[1], reading)
        rotated = first if rotations is None else rotate_parts(first, rotations)
        job = take_all_pairs(rotated, second, what, rounding)
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
            "run the same command to resume"
        ) from None
    text = f"{count(summary.pairs, 'pair')}, {summary.refused} refused"
    if summary.resumed:
        text += f"; {summary.resumed} records already existed"
    write(f"{text}\n", "-")
    if output.endswith(".jsonl"):
        report_limit(max(measure_file(output), FAULT * summary.refused), output)
    if summary.pairs and summary.refused == summary.pairs:
        raise click.ClickException(f"all pairs were refused; {show_path(output)} states why")


def _require_new(output: str, paths: Sequence[str]) -> None:
    files = (file for path in paths for file in find_files(split_choice(path)[0]))
    read = {os.path.realpath(file) for file in files if file != "-"}
    for name in (output, f"{output}.part", f"{output}.job"):
        if os.path.realpath(name) in read:
            raise FormatError(f"{show_path(name)}: is both input and output of this batch")


def _parts(path: str, reading: ReadingOptions) -> Sequence[Part]:
    from exactsweep.batch.parts import make_parts

    return make_parts(find_parts([path], reading))
