from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import click

from exactsweep.cli import judging
from exactsweep.cli.options import PATH, checked, gather, takes_file, takes_output, takes_workers
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import ReadingOptions, takes_reading
from exactsweep.cli.reports import require_own_files, to_gap
from exactsweep.cli.working import show_bar, working
from exactsweep.formats import show_path
from exactsweep.formats.folder import find_files
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.limits import get_limits, set_limits
from exactsweep.words import count

if TYPE_CHECKING:
    from exactsweep.formats.layouts import FoundLayout
    from exactsweep.layout import Judgement
    from exactsweep.layout.report import ReportContext


_UNCHECKED = 3
"""The exit code of --strict if all layouts are valid, but not all rules were judged."""


def _choose_container(container: str | None, no_container: bool) -> str | Literal[False] | None:
    if container is not None and no_container:
        raise click.UsageError("Give either --container or --no-container.")
    return False if no_container else container


def _make_gaps(spacing: Fraction | None, margin: Fraction | None) -> dict[str, str]:
    given = {"spacing": spacing, "margin": margin}
    return {name: format_fraction(gap) for name, gap in given.items() if gap is not None}


class _Rules(NamedTuple):
    accept: Fraction | None
    strict: bool


class _TableOptions(NamedTuple):
    part: str | None
    turns_in: str


class _Outputs(NamedTuple):
    as_json: bool
    everything: bool
    certificate: str | None
    html: str | None
    svg: str | None
    repair: str | None
    shrink: str | None
    output: str

    def list_files(self) -> list[str | None]:
        return [self.certificate, self.html, self.svg, self.repair, self.shrink]


@click.command("layout")
@click.argument("files", nargs=-1, required=True, type=PATH)
@takes_file(
    "--instance",
    "The instance of a solution, with its parts, their quantities and allowed rotations; or a "
    "drawing, a file or a folder of parts to be placed once each.",
)
@gather(
    "table",
    _TableOptions,
    takes_file(
        "--part",
        "The parts of a table of placements: any file with polygons, Layout JSON, or FILE#GROUP "
        "for the outlines of an SVG group as one part.",
    ),
    click.option(
        "--turns-in",
        type=click.Choice(["degrees", "radians"]),
        default="degrees",
        help="The unit of angles in tables and Layout JSON.",
    ),
)
@gather(
    "container",
    _choose_container,
    click.option(
        "--container",
        metavar="ID",
        help="Name, index, layer or group of the container in a drawing; default: sheet, bin, "
        "board, container or stock, or else the outline around all others.",
    ),
    click.option("--no-container", is_flag=True, help="Judge the parts only against each other."),
)
@gather(
    "gaps",
    _make_gaps,
    click.option(
        "--spacing",
        callback=checked(to_gap),
        metavar="DISTANCE",
        help="Minimum distance between parts; default: as in the file, or 0.",
    ),
    click.option(
        "--margin",
        callback=checked(to_gap),
        metavar="DISTANCE",
        help="Minimum distance from parts to the boundary of the container and to its defects.",
    ),
)
@gather(
    "rules",
    _Rules,
    click.option(
        "--accept",
        callback=checked(to_gap),
        metavar="DEPTH",
        help="Accept overlaps up to this depth, and distances short by at most this amount.",
    ),
    click.option("--strict", is_flag=True, help="Exit with 3 if a rule of the file is not judged."),
)
@takes_reading
@gather(
    "outputs",
    _Outputs,
    click.option("--json", "as_json", is_flag=True, help="Write the exact judgement as JSON."),
    click.option("--all", "everything", is_flag=True, help="List all faults."),
    takes_file(
        "--certificate",
        "Write a certificate, for 'exactsweep verify'.",
    ),
    takes_file("--html", "Write a page with pictures of faults."),
    takes_file("--svg", "Write a picture with enlarged faults below."),
    takes_file("--repair", "Write a layout repaired by small moves, as Layout JSON."),
    takes_file(
        "--shrink",
        "Write a valid layout with the smallest container that is proved to suffice: a convex one "
        "is shrunk about a corner, a disc about its center.",
    ),
    takes_workers("Number of processes for several files; default: one per CPU."),
    takes_output,
)
def layout_command(
    files: tuple[str, ...],
    instance: str | None,
    table: _TableOptions,
    container: str | Literal[False] | None,
    gaps: dict[str, str],
    rules: _Rules,
    reading: ReadingOptions,
    outputs: _Outputs,
    workers: int | None,
) -> None:
    """Judge the output of a nesting program.

    FILES may be files, folders, patterns such as 'nests/*.json', or - for standard input: Layout
    JSON; JSON solutions of sparrow, jagua-rs, spyrrow, packingsolver or CG:SHOP 2024; SVG of
    sparrow, jagua-rs, SVGnest or Deepnest; any drawing, such as SVG or DXF, with the outlines in
    place; a table of placements, as CSV or JSON with columns part, x, y and angle, together with
    --part OUTLINE; or a table of discs with columns x, y and radius. --instance adds rules that a
    file lacks. Each sheet of a file is a separate layout; FILE#0 is the first.

    A layout is valid if all parts are inside the container and clear of its defects, no two parts
    overlap, all minimum distances are kept, and the number, the rotations and the mirroring of the
    parts obey the rules. The report lists the faults, worst first, each with a proof, a measure and
    the shortest move that repairs it. If most of a layout is wrong, the command tries other
    conventions: radians, another center, another sign, Y downward, another scale.

    In drawings, outlines inside others are holes, outlines in a hole are parts, and so on; with
    --flat, each outline is a part. --layer and --ignore-layer select layers. The report lists all
    rules and shapes that were not judged.

    The exit code is 0 only if all layouts are valid, or all faults are within --accept.

    Example:
      exactsweep layout nest.svg --html nest.html
      exactsweep layout nest.dxf --ignore-layer engrave --accept 1e-6
      exactsweep layout final.json --spacing 0.5 --certificate proof.json
      exactsweep layout solution.json --instance instance.json
      exactsweep layout trees.csv --part tree.json
      exactsweep layout nests 'more/*.svg' --workers 4
    """
    from exactsweep.formats.layouts import read_layouts

    require_own_files([*outputs.list_files(), outputs.output])
    found = [path for given in files for path in find_files(given)]
    if "-" in found and len(found) > 1:
        raise click.UsageError("Standard input (-) cannot be combined with other files.")
    options = {"instance": instance, "container": container, **reading}
    options |= {"part": table.part, "radians": table.turns_in == "radians"}
    layouts: list[FoundLayout] = []
    if len(found) == 1:
        layouts = read_layouts(found[0], **options)
        if len(layouts) == 1:
            y_down = reading["y_down"]
            if y_down is None:
                y_down = found[0].split("#")[0].lower().endswith(".svg")
            code = _judge_one(layouts[0], gaps, rules, show_path(found[0]), outputs, y_down=y_down)
            sys.exit(code)
    if any(outputs.list_files()):
        raise click.UsageError(
            "--certificate, --html, --svg, --repair and --shrink are for a single layout."
        )
    if layouts:
        rows = judging.judge_file(found[0], lambda: layouts, gaps, rules.accept)
    else:
        rows = [*_judge_all(found, options, gaps, rules.accept, workers)]
    if outputs.as_json:
        text = json.dumps([row._asdict() for row in rows], indent=1) + "\n"
    else:
        text = judging.write_rows(rows, measure_columns(outputs.output))
    write(text, outputs.output)
    passed = all(row.valid or row.accepted for row in rows)
    unchecked = any(row.unchecked for row in rows)
    sys.exit(_find_exit_code(rules, passed=passed, unchecked=unchecked))


def _find_exit_code(rules: _Rules, *, passed: bool, unchecked: bool) -> int:
    return 1 if not passed else _UNCHECKED if rules.strict and unchecked else 0


def _judge_one(
    found: FoundLayout,
    gaps: Mapping[str, str],
    rules: _Rules,
    title: str,
    outputs: _Outputs,
    *,
    y_down: bool,
) -> int:
    from exactsweep.layout import LayoutError, report

    placed = len(found.data["placements"])
    with working(f"judging {placed} placements") as update:
        coarse = judging.judge_found(found, gaps, title)
        # Other conventions explain only deep faults, and those need no finer curves.
        notes = judging.list_notes(found, coarse)
        judgement = judging.refine_curves(found, coarse, gaps, title)
        context = report.ReportContext(found.unchecked, found.places, found.unit, rules.accept)
        ranked = report.rank_faults(
            judgement, lambda k, n: update(f"measuring fault {k + 1} of {n}"), rules.accept
        )
        update("writing")
        shown: dict[str, Any] = {"y_down": y_down, "context": context}
        if outputs.html:
            page = report.write_layout_page(judgement, ranked, title, notes, **shown)
            write(page, outputs.html)
        if outputs.svg:
            write(report.draw_layout(judgement, ranked, title, **shown), outputs.svg)
        if outputs.certificate:
            try:
                write_readable(json.dumps(judgement.certificate()) + "\n", outputs.certificate)
            except LayoutError as error:
                click.echo(f"{title}: {error}", err=True)
        if outputs.repair:
            update("repairing")
            notes.append(_repair(judgement, outputs.repair, context))
        if outputs.shrink:
            notes.append(_shrink(judgement, outputs.shrink, context))
        if outputs.as_json:
            text = report.write_layout_json(judgement, notes, ranked, context)
        else:
            columns, everything = measure_columns(outputs.output), outputs.everything
            text = report.report_layout(
                judgement, ranked, columns, notes=notes, everything=everything, context=context
            )
    write(text, outputs.output)
    passed = all(one.accepted for one in ranked)
    return _find_exit_code(rules, passed=passed, unchecked=bool(found.unchecked))


def _repair(judgement: Judgement, path: str, context: ReportContext) -> str:
    from exactsweep.layout.repaired import repair_layout
    from exactsweep.text.report import approximate, take_root

    repaired = repair_layout(judgement)
    if repaired is None:
        return f"no repair by small moves found; {show_path(path)} was not written"
    write_readable(json.dumps(repaired.layout.to_json()) + "\n", path)
    if not repaired.moves:
        return f"the layout is valid; {show_path(path)} has it unchanged"
    longest = approximate(take_root(repaired.longest_squared), up=True)
    moved = f"{count(len(repaired.moves), 'placement')} moved by at most"
    return f"repaired in {show_path(path)}: {moved} {context.add_unit(longest)}; judged valid"


def _shrink(judgement: Judgement, path: str, context: ReportContext) -> str:
    from exactsweep.layout.slack import find_slack
    from exactsweep.text.report import approximate

    found = find_slack(judgement)
    if found is None:
        return (
            "no slack proved: the layout is invalid, or its container is not convex or has defects"
        )
    write_readable(json.dumps(found.layout.to_json()) + "\n", path)
    less = approximate(1 - found.scale)
    growth = context.add_unit(approximate(found.growth))
    return (
        f"proved slack: the container can shrink by {less} of its size (see {show_path(path)}), "
        f"or the parts can grow by {growth}"
    )


def _judge_all(
    paths: Sequence[str],
    options: Mapping[str, Any],
    gaps: Mapping[str, str],
    accept: Fraction | None,
    workers: int | None,
) -> Iterator[judging.LayoutRow]:
    """Judge the layouts of several files in parallel; yield the rows in order."""
    from exactsweep.formats.layouts import read_layouts
    from exactsweep.processes import Pool, count_cores

    pool = Pool(min(workers or count_cores(), len(paths)), set_limits, get_limits())
    try:
        jobs = [
            pool.submit(
                judging.judge_file, path, partial(read_layouts, path, **options), gaps, accept
            )
            for path in paths
        ]
        with show_bar(len(jobs)) as show:
            for k, job in enumerate(jobs):
                yield from job.result()
                show(k + 1, "")
    finally:
        pool.close()
