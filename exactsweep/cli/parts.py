"""The polygons of files and folders, and what is said of those that are left out."""

from collections.abc import Mapping, Sequence
from typing import Any

import click

from exactsweep.formats import FormatError, NamedRegion, show_path
from exactsweep.formats.folder import Listing, list_parts, make_unique

_MOST_REASONS = 100


def find_parts(paths: Sequence[str], reading: Mapping[str, Any]) -> Listing:
    """Find the polygons of files, and say what is none.

    Args:
        paths: files, folders and patterns, as `list_parts` takes them.
        reading: how they are read.

    Raises:
        FormatError: nothing is there.
    """
    listing = list_parts(paths, **reading)
    if not listing.parts:
        reasons = listing.left_out or [f"{', '.join(map(show_path, paths))}: holds no polygon"]
        raise FormatError(summarize(reasons))
    say_left_out(listing.left_out)
    return listing


def read_named(
    paths: Sequence[str], reading: Mapping[str, Any], *, keep: bool = False
) -> list[NamedRegion]:
    """Read the polygons of files, named among all of them, and say what is left out.

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
    for part in listing.parts:
        try:
            found.append(part.candidate.named_region())
            names.append(part.name)
        except ValueError as error:
            reasons.append(f"{part.file}: {error}")
    if not found:
        raise FormatError(summarize(reasons))
    say_left_out(reasons)
    if keep and listing.files == 1:
        return found
    unique = make_unique(names)
    return [one._replace(name=name) for one, name in zip(found, unique, strict=True)]


def summarize(reasons: Sequence[str]) -> str:
    """The one reason for which nothing could be read, or the first of several."""
    if len(reasons) == 1:
        return reasons[0]
    return f"nothing can be read: {reasons[0]}; and {len(reasons) - 1} more"


def say_left_out(reasons: Sequence[str]) -> None:
    """Say on standard error what was not read, and why, a line each."""
    for reason in reasons[:_MOST_REASONS]:
        click.echo(f"left out: {reason}", err=True)
    if len(reasons) > _MOST_REASONS:
        click.echo(f"left out: {len(reasons) - _MOST_REASONS} more", err=True)
