"""Path data (SVG 1.1, 8.3)."""

import re
from collections.abc import Sequence
from fractions import Fraction
from itertools import accumulate
from typing import NoReturn

from exactsweep.formats.curved import curves
from exactsweep.formats.curved.affine import Affine
from exactsweep.formats.curved.arc import make_rotation
from exactsweep.formats.curved.path import Path, map_points
from exactsweep.formats.decimals import DECIMAL, count_decimals, read_decimal, read_decimals
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.numbers.error import NumberError, quote
from exactsweep.numbers.number import ORIGIN, Point

_NUMBER = rf"[\s,]*+({DECIMAL})"
# The flags of an arc need no separators.
_ARC = _NUMBER * 3 + r"[\s,]*+([01])" * 2 + _NUMBER * 2
_RUN = re.compile(
    rf"(?P<letter>[A-Za-z])(?P<numbers>(?<=[Aa])(?:{_ARC})*+|(?<![Aa])(?:{_NUMBER})*+)[\s,]*+"
)
# Numbers per command.
_SIZES = {"M": 2, "L": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "T": 2, "A": 7, "Z": 0}
_WANTED = {0: "no number", 1: "numbers", 7: "7 numbers, the flags 0 or 1, or a multiple,"}
_BEZIERS = "CSQT"
_HEIGHTS = 10**40  # the height of an arc is rounded to a multiple of 1 / _HEIGHTS


def read_path(data: str, matrix: Affine, reading: Reading) -> list[Path]:
    drawn = Subpaths(matrix, reading)
    place = len(data) - len(data.lstrip(" \t\r\n\f,"))
    while place < len(data):
        match = _RUN.match(data, place)
        if match is None:
            _fail(f"expected a command, found {quote(data[place : place + 20])}", place)
        letter, numbers = match["letter"], match["numbers"]
        size = _SIZES.get(letter.upper())
        if size is None:
            _fail(f"{quote(letter)} is not a path command", place)
        if not drawn.found and letter not in "Mm":
            _fail("the path does not begin with M", place)
        count = count_decimals(numbers)
        reading.charge_vertices(count // size if size else 1)
        # The flags of an arc may run together, so its numbers cannot be counted.
        if (size and letter not in "Aa" and count % size) or bool(size) != bool(count):
            after = quote(data[place + 1 : place + 21]) if data[place + 1 :] else "the end"
            several = _WANTED.get(size, f"{size} numbers, or a multiple,")
            _fail(f"expected {several} after {letter}, found {after}", place)
        try:
            if letter in "Aa":
                drawn.draw(letter, [[*map(read_decimal, arc)] for arc in re.findall(_ARC, numbers)])
            else:
                values = read_decimals(numbers)
                drawn.draw(letter, [values[k : k + size] for k in range(0, count, size or 1)])
        except (FormatError, NumberError) as error:
            _fail(str(error), place)
        place = match.end()
    found = [path for path in drawn.found if path.points]
    if not found:
        _fail("the path is empty", 0)
    return found


def _fail(reason: str, place: int) -> NoReturn:
    raise FormatError(f"path data, character {place + 1}: {reason}")


class Subpaths:
    def __init__(self, matrix: Affine, reading: Reading) -> None:
        self.matrix, self.reading = matrix, reading
        self.current = self.start = ORIGIN
        # The control point that a smooth curve reflects, and the commands that may do so.
        self.control: tuple[str, Point] = ("", ORIGIN)
        self.found: list[Path] = []

    def draw(self, letter: str, rows: Sequence[Sequence[Fraction]]) -> None:
        """Draw a command with rows of numbers, relative if the letter is lowercase."""
        kind, is_relative = letter.upper(), letter.islower()
        if kind not in _BEZIERS:
            self.control = ("", ORIGIN)
        if kind == "Z":
            self.found[-1].points += self.found[-1].points[:1]
            self.current = self.start
        if kind in "MZ":
            self.found.append(Path())
        elif not self.found[-1].points:
            # After Z, the next subpath begins at the start of the last one.
            self._add([self.current])
        if kind in "ML":
            ends = [*map(Point, *zip(*rows, strict=True))]
            if is_relative:
                ends = [*accumulate(ends, _add, initial=self.current)][1:]
            # Further pairs after M are lines.
            self.start = ends[0] if kind == "M" else self.start
            self._add(ends)
            return
        for row in rows:
            x, y = self.current
            origin = self.current if is_relative else ORIGIN
            if kind == "H":
                self._add([Point(origin.x + row[0], y)])
            elif kind == "V":
                self._add([Point(x, origin.y + row[0])])
            elif kind == "A":
                self._draw_arc(row, _add(origin, Point(*row[5:])))
            elif kind in _BEZIERS:
                points = [*map(Point, row[::2], row[1::2])]
                self._draw_bezier(kind, [_add(origin, point) for point in points])

    def _draw_arc(self, row: Sequence[Fraction], end: Point) -> None:
        before, rx, ry = self.current, abs(row[0]), abs(row[1])
        if not rx or not ry or end == before:
            self._add([end])
            return
        angle = row[2] if rx != ry else Fraction(0)
        flags = bool(row[3]), bool(row[4])
        arc = make_elliptic_arc((before, end), (rx, ry), angle, flags, self.matrix)
        # A bound on the distance of the arc from its ends.
        margin = 2 * (rx + ry + abs(end.x - before.x) + abs(end.y - before.y))
        self._curve(arc, end, [Point(abs(x) + margin, y) for x, y in (before, end)])

    def _draw_bezier(self, kind: str, points: list[Point]) -> None:
        before, (known, control) = self.current, self.control
        if kind in "ST":
            smooth = Point(2 * before.x - control.x, 2 * before.y - control.y)
            points.insert(0, smooth if kind in known else before)
        self.control = ("CS" if kind in "CS" else "QT", points[-2])
        controls = [before, *points]
        if all(point == before for point in points):
            self._add([before])
        else:
            curve = curves.make_bezier(tuple(map_points(controls, self.matrix)))
            self._curve(curve, points[-1], controls)

    def _add(self, ends: list[Point]) -> None:
        self.current = ends[-1]
        self.found[-1].points += map_points(ends, self.matrix)
        self._add_error(ends)

    def _curve(self, drawn: tuple[curves.Curve, bool], end: Point, around: list[Point]) -> None:
        """Append a curve inside the convex hull of `around`."""
        curve, forward = drawn
        self.current = end
        (placed,) = map_points([end], self.matrix)
        self.found[-1].add_curve(curve, placed, forward=forward)
        self._add_error(around)

    def _add_error(self, points: list[Point]) -> None:
        if self.matrix.error:
            self.found[-1].error = max(self.found[-1].error, self.matrix.bound_error(points))


def _add(p: Point, q: Point) -> Point:
    return Point(p.x + q.x, p.y + q.y)


def make_elliptic_arc(
    ends: tuple[Point, Point],
    radii: tuple[Fraction, Fraction],
    angle: Fraction,
    flags: tuple[bool, bool],
    matrix: Affine,
) -> tuple[curves.Arc, bool]:
    """Return an elliptical arc (SVG 1.1, F.6), and whether it runs from start to end.

    After scaling the ellipse to a unit circle, the center is k half chords from the midpoint of the
    chord, with rational k**2. An error d in k moves the arc by at most 2 d, because a ray from one
    end meets both arcs at most 2 d apart. An irrational angle is replaced by one with rational sine
    and cosine, so that rotating back and forth preserves the ends.
    """
    (rx, ry), (large, left) = radii, flags
    # The height is a square root, so its error is the root of the angle's error.
    turn = make_rotation(angle, power=2)
    back = turn._replace(b=-turn.b, c=-turn.c)
    start, end = (Point(x / rx, y / ry) for x, y in (back.vector(*point) for point in ends))
    zero = Fraction(0)
    image = matrix @ turn._replace(error=zero) @ Affine(rx, zero, zero, ry, zero, zero)
    half = ((end.x - start.x) ** 2 + (end.y - start.y) ** 2) / 4
    height = curves.round_root_up(max(1 - half, zero) / half, _HEIGHTS)
    if large == left:
        height = -height
    center = curves.find_arc_center(start, end, height)
    return curves.make_round_arc(center, start, end, image, left=left)
