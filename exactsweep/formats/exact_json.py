"""JSON without floats."""

import json
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path

from exactsweep.formats.error import FormatError
from exactsweep.formats.files import read_text, show_path
from exactsweep.formats.size import require_text, weigh
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import explain_type_errors, prefix_errors, quote
from exactsweep.numbers.number import Point, to_fraction


def parse_json(text: str) -> object:
    """Parse JSON; all numbers, even NaN and Infinity, remain text. Raises FormatError."""
    return _parse(text, str)


def parse_certificate(text: str) -> object:
    """Parse a certificate; its integers become ints."""
    return _parse(text, None)


def read_vertices(value: object, path: str) -> list[Point]:
    """Read a list of pairs, or of objects with "x" and "y"; errors start with the path."""
    if not isinstance(value, list):
        raise FormatError(f"{path} is {describe_kind(value)}, not a list of vertices")
    return [read_point(pair, f"{path}[{i}]") for i, pair in enumerate(value)]


def describe_kind(value: object) -> str:
    if isinstance(value, (dict, list)):
        return "an object" if isinstance(value, dict) else "a list"
    return json.dumps(value) if value is None or isinstance(value, bool) else quote(value)


def count_vertices(text: str) -> int:
    """Bound the number of vertices by the brackets and braces."""
    return text.count("[") + text.count("{")


def measure_file(path: str) -> int:
    """Return `parsing.measure_written` for a file of JSON lines, reading line by line."""
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
        # An int exceeds the interpreter's digit limit.
        raise FormatError(f"unreadable JSON: {error}") from None
    return document


def _without_repeats(pairs: list[tuple[str, object]]) -> dict[str, object]:
    found: dict[str, object] = {}
    for name, value in pairs:
        # JSON does not define the meaning of duplicate keys.
        if name in found:
            raise FormatError(f"duplicate key {quote(name)}")
        found[name] = value
    return found


def read_point(pair: object, path: str) -> Point:
    for names in (("x", "y"), ("X", "Y")):
        if isinstance(pair, dict) and pair.keys() == set(names):
            return Point(*(read_number(pair[name], f"{path}.{name}") for name in names))
    if not isinstance(pair, list):
        raise FormatError(f"{path} is {describe_kind(pair)}, not a pair of numbers")
    if len(pair) != 2:
        raise FormatError(f"{path} has {len(pair)} coordinates, not 2")
    return Point(*(read_number(value, f"{path}[{j}]") for j, value in enumerate(pair)))


def read_number(value: object, path: str) -> Fraction:
    if not isinstance(value, str):
        raise FormatError(f"{path} is {describe_kind(value)}, not a number")
    with prefix_errors(path, FormatError):
        return to_fraction(value)


@explain_type_errors
def read_certificate(path: str) -> object:
    """Read a certificate from a file, or from standard input for "-", for `check.verify`."""
    with prefix_errors(show_path(path), FormatError):
        return parse_certificate(read_text(path))


def quote_fraction(value: Fraction) -> str:
    return f'"{format_fraction(value)}"'


def write_json(value: object, number: Callable[[Fraction], str] = quote_fraction) -> str:
    """Format plain data, Fractions and Polygons as JSON on one line."""
    if isinstance(value, Fraction):
        return number(value)
    if isinstance(value, dict):
        members = [
            f"{json.dumps(name)}: {write_json(part, number)}" for name, part in value.items()
        ]
        return f"{{{', '.join(members)}}}"
    if isinstance(value, Polygon):
        value = value.vertices
    if isinstance(value, (list, tuple)):
        return f"[{', '.join([write_json(part, number) for part in value])}]"
    return json.dumps(value)
