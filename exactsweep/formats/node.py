"""JSON values with their paths, for error messages."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, NamedTuple, NoReturn

from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import describe_kind, read_number, read_point
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import Point

Data = dict[str, Any]


class JsonNode(NamedTuple):
    """A value from `parse_json` with its JSON path; accessors raise FormatError."""

    value: object
    path: str = "$"

    def has(self, name: str) -> bool:
        return isinstance(self.value, Mapping) and self.value.get(name) is not None

    def __truediv__(self, name: str) -> JsonNode:
        if not isinstance(self.value, Mapping):
            self.fail(f"{describe_kind(self.value)}, not an object")
        if name not in self.value:
            raise FormatError(f"{self.path} has no {quote(name)}")
        return JsonNode(self.value[name], f"{self.path}.{name}")

    def either(self, name: str) -> JsonNode:
        return self / name if self.has(name) else self

    def get(self, name: str, default: object) -> JsonNode:
        return self / name if self.has(name) else JsonNode(default, f"{self.path}.{name}")

    def entries(self, what: str = "a list") -> list[Any]:
        if not isinstance(self.value, list):
            self.fail(f"{describe_kind(self.value)}, not {what}")
        return self.value

    def each(self, what: str = "a list") -> Iterator[JsonNode]:
        for k, entry in enumerate(self.entries(what)):
            yield JsonNode(entry, f"{self.path}[{k}]")

    @property
    def fraction(self) -> Fraction:
        return read_number(self.value, self.path)

    @property
    def number(self) -> str:
        """The value as a number, still text."""
        read_number(self.value, self.path)
        return str(self.value)

    @property
    def whole(self) -> int:
        if self.fraction.denominator != 1:
            self.fail(f"{quote(self.value)}, not a whole number")
        return int(self.fraction)

    @property
    def text(self) -> str:
        if not isinstance(self.value, str):
            self.fail(f"{describe_kind(self.value)}, not a string")
        return self.value

    @property
    def name(self) -> str:
        """A string or a number, as text."""
        if not isinstance(self.value, str):
            self.fail(f"{describe_kind(self.value)}, not a string or a number")
        return self.value

    @property
    def id(self) -> str | None:
        return None if self.value is None else self.name

    @property
    def pair(self) -> list[str]:
        """A list of two numbers, still text."""
        numbers = [entry.number for entry in self.each()]
        if len(numbers) != 2:
            raise FormatError(f"{self.path} has {len(numbers)} coordinates, not 2")
        return numbers

    @property
    def ring(self) -> list[list[str]]:
        return write_ring([read_point(*point) for point in self.each()])

    @property
    def is_true(self) -> bool:
        if not isinstance(self.value, bool):
            self.fail(f"{describe_kind(self.value)}, not true or false")
        return self.value

    def fail(self, reason: str) -> NoReturn:
        raise FormatError(f"{self.path} is {reason}")


def write_ring(points: Sequence[Point]) -> list[list[str]]:
    """Convert points to a Layout JSON ring, without a repeated last point."""
    closed = len(points) > 1 and points[0] == points[-1]
    return [[*map(format_fraction, point)] for point in points[: -1 if closed else None]]


def write_shape(exterior: list[list[str]], holes: Sequence[list[list[str]]]) -> Data:
    return {"exterior": exterior} | ({"holes": [*holes]} if holes else {})


def write_box(left: Fraction, low: Fraction, width: Fraction, height: Fraction) -> list[list[str]]:
    right, top = left + width, low + height
    return write_ring([Point(left, low), Point(right, low), Point(right, top), Point(left, top)])
