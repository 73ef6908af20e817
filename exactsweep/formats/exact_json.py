"""A reader of JSON whose numbers are decimals or fractions and never become floats."""

import json
from collections.abc import Callable, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import partial
from pathlib import Path

from exactsweep.formats.candidate import Candidate, allow_faults
from exactsweep.formats.error import FormatError
from exactsweep.formats.files import read_text, show_path
from exactsweep.formats.size import require_text, weigh
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.arguments import tells_arguments
from exactsweep.numbers.number import NumberError, format_fraction, quote, to_fraction
from exactsweep.numbers.point import Point


def parse_json(text: str) -> object:
    """Parse JSON, and keep all numbers, NaN and Infinity included, as text.

    Args:
        text: a JSON document.

    Returns:
        dict, list, str (strings and numbers), bool or None.

    Raises:
        FormatError: not JSON, nested too deeply, a name twice in one object, or too large.

    Cost: linear in the length of the text.

    Example:
        >>> parse_json('[0.10, 1e400, "1/3"]')
        ['0.10', '1e400', '1/3']
    """
    return _parse(text, str)


def parse_certificate(text: str) -> object:
    """Parse JSON with integers as ints, which a certificate uses for indices.

    Args:
        text: a JSON document.

    Returns:
        An argument for `exactsweep.check.verify`, of any content.

    Raises:
        FormatError: as by `parse_json`, and integers too long for Python to read.

    Cost: linear in the length of the text.

    Example:
        >>> parse_certificate('[0, "1/3"]')
        [0, '1/3']
    """
    return _parse(text, None)


def read_vertices(value: object, path: str) -> list[Point]:
    """Read a list of pairs of numbers, or of objects of "x" and "y".

    Args:
        value: a part of the result of `parse_json`.
        path: the JSON path of the value, for messages.

    Returns:
        list of Point, in the same order.

    Raises:
        FormatError: anything else; the message starts with the JSON path of the error.

    Cost: linear.

    Example:
        >>> read_vertices(parse_json("[[0.5, 2]]"), "$")
        [Point(x=Fraction(1, 2), y=Fraction(2, 1))]
    """
    if not isinstance(value, list):
        raise FormatError(f"{path} is {describe_kind(value)}, not a list of vertices")
    if all(type(pair) is list and [*map(type, pair)] == [str, str] for pair in value):
        with suppress(NumberError):
            return [Point(to_fraction(x), to_fraction(y)) for x, y in value]
    # The fast path failed: some value is wrong, or has another form.
    return [read_point(pair, f"{path}[{i}]") for i, pair in enumerate(value)]


def read_exact(document: object, path: str = "$") -> list[Candidate]:
    """Find the polygons of an exact JSON document.

    Args:
        document: a list of vertices, or of such lists; an object with a list of vertices as
            "vertices", or as "exterior" and with a list of these as "holes"; an object whose
            "polygons" is a list of all these; or a result, with "trajectory", "inner", "outer" and
            "unswept", or with "regions". "id" in an object is the name.
        path: where the document is, for messages.

    Returns:
        list of Candidate.

    Raises:
        FormatError: anything else; the message starts with the JSON path. The Candidates check the
            vertices later.

    Example:
        >>> [found.name for found in read_exact({"polygons": [{"id": "a", "vertices": []}]})]
        ['a']
    """
    if isinstance(document, dict) and "polygons" in document:
        return _each(document["polygons"], f"{path}.polygons", "polygons")
    if isinstance(document, list) and _is_list_of_rings(document):
        return _each(document, path, "polygons")
    if isinstance(document, dict) and not {"vertices", "exterior"} & document.keys():
        found = _read_result(document, path)
        if found:
            return found
    return [_read_one(document, path)._replace(place="" if path == "$" else path)]


def _each(value: object, path: str, what: str) -> list[Candidate]:
    if not isinstance(value, list):
        raise FormatError(f"{path} is {describe_kind(value)}, not a list of {what}")
    return allow_faults(_read_one(polygon, f"{path}[{k}]") for k, polygon in enumerate(value))


def _is_list_of_rings(value: list[object]) -> bool:
    first = value[0] if value else None
    return isinstance(first, list) and bool(first) and isinstance(first[0], (list, dict))


def _read_result(document: Mapping[str, object], path: str) -> list[Candidate]:
    """Find the loops of a result, and name them by the pair and the loop."""
    found: list[Candidate] = []
    for member in _LOOPS:
        if member in document:
            value, place = document[member], f"{path}.{member}"
            if isinstance(value, list) and (member in _LISTS or _is_list_of_rings(value)):
                each = _each(value, place, "polygons")
                found += [one._replace(name=f"{member} {k}") for k, one in enumerate(each)]
            else:
                found.append(_read_one(value, place)._replace(name=member))
    named = read_record_name(document)
    if named is not None:
        found = [one._replace(name=f"{named} {one.name}") for one in found]
    if not found and isinstance(document.get("error"), str):
        found = [Candidate.refused(f"{path}: an error: {document['error']}", named)]
    return found


_LOOPS = ("trajectory", "inner", "outer", "unswept", "regions")
_LISTS = ("unswept", "regions")


def read_record_name(document: Mapping[str, object]) -> str | None:
    """Return the name of a record: its id, the names of its pair, or its index; or None."""
    for members in (("id",), ("generatrix", "directrix"), ("index",)):
        values = [document.get(member) for member in members]
        if all(isinstance(value, str) for value in values):
            return " ".join(map(str, values))
    return None


def _read_one(value: object, path: str) -> Candidate:
    if isinstance(value, list):
        return Candidate(path, partial(read_vertices, value, path))
    if not isinstance(value, dict):
        return Candidate.refused(f"{path} is {describe_kind(value)}, not a list of vertices")
    member = "vertices" if "vertices" in value else "exterior"
    if member not in value:
        raise FormatError(
            f'{path} has neither "vertices" nor "polygons" nor, as in GeoJSON, a "type"'
            if path.endswith("$")
            else f'{path} has no "vertices"'
        )
    name = read_name(value.get("id"), f"{path}.id")
    if not isinstance(value[member], list):
        fault = f"{path}.{member} is {describe_kind(value[member])}, not a list of vertices"
        return Candidate.refused(fault, name)
    holes = value.get("holes", []) if member == "exterior" else []
    if not isinstance(holes, list):
        raise FormatError(f"{path}.holes is {describe_kind(holes)}, not a list of holes")
    for k, hole in enumerate(holes):
        if not isinstance(hole, list):
            raise FormatError(f"{path}.holes[{k}] is {describe_kind(hole)}, not a list of vertices")
    rings = {f"{path}.{member}": value[member]}
    rings |= {f"{path}.holes[{k}]": hole for k, hole in enumerate(holes)}
    readers = ((place, partial(read_vertices, ring, place)) for place, ring in rings.items())
    return Candidate.of_rings(readers, path, name)


def read_name(value: object, path: str) -> str | None:
    """Read an id, a string or a number; None if it is missing."""
    if value is None or isinstance(value, str):
        return value
    raise FormatError(f"{path} is {describe_kind(value)}, not a string or a number")


def describe_kind(value: object) -> str:
    """Name the kind of a JSON value.

    >>> describe_kind(parse_json("[true]")), describe_kind(parse_json("-1"))
    ('a list', "'-1'")
    """
    if isinstance(value, dict):
        return "an object"
    if isinstance(value, list):
        return "a list"
    if isinstance(value, str):
        return quote(value)
    return json.dumps(value) if value is None or isinstance(value, bool) else quote(value)


def count_vertices(text: str) -> int:
    """Count the possible vertices; each has its own bracket or brace."""
    return text.count("[") + text.count("{")


def measure_file(path: str) -> int:
    """Count the size of a file with one JSON document per line, for the limit of its reader.

    Returns:
        The result of `parsing.measure_written` for its text. The function holds one line at a time.

    Cost: linear.
    """
    vertices = numbers = 0
    with Path(path).open(encoding="utf-8") as lines:
        for line in lines:
            vertices += count_vertices(line)
            numbers += line.count(",")
    return weigh(Path(path).stat().st_size, vertices, numbers)


def _parse(text: str, number: Callable[[str], object] | None) -> object:
    require_text(text, count_vertices(text))
    try:
        document: object = json.loads(
            text,
            parse_int=number,
            parse_float=number,
            parse_constant=number,
            object_pairs_hook=_without_repeats,
        )
    except json.JSONDecodeError as error:
        raise FormatError(
            f"line {error.lineno}, column {error.colno}: not JSON: {error.msg}"
        ) from None
    except FormatError:
        raise
    except RecursionError:
        raise FormatError("nested too deeply") from None
    except ValueError as error:
        # The interpreter's limit on the digits of an int.
        raise FormatError(f"not JSON that can be read: {error}") from None
    return document


def _without_repeats(pairs: list[tuple[str, object]]) -> dict[str, object]:
    found: dict[str, object] = {}
    for name, value in pairs:
        # JSON does not define which of the two is valid; programs differ.
        if name in found:
            raise FormatError(f"the name {quote(name)} is twice in one object")
        found[name] = value
    return found


def read_point(pair: object, path: str) -> Point:
    """Read a pair of numbers, or an object of "x" and "y", as `read_vertices` does."""
    for names in (("x", "y"), ("X", "Y")):
        if isinstance(pair, dict) and pair.keys() == set(names):
            return Point(*(read_number(pair[name], f"{path}.{name}") for name in names))
    if not isinstance(pair, list):
        raise FormatError(f"{path} is {describe_kind(pair)}, not a pair of numbers")
    if len(pair) != 2:
        raise FormatError(f"{path} has {len(pair)} coordinates, not 2")
    return Point(*(read_number(value, f"{path}[{j}]") for j, value in enumerate(pair)))


def read_number(value: object, path: str) -> Fraction:
    """Read a number that `parse_json` kept as text; the path is for messages."""
    if not isinstance(value, str):
        raise FormatError(f"{path} is {describe_kind(value)}, not a number")
    try:
        return to_fraction(value)
    except NumberError as error:
        raise FormatError(f"{path}: {error}") from None


@tells_arguments
def read_certificate(path: str) -> object:
    """Read a certificate from a file, or from standard input, as `parse_certificate` does.

    Args:
        path: a path, or "-" for standard input.

    Returns:
        An argument for `exactsweep.check.verify`, of any content.

    Raises:
        FormatError: the file cannot be read, or is not JSON; the message names the file.
    """
    try:
        return parse_certificate(read_text(path))
    except ValueError as error:
        raise FormatError(f"{show_path(path)}: {error}") from None


def write_json(value: object, number: Callable[[Fraction], str] | None = None) -> str:
    """Write plain data and Fractions as JSON.

    Args:
        value: dict, list, tuple, str, int, bool, None, Fraction, or a Polygon, as its vertices.
        number: a function that writes a Fraction; by default as an exact string.

    Returns:
        JSON, on one line.

    Example:
        >>> write_json({"a": [Fraction(1, 3), 2]})
        '{"a": ["1/3", 2]}'
    """
    if isinstance(value, Fraction):
        return f'"{format_fraction(value)}"' if number is None else number(value)
    if isinstance(value, dict):
        members = (
            f"{json.dumps(name)}: {write_json(part, number)}" for name, part in value.items()
        )
        return f"{{{', '.join(members)}}}"
    if isinstance(value, Polygon):
        value = value.vertices
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(write_json(part, number) for part in value)}]"
    return json.dumps(value)
