import json
from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from itertools import chain, islice
from pathlib import Path
from typing import Any

import click

from exactsweep import corpus
from exactsweep.cli import complete
from exactsweep.cli.complete import offer
from exactsweep.cli.options import gather, takes_output
from exactsweep.cli.output import write
from exactsweep.corpus import export, publish
from exactsweep.corpus.case_json import case_to_line
from exactsweep.corpus.describe import describe
from exactsweep.corpus.layouts import find_layout_case, find_path_case, layout_cases, path_cases
from exactsweep.corpus.shipped import list_ids, list_summaries, read_schema, require_prefix
from exactsweep.words import count


@click.group("corpus")
def corpus_command() -> None:
    """List, show, export or generate test cases."""


_LISTS = ("cases", "themes", "flags", "families")


def _make_filters(flags: tuple[str, ...], kind: str | None, max_size: int | None) -> dict[str, Any]:
    return {"flags": flags, "kind": kind, "max_size": max_size}


_takes_filters = gather(
    "filters",
    _make_filters,
    click.option(
        "--flag",
        "flags",
        multiple=True,
        shell_complete=offer(complete.FLAGS),
        help="Only cases with this flag; repeatable.",
    ),
    click.option(
        "--class",
        "kind",
        metavar="CLASS",
        shell_complete=offer(complete.CLASSES),
        help="Only cases of this class: CC, CM, MM or SS.",
    ),
    click.option("--max-size", type=click.IntRange(min=0), help="Maximum number of vertices."),
)


def _is_any(filters: dict[str, Any]) -> bool:
    return any(value not in ((), None, "") for value in filters.values())


@corpus_command.command("list")
@click.argument(
    "names",
    nargs=-1,
    metavar="[themes|flags|families|ID]...",
    shell_complete=offer(lambda: ["themes", "flags", "families"], complete.THEMES, complete.CASES),
)
# An alias for older scripts.
@click.option("--prefix", hidden=True)
@_takes_filters
def list_command(names: tuple[str, ...], prefix: str | None, filters: dict[str, Any]) -> None:
    """List cases; or themes, flags, or families of the generator.

    ID is the id of a case, or a prefix of ids such as a theme. Each line has the id, the class, the
    number of vertices of D and G in total, and the title.

    Example:
      exactsweep corpus list --class MM --max-size 20
      exactsweep corpus list families
    """
    what = names[0] if len(names) == 1 and names[0] in _LISTS else "cases"
    starts = [prefix or ""] if names in ((), ("cases",)) else names
    if what != "cases" and (prefix or _is_any(filters)):
        raise click.UsageError("The options are only for cases.")
    match what:
        case "themes":
            rows: Iterable[tuple[str, ...]] = corpus.themes().items()
        case "flags":
            rows = ((flag, note.meaning) for flag, note in corpus.notes().items())
        case "families":
            rows = (
                (family.name, family.level, family.summary) for family in corpus.FAMILIES.values()
            )
        case _:
            rows = (
                (case.id, case.kind, f"{case.size:3}", case.title)
                for start in starts
                for case in list_summaries(prefix=require_prefix(start, *_LISTS), **filters)
            )
    write(_columns([*rows]), "-")


@corpus_command.command("show")
@click.argument(
    "name",
    metavar="ID|FLAG|FAMILY",
    shell_complete=offer(complete.CASES, complete.FLAGS, complete.FAMILIES),
)
@click.option("--json", "as_json", is_flag=True, help="Write the case as one JSON line.")
def show_command(name: str, as_json: bool) -> None:
    """Show a case with notes on its flags, a flag, or a family of the generator.

    ID is the id of a case of the corpus, or gen-FAMILY-SEED-NUMBER for a generated case.

    Example:
      exactsweep corpus show directions-y
    """
    write(case_to_line(corpus.find_case(name)) if as_json else describe(name), "-")


@corpus_command.command("layouts")
@click.argument("name", required=False, metavar="[ID]")
@click.option(
    "--json", "as_json", is_flag=True, help="Write layouts with their expected faults as JSON."
)
def layouts_command(name: str | None, as_json: bool) -> None:
    """List layouts with known faults, or write one of them.

    Example:
      exactsweep corpus layouts
      exactsweep corpus layouts layouts-slot
      exactsweep corpus layouts --json
    """
    found = [*layout_cases()] if name is None else [find_layout_case(name)]
    if as_json:
        rows = ({"id": one.id, "layout": one.data, "expected": one.expected} for one in found)
        text = "".join(f"{json.dumps(row)}\n" for row in rows)
    elif name is None:
        verdicts = {True: "valid", False: "wrong"}
        text = _columns([(one.id, verdicts[one.expected["valid"]], one.title) for one in found])
    else:
        text = f"{json.dumps(found[0].data)}\n"
    write(text, "-")


@corpus_command.command("paths")
@click.argument("name", required=False, metavar="[ID]")
@click.option("--json", "as_json", is_flag=True, help="Write shapes, paths and sums as JSON.")
def paths_command(name: str | None, as_json: bool) -> None:
    """List Minkowski sums of a shape and a path, or write one of them as JSON.

    Example:
      exactsweep corpus paths
      exactsweep corpus paths paths-slot
      exactsweep corpus paths --json
    """
    found = [*path_cases()] if name is None else [find_path_case(name)]
    if as_json or name is not None:
        write("".join(f"{json.dumps(one.data)}\n" for one in found), "-")
    else:
        write(_columns([(one.id, str(len(one.path)), one.title) for one in found]), "-")


@corpus_command.command("export")
@click.argument(
    "names", nargs=-1, metavar="[ID]...", shell_complete=offer(complete.THEMES, complete.CASES)
)
@_takes_filters
@click.option(
    "--to",
    "--format",
    "form",
    type=click.Choice(["json", "wkt", "geojson", "svg"]),
    default="json",
    help="Output format; default: json.",
)
@takes_output
def export_command(names: tuple[str, ...], filters: dict[str, Any], form: str, output: str) -> None:
    """Write cases for other programs.

    ID is the id of a case, gen-FAMILY-SEED-NUMBER for a generated case, or a prefix of ids such as
    a theme. Without ID, all cases of the corpus are written. The options filter them.

    json: one case per line, exact; for the format see 'exactsweep corpus schema'.

    wkt: comma-separated values, one ring or segment per row. If a coordinate is not a finite
    decimal, the row states this instead of the geometry.

    geojson: a FeatureCollection with one ring or segment per feature. If a coordinate is not a
    double, the feature has "exact": false, the nearest doubles, and the exact vertices as strings.

    svg: a sheet of small pictures.

    Example:
      exactsweep corpus export directions --to svg -o directions.svg
    """
    writers: dict[str, Callable[[Iterable[corpus.Case]], Iterable[str]]] = {
        "json": partial(map, case_to_line),
        "wkt": export.cases_to_wkt,
        "geojson": export.cases_to_geojson,
        "svg": export.cases_to_svg,
    }
    parts = writers[form](_choose(names, filters))
    for text in parts if output == "-" else ["".join(parts)]:
        write(text, output)


@corpus_command.command("release")
@takes_output
def release_command(output: str) -> None:
    """Write the corpus as a folder of data for programs in any language.

    The folder, by default exactsweep-corpus-VERSION, contains the cases as JSON lines by theme, the
    schema, a description, readers in six languages, the changelog, the license, and checksums. A
    published version never changes; new versions only add cases.

    Example:
      exactsweep corpus release -o answers
    """
    folder = Path(f"exactsweep-corpus-{publish.VERSION}" if output == "-" else output)
    click.echo(f"{folder}: {count(publish.write_corpus(folder), 'file')}", err=True)


@corpus_command.command("generate")
@click.option(
    "--family",
    "families",
    multiple=True,
    shell_complete=offer(complete.FAMILIES),
    help="A family, repeatable; default: all families.",
)
@click.option("--seed", type=click.IntRange(min=0), default=0, help="Seed; default: 0.")
@click.option("--count", type=click.IntRange(min=0), required=True, help="Number of cases.")
def generate_command(families: tuple[str, ...], seed: int, count: int) -> None:
    """Generate cases as JSON lines.

    The cases depend only on family and seed, not on the machine or the Python version. Several
    families alternate. 'exactsweep corpus list families' lists the families.

    Example:
      exactsweep corpus generate --family notched --seed 1 --count 100
    """
    streams = [corpus.generate(family, seed) for family in families or corpus.FAMILIES]
    for case in islice(chain.from_iterable(zip(*streams, strict=True)), count):
        write(case_to_line(case), "-")


@corpus_command.command("schema")
def schema_command() -> None:
    """Write the JSON Schema (2020-12) of a case.

    Example:
      exactsweep corpus schema
    """
    write(read_schema(), "-")


def _choose(names: tuple[str, ...], filters: dict[str, Any]) -> Iterator[corpus.Case]:
    """Return the named cases lazily; reject wrong names at once."""
    ids = list_ids()
    found: list[Iterable[corpus.Case]] = [
        [corpus.find_case(name)]
        if name in ids or name.startswith("gen-")
        else corpus.cases(prefix=require_prefix(name, *_LISTS), **filters)
        for name in names or ("",)
    ]
    return chain.from_iterable(found)


def _columns(rows: Sequence[tuple[str, ...]]) -> str:
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    lines = ("  ".join(map(str.ljust, row, widths)).rstrip() for row in rows)
    return "".join(f"{line}\n" for line in lines)
