"""WKT (OGC 06-103r4, 7.2): POLYGON with one ring in, POLYGONs out."""

import re
from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple, NoReturn

from exactsweep.formats.error import FormatError
from exactsweep.number import NumberError, format_fraction, quoted, to_fraction
from exactsweep.polygon import Point, Polygon, abridged
from exactsweep.sweep import Sweep

# Possessive, so that a long number with a letter at its end is not tried again for each digit.
_TOKEN = re.compile(
    r"(?P<mark>[(),])|(?:(?P<word>[A-Za-z]++)"
    r"|(?P<number>[+-]?(?:[0-9]++\.?+[0-9]*+|\.[0-9]++)(?:[eE][+-]?[0-9]++)?+))(?![^\s(),])"
    r"|(?P<unknown>[^\s(),]++)"
)
_NUMBER = re.compile(r"(-?)\+?0*([0-9]*)(?:\.([0-9]*))?(.*)")


class _Token(NamedTuple):
    kind: str
    text: str
    offset: int


def parse_wkt(text: str) -> list[Point]:
    """Read the outer ring of a WKT polygon.

    Args:
        text: `POLYGON ((x y, ...))`, in upper or lower case; numbers as WKT has them: `-1.5e3`,
            and `+1`, `.5`, `5.` and `007` as well.

    Returns:
        list of Point, the first one repeated at the end.

    Raises:
        FormatError: other geometries, inner rings (holes), Z or M coordinates, a ring that is not
            closed, whatever is not WKT; the message starts with line and column.

    Cost: linear in the length of the text.

    Example:
        >>> len(parse_wkt("POLYGON ((0 0, 1 0, .5 1e2, 0 0))"))
        4
    """
    return _Reader(text).polygon()


def sweep_to_wkt(sweep: Sweep) -> str:
    """Write the loops of a sweep as three lines of WKT: trajectory, inner loop, outer loop.

    Args:
        sweep: a Sweep.

    Returns:
        Three POLYGONs, a line each, in exact decimals.

    Raises:
        FormatError: a coordinate is not a finite decimal, such as 1/3, which WKT cannot hold.

    Cost: linear in the length of the result, times the cost of a division of that length.
    """
    loops = {"trajectory": sweep.trajectory, "inner loop": sweep.inner, "outer loop": sweep.outer}
    return "".join(f"{_polygon(loop, name)}\n" for name, loop in loops.items())


class _Reader:
    """A WKT polygon, read from left to right."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.tokens = self._tokens()
        self.token = next(self.tokens)

    def polygon(self) -> list[Point]:
        if self.token.text.upper() != "POLYGON":
            self._refuse(f"{self._shown()} is not POLYGON")
        self._advance()
        if self.token.text.upper() in ("Z", "M", "ZM"):
            self._refuse("Z and M coordinates cannot be swept")
        if self.token.text.upper() == "EMPTY":
            self._refuse("the polygon is empty")
        self._expect("(")
        start = self.token
        self._expect("(")
        ring = [self._point()]
        while self.token.text == ",":
            self._advance()
            ring.append(self._point())
        self._expect(")")
        if self.token.text == ",":
            self._refuse("an inner ring: polygons with holes cannot be swept")
        self._expect(")")
        if self.token.kind != "end":
            self._refuse(f"{self._shown()} after the end of the polygon")
        if ring[0] != ring[-1]:
            self.token = start
            self._refuse("the ring is not closed: its last vertex must repeat the first")
        return ring

    def _point(self) -> Point:
        point = Point(self._number(), self._number())
        if self.token.kind == "number":
            self._refuse("a third coordinate: Z and M coordinates cannot be swept")
        return point

    def _number(self) -> Fraction:
        if self.token.kind != "number":
            self._refuse(f"{self._shown()} instead of a number")
        try:
            value = to_fraction(_standard(self.token.text))
        except NumberError as error:
            self._refuse(str(error))
        self._advance()
        return value

    def _expect(self, mark: str) -> None:
        if self.token.text != mark:
            self._refuse(f"{self._shown()} instead of '{mark}'")
        self._advance()

    def _advance(self) -> None:
        self.token = next(self.tokens)

    def _tokens(self) -> Iterator[_Token]:
        for match in _TOKEN.finditer(self.text):
            yield _Token(match.lastgroup or "", match[0], match.start())
        yield _Token("end", "", len(self.text))

    def _shown(self) -> str:
        return "the end" if self.token.kind == "end" else quoted(self.token.text)

    def _refuse(self, reason: str) -> NoReturn:
        before = self.text[: self.token.offset]
        line, column = before.count("\n") + 1, len(before) - before.rfind("\n")
        raise FormatError(f"line {line}, column {column}: {reason}")


def _standard(number: str) -> str:
    """Bring a WKT number into the grammar of `to_fraction`.

    >>> [_standard(number) for number in ("+1", "-.5", "5.", "007", "1e+2")]
    ['1', '-0.5', '5', '7', '1e+2']
    """
    match = _NUMBER.fullmatch(number)
    assert match is not None
    sign, whole, decimals, exponent = match.groups()
    return f"{sign}{whole or '0'}{'.' if decimals else ''}{decimals or ''}{exponent}"


def _polygon(polygon: Polygon, name: str) -> str:
    vertices = [
        " ".join(_decimal(coordinate, f"{name}, vertex {k}") for coordinate in vertex)
        for k, vertex in enumerate(polygon.vertices)
    ]
    return f"POLYGON (({', '.join([*vertices, vertices[0]])}))"


def _decimal(value: Fraction, place: str) -> str:
    """Write a number as a decimal, exactly."""
    if value.denominator == 1:
        return format_fraction(value)
    # A divisor of any power of ten divides this one: no prime's exponent is above log2.
    places = value.denominator.bit_length()
    scaled = value * 10**places
    if scaled.denominator != 1:
        raise FormatError(
            f"{place}: {abridged(value)} is not a finite decimal, which is all that WKT can hold"
        )
    digits = format_fraction(abs(scaled)).zfill(places + 1)
    sign = "-" if value < 0 else ""
    return f"{sign}{digits[:-places]}.{digits[-places:].rstrip('0')}"
