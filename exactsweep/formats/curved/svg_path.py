"""The path data of SVG (SVG 1.1, 8.3): closed outlines of lines, and of curves on request."""

import re
from collections.abc import Callable
from fractions import Fraction
from math import ceil
from typing import NoReturn

from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.curved.curves import (
    chord_arc_center,
    flatten_arc,
    flatten_bezier,
    root_above,
)
from exactsweep.formats.decimals import DECIMAL, read_decimal, required_tolerance
from exactsweep.formats.error import FormatError
from exactsweep.geometry.number import NumberError, quoted
from exactsweep.geometry.point import ORIGIN, Point

_GAP = re.compile(r"[\s,]*")
_NUMBER = re.compile(DECIMAL)
_FLAG = re.compile("[01]")


def read_path(data: str, matrix: Affine, tolerance: Fraction | None) -> list[list[Point]]:
    """Read the outlines that a path draws.

    Args:
        data: the `d` attribute of a path with closed subpaths.
        matrix: the transformation of the path.
        tolerance: how far the lines may be from the curves that they replace; None to refuse
            curves.

    Returns:
        For each subpath, a list of Point, the corners in the order of the path.

    Raises:
        FormatError: not path data, curves without a tolerance, an open subpath;
            the message says at which character.

    Cost: linear in the length of the data and the number of the vertices.
    """
    return _Path(data, matrix, tolerance).outlines()


class _Path:
    """Path data, read from left to right."""

    def __init__(self, data: str, matrix: Affine, tolerance: Fraction | None) -> None:
        self.data, self.matrix, self.tolerance = data, matrix, tolerance
        self.place = 0
        self.command = ""
        self.current = ORIGIN
        # The control point that a smooth curve mirrors, with the command that set it.
        self.control: tuple[str, Point] = ("", ORIGIN)
        # The subpath that is being read: where it starts, before the matrix, and its corners.
        self.start = ORIGIN
        self.points: list[Point] = []

    def outlines(self) -> list[list[Point]]:
        found: list[list[Point]] = []
        closed = False
        while not self._at_end():
            start = self.place
            letter = self.data[start]
            if letter.isalpha():
                self.place += 1
                self.command = letter
                if letter not in "MmLlHhVvZzCcSsQqTtAa":
                    self._refuse(f"{quoted(letter)} is no command", start)
            elif not self.command or self.command in "Zz":
                self._refuse(f"{quoted(self.data[start : start + 20])} instead of a command", start)
            begins = self.command in "Mm"
            if not self.points and not begins:
                self._refuse("the path does not begin with M", start)
            if closed and not begins:
                self._refuse("the path goes on after Z", start)
            if begins:
                if self.points:
                    found.append(self._subpath(closed, start))
                self._segment(start)
                closed = False
            elif self.command in "Zz":
                closed = True
                self.current, self.control = self.start, ("", self.start)
            else:
                self._segment(start)
        if not self.points:
            self._refuse("the path is empty", 0)
        return [*found, self._subpath(closed, len(self.data))]

    def _subpath(self, closed: bool, end: int) -> list[Point]:
        """Take the subpath that ends here."""
        found, self.points = self.points, []
        if not closed and found[0] != found[-1]:
            self._refuse("the path is not closed by Z or by its last vertex", end)
        return found

    def _segment(self, start: int) -> None:
        kind = self.command.upper()
        base = self.current if self.command.islower() else ORIGIN
        before, control = self.current, self.control
        self.control = ("", before)
        if kind in "ML":
            self._line(self._point(base))
            if kind == "M":
                self.start = self.current
            # Further pairs after M are lines.
            self.command = self.command.replace("M", "L").replace("m", "l")
        elif kind == "H":
            self._line(Point(base.x + self._number(), before.y))
        elif kind == "V":
            self._line(Point(before.x, base.y + self._number()))
        elif kind == "A":
            self._arc(base, start)
        else:
            controls = [self._mirrored(control)] if kind in "ST" else []
            while len(controls) < (2 if kind in "CS" else 1):
                controls.append(self._point(base))
            end = self._point(base)
            points = [self.matrix.point(*point) for point in (before, *controls, end)]
            self._curve(end, lambda tolerance: flatten_bezier(points, tolerance), start)
            self.control = ("CS" if kind in "CS" else "QT", controls[-1])

    def _line(self, end: Point) -> None:
        self.current = end
        self.points.append(self.matrix.point(*end))

    def _curve(self, end: Point, flat: Callable[[Fraction], list[Point]], start: int) -> None:
        try:
            found = flat(required_tolerance(self.tolerance))
        except FormatError as error:
            self._refuse(str(error), start)
        self.points += found[1:]
        self.current = end

    def _mirrored(self, control: tuple[str, Point]) -> Point:
        kinds, point = control
        at = self.current
        if self.command.upper() not in kinds:
            return at
        return Point(2 * at.x - point.x, 2 * at.y - point.y)

    def _arc(self, base: Point, start: int) -> None:
        rx, ry, angle = abs(self._number()), abs(self._number()), self._number()
        large, left = self._flag(), self._flag()
        first, last = self.current, self._point(base)
        if rx == 0 or ry == 0 or first == last:
            self._line(last)
            return
        if rx != ry and angle % 90:
            self._refuse("an arc of an ellipse that is turned by no multiple of 90 degrees", start)
        radii = (ry, rx) if angle % 180 == 90 else (rx, ry)
        self._curve(
            last,
            lambda tolerance: elliptic_arc(first, last, radii, large, left, self.matrix, tolerance),
            start,
        )

    def _point(self, base: Point) -> Point:
        x = self._number()
        return Point(base.x + x, base.y + self._number())

    def _number(self) -> Fraction:
        text, start = self._match(_NUMBER, "a number")
        try:
            return read_decimal(text)
        except NumberError as error:
            self._refuse(str(error), start)

    def _flag(self) -> bool:
        return self._match(_FLAG, "a flag, 0 or 1")[0] == "1"

    def _match(self, pattern: re.Pattern[str], what: str) -> tuple[str, int]:
        ended = self._at_end()
        start = self.place
        match = pattern.match(self.data, start)
        if match is None:
            shown = "the end" if ended else quoted(self.data[start : start + 20])
            self._refuse(f"{shown} instead of {what}", start)
        self.place = match.end()
        return match[0], start

    def _at_end(self) -> bool:
        gap = _GAP.match(self.data, self.place)
        assert gap is not None
        self.place = gap.end()
        return self.place == len(self.data)

    def _refuse(self, reason: str, place: int) -> NoReturn:
        raise FormatError(f"path data, character {place + 1}: {reason}")


def elliptic_arc(
    first: Point,
    last: Point,
    radii: tuple[Fraction, Fraction],
    large: bool,
    left: bool,
    matrix: Affine,
    tolerance: Fraction,
) -> list[Point]:
    """Turn an arc of an ellipse with axes along x and y into lines (SVG 1.1, F.6).

    In the plane in which the ellipse is a unit circle, its center is k half chords from the middle
    of the chord, k**2 being rational. Taking k by d too large moves the arc by no more than 2 d,
    for a ray from one end meets both arcs 2 d or less apart.

    Args:
        first: the start of the arc.
        last: its end, another point.
        radii: along x and y; both are enlarged where they are too short for the chord.
        large: whether it is the longer one of the two arcs.
        left: whether it runs counter-clockwise, from x to y.
        matrix: what maps the arc to the result.
        tolerance: how far the lines may be from it.

    Returns:
        list of Point, the images of both ends included.
    """
    rx, ry = radii
    start, end = Point(first.x / rx, first.y / ry), Point(last.x / rx, last.y / ry)
    image = matrix @ Affine(rx, Fraction(0), Fraction(0), ry, Fraction(0), Fraction(0))
    half = ((end.x - start.x) ** 2 + (end.y - start.y) ** 2) / 4
    height = Fraction(0)
    if half < 1:
        stretch = root_above(image.a**2 + image.b**2 + image.c**2 + image.d**2)
        height = root_above((1 - half) / half, ceil(8 * stretch / tolerance))
    if large == left:
        height = -height
    center = chord_arc_center(start, end, height)
    return flatten_arc(center, start, end, left, image, tolerance)
