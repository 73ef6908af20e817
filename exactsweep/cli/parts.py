"""The polygons of files and folders, and the report of omissions."""

from collections.abc import Iterable, Mapping, Sequence
from fractions import Fraction
from typing import Any

import click

from exactsweep.cli.working import working
from exactsweep.formats import FormatError, NamedRegion, show_path
from exactsweep.formats.folder import Listing, list_parts, make_unique
from exactsweep.formats.part_list import PartList, Said, summarize
from exactsweep.text.report import approximate

_MOST_REASONS = 100


def find_parts(paths: Sequence[str], reading: Mapping[str, Any]) -> Listing:
    """Find the polygons of files, and report elements that are not polygons.

    Args:
        paths: files, folders and patterns, as for `list_parts`.
        reading: the options of the reader.

    Raises:
        FormatError: there is no polygon.
    """
    with working("reading"):
        listing = list_parts(paths, **reading)
    if not listing.parts:
        reasons = listing.left_out or [f"{', '.join(map(show_path, paths))}: holds no polygon"]
        raise FormatError(summarize(reasons))
    say_skipped(listing.left_out)
    say_all(listing.notes)
    say_error(max(part.candidate.error for part in listing.parts), reading)
    return listing


def read_named(
    paths: Sequence[str], reading: Mapping[str, Any], *, keep: bool = False
) -> PartList[NamedRegion]:
    """Read the polygons of files, with unique names, and report the omissions.

    Args:
        paths: as for `find_parts`.
        reading: likewise.
        keep: whether those of a single file keep the names, or none, that they have there.

    Raises:
        FormatError: nothing can be read.
    """
    listing = find_parts(paths, reading)
    found: list[NamedRegion] = []
    names: list[str] = []
    reasons: list[str] = []
    notes: list[str] = []
    with working("reading"):
        for part in listing.parts:
            said = Said([], [])
            try:
                read = part.candidate.named_regions(said)
            except ValueError as error:
                said.left_out.append(str(error))
                read = []
            found += read
            names += [part.name] * len(read)
            notes += [f"{part.file}: {note}" for note in said.notes]
            reasons += [f"{part.file}: {reason}" for reason in said.left_out]
    if not found:
        raise FormatError(summarize(reasons))
    say_skipped(reasons)
    say_all(notes)
    if not keep or listing.files > 1:
        unique = make_unique(names)
        found = [one._replace(name=name) for one, name in zip(found, unique, strict=True)]
    return PartList(found, listing.coordinates)


def say_error(error: Fraction, reading: Mapping[str, Any]) -> None:
    """Say on standard error how near lines are to the curves that were read, if any were."""
    if error:
        how = "" if reading.get("tolerance") else " (--flatten TOLERANCE sets it)"
        say_all([f"curves drawn as lines, within {approximate(error, up=True)} of them{how}"])


def say_skipped(reasons: Sequence[str]) -> None:
    """Say on standard error what was not read, and why, a line each."""
    more = len(reasons) - _MOST_REASONS
    shown = [*reasons[:_MOST_REASONS], f"{more} more"] if more > 0 else reasons
    for reason in shown:
        click.echo(f"left out: {reason}", err=True)


def say_all(lines: Iterable[str]) -> None:
    """Write lines on standard error, each only once in a command."""
    said = click.get_current_context().meta.setdefault("exactsweep.said", set())
    for line in lines:
        if line not in said:
            said.add(line)
            click.echo(line, err=True)
