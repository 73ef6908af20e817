"""The path data of SVG (SVG 1.1, 8.3): closed outlines of lines, and of curves on request."""

import re
from collections.abc import Callable
from fractions import Fraction
from math import ceil
from typing import NoReturn

from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.curved.arc import make_rotation
from exactsweep.formats.curved.curves import (
    bound_root,
    find_arc_center,
    flatten_arc,
    flatten_bezier,
    place_points,
)
from exactsweep.formats.decimals import DECIMAL, read_decimal
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.numbers.number import NumberError, quote
from exactsweep.numbers.point import ORIGIN, Point

_GAP = re.compile(r"[\s,]*")
_NUMBER = re.compile(DECIMAL)
_FLAG = re.compile("[01]")


def read_path(data: str, matrix: Affine, reading: Reading) -> list[list[Point]]:
    """Read the lines that a path draws.

    Args:
        data: the `d` attribute of a path.
        matrix: the transformation of the path.
        reading: has the tolerance of curves.

    Returns:
        For each subpath, a list of Point in the order of the path; the first one is repeated at the
        end where the subpath is closed.

    Raises:
        FormatError: not path data, curves without a tolerance; the message says at which character.
            More vertices than are read.

    Cost: linear in the length of the data and the number of the vertices.
    """
    return _Path(data, matrix, reading).lines()


class _Path:
    """Path data, read from left to right."""

    def __init__(self, data: str, matrix: Affine, reading: Reading) -> None:
        self.data, self.matrix, self.reading = data, matrix, reading
        self.place = 0
        self.command = ""
        self.current = ORIGIN
        # The control point that a smooth curve mirrors, with the command that set it.
        self.control: tuple[str, Point] = ("", ORIGIN)
        # The subpath that is being read: where it starts, before the matrix, and its corners.
        self.start = ORIGIN
        self.points: list[Point] = []

    def lines(self) -> list[list[Point]]:
        found: list[list[Point]] = []
        while not self._at_end():
            start = self.place
            letter = self.data[start]
            if letter.isalpha():
                self.place += 1
                self.command = letter
                if letter not in "MmLlHhVvZzCcSsQqTtAa":
                    self._refuse(f"{quote(letter)} is no command", start)
            elif not self.command or self.command in "Zz":
                self._refuse(f"{quote(self.data[start : start + 20])} instead of a command", start)
            if self.command in "Mm":
                found.append(self.points)
                self.points = []
                self._segment(start)
            elif not self.points and not found:
                self._refuse("the path does not begin with M", start)
            elif self.command in "Zz":
                self._close()
            else:
                if not self.points:
                    # After Z, the next subpath begins where the last one did.
                    self._line(self.current)
                self._segment(start)
            if self.command in "Zz":
                found.append(self.points)
                self.points = []
        found = [line for line in [*found, self.points] if line]
        if not found:
            self._refuse("the path is empty", 0)
        return found

    def _close(self) -> None:
        self.reading.allow_vertices(1)
        self.points += self.points[:1]
        self.current, self.control = self.start, ("", self.start)

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
            controls = [self._mirror(control)] if kind in "ST" else []
            while len(controls) < (2 if kind in "CS" else 1):
                controls.append(self._point(base))
            end = self._point(base)
            points = [before, *controls, end]
            self._curve(end, lambda: flatten_bezier(points, self.matrix, self.reading), start)
            self.control = ("CS" if kind in "CS" else "QT", controls[-1])

    def _line(self, end: Point) -> None:
        self.reading.allow_vertices(1)
        self.current = end
        if self.matrix.off:
            self.points += place_points([end], self.matrix, self.reading)
        else:
            self.points.append(self.matrix.point(*end))

    def _curve(self, end: Point, flat: Callable[[], list[Point]], start: int) -> None:
        try:
            found = flat()
        except FormatError as error:
            self._refuse(str(error), start)
        self.reading.allow_vertices(len(found))
        self.points += found[1:]
        self.current = end

    def _mirror(self, control: tuple[str, Point]) -> Point:
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
        self._curve(
            last,
            lambda: flatten_elliptic_arc(
                (first, last),
                (rx, ry),
                angle if rx != ry else Fraction(0),
                (large, left),
                self.matrix,
                self.reading,
            ),
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
            shown = "the end" if ended else quote(self.data[start : start + 20])
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


def flatten_elliptic_arc(
    ends: tuple[Point, Point],
    radii: tuple[Fraction, Fraction],
    angle: Fraction,
    flags: tuple[bool, bool],
    matrix: Affine,
    reading: Reading,
) -> list[Point]:
    """Turn an arc of an ellipse into lines (SVG 1.1, F.6).

    In the plane in which the ellipse is a unit circle, its center is k half chords from the middle
    of the chord, k**2 being rational. Taking k by d too large moves the arc by no more than 2 d,
    for a ray from one end meets both arcs 2 d or less apart. An irrational angle is replaced by one
    whose sine and cosine are rational, so that turning back and forth leaves the ends where they
    are.

    Args:
        ends: the start of the arc and its end, another point.
        radii: along the axes; both are enlarged where they are too short for the chord.
        angle: from x to the first axis, in degrees.
        flags: whether it is the longer one of the two arcs, and whether it runs counter-clockwise,
            from x to y.
        matrix: what maps the arc to the result.
        reading: has the tolerance, how far the lines may be from it.

    Returns:
        list of Point, the images of both ends included.
    """
    (rx, ry), (large, left) = radii, flags
    # Half a chord's height is a root, so that it is as good as the root of the angle's error.
    turn = make_rotation(angle, reading, power=2)
    # The inverse of a rotation has the same sine, negative.
    back = turn._replace(b=-turn.b, c=-turn.c)
    start, end = (Point(x / rx, y / ry) for x, y in (back.vector(*point) for point in ends))
    zero = Fraction(0)
    image = matrix @ turn._replace(off=zero) @ Affine(rx, zero, zero, ry, zero, zero)
    half = ((end.x - start.x) ** 2 + (end.y - start.y) ** 2) / 4
    height = zero
    if half < 1:
        stretch = bound_root(image.a**2 + image.b**2 + image.c**2 + image.d**2)
        allowed = reading.allow_curve()
        height = bound_root((1 - half) / half, ceil(8 * stretch / allowed))
    if large == left:
        height = -height
    center = find_arc_center(start, end, height)
    return flatten_arc(center, start, end, left, image, reading)
