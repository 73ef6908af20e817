"""`exactsweep layout`."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import click

from exactsweep.cli.options import PATH, checked, gather, takes_file, takes_output, takes_workers
from exactsweep.cli.output import measure_columns, write, write_readable
from exactsweep.cli.pair import ReadingOptions, takes_reading
from exactsweep.cli.reports import to_gap
from exactsweep.cli.working import show_bar, working
from exactsweep.formats import FormatError, show_path
from exactsweep.formats.folder import find_files
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import name_refusals
from exactsweep.numbers.limits import keep_limits, list_limits
from exactsweep.words import count, spell_out

if TYPE_CHECKING:
    from exactsweep.formats.layouts import FoundLayout
    from exactsweep.layout import Judgement
    from exactsweep.layout.report import ReportContext


# The factor of the tolerance each time that curves are flattened again, and the most times.
_FINER, _MOST_FINER = Fraction(1, 100), 2


_UNCHECKED = 3
"""The exit code of --strict if all is valid, but not everything was judged."""


class LayoutRow(NamedTuple):
    """A layout of several, as the table of all shows it.

    Attributes:
        name: the file, and which sheet of it.
        verdict: "valid", what is wrong, or why it could not be read.
        valid: None where it could not be read.
        placements: how many there are.
        worst: how bad the worst fault is; of a valid one the least distance.
        notes: what the reader passed over.
        accepted: whether all faults are at most as deep as is accepted.
        unchecked: rules and shapes that were not judged.
    """

    name: str
    verdict: str
    valid: bool | None
    placements: int = 0
    worst: str = ""
    notes: Sequence[str] = ()
    accepted: bool = False
    unchecked: Sequence[str] = ()


def _choose_container(container: str | None, no_container: bool) -> str | Literal[False] | None:
    if container is not None and no_container:
        raise click.UsageError("Give either --container or --no-container.")
    return False if no_container else container


def _make_gaps(spacing: Fraction | None, margin: Fraction | None) -> dict[str, str]:
    given = {"spacing": spacing, "margin": margin}
    return {name: format_fraction(gap) for name, gap in given.items() if gap is not None}


class _Rules(NamedTuple):
    """What decides the exit code: an accepted depth, and whether everything has to be judged."""

    accept: Fraction | None
    strict: bool


class _Wanted(NamedTuple):
    """The outputs that are asked for of a layout, and their files."""

    as_json: bool
    everything: bool
    certificate: str | None
    html: str | None
    svg: str | None
    repair: str | None
    output: str


@click.command("layout")
@click.argument("files", nargs=-1, required=True, type=PATH)
@takes_file(
    "--instance",
    "The instance of a solution, with its parts, their number and their allowed turns; or a "
    "drawing, a file or a folder of parts, each to be placed once.",
)
@gather(
    "container",
    _choose_container,
    click.option(
        "--container",
        metavar="ID",
        help="The outline of a drawing that is the container, by name, index or layer; by default "
        "one called sheet, bin, board, container or stock, or the outline around all others.",
    ),
    click.option("--no-container", is_flag=True, help="Judge only the parts among themselves."),
)
@gather(
    "gaps",
    _make_gaps,
    click.option(
        "--spacing",
        callback=checked(to_gap),
        metavar="DISTANCE",
        help="The least distance of any two parts; by default that of the file, or 0.",
    ),
    click.option(
        "--margin",
        callback=checked(to_gap),
        metavar="DISTANCE",
        help="The least distance of parts from the edge of the container and from its defects.",
    ),
)
@gather(
    "rules",
    _Rules,
    click.option(
        "--accept",
        callback=checked(to_gap),
        metavar="DEPTH",
        help="Accept overlaps up to this depth, and distances that are short by up to this much.",
    ),
    click.option("--strict", is_flag=True, help="Exit with 3 if a rule of the file is not judged."),
)
@takes_reading
@gather(
    "wanted",
    _Wanted,
    click.option("--json", "as_json", is_flag=True, help="Write the exact judgement as JSON."),
    click.option("--all", "everything", is_flag=True, help="List all faults."),
    takes_file(
        "--certificate",
        "Write a certificate, with which 'exactsweep verify' proves the verdict.",
    ),
    takes_file("--html", "Write a page with pictures of faults."),
    takes_file("--svg", "Write a picture with enlarged faults below."),
    takes_file("--repair", "Write the layout, moved by small moves to be valid, as Layout JSON."),
    takes_workers("The number of processes for several files; by default one per processor."),
    takes_output,
)
def layout_command(
    files: tuple[str, ...],
    instance: str | None,
    container: str | Literal[False] | None,
    gaps: dict[str, str],
    rules: _Rules,
    reading: ReadingOptions,
    wanted: _Wanted,
    workers: int | None,
) -> None:
    """Judge the output of a nesting program.

    Each of FILES is a file, a folder of files, a pattern such as 'nests/*.json', or - for standard
    input: Layout JSON; solutions of sparrow, jagua-rs, spyrrow, packingsolver or CG:SHOP 2024 as
    JSON; SVG of sparrow, jagua-rs, SVGnest or Deepnest; or any drawing, such as SVG or DXF, with
    the outlines in place. --instance adds rules that a file lacks. In a file with several sheets
    each sheet is a layout; FILE#0 is the first.

    A layout is valid if all parts are inside the container and clear of its defects, no two
    overlap, all distances are kept, and the number, the turns and the mirroring of parts obey the
    rules. The report lists each fault, the worst first, with its proof, its measure and the
    shortest move that repairs it. If most of a layout is wrong, the command tries other
    conventions: radians, another center, another sign, Y downward, another scale.

    Outlines of drawings inside others are holes, outlines in a hole parts again, and so on (--flat
    reads each as a part). --layer and --ignore-layer choose layers. The report lists all rules and
    shapes that are not judged.

    The exit code is 0 only if all layouts are valid, or all faults are within --accept.

    Example:
      exactsweep layout nest.svg --html nest.html
      exactsweep layout nest.dxf --ignore-layer engrave --accept 1e-6
      exactsweep layout final.json --spacing 0.5 --certificate proof.json
      exactsweep layout solution.json --instance instance.json
      exactsweep layout nests 'more/*.svg' --workers 4
    """
    from exactsweep.formats.layouts import read_layouts

    found = [path for given in files for path in find_files(given)]
    if "-" in found and len(found) > 1:
        raise click.UsageError("Standard input is read alone, without other files.")
    options = {"instance": instance, "container": container, **reading}
    layouts: list[FoundLayout] = []
    if len(found) == 1:
        layouts = read_layouts(found[0], **options)
        if len(layouts) == 1:
            y_down = reading["y_down"]
            if y_down is None:
                y_down = found[0].split("#")[0].lower().endswith(".svg")
            code = _judge_one(layouts[0], gaps, rules, show_path(found[0]), wanted, y_down=y_down)
            sys.exit(code)
    if wanted.certificate or wanted.html or wanted.svg or wanted.repair:
        raise click.UsageError("--certificate, --html, --svg and --repair are for a single layout.")
    if layouts:
        rows = judge_file(found[0], lambda: layouts, gaps, rules.accept)
    else:
        rows = [*_judge_all(found, options, gaps, rules.accept, workers)]
    if wanted.as_json:
        text = json.dumps([row._asdict() for row in rows], indent=1) + "\n"
    else:
        text = _write_rows(rows, measure_columns(wanted.output))
    write(text, wanted.output)
    good = all(row.valid or row.accepted for row in rows)
    unchecked = any(row.unchecked for row in rows)
    sys.exit(_find_code(rules, good=good, unchecked=unchecked))


def _find_code(rules: _Rules, *, good: bool, unchecked: bool) -> int:
    """Return the exit code."""
    return 1 if not good else _UNCHECKED if rules.strict and unchecked else 0


def _judge_one(
    found: FoundLayout,
    gaps: Mapping[str, str],
    rules: _Rules,
    title: str,
    wanted: _Wanted,
    *,
    y_down: bool,
) -> int:
    """Judge a layout, write what is wanted, and return the exit code."""
    from exactsweep.layout import LayoutError, report

    placed = len(found.data["placements"])
    with working(f"judging {placed} placements") as tell:
        judgement = judge_finely(found, gaps, title)
        notes = list_notes(found, judgement)
        context = report.ReportContext(found.unchecked, found.places, found.unit, rules.accept)
        ranked = report.rank_faults(
            judgement, lambda k, n: tell(f"measuring fault {k + 1} of {n}"), rules.accept
        )
        tell("writing")
        shown: dict[str, Any] = {"y_down": y_down, "context": context}
        if wanted.html:
            page = report.write_layout_page(judgement, ranked, title, notes, **shown)
            write(page, wanted.html)
        if wanted.svg:
            write(report.draw_layout(judgement, ranked, title, **shown), wanted.svg)
        if wanted.certificate:
            try:
                write_readable(json.dumps(judgement.certificate()) + "\n", wanted.certificate)
            except LayoutError as error:
                click.echo(f"{title}: {error}", err=True)
        if wanted.repair:
            tell("repairing")
            notes.append(_repair(judgement, wanted.repair, context))
        if wanted.as_json:
            text = report.write_layout_json(judgement, notes, ranked, context)
        else:
            columns, everything = measure_columns(wanted.output), wanted.everything
            text = report.report_layout(
                judgement, ranked, columns, notes=notes, everything=everything, context=context
            )
    write(text, wanted.output)
    good = all(one.accepted for one in ranked)
    return _find_code(rules, good=good, unchecked=bool(found.unchecked))


def _repair(judgement: Judgement, path: str, context: ReportContext) -> str:
    """Write a repaired layout, if there is one, and tell how far its parts moved."""
    from exactsweep.layout.repaired import repair_layout
    from exactsweep.text.report import approximate, take_root

    repaired = repair_layout(judgement)
    if repaired is None:
        return f"no repair by small moves found; {show_path(path)} is not written"
    write_readable(json.dumps(repaired.layout.to_json()) + "\n", path)
    longest = approximate(take_root(repaired.longest_squared), up=True)
    moved = f"{count(len(repaired.moves), 'placement')} moved by at most"
    return f"repaired in {show_path(path)}: {moved} {context.add_unit(longest)}; judged valid"


def list_notes(found: FoundLayout, judgement: Judgement) -> list[str]:
    """List the remarks on a layout: of its reader, and other conventions that explain it."""
    from exactsweep.layout.diagnose import diagnose, find_radians

    guesses = diagnose(judgement)
    if not any("radians" in guess for guess in guesses):
        guesses += find_radians(judgement.layout)
    return [*map(spell_out, found.notes), *guesses]


def judge_finely(found: FoundLayout, gaps: Mapping[str, str], title: str) -> Judgement:
    """Judge a layout, and flatten the curves of what is undecided more finely, up to a budget."""
    from exactsweep.layout import judge_layout

    data, judgement = found.data, judge_layout(_make(found, gaps, title))
    for _ in range(_MOST_FINER):
        layout = judgement.layout
        unsure = [f for f in judgement.faults if f.kind == "undecided" and f.error]
        if not unsure or found.flatten is None:
            break
        names: set[str | None] = {layout.placements[k].part for f in unsure for k in f.placements}
        if any(len(f.placements) == 1 for f in unsure):
            names.add(None)
        errors = [layout.error if n is None else layout.part_by_id[n].error for n in names]
        names -= {name for name, error in zip(names, errors, strict=True) if not error}
        try:
            finer = found.flatten(names, max(errors) * _FINER)
        except FormatError:
            # Too many lines.
            break
        if not finer:
            break
        parts = [{**part, **finer.get(part["id"], {})} for part in data["parts"]]
        walls = {"container": finer[None]} if finer.get(None) else {}
        data = {**data, **walls, "parts": parts}
        judgement = judge_layout(_make(found._replace(data=data), gaps, title))
    return judgement


def _make(found: FoundLayout, gaps: Mapping[str, str], title: str) -> Any:
    from exactsweep.layout import Layout

    with name_refusals(title):
        return Layout.from_json({**found.data, **gaps})


def _judge_all(
    paths: Sequence[str],
    options: Mapping[str, Any],
    gaps: Mapping[str, str],
    accept: Fraction | None,
    workers: int | None,
) -> Iterator[LayoutRow]:
    """Judge the layouts of several files, in processes of their own, in order."""
    from exactsweep.formats.layouts import read_layouts
    from exactsweep.processes import Pool, count_cores

    pool = Pool(min(workers or count_cores(), len(paths)), keep_limits, list_limits())
    try:
        jobs = [
            pool.submit(judge_file, path, partial(read_layouts, path, **options), gaps, accept)
            for path in paths
        ]
        with show_bar(len(jobs)) as show:
            for k, job in enumerate(jobs):
                yield from job.result()
                show(k + 1, "")
    finally:
        pool.close()


def judge_file(
    path: str,
    read: Callable[[], Sequence[FoundLayout]],
    gaps: Mapping[str, str],
    accept: Fraction | None = None,
) -> list[LayoutRow]:
    """Judge the layouts of a file; one that cannot be read is a row as well."""
    rows = []
    try:
        for found in read():
            name = f"{show_path(path)}, {found.name}" if found.name else show_path(path)
            rows.append(_sum_up(name, found, judge_finely(found, gaps, name), accept))
    except ValueError as error:
        rows.append(LayoutRow(show_path(path), str(error), None))
    return rows


def _sum_up(
    name: str, found: FoundLayout, judgement: Judgement, accept: Fraction | None
) -> LayoutRow:
    from exactsweep.layout.report import ReportContext, rank_faults
    from exactsweep.layout.report.table import list_measures, tell_fault

    context = ReportContext(found.unchecked, found.places, found.unit, accept)
    ranked = rank_faults(judgement, accepted=accept)
    facts = list_measures(judgement, ranked, context)
    worst = tell_fault(judgement, ranked[0], context)[1] if ranked else facts.get("nearest", "")
    return LayoutRow(
        name,
        facts["verdict"],
        judgement.valid,
        len(judgement.layout.placements),
        worst,
        [*map(spell_out, found.notes)],
        accepted=all(one.accepted for one in ranked),
        unchecked=found.unchecked,
    )


def _write_rows(rows: Sequence[LayoutRow], terminal_width: int | None) -> str:
    from exactsweep.text.report import lay_out, make_table

    table = make_table(("layout", "placements", "verdict", "worst or nearest"), {"placements"})
    for row in rows:
        placements = "" if row.valid is None else str(row.placements)
        table.add_row(row.name, placements, row.verdict, row.worst)
    valid = sum(bool(row.valid) or row.accepted for row in rows)
    notes = [f"note: {row.name}: {note}\n" for row in rows for note in row.notes]
    return lay_out([table], terminal_width) + "".join(notes) + f"{valid} of {len(rows)} valid\n"
