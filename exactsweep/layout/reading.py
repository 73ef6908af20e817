"""Readers of plain JSON data; error messages name the field."""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import TypeVar

from exactsweep.geometry.reading import read_point
from exactsweep.geometry.turn import Turn
from exactsweep.geometry.turn import read_turn as make_turn
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.error import ExactSweepError, NumberError, quote
from exactsweep.numbers.number import Loop, Point, to_fraction

_Value = TypeVar("_Value")


class LayoutError(ExactSweepError):
    """Invalid layout data; the message names the part or placement, and the field."""


def read_object(
    data: object, path: str, needed: Sequence[str], others: Sequence[str]
) -> Mapping[str, object]:
    """Require an object that has all required fields and no unknown ones."""
    if not isinstance(data, Mapping):
        raise LayoutError(f"{path} is {quote(data)}, not an object")
    for name in needed:
        if name not in data:
            raise LayoutError(f'{path} has no "{name}"')
    for name in data:
        if name not in needed and name not in others:
            known = ", ".join([*needed, *others])
            raise LayoutError(f"{path} has an unknown field {quote(name)}; known fields: {known}")
    return data


def read_list(data: object, path: str, read: Callable[[object, str], _Value]) -> tuple[_Value, ...]:
    if not isinstance(data, list | tuple):
        raise LayoutError(f"{path} is {quote(data)}, not a list")
    return tuple(read(one, f"{path}[{k}]") for k, one in enumerate(data))


def read_rings(data: Mapping[str, object], path: str) -> tuple[Loop, tuple[Loop, ...]]:
    exterior = read_ring(data["exterior"], f"{path}.exterior")
    return exterior, read_list(data.get("holes", ()), f"{path}.holes", read_ring)


def read_ring(data: object, path: str) -> Loop:
    return read_list(data, path, read_vertex)


def read_vertex(data: object, path: str) -> Point:
    try:
        return read_point(data, path)  # type: ignore[arg-type]
    except ExactSweepError as error:
        raise LayoutError(str(error)) from None


def read_number(data: object, path: str) -> Fraction:
    try:
        return to_fraction(data)
    except NumberError as error:
        raise LayoutError(f"{path}: {error}") from None


def read_gap(data: object, path: str) -> Fraction:
    found = read_number(data, path)
    if found < 0:
        raise LayoutError(f"{path} is negative: {abridge(found)}")
    return found


def read_turn(data: object, path: str) -> Turn:
    """Read an angle in degrees, or its exact cosine and sine."""
    if isinstance(data, list | tuple):
        cosine, sine = read_vertex(data, path)
        if cosine * cosine + sine * sine != 1:
            raise LayoutError(
                f"{path}: ({abridge(cosine)}, {abridge(sine)}) is not a cosine and a sine: "
                "the squares do not add up to 1"
            )
        return make_turn((cosine, sine))
    return make_turn(read_number(data, path))


def read_id(data: object, path: str) -> str:
    if not isinstance(data, str):
        raise LayoutError(f"{path} is {quote(data)}, not a string")
    return data


def read_flag(data: object, path: str) -> bool | None:
    if data is not None and not isinstance(data, bool):
        raise LayoutError(f"{path} is {quote(data)}, not true or false")
    return data
