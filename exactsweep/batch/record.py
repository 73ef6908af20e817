"""The record of a pair, a JSON line."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, Literal

from exactsweep import NoFitPolygon, Sweep
from exactsweep.batch.rounded import round_values
from exactsweep.formats.decimals import format_decimal
from exactsweep.formats.exact_json import quote_fraction, write_json
from exactsweep.formats.rounding import Rounding
from exactsweep.text.results import direction_to_json

Quantities = Literal["trajectory", "loops", "areas", "nfp"]
QUANTITIES: tuple[Quantities, ...] = ("trajectory", "loops", "areas", "nfp")
"""The computations of a batch: trajectories only, all loops and areas, areas only, or no-fit
polygons with holes and exact fits."""

COLUMNS = {
    "trajectory": ("kind", "direction", "trajectory"),
    "loops": ("kind", "direction", "trajectory", "inner", "outer", "unswept", "area"),
    "areas": ("kind", "trajectory_area", "inner_area", "outer_area", "area"),
    "nfp": ("kind", "exterior", "holes", "exact_fits", "area"),
}
"""The members of a record besides the index, the error and the names; "unswept" only for "SS"."""


def write_result_line(
    index: int,
    names: Mapping[str, object],
    result: Sweep | NoFitPolygon,
    what: Quantities,
    rounding: Rounding | None = None,
) -> bytes:
    """Format the record of a pair: "index", the names, and COLUMNS[what].

    The index and the components of the direction, null for kind "SS", are integers; all other
    numbers are decimals if rounded, else strings that `to_fraction` reads.
    """
    columns = (c for c in COLUMNS[what] if c != "unswept" or result.kind == "SS")
    values = {c: _value(result, c) for c in columns}
    if rounding is not None:
        values = round_values(values, rounding)
    number = format_decimal if rounding else quote_fraction
    return _line({"index": index, **names, **values}, number)


def write_error_line(index: int, names: Mapping[str, object], reason: str) -> bytes:
    """Format the error record of a pair: "index", "error" and the names."""
    return _line({"index": index, "error": reason, **names})


def is_record(line: bytes, index: int) -> bool:
    """Return whether a line is the complete record of a pair."""
    return line.startswith(b'{"index": %d, ' % index) and line.endswith(b"}\n")


def is_error(line: bytes) -> bool:
    """Return whether a record is an error record."""
    return line.partition(b", ")[2].startswith(b'"error": ')


def _value(result: Sweep | NoFitPolygon, column: str) -> object:
    if column.endswith("_area"):
        return getattr(result, column.removesuffix("_area")).area
    value: Any = getattr(result, column)
    return list(value) if column in ("holes", "unswept") else value


def _line(record: Mapping[str, Any], number: Callable[[Fraction], str] = quote_fraction) -> bytes:
    members = [
        f'"{name}": {direction_to_json(v) if name == "direction" else write_json(v, number)}'
        for name, v in record.items()
    ]
    return f"{{{', '.join(members)}}}\n".encode()
