"""Polygons in files, folders and file name patterns."""

import itertools
import os
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from functools import partial
from glob import glob, has_magic
from pathlib import Path
from typing import NamedTuple, TypeVar, Unpack

from exactsweep.formats.candidate import Candidate, NamedRegion
from exactsweep.formats.error import FormatError
from exactsweep.formats.files import show_path
from exactsweep.formats.part_list import Coordinates, PartList
from exactsweep.formats.polygons import read_candidates, split_choice
from exactsweep.formats.reading import Options

# The suffixes of the files to read in a folder.
ENDINGS = (".json", ".jsonl", ".geojson", ".wkt", ".csv", ".svg", ".dxf")


class ListedPart(NamedTuple):
    name: str  # not necessarily unique
    file: str
    candidate: Candidate


class Listing(NamedTuple):
    files: int
    parts: list[ListedPart]
    left_out: list[str]
    notes: list[str]
    coordinates: Coordinates


def find_files(path: str) -> list[str]:
    """Find the files of a path, folder or pattern, sorted; a folder includes its subfolders.

    An existing file has priority over a pattern. Hidden files in folders are skipped.
    """
    if os.path.isdir(path):
        found = [
            file
            for file in Path(path).rglob("*")
            if file.suffix.lower() in ENDINGS and file.is_file()
            if not any(part.startswith(".") for part in file.relative_to(path).parts)
        ]
        if not found:
            raise FormatError(
                f"{show_path(path)}: no file has one of the suffixes {', '.join(ENDINGS)}"
            )
        return sorted(map(str, found))
    if has_magic(path) and not os.path.lexists(path):
        fitting = sorted(file for file in glob(path, recursive=True) if os.path.isfile(file))
        if not fitting:
            raise FormatError(f"{show_path(path)}: no file matches this pattern")
        return fitting
    return [path]


def list_parts(
    paths: Iterable[str], tolerance: object = None, **options: Unpack[Options]
) -> Listing:
    """Find the polygons in files, folders and patterns, and name them.

    Each path may end with "#" and a choice. A polygon is named by its id, its layer, the file name
    if it is the only one, or its index. With several files, names start with the file name, as in
    "left.dxf#cut". If Y points down in only some of the files, it is flipped there, with a note.
    Raises FormatError if no file can be read.
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
    coordinates, notes = unify_coordinates([(file, candidates) for file, _, candidates in read])
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


def unify_coordinates(
    files: Sequence[tuple[str, PartList[_Turned]]],
) -> tuple[Coordinates, list[str]]:
    """Flip Y in files where it points down if it points up in others; also return notes."""
    systems = {found.coordinates for _, found in files}
    notes = []
    down = [(name, found) for name, found in files if found.coordinates.y_down]
    if len({one.y_down for one in systems}) > 1:
        for name, found in down:
            found[:] = [one.flipped() for one in found]
            notes.append(f"{name}: Y axis flipped: it points down in this file and up in others")
    units = {one.unit for one in systems} - {None}
    if len(units) > 1:
        notes.append("the files have different units (--unit converts them to one)")
    unit = units.pop() if len(units) == 1 else None
    return Coordinates(bool(systems) and all(one.y_down for one in systems), unit), notes


def _split_files(path: str) -> Iterator[tuple[str, str]]:
    file, choice = split_choice(path)
    ending = "" if choice is None else f"#{choice}"
    for found in find_files(file):
        shown = os.path.relpath(found, file) if os.path.isdir(file) else os.path.basename(found)
        yield found + ending, shown


def make_unique(names: Sequence[str]) -> list[str]:
    """Make repeated names unique by appending the least unused number.

    >>> make_unique(["cut", "cut", "cut-2", "cut"])
    ['cut', 'cut-3', 'cut-2', 'cut-4']
    """
    taken = set(names)
    numbers: defaultdict[str, Iterator[int]] = defaultdict(partial(itertools.count, 2))
    seen: set[str] = set()
    found = []
    for name in names:
        spellings = (f"{name}-{number}" for number in numbers[name])
        new = next(one for one in spellings if one not in taken) if name in seen else name
        seen.add(name)
        taken.add(new)
        found.append(new)
    return found
