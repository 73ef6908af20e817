"""Joining of open lines into closed outlines."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Container, Hashable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import chain
from typing import NamedTuple

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.curved.path import CURVED, Path, default_tolerance, find_grid, round_points
from exactsweep.formats.decimals import show_point
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.formats.rounded import find_rounded
from exactsweep.numbers.error import prefix_errors
from exactsweep.numbers.number import Point
from exactsweep.words import count

_MAX_CROWD = 64  # joints near an end
_ROUNDED = 250  # gaps smaller than the reach divided by this are due to rounding


class OpenLine(NamedTuple):
    shape: Candidate  # its location, names and fill rule
    ends: tuple[Point, Point]
    path: Path | None = None  # None for a straight line
    is_exact: bool = True  # whether its ends are exact

    @classmethod
    def from_path(cls, shape: Candidate, path: Path, *, is_exact: bool) -> OpenLine:
        is_straight = len(path.points) == 2 and path.is_exact
        ends = path.points[0], path.points[-1]
        return cls(shape, ends, None if is_straight else path, is_exact)

    @property
    def key(self) -> Hashable:
        """A key that distinguishes lines with the same ends; () for a straight line."""
        return self.path.key if self.path else ()

    def draw(self, start: Point, end: Point) -> Path:
        """Return its path, with the ends moved to the given points."""
        return (self.path or Path(self.ends)).moved(start, end)


class _Joined(NamedTuple):
    order: int  # its index in the file
    line: OpenLine
    joints: tuple[int, int]  # at its ends


def join_layers(drawn: Iterable[Candidate | OpenLine], reading: Reading) -> list[Candidate]:
    found: list[tuple[int, Candidate]] = []
    lines: defaultdict[str | None, dict[int, OpenLine]] = defaultdict(dict)
    for order, one in enumerate(drawn):
        if isinstance(one, OpenLine):
            lines[one.shape.layer][order] = one
        else:
            found.append((order, one))
    for loose in lines.values():
        found += join(loose, reading)
    return [candidate for _, candidate in sorted(found, key=lambda pair: pair[0])]


def join(lines: Mapping[int, OpenLine], reading: Reading) -> Iterator[tuple[int, Candidate]]:
    """Join the lines of one layer; yield the candidates with their indices.

    Each end snaps to the nearest joint within reach, or becomes a new joint. Exact ends come first,
    with a reach of `reading.join`; the reach of other ends is at least a quarter of the tolerance.
    Repeated lines are ignored. A line with both ends at one joint is dropped if an outline passes
    through it; otherwise it is rejected, since it may be a hole. Connected lines are rejected
    unless exactly two ends meet at each joint; a single straight line is an ornament.
    """
    joints = Joints(reading.join or Fraction(0))
    find = joints.find
    exact = [[*map(find, line.ends)] if line.is_exact else [] for line in lines.values()]
    if not all(exact):
        tolerance = reading.joining or find_tolerance(lines.values())
        reach = max(tolerance / 4, joints.reach)
        joints = Joints(reach, joints.points, tolerance)
    placed: list[tuple[int, OpenLine, list[int]]] = []
    for (order, line), ends in zip(lines.items(), exact, strict=True):
        try:
            placed.append((order, line, ends or [*map(joints.find, line.ends)]))
        except FormatError as error:
            yield order, line.shape.rejected(f"{line.shape.place}: {error}")
    if not all(exact):
        _note_gaps(placed, joints, reading)
    found: dict[tuple[int, int, Hashable], _Joined] = {}
    lost: defaultdict[int, list[_Joined]] = defaultdict(list)
    for order, line, (i, k) in placed:
        try:
            joined = _Joined(order, line, (i, k))
            if i != k:
                same = found.setdefault((min(i, k), max(i, k), line.key), joined).line
                if same is not line and sorted(same.ends) != sorted(line.ends):
                    lost[i].append(joined)
            elif line.path is not None and line.path.size > 4 * joints.reach:
                path = line.draw(joints.points[i], joints.points[i])
                yield order, draw_outline(path, line.shape, reading)
            elif line.ends[0] != line.ends[1]:
                lost[i].append(joined)
        except FormatError as error:
            yield order, line.shape.rejected(f"{line.shape.place}: {error}")
    passed = {joint for line in found.values() for joint in line.joints}
    for joint, short in lost.items():
        order, start, _ = short[0]
        vanished = f"dropped {count(len(short), 'line')} shorter than the --join distance"
        reason = f"{start.shape.place}: {vanished}"
        ends_of = Counter(end for one in short for end in one.line.ends)
        if joint not in passed or not any(number % 2 for number in ends_of.values()):
            alone = len(short) == 1 and not start.path
            yield order, start.shape.rejected(reason, ornament=alone)
        elif len(short) > 1:
            reading.notes[reason] = None
    yield from _outlines(list(found.values()), joints.points, lost, reading)


def find_tolerance(lines: Iterable[OpenLine]) -> Fraction:
    xs, ys = zip(*(end for line in lines for end in line.ends), strict=True)
    return default_tolerance(max(max(xs) - min(xs), max(ys) - min(ys)), CURVED)


def _note_gaps(
    placed: Sequence[tuple[int, OpenLine, list[int]]], joints: Joints, reading: Reading
) -> None:
    first: dict[int, Point] = {}
    gaps = []
    for _, line, ends in placed:
        for end, joint in zip(line.ends, ends, strict=True):
            x, y = first.setdefault(joint, end)
            gap = max(abs(x - end.x), abs(y - end.y)) if end is not first[joint] else 0
            if gap * _ROUNDED > joints.reach and gap > (reading.join or 0):
                gaps.append((gap, line.shape.place))
    if gaps:
        gap, where = max(gaps)
        note = f"closed {count(len(gaps), 'gap')} at curves, up to {float(gap):.2g} ({where})"
        reading.notes[note] = None


class Joints:
    """A hash grid of points that line ends snap to, on a decimal grid if a tolerance is given."""

    def __init__(
        self, reach: Fraction, known: Iterable[Point] = (), tolerance: Fraction | None = None
    ) -> None:
        self.reach, self.tolerance = reach, tolerance
        self.points: list[Point] = []
        self._cells: defaultdict[tuple[object, object], list[int]] = defaultdict(list)
        # Hashing ints is ten times as fast as hashing Fractions.
        self._found: dict[tuple[int, ...], int] = {}
        for joint in known:
            self._add(joint)

    def find(self, end: Point) -> int:
        key = end.x.numerator, end.x.denominator, end.y.numerator, end.y.denominator
        if key not in self._found:
            self._found[key] = self._find_closest(end) if self.reach else self._add(end)
        return self._found[key]

    def _find_closest(self, end: Point) -> int:
        x, y = self._cell(end)
        cells = (self._cells.get((x + i, y + k), ()) for i in (-1, 0, 1) for k in (-1, 0, 1))
        close = [joint for cell in cells for joint in cell]
        if len(close) > _MAX_CROWD:
            raise FormatError(
                f"more than {_MAX_CROWD} line ends near {show_point(end)}; try a smaller --join"
            )
        near = [
            ((p.x - end.x) ** 2 + (p.y - end.y) ** 2, p, k) for k in close for p in [self.points[k]]
        ]
        square, _, closest = min(near, default=(self.reach**2 + 1, end, -1))
        if square <= self.reach**2:
            return closest
        if self.tolerance is not None:
            (end,) = round_points([end], find_grid(self.tolerance))
        return self._add(end)

    def _add(self, joint: Point) -> int:
        if self.reach:
            self._cells[self._cell(joint)].append(len(self.points))
        self.points.append(joint)
        return len(self.points) - 1

    def _cell(self, point: Point) -> tuple[int, int]:
        return point.x // self.reach, point.y // self.reach


def _outlines(
    lines: Sequence[_Joined], points: Sequence[Point], lost: Container[int], reading: Reading
) -> Iterator[tuple[int, Candidate]]:
    at: defaultdict[int, list[int]] = defaultdict(list)
    for k, line in enumerate(lines):
        for joint in line.joints:
            at[joint].append(k)
    seen: set[int] = set()
    passed: set[int] = set()
    for first in range(len(lines)):
        if first in seen:
            continue
        together, fault = [first], ""
        seen.add(first)
        for k in together:
            for joint in lines[k].joints:
                # Visit each joint only once, because many lines may meet there.
                if joint in passed:
                    continue
                passed.add(joint)
                meeting = at[joint]
                if len(meeting) != 2 and not fault:
                    fault = _fault(lines[k].line, points[joint], len(meeting), reading)
                new = [other for other in meeting if other not in seen]
                seen.update(new)
                together += new
        joined = [lines[k].line for k in sorted(together)]
        order, start, joints = lines[first]
        named = (line.shape.name for line in joined if line.shape.name is not None)
        shape = start.shape._replace(name=next(named, None))
        if fault and len(joined) == 1 and shape.rule and start.path:
            reading.notes[f"{shape.place}: an open path, closed by filling"] = None
            yield order, draw_outline(start.path.closed(), shape, reading)
        elif fault:
            alone = len(joined) == 1 and not start.path
            alone = alone and not any(joint in lost for joint in joints)
            rejected = shape.rejected(fault, ornament=alone)
            runs = (line.path.points if line.path else line.ends for line in joined)
            yield order, rejected._replace(points=(*chain.from_iterable(runs),))
        else:
            yield order, draw_outline(_walk(lines, at, points, first), shape, reading)


def _fault(line: OpenLine, end: Point, count: int, reading: Reading) -> str:
    if count > 1:
        where = f"{line.shape.place}: {count} ends meet at {show_point(end)}"
        return f"{where}; draw outlines that touch as polylines"
    exactly = "" if reading.join else " exactly; --join DISTANCE closes small gaps"
    return f"{line.shape.place}: open end at {show_point(end)}: no other end meets it{exactly}"


def _walk(
    lines: Sequence[_Joined], at: Mapping[int, Sequence[int]], points: Sequence[Point], first: int
) -> Path:
    outline = Path()
    k, joint = first, lines[first].joints[0]
    while True:
        _, line, (start, end) = lines[k]
        path = line.draw(points[start], points[end])
        if joint == start:
            joint = end
        else:
            path, joint = path.reversed(), start
        if outline.points:
            outline.add(path)
        else:
            outline = path
        k = sum(at[joint]) - k
        if k == first:
            return outline


def draw_outline(path: Path, shape: Candidate, reading: Reading) -> Candidate:
    """Set the outline of a shape to a closed path, filled by its rule if it is not simple."""

    def read_vertices() -> list[Point]:
        with prefix_errors(shape.place):
            return path.flatten(reading)

    def find_finer(tolerance: Fraction) -> Candidate:
        return draw_outline(path, shape, reading.with_tolerance(tolerance))

    error = path.find_error(reading)
    return shape._replace(
        vertices=read_vertices,
        error=error,
        rule=shape.rule or "nonzero",
        finer=find_finer if error else None,
        rounded=find_rounded(path),
    )
