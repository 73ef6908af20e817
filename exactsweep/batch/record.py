"""The record of a pair, a JSON line."""

from collections.abc import Callable, Mapping
from fractions import Fraction
from typing import Any, Literal

from exactsweep import NoFitPolygon, Sweep
from exactsweep.formats.decimals import format_decimal
from exactsweep.formats.exact_json import quote_fraction, write_json
from exactsweep.formats.rounding import Rounding, Side, round_fits, round_region
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.text.results import direction_to_json

Quantities = Literal["trajectory", "loops", "areas", "nfp"]
QUANTITIES: tuple[Quantities, ...] = ("trajectory", "loops", "areas", "nfp")

# The columns of a record besides the index, the error and the names; "unswept" only for "SS".
COLUMNS = {
    "trajectory": ("kind", "direction", "trajectory"),
    "loops": ("kind", "direction", "trajectory", "inner", "outer", "unswept", "area"),
    "areas": ("kind", "trajectory_area", "inner_area", "outer_area", "area"),
    "nfp": ("kind", "exterior", "holes", "exact_fits", "area"),
}


def write_result_line(
    index: int,
    names: Mapping[str, object],
    result: Sweep | NoFitPolygon,
    what: Quantities,
    rounding: Rounding | None = None,
) -> bytes:
    """Format the record of a pair: "index", the names, and COLUMNS[what].

    The index and the components of the direction, null for kind "SS", are integers; all other
    numbers are decimals if rounded, else strings for `to_fraction`.
    """
    columns = (c for c in COLUMNS[what] if c != "unswept" or result.kind == "SS")
    values = {c: _value(result, c) for c in columns}
    if rounding is not None:
        values = round_values(values, rounding)
    number = format_decimal if rounding else quote_fraction
    return _line({"index": index, **names, **values}, number)


def write_error_line(index: int, names: Mapping[str, object], reason: str) -> bytes:
    return _line({"index": index, "error": reason, **names})


def is_record(line: bytes, index: int) -> bool:
    """Return whether a line is the complete record of a pair."""
    return line.startswith(b'{"index": %d, ' % index) and line.endswith(b"}\n")


def is_error(line: bytes) -> bool:
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


def round_values(values: Mapping[str, Any], rounding: Rounding) -> dict[str, Any]:
    """Round the columns of a record; areas refer to the exact loops.

    For outward rounding, the trajectory, the outer loop and the exterior grow, all other loops
    shrink or vanish, and exact fits that would move are dropped.
    """
    places, outward = rounding

    def round_loop(loop: Polygon, side: Side) -> Polygon | None:
        region = round_region(Region(loop), places, side if outward else "closest").region
        return None if region is None else region.exterior

    found = dict(values)
    for name, value in values.items():
        if isinstance(value, Fraction):
            found[name] = round(value, places)
        elif name == "exact_fits":
            found[name], _ = round_fits(value, rounding)
        elif isinstance(value, Polygon):
            found[name] = round_loop(value, "inward" if name == "inner" else "outward")
        elif name in ("holes", "unswept"):
            loops = (round_loop(loop, "inward") for loop in value)
            found[name] = [loop for loop in loops if loop is not None]
    return found
