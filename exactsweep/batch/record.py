"""The record of one pair, a line of JSON."""

import json
from collections.abc import Mapping
from fractions import Fraction
from typing import Any, Literal

from exactsweep.geometry.number import format_fraction
from exactsweep.geometry.polygon import Polygon
from exactsweep.sweep import Sweep

Quantities = Literal["trajectory", "loops", "areas"]
QUANTITIES: tuple[Quantities, ...] = ("trajectory", "loops", "areas")
"""What a batch computes: the trajectory alone, all loops and areas, or the areas alone."""

COLUMNS = {
    "trajectory": ("kind", "direction", "trajectory"),
    "loops": ("kind", "direction", "trajectory", "inner", "outer", "area"),
    "areas": ("kind", "trajectory_area", "inner_area", "outer_area", "area"),
}
"""The members of a record besides "index", "error", "id", "generatrix" and "directrix"."""


def result_line(index: int, names: Mapping[str, object], sweep: Sweep, what: Quantities) -> bytes:
    """Write what is wanted of a sweep.

    Args:
        index: the number of the pair, from 0.
        names: "id", "generatrix" and "directrix", those that there are.
        sweep: the pair's.
        what: the quantities.

    Returns:
        A line of JSON; its members are "index", the names and COLUMNS of the quantities, all
        numbers but the index and the direction strings that `to_fraction` reads.
    """
    return _line({"index": index, **names, **{c: _value(sweep, c) for c in COLUMNS[what]}})


def error_line(index: int, names: Mapping[str, object], reason: str) -> bytes:
    """Write that a pair is refused; the members are "index", "error" and the names."""
    return _line({"index": index, "error": reason, **names})


def is_record(line: bytes, index: int) -> bool:
    """Tell whether a line is the complete record of a pair."""
    return line.startswith(b'{"index": %d, ' % index) and line.endswith(b"}\n")


def is_error(line: bytes) -> bool:
    """Tell whether a record is that of a refusal."""
    return line.partition(b", ")[2].startswith(b'"error": ')


def _value(sweep: Sweep, column: str) -> object:
    loop, _, area = column.partition("_")
    value: Any = getattr(sweep, loop)
    if isinstance(value, Polygon):
        return value.area if area else value.vertices
    return value


def _line(record: Mapping[str, object]) -> bytes:
    members = (f'"{name}": {_text(name, value)}' for name, value in record.items())
    return f"{{{', '.join(members)}}}\n".encode()


def _text(name: str, value: Any) -> str:
    if name == "direction":
        # Integers as numbers, of whatever length.
        return f"[{', '.join(format_fraction(Fraction(component)) for component in value)}]"
    return json.dumps(value, default=format_fraction)
