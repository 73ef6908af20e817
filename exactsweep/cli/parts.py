"""Polygons from files, folders and patterns, with notes on skipped elements."""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import click

from exactsweep.cli.working import working
from exactsweep.formats import FormatError, NamedRegion, show_path
from exactsweep.formats.choice import is_group
from exactsweep.formats.folder import Listing, list_parts, make_unique
from exactsweep.formats.part_list import PartList, Remarks, summarize
from exactsweep.formats.polygons import split_choice
from exactsweep.text.report import approximate

_MOST_REASONS = 100


def find_parts(paths: Sequence[str], reading: Mapping[str, Any]) -> Listing:
    with working("reading"):
        listing = list_parts(paths, **reading)
    if not listing.parts:
        reasons = listing.left_out or [f"{', '.join(map(show_path, paths))}: contains no polygon"]
        raise FormatError(summarize(reasons))
    report_skipped(listing.left_out)
    print_notes(listing.notes)
    report_error(max(part.candidate.error for part in listing.parts), reading)
    return listing


def read_named(
    paths: Sequence[str], reading: Mapping[str, Any], *, keep: bool = False, whole: bool = False
) -> PartList[NamedRegion]:
    """Read polygons and report skipped elements.

    Names are made unique, unless `keep` is true and there is a single file. With `whole`, polygons
    that are not simple are errors.
    """
    listing = find_parts(paths, reading)
    candidates = [part.candidate for part in listing.parts]
    is_one = listing.files == 1 and is_group(candidates, split_choice(paths[0])[1])
    found: list[NamedRegion] = []
    names: list[str] = []
    reasons: list[str] = []
    notes: list[str] = []
    with working("reading"):
        for part in listing.parts:
            remarks = Remarks([], [])
            try:
                read = part.candidate.named_regions(remarks)
            except ValueError as error:
                if whole or is_one:
                    raise FormatError(f"{part.file}: {error}") from None
                remarks.left_out.append(str(error))
                read = []
            found += read
            names += [part.name] * len(read)
            notes += [f"{part.file}: {note}" for note in remarks.notes]
            reasons += [f"{part.file}: {reason}" for reason in remarks.left_out]
    if not found:
        raise FormatError(summarize(reasons))
    report_skipped(reasons)
    print_notes(notes)
    if not keep or listing.files > 1:
        unique = make_unique(names)
        found = [one._replace(name=name) for one, name in zip(found, unique, strict=True)]
    result = PartList(found, listing.coordinates)
    result.is_group = is_one
    return result


def report_error(error: Fraction, reading: Mapping[str, Any]) -> None:
    if error:
        how = "" if reading.get("tolerance") else " (--flatten TOLERANCE sets it)"
        print_notes([f"curves flattened within {approximate(error, up=True)}{how}"])


def report_skipped(reasons: Sequence[str]) -> None:
    more = len(reasons) - _MOST_REASONS
    shown = [*reasons[:_MOST_REASONS], f"{more} more"] if more > 0 else reasons
    for reason in shown:
        click.echo(f"skipped: {reason}", err=True)


def print_notes(lines: Iterable[str]) -> None:
    """Print lines on standard error, each at most once per command."""
    printed = click.get_current_context().meta.setdefault("exactsweep.printed", set())
    for line in lines:
        if line not in printed:
            printed.add(line)
            click.echo(line, err=True)
