"""Reader of WKT (OGC 06-103r4, 7.2), with the SRID prefix of PostGIS."""

import re
from bisect import bisect_right
from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import chain
from typing import NoReturn, TypeVar

from exactsweep.formats.candidate import Candidate, limit_faults
from exactsweep.formats.decimals import DECIMAL, read_decimal
from exactsweep.formats.error import FormatError
from exactsweep.numbers.error import NumberError, quote
from exactsweep.numbers.number import Point
from exactsweep.words import count

_TOKEN = re.compile(
    r"(?P<mark>[(),])|(?:(?P<word>[A-Za-z]++)"
    rf"|(?P<number>{DECIMAL}))(?![^\s(),])"
    r"|(?P<unknown>[^\s(),]++)"
)

# Results contain exact fits as lines and points.
_OTHERS = ("LINESTRING", "POINT")
_SRID = re.compile(r"\s*(?i:SRID)\s*=\s*[0-9]{1,9}\s*;")
_MAX_DEPTH = 32
_ZERO = Fraction(0)
_Enclosed = TypeVar("_Enclosed")


def parse_wkt(text: str, notes: dict[str, None] | None = None) -> list[Candidate]:
    """Read POLYGONs, MULTIPOLYGONs and GEOMETRYCOLLECTIONs; open rings are added to `notes`."""
    reader = _Reader(text)
    found = [*limit_faults(reader.outlines())]
    if reader.opened and notes is not None:
        rings = count(len(reader.opened), "open ring")
        notes[f"{rings} closed, the first at {reader.opened[0]}"] = None
    if not found:
        raise FormatError("contains no polygon")
    return found if len(found) > 1 else [found[0]._replace(place="")]


class _Reader:
    kind: str | None

    def __init__(self, text: str) -> None:
        self.text = text
        srid = _SRID.match(text)
        self.matches = _TOKEN.finditer(text, srid.end() if srid else 0)
        self.lines = [0, *(match.end() for match in re.finditer("\n", text))]
        self.heights: set[Fraction] = set()
        self.opened: list[str] = []
        self._advance()

    def outlines(self) -> Iterator[Candidate]:
        while self.kind != "end":
            yield from self._geometry(0)

    def path(self) -> list[Point]:
        self._skip_name()
        found = self._list(self._point)
        if self.kind != "end":
            self._fail(f"{self._show()} after the end of the path")
        return found

    def _skip_name(self) -> None:
        self._advance()
        if self.word.upper() in ("M", "ZM"):
            self._fail("M coordinates are not supported")
        if self.word.upper() == "Z":
            self._advance()

    def _geometry(self, depth: int) -> Iterator[Candidate]:
        place, kind = self._place(), self.word.upper()
        if kind not in ("POLYGON", "MULTIPOLYGON", "GEOMETRYCOLLECTION", *_OTHERS):
            self._fail(f"expected POLYGON or MULTIPOLYGON, found {self._show()}")
        if depth > _MAX_DEPTH:
            self._fail("nested too deeply")
        self._skip_name()
        if self.word.upper() == "EMPTY":
            yield Candidate.from_error(f"{self._place()}: the polygon is empty")
            self._advance()
        elif kind in _OTHERS:
            self._list(self._point)
            yield Candidate.from_error(f"{place}: {kind} is neither POLYGON nor MULTIPOLYGON")
        elif kind == "POLYGON":
            yield self._polygon()
        elif kind == "MULTIPOLYGON":
            yield from self._list(self._polygon)
        else:
            yield from chain(*self._list(lambda: [*self._geometry(depth + 1)]))

    def _list(self, read: Callable[[], _Enclosed]) -> list[_Enclosed]:
        self._expect("(")
        found = [read()]
        while self.word == ",":
            self._advance()
            found.append(read())
        self._expect(")")
        return found

    def _polygon(self) -> Candidate:
        place = self._place()
        self.heights.clear()
        found = Candidate.of_rings(self._list(self._ring))
        if len(self.heights) > 1:
            raise FormatError(f"{place}: Z varies; only planar polygons are supported")
        return found

    def _ring(self) -> tuple[str, Callable[[], Sequence[Point]]]:
        place = self._place()
        ring = self._list(self._point)
        if ring[0] != ring[-1]:
            self.opened.append(place)
        return place, partial(list, ring)

    def _point(self) -> Point:
        point = Point(self._number(), self._number())
        self.heights.add(self._number() if self.kind == "number" else _ZERO)
        return point

    def _number(self) -> Fraction:
        if self.kind != "number":
            self._fail(f"expected a number, found {self._show()}")
        try:
            value = read_decimal(self.word)
        except NumberError as error:
            self._fail(str(error))
        self._advance()
        return value

    def _expect(self, mark: str) -> None:
        if self.word != mark:
            self._fail(f"expected '{mark}', found {self._show()}")
        self._advance()

    def _advance(self) -> None:
        match = next(self.matches, None)
        if match is None:
            self.kind, self.word, self.offset = "end", "", len(self.text)
        else:
            self.kind, self.word, self.offset = match.lastgroup, match[0], match.start()

    def _show(self) -> str:
        return "the end of the text" if self.kind == "end" else quote(self.word)

    def _place(self) -> str:
        line = bisect_right(self.lines, self.offset)
        return f"line {line}, column {self.offset - self.lines[line - 1] + 1}"

    def _fail(self, reason: str) -> NoReturn:
        raise FormatError(f"{self._place()}: {reason}")


def parse_wkt_path(text: str) -> list[Point] | None:
    reader = _Reader(text)
    if reader.kind != "word" or reader.word.upper() not in _OTHERS:
        return None
    return reader.path()
