"""Files, folders and patterns of file names; the names of what is in them, and what is left out."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from glob import glob, has_magic
from pathlib import Path
from typing import NamedTuple, TypeVar, Unpack

from exactsweep.formats.candidate import Candidate, NamedRegion
from exactsweep.formats.error import FormatError
from exactsweep.formats.files import show_path
from exactsweep.formats.part_list import Coordinates, PartList
from exactsweep.formats.polygons import read_candidates, split_choice
from exactsweep.formats.reading import Options

ENDINGS = (".json", ".jsonl", ".geojson", ".wkt", ".csv", ".svg", ".dxf")
"""What the names of the files end with that are read from a folder."""


class ListedPart(NamedTuple):
    """A possible polygon, among others.

    Attributes:
        name: what it is called among all of them; another may have the same.
        file: the file, as messages have it.
        candidate: what is to be read.
    """

    name: str
    file: str
    candidate: Candidate


class Listing(NamedTuple):
    """The contents of files.

    Attributes:
        files: how many there are.
        parts: list of ListedPart.
        left_out: what is hidden or no polygon, a line each: the file, and the reason.
        notes: what else there is to say, a line each.
        coordinates: the meaning of the coordinates, of Y and of the unit.
    """

    files: int
    parts: list[ListedPart]
    left_out: list[str]
    notes: list[str]
    coordinates: Coordinates


def find_files(path: str) -> list[str]:
    """Find the files that a path stands for.

    Args:
        path: a file, "-", a folder, or a pattern such as `parts/*.dxf`; `**` stands for any
            folders. A file of that name goes before a pattern.

    Returns:
        The path itself if it is none of these; of a folder, the files in it and below, by name,
        that end as ENDINGS and do not begin with a point; of a pattern, those that fit it, by name.

    Raises:
        FormatError: a folder without such files, or a pattern that fits none.

    Example:
        >>> find_files("part.json"), find_files("-")
        (['part.json'], ['-'])
    """
    if os.path.isdir(path):
        found = [
            file
            for file in Path(path).rglob("*")
            if file.suffix.lower() in ENDINGS and file.is_file()
            if not any(part.startswith(".") for part in file.relative_to(path).parts)
        ]
        if not found:
            raise FormatError(f"{show_path(path)}: no file in it ends in {', '.join(ENDINGS)}")
        return sorted(map(str, found))
    if has_magic(path) and not os.path.lexists(path):
        fitting = sorted(file for file in glob(path, recursive=True) if os.path.isfile(file))
        if not fitting:
            raise FormatError(f"{show_path(path)}: no file fits this pattern")
        return fitting
    return [path]


def list_parts(
    paths: Iterable[str], tolerance: object = None, **options: Unpack[Options]
) -> Listing:
    """Find the polygons of files, folders and patterns, and name them.

    Args:
        paths: each as for `find_files`, perhaps with "#" and a choice after it, as for
            `read_polygons`, that holds for each of the files.
        tolerance: as for `exactsweep.formats.parse_polygons`.
        options: likewise.

    Returns:
        A Listing. A polygon of one file is named by its id, or else by its layer, or by the file if
        it is the only one, or by its index. Of several files the name of the file goes before that,
        as in "left.dxf#cut", without the folder that was given. Where Y points down in some files
        and up in others, it points up in all, and a note says so.

    Raises:
        FormatError: the only file cannot be read, or none of several; no file is there.
    """
    files = [found for path in paths for found in _split_files(path)]
    parts: list[ListedPart] = []
    left_out: list[str] = []
    faults = []
    read: list[tuple[str, str, PartList[Candidate]]] = []
    for path, shown in files:
        try:
            candidates = read_candidates(path, tolerance, **options)
        except FormatError as error:
            faults.append(error)
            left_out.append(str(error))
            continue
        read.append((show_path(split_choice(path)[0]), shown, candidates))
    coordinates, notes = bring_to_one([(file, candidates) for file, _, candidates in read])
    for file, shown, candidates in read:
        left_out += [f"{file}: {reason}" for reason in candidates.left_out]
        notes += [f"{file}: {note}" for note in candidates.notes]
        left_out += [f"{file}: {one.fault}" for one in candidates if one.fault]
        sound = [(k, one) for k, one in enumerate(candidates) if not one.fault]
        for k, candidate in sound:
            own = candidate.name or candidate.layer or (str(k) if len(sound) > 1 else "")
            if len(files) > 1:
                own = f"{shown}#{own}" if own else shown
            parts.append(ListedPart(own or shown, file, candidate))
    if len(faults) == len(files):
        raise faults[0]
    return Listing(len(files), parts, left_out, notes, coordinates)


_Turned = TypeVar("_Turned", Candidate, NamedRegion)


def bring_to_one(files: Sequence[tuple[str, PartList[_Turned]]]) -> tuple[Coordinates, list[str]]:
    """Turn Y up in some files if it points up in others.

    Args:
        files: what each is called, and its polygons, which are turned in place.

    Returns:
        The coordinates of all, without a unit where they have several; and what there is to say.
    """
    systems = {found.coordinates for _, found in files}
    notes = []
    down = [(name, found) for name, found in files if found.coordinates.y_down]
    if len({one.y_down for one in systems}) > 1:
        for name, found in down:
            found[:] = [one.turned() for one in found]
            notes.append(f"{name}: Y points down there, up in other files: turned up")
    units = {one.unit for one in systems} - {None}
    if len(units) > 1:
        notes.append("the files have different units (--unit brings them to one)")
    unit = units.pop() if len(units) == 1 else None
    return Coordinates(bool(systems) and all(one.y_down for one in systems), unit), notes


def _split_files(path: str) -> Iterator[tuple[str, str]]:
    """The files that a path with a choice stands for, with it, and how each is called."""
    file, choice = split_choice(path)
    ending = "" if choice is None else f"#{choice}"
    for found in find_files(file):
        shown = os.path.relpath(found, file) if os.path.isdir(file) else os.path.basename(found)
        yield found + ending, shown


def make_unique(names: Sequence[str]) -> list[str]:
    """Give equal names a number after the first: the least that makes a name of its own.

    >>> make_unique(["cut", "cut", "cut-2", "cut"])
    ['cut', 'cut-3', 'cut-2', 'cut-4']
    """
    taken = set(names)
    seen: set[str] = set()
    last: dict[str, int] = {}
    found = []
    for name in names:
        new = name
        if name in seen:
            number = last.get(name, 1) + 1
            while f"{name}-{number}" in taken:
                number += 1
            last[name] = number
            new = f"{name}-{number}"
            taken.add(new)
        seen.add(name)
        found.append(new)
    return found
