"""A user's own pairs of polygons as cases, with computed exact answers."""

from __future__ import annotations

import io
import json
from collections.abc import Iterator, Sequence
from itertools import product
from pathlib import Path
from typing import BinaryIO, Unpack

from exactsweep.conform.run.cases import read_lines
from exactsweep.corpus import Case, case_from_json, find_case
from exactsweep.formats import FormatError, read_text, show_path
from exactsweep.formats.candidate import Candidate, choose
from exactsweep.formats.exact_json import (
    describe_kind,
    parse_certificate,
    parse_json,
    read_vertices,
)
from exactsweep.formats.files import open_bytes
from exactsweep.formats.parsing import find_candidates, parse_candidates
from exactsweep.formats.reading import Options
from exactsweep.numbers.error import name_refusals, quote
from exactsweep.numbers.limits import get_max_bytes
from exactsweep.numbers.number import ORIGIN, Point, PointRings
from exactsweep.words import suggest

_ROLES = ("directrix", "generatrix")
_MEMBERS = (*_ROLES, "reference", "id")


def read_pairs(path: str, tolerance: object = None, **options: Unpack[Options]) -> Iterator[Case]:
    """Read pairs of polygons as cases.

    Args:
        path: of a file, or "-" for standard input. Either lines of JSON, {"directrix": ...,
            "generatrix": ...}, perhaps with "reference" and "id", a polygon being anything that
            `parse_region` reads of JSON; or polygons in any format that `parse_regions` reads,
            each of which is put around each, itself included.
        tolerance: as for `parse_regions`.
        options: likewise.

    Returns:
        An iterator of Case; the ids are those of the lines, or "pair-NUMBER" by line; or the two
        names or indices, D first, as in "plate/disc".

    Raises:
        FormatError: not to be read; the message names the file, and the line.
        ValueError: what `sweep` refuses, likewise.

    Cost: that of `Case.of` for each pair; memory is a line, or the polygons.
    """
    if path == "-":
        # It is read twice.
        yield from _read(io.BytesIO(read_text(path).encode()), path, tolerance, **options)
        return
    with open_bytes(path) as file:
        yield from _read(file, path, tolerance, **options)


def read_case(name: str) -> Case:
    """Read a case.

    Args:
        name: the path of a file, "-" for standard input, or the id of a case of the corpus or of
            a generated one. The file holds a case as `case_from_json` reads it; or just a pair, an
            object with "directrix" and "generatrix" and, if wanted, "reference", such as
            `exactsweep sweep --json` writes.

    Returns:
        The Case; of a pair without "id", the name of the file is the id.

    Raises:
        ValueError: none of these; the message names the file.
    """
    if name != "-" and not Path(name).exists():
        return find_case(name)
    with name_refusals(show_path(name), FormatError):
        text = read_text(name)
        document = _require_object(parse_json(text))
        if "expected" in document:
            return case_from_json(parse_certificate(text))
        return _make_pair(document, show_path(name))


def _read(
    file: BinaryIO, path: str, tolerance: object, **options: Unpack[Options]
) -> Iterator[Case]:
    first = b"\n"
    while first.isspace():
        first = file.readline(get_max_bytes() + 1)
    file.seek(0)
    if _is_pair(first):
        yield from read_lines(file, path, _read_pair)
        return
    with name_refusals(show_path(path), FormatError):
        text = file.read().decode() if path == "-" else read_text(path)
        parts = _name(parse_candidates(text, tolerance, **options))
        for (d, directrix), (g, generatrix) in product(parts, repeat=2):
            yield _make_case(f"{d}/{g}", directrix, generatrix)


def _is_pair(line: bytes) -> bool:
    """Decide whether a line looks like a pair, valid or not."""
    try:
        document = json.loads(line)
    except (ValueError, RecursionError):
        return False
    return isinstance(document, dict) and not {*_ROLES}.isdisjoint(document)


def _read_pair(number: int, line: str) -> Case:
    document = _require_object(parse_json(line))
    for member in document:
        if member not in _MEMBERS:
            raise FormatError(f"$ has {quote(member)}{suggest(member, _MEMBERS)}")
    return _make_pair(document, f"pair-{number}")


def _require_object(document: object) -> dict[str, object]:
    if not isinstance(document, dict):
        raise FormatError(f"$ is {describe_kind(document)}, not an object")
    return document


def _make_pair(document: dict[str, object], name: str) -> Case:
    """Make the case of a pair, whose id is the name if it has none."""
    for role in _ROLES:
        if role not in document:
            raise FormatError(f"$ has no {role}")
    id = document.get("id", name)
    if not isinstance(id, str):
        raise FormatError(f"$.id is {describe_kind(id)}, not a string or a number")
    (reference,) = read_vertices([document.get("reference", ["0", "0"])], "$.reference")
    d, g = (_read_rings(choose(find_candidates(document[role]), None), role) for role in _ROLES)
    return _make_case(id, d, g, reference)


def _make_case(
    id: str, directrix: PointRings, generatrix: PointRings, reference: Point = ORIGIN
) -> Case:
    (d, *d_holes), (g, *g_holes) = directrix, generatrix
    return Case.of(id, "", d, g, reference, directrix_holes=d_holes, generatrix_holes=g_holes)


def _read_rings(candidate: Candidate, name: str) -> PointRings:
    """Read a polygon and its holes, vertices as they are given."""
    with name_refusals(name, FormatError):
        candidate.shape()
        return [candidate.vertices(), *(hole.vertices() for hole in candidate.holes())]


def _name(candidates: Sequence[Candidate]) -> list[tuple[str, PointRings]]:
    """Read polygons; they are called by their ids, or by index unless all have ids of their own."""
    names = [candidate.name or "" for candidate in candidates]
    if "" in names or len(set(names)) < len(names):
        names = [str(k) for k in range(len(candidates))]
    return [(name, _read_rings(one, name)) for name, one in zip(names, candidates, strict=True)]
