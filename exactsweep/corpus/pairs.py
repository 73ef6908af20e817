"""Pairs of polygons in files, as cases with computed answers."""

import io
import json
from collections.abc import Iterator, Sequence
from itertools import product
from pathlib import Path
from typing import BinaryIO, NamedTuple, Unpack

from exactsweep.corpus.case import Case
from exactsweep.corpus.case_json import case_from_json
from exactsweep.corpus.selection import read_lines
from exactsweep.corpus.shipped import find_case
from exactsweep.formats import FormatError, exact_json, read_text, show_path
from exactsweep.formats.candidate import Candidate
from exactsweep.formats.choice import choose
from exactsweep.formats.files import open_bytes
from exactsweep.formats.json_polygons import find_candidates
from exactsweep.formats.parsing import parse_candidates
from exactsweep.formats.reading import Options
from exactsweep.numbers.error import prefix_errors, quote
from exactsweep.numbers.limits import get_limits
from exactsweep.numbers.number import ORIGIN, Point, PointRings
from exactsweep.words import suggest


class _PairForm(NamedTuple):
    directrix_key: str
    generatrix_key: str
    others: tuple[str, ...]


# A case, a line of the protocol or `sweep --json`; `nfp --json`; `ifp --json`; `sum --json`.
_FORMS = (
    _PairForm(
        "directrix",
        "generatrix",
        (
            *("directrix_holes", "generatrix_holes", "title", "note", "version", "ask"),
            *("class", "flags", "integer_scale", "representable"),
            *("kind", "direction", "trajectory", "inner", "outer", "unswept", "area"),
        ),
    ),
    _PairForm("stationary", "orbiting", ("kind", "exterior", "holes", "exact_fits", "area")),
    _PairForm("container", "part", ("placed", "regions", "exact_fits", "area")),
    _PairForm("a", "b", ("exterior", "holes", "area", "a_holes", "b_holes")),
)


def read_pairs(path: str, tolerance: object = None, **options: Unpack[Options]) -> Iterator[Case]:
    """Read pairs of polygons as cases, from a file or, if the path is "-", standard input.

    The file has JSON lines as for `read_case`, one such object over several lines, or polygons in
    any format of `parse_regions`, of which all ordered pairs are cases. A line without an id
    gets the id "pair-NUMBER"; a pair of polygons gets their names or indices, D first, as in
    "plate/disc". For the tolerance and the options see `parse_regions`.
    """
    if path == "-":
        # The text is parsed twice.
        yield from _read(io.BytesIO(read_text(path).encode()), path, tolerance, **options)
        return
    with open_bytes(path) as file:
        yield from _read(file, path, tolerance, **options)


def read_case(name: str) -> Case:
    """Read a case from a file, from standard input ("-"), or by its id, shipped or generated.

    A file contains a case as for `case_from_json`, the --json output of `sweep`, `nfp`, `ifp` or
    `sum`, or an object with "directrix", "generatrix" and optional members of a case, polygons as
    for `parse_region`. The default id is the name of the file.
    """
    if name != "-" and not Path(name).exists():
        return find_case(name)
    with prefix_errors(show_path(name), FormatError):
        return _read_document(read_text(name), show_path(name))


def _read(
    file: BinaryIO, path: str, tolerance: object, **options: Unpack[Options]
) -> Iterator[Case]:
    first = b"\n"
    while first.isspace():
        first = file.readline(get_limits().max_bytes + 1)
    file.seek(0)
    if _is_pair(first):
        yield from read_lines(
            file, path, lambda number, line: _read_document(line, f"pair-{number}")
        )
        return
    with prefix_errors(show_path(path), FormatError):
        text = file.read().decode() if path == "-" else read_text(path)
        if text.lstrip().startswith("{") and _is_pair(text):
            yield _read_document(text, show_path(path))
            return
        parts = _name(parse_candidates(text, tolerance, **options))
        for (d, directrix), (g, generatrix) in product(parts, repeat=2):
            yield _make_case(f"{d}/{g}", directrix, generatrix)


def _is_pair(text: str | bytes) -> bool:
    try:
        document = json.loads(text)
    except (ValueError, RecursionError):
        return False
    return isinstance(document, dict) and any(
        {form.directrix_key, form.generatrix_key} & document.keys() for form in _FORMS
    )


def _read_document(text: str, name: str) -> Case:
    document = exact_json.parse_json(text)
    if not isinstance(document, dict):
        raise FormatError(f"$ is {exact_json.describe_kind(document)}, not an object")
    if "expected" in document:
        return case_from_json(exact_json.parse_certificate(text))
    return _make_pair(document, name)


def _make_pair(document: dict[str, object], name: str) -> Case:
    form = next(
        (one for one in _FORMS if {one.directrix_key, one.generatrix_key} & document.keys()), None
    )
    if form is None:
        roles = ", ".join(f"{one.directrix_key} and {one.generatrix_key}" for one in _FORMS)
        raise FormatError(f"$ is not a pair; it needs {roles}")
    members = (form.directrix_key, form.generatrix_key, "reference", "id", *form.others)
    for member in document:
        if member not in members:
            raise FormatError(f"$ has an unknown key {quote(member)}{suggest(member, members)}")
    for role in (form.directrix_key, form.generatrix_key):
        if role not in document:
            raise FormatError(f"$ has no {role}")
    if document.get("placed"):
        raise FormatError("$.placed: a case cannot have placed shapes")
    id = document.get("id", name)
    if not isinstance(id, str):
        raise FormatError(f"$.id is {exact_json.describe_kind(id)}, not a string or a number")
    (reference,) = exact_json.read_vertices([document.get("reference", ["0", "0"])], "$.reference")
    d, g = (_read_shape(document, role) for role in (form.directrix_key, form.generatrix_key))
    if form.generatrix_key == "b":
        g = [[Point(-x, -y) for x, y in ring] for ring in g]
    return _make_case(id, d, g, reference, inner_fit=form.directrix_key == "container")


def _read_shape(document: dict[str, object], role: str) -> PointRings:
    """Read a polygon with its own holes, or with the holes in the member ROLE_holes."""
    given = document[role]
    if isinstance(given, dict) and "path" in given:
        raise FormatError(f"$.{role}: a case cannot have a path, only polygons")
    rings = _read_rings(choose(find_candidates(given), None), role)
    key = f"{role}_holes"
    holes = document.get(key, [])
    if not isinstance(holes, list):
        raise FormatError(f"$.{key} is {exact_json.describe_kind(holes)}, not a list of holes")
    if holes and len(rings) > 1:
        raise FormatError(f"$.{key}: {role} already has holes")
    return [
        *rings,
        *(exact_json.read_vertices(hole, f"$.{key}[{k}]") for k, hole in enumerate(holes)),
    ]


def _make_case(
    id: str,
    directrix: PointRings,
    generatrix: PointRings,
    reference: Point = ORIGIN,
    *,
    inner_fit: bool = False,
) -> Case:
    (d, *d_holes), (g, *g_holes) = directrix, generatrix
    return Case.of(
        id,
        "",
        d,
        g,
        reference,
        directrix_holes=d_holes,
        generatrix_holes=g_holes,
        inner_fit=inner_fit,
    )


def _read_rings(candidate: Candidate, name: str) -> PointRings:
    with prefix_errors(name, FormatError):
        candidate.shape()
        return [candidate.vertices(), *(hole.vertices() for hole in candidate.holes())]


def _name(candidates: Sequence[Candidate]) -> list[tuple[str, PointRings]]:
    """Read polygons, named by their ids if these are distinct, else by their indices."""
    names = [candidate.name or "" for candidate in candidates]
    if "" in names or len(set(names)) < len(names):
        names = [str(k) for k in range(len(candidates))]
    return [(name, _read_rings(one, name)) for name, one in zip(names, candidates, strict=True)]
