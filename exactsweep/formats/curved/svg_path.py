"""Path data of SVG (SVG 1.1, 8.3)."""

import re
from contextlib import suppress
from fractions import Fraction
from itertools import accumulate
from typing import NoReturn

from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.curved.arc import make_rotation
from exactsweep.formats.curved.curves import (
    Arc,
    Curve,
    bound_root,
    find_arc_center,
    make_bezier,
    make_round_arc,
)
from exactsweep.formats.curved.path import Path, place_points
from exactsweep.formats.decimals import DECIMAL, read_decimal, read_points
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.geometry.reading import to_lattice
from exactsweep.numbers.error import NumberError, quote
from exactsweep.numbers.number import ORIGIN, Point, divide_all, make_points

_GAP = re.compile(r"[\s,]*")
_NUMBER = re.compile(rf"[\s,]*({DECIMAL})")
# Runs of pairs of lines, optionally with the command between them; bounded, so that vertices are
# counted in time.
_PAIR = rf"[\s,]*+{DECIMAL}[\s,]*+{DECIMAL}"
_LINES = {letter: re.compile(rf"(?:[\s,]*+{letter}?+{_PAIR}){{1,4096}}+") for letter in "Ll"}
# The height of an arc is rounded to a multiple of 1 / _HEIGHTS.
_HEIGHTS = 10**40
_FLAG = re.compile(r"[\s,]*([01])")
# The arguments of each command: coordinates, numbers, and flags.
_ARGUMENTS = {"M": "", "L": "", "H": "x", "V": "y", "C": "xyxyxy", "S": "xyxy"}
_ARGUMENTS |= {"Q": "xyxy", "T": "xy", "A": "nnnffxy", "Z": ""}


def read_path(data: str, matrix: Affine, reading: Reading) -> list[Path]:
    """Read path data as a Path for each subpath.

    Args:
        data: the `d` attribute.
        matrix: the transformation of the path.
        reading: counts vertices.

    Raises:
        FormatError: not path data, with the character; or too many vertices.
    """
    return _PathData(data, matrix, reading).lines()


class _PathData:
    def __init__(self, data: str, matrix: Affine, reading: Reading) -> None:
        self.data, self.matrix, self.reading = data, matrix, reading
        self.place = 0
        self.command = ""
        self.current = ORIGIN
        # The control point that a smooth curve mirrors, with the commands that may mirror it.
        self.control: tuple[str, Point] = ("", ORIGIN)
        # The start of the current subpath, before the matrix, and all subpaths.
        self.start = ORIGIN
        self.found: list[Path] = []

    def lines(self) -> list[Path]:
        while not self._at_end():
            start = self.place
            letter = self.data[start]
            if letter.isalpha():
                self.place += 1
                self.command = letter
                if letter.upper() not in _ARGUMENTS:
                    self._refuse(f"{quote(letter)} is not a path command", start)
            elif self.command in ("", *"Zz"):
                self._refuse(
                    f"expected a command, found {quote(self.data[start : start + 20])}", start
                )
            kind = self.command.upper()
            if kind == "M":
                self._begin()
            elif not self.found:
                self._refuse("the path does not begin with M", start)
            elif not self.found[-1].points and kind != "Z":
                # After Z, the next subpath begins where the last one did.
                self._add([self.current])
            self._draw(kind, start)
        found = [line for line in self.found if line.points]
        if not found:
            self._refuse("the path is empty", 0)
        return found

    def _draw(self, kind: str, start: int) -> None:
        """Read the arguments of a command and draw it; draw a run of lines in one batch."""
        before, (kinds, control) = self.current, self.control
        if kind in "ML":
            self._draw_lines(kind)
            return
        values = [self._argument(sort) for sort in _ARGUMENTS[kind]]
        points = [Point(*pair) for pair in zip(values[::2], values[1::2], strict=False)]
        self.control = ("", before)
        if kind == "Z":
            self.reading.allow_vertices(1)
            self.found[-1].points += self.found[-1].points[:1]
            self._begin()
            self.current = self.start
        elif kind == "H":
            self._add([Point(values[0], before.y)])
        elif kind == "V":
            self._add([Point(before.x, values[0])])
        elif kind == "A":
            rx, ry, angle, large, left = values[:5]
            end = Point(*values[5:])
            if rx and ry and end != before:
                angle = angle if abs(rx) != abs(ry) else Fraction(0)
                shape = (abs(rx), abs(ry)), angle, (bool(large), bool(left))
                arc = make_elliptic_arc((before, end), *shape, self.matrix)
                # No point of the arc is farther from its ends than this.
                room = 2 * (abs(rx) + abs(ry) + abs(end.x - before.x) + abs(end.y - before.y))
                self._curve(arc, end, [Point(abs(x) + room, y) for x, y in (before, end)])
            else:
                self._add([end])
        else:
            if kind in "ST":
                smooth = Point(2 * before.x - control.x, 2 * before.y - control.y)
                points.insert(0, smooth if kind in kinds else before)
            controls = [before, *points]
            curve = make_bezier(tuple(place_points(controls, self.matrix)))
            if any(point != before for point in points):
                self._curve(curve, points[-1], controls)
            else:
                self._add([before])
            self.control = ("CS" if kind in "CS" else "QT", points[-2])

    def _draw_lines(self, kind: str) -> None:
        # Further pairs after M are lines.
        self.command = "L" if self.command.isupper() else "l"
        ends = self._read_pairs(self.command)
        if self.command == "l":
            scale, steps = to_lattice(*zip(self.current, *ends, strict=True))
            columns = (accumulate(column) for column in zip(*steps, strict=True))
            ends = make_points(*(divide_all(column, scale) for column in columns))[1:]
        if kind == "M":
            self.start = ends[0]
        self._add(ends)
        self.control = ("", ORIGIN)

    def _read_pairs(self, letter: str) -> list[Point]:
        run = _LINES[letter].match(self.data, self.place)
        if run:
            with suppress(NumberError):
                points = read_points(run[0].replace(letter, " "))
                self.place = run.end()
                return points
            self.data = self.data.replace(letter, " ")
        # A number is missing or too long.
        while True:
            self._argument("n")

    def _begin(self) -> None:
        self.found.append(Path())

    def _add(self, ends: list[Point]) -> None:
        self.reading.allow_vertices(len(ends))
        self.current = ends[-1]
        path = self.found[-1]
        path.points += place_points(ends, self.matrix)
        self._let_off(ends)

    def _curve(self, drawn: tuple[Curve, bool], end: Point, around: list[Point]) -> None:
        """Add a curve in the hull of some points."""
        curve, forward = drawn
        self.reading.allow_vertices(1)
        self.current = end
        (placed,) = place_points([end], self.matrix)
        self.found[-1].add_curve(curve, placed, forward=forward)
        self._let_off(around)

    def _let_off(self, points: list[Point]) -> None:
        if self.matrix.off:
            self.found[-1].off = max(self.found[-1].off, self.matrix.error(points))

    def _argument(self, sort: str) -> Fraction:
        """Read a number; of a small letter, relative to the current point."""
        if sort == "f":
            return Fraction(self._match(_FLAG, "a flag, 0 or 1")[0])
        text, start = self._match(_NUMBER, "a number")
        try:
            value = read_decimal(text)
        except NumberError as error:
            self._refuse(str(error), start)
        if sort == "n" or self.command.isupper():
            return value
        return value + self.current["xy".index(sort)]

    def _match(self, pattern: re.Pattern[str], what: str) -> tuple[str, int]:
        match = pattern.match(self.data, self.place)
        if match is None:
            shown = "the end" if self._at_end() else quote(self.data[self.place : self.place + 20])
            self._refuse(f"expected {what}, found {shown}", self.place)
        self.place = match.end()
        return match[1], match.start(1)

    def _at_end(self) -> bool:
        gap = _GAP.match(self.data, self.place)
        assert gap is not None
        self.place = gap.end()
        return self.place == len(self.data)

    def _refuse(self, reason: str, place: int) -> NoReturn:
        raise FormatError(f"path data, character {place + 1}: {reason}")


def make_elliptic_arc(
    ends: tuple[Point, Point],
    radii: tuple[Fraction, Fraction],
    angle: Fraction,
    flags: tuple[bool, bool],
    matrix: Affine,
) -> tuple[Arc, bool]:
    """Make an elliptical arc (SVG 1.1, F.6).

    In the plane in which the ellipse is a unit circle, the center is k half chords from the middle
    of the chord, with rational k**2. An error d of k moves the arc by at most 2 d, because a ray
    from one end meets both arcs at most 2 d apart. An irrational angle is replaced by one with
    rational sine and cosine, so that rotating back and forth preserves the ends.

    Args:
        ends: the start of the arc and its end, another point.
        radii: along the axes; both are enlarged where they are too short for the chord.
        angle: from x to the first axis, in degrees.
        flags: whether it is the longer one of the two arcs, and whether it runs from x to y.
        matrix: the map from the arc to the result.

    Returns:
        The Arc, and whether it runs from the start to the end.
    """
    (rx, ry), (large, left) = radii, flags
    # The height is a root, so its error is the root of that of the angle.
    turn = make_rotation(angle, power=2)
    back = turn._replace(b=-turn.b, c=-turn.c)
    start, end = (Point(x / rx, y / ry) for x, y in (back.vector(*point) for point in ends))
    zero = Fraction(0)
    image = matrix @ turn._replace(off=zero) @ Affine(rx, zero, zero, ry, zero, zero)
    half = ((end.x - start.x) ** 2 + (end.y - start.y) ** 2) / 4
    height = bound_root(max(1 - half, zero) / half, _HEIGHTS)
    if large == left:
        height = -height
    center = find_arc_center(start, end, height)
    return make_round_arc(center, start, end, image, left=left)
