"""Other conventions of placements that explain a layout with many faults.

Each convention turns the same numbers into another exact layout, which is then judged. A rotation R
about a center c maps P to R (P - c) + c + t, so it suffices to shift the part and the translation.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from fractions import Fraction

from exactsweep.geometry.canonical import find_centroid
from exactsweep.geometry.turn import read_turn
from exactsweep.layout.board import Board
from exactsweep.layout.judge import Judgement, judge_layout
from exactsweep.layout.layout import Layout, LayoutPart, Placement
from exactsweep.layout.repair import make_box
from exactsweep.layout.rounded import RoundedPiece
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import ORIGIN, Point

# Minimum number and share (1/8) of faulty placements; maximum number of faulty placements, to bound
# the time; maximum share (1/10) of remaining faults; maximum number of conventions to report.
_FEW, _SHARE, _MANY, _LEFT, _NAMED = 2, 8, 1000, 10, 3
# Degrees per radian, with an error below 10**-45.
_DEGREES = Fraction("57.2957795130823208767981548141051703324054724665643")
_NEARLY = Fraction(1, 10**4)
_SCALES = (
    *map(Fraction, (10, 100, 1000)),
    Fraction(127, 5),
    Fraction(480, 127),
    Fraction(360, 127),
)
_DECIDED = {"overlap", "outside"}
_PLACED = _DECIDED | {"undecided"}
# Overlaps this many times smaller than the parts are due to rounding.
_ROUNDING = 10**6
Convention = Callable[[LayoutPart, Placement], tuple[LayoutPart, Placement]]


def diagnose(judgement: Judgement) -> list[str]:
    """Describe the conventions under which nearly all overlaps and parts outside vanish.

    The list is sorted by remaining faults. It is empty if few placements are faulty, no convention
    explains the faults, or a shape is rounded. It takes up to thirty times as long as the judge.
    """
    layout, faults = judgement.layout, _count_faults(judgement)
    if any(part.pieces for part in layout.parts) or isinstance(layout.container, RoundedPiece):
        return []
    wrong = {k for f in judgement.faults if f.kind in _DECIDED for k in f.placements}
    if len(wrong) < max(_FEW, len(layout.placements) / _SHARE) or len(wrong) > _MANY:
        return []
    if all(f.is_within(judgement._board.grain / _ROUNDING) for f in judgement.faults[:_FEW]):
        return []
    found = []
    for name, change in _list_conventions(layout):
        left = _count_faults(judge_layout(_apply(layout, change)))
        if left * _LEFT <= faults:
            found.append((left, f"with {name}, {left} of {faults} faults remain"))
    return [said for _, said in sorted(found, key=lambda one: one[0])][:_NAMED]


def find_radians(layout: Layout) -> list[str]:
    """Report a rotation that is nearly a multiple of 15 degrees when read as radians.

    >>> found = find_radians(Layout(None, (), (Placement("a", read_turn("3.14159"), ORIGIN),)))
    >>> print(*found)
    placement 0: turn 3.14159 looks like radians (180 degrees); turns are in degrees
    """
    for k, placement in enumerate(layout.placements):
        angle = placement.turn.degrees
        if angle is None or angle.denominator == 1:
            continue
        degrees = (angle if angle <= 180 else angle - 360) * _DEGREES
        whole = round(degrees)
        if whole and whole % 15 == 0 and abs(degrees - whole) < _NEARLY * 10 and abs(whole) <= 360:
            return [
                f"placement {k}: turn {float(angle):.7g} looks like radians ({whole} degrees); "
                "turns are in degrees"
            ]
    return []


def _count_faults(judgement: Judgement) -> int:
    return sum(fault.kind in _PLACED for fault in judgement.faults)


def _apply(layout: Layout, change: Convention) -> Layout:
    parts: dict[LayoutPart, str] = {}
    placements = []
    for placement in layout.placements:
        part, placed = change(layout.part_by_id[placement.part], placement)
        name = parts.setdefault(
            replace(part, demand=None, turns=None, mirrored_turns=None), str(len(parts))
        )
        placements.append(replace(placed, part=name))
    named = tuple(replace(part, id=name) for part, name in parts.items())
    return replace(layout, parts=named, placements=tuple(placements))


def _list_conventions(layout: Layout) -> Iterator[tuple[str, Convention]]:
    low, high = (layout.container or make_box(Board(layout).frame)).bounding_box

    def turn(by: Callable[[Fraction], Fraction], *, all_of_them: bool = True) -> Convention:
        return lambda part, p: (part, _turn(p, by) if p.mirrored or all_of_them else p)

    def move(by: Callable[[Point], Point]) -> Convention:
        return lambda part, p: (part, replace(p, move=by(p.move)))

    def mirror(point: Point) -> Point:
        return Point(point.x, low.y + high.y - point.y)

    yield "rotations in radians", turn(_from_radians)
    yield "clockwise rotations", turn(lambda angle: -angle)
    for name, find in _CENTERS.items():
        yield f"rotations about {name}", _shift_by(find, move=True)
        yield f"translations that place {name}", _shift_by(find, move=False)
    yield "translations that place the lower left corner of the rotated box", _from_turned_corner
    yield "translation before rotation", _move_first
    yield "Y pointing down in parts", _flip
    yield "Y pointing down in translations", move(mirror)
    yield "Y pointing down in parts and translations", lambda part, p: move(mirror)(*_flip(part, p))
    yield (
        "Y pointing down in translations, and clockwise rotations",
        lambda part, p: move(mirror)(part, _turn(p, lambda angle: -angle)),
    )
    yield "rotation before mirroring", turn(lambda angle: -angle, all_of_them=False)
    yield "mirroring in the X axis", turn(lambda a: a + 180, all_of_them=False)
    for scale in _SCALES:
        for factor, times in ((scale, "multiplied by"), (1 / scale, "divided by")):
            name = f"translations {times} {format_fraction(scale)}"
            yield name, move(lambda at, factor=factor: Point(at.x * factor, at.y * factor))  # type: ignore[misc]


def _from_radians(angle: Fraction) -> Fraction:
    degrees = (angle if angle <= 180 else angle - 360) * _DEGREES
    return Fraction(round(degrees)) if abs(degrees - round(degrees)) < _NEARLY else degrees


def _turn(p: Placement, by: Callable[[Fraction], Fraction]) -> Placement:
    if p.turn.degrees is None:
        return p
    return replace(p, turn=read_turn(by(p.turn.degrees)))


def _shift_by(find: Callable[[LayoutPart], Point], *, move: bool) -> Convention:
    def change(part: LayoutPart, p: Placement) -> tuple[LayoutPart, Placement]:
        at = find(part)
        there = Point(p.move.x + at.x, p.move.y + at.y) if move else p.move
        return _map(part, lambda q: Point(q.x - at.x, q.y - at.y)), replace(p, move=there)

    return change


def _move_first(part: LayoutPart, p: Placement) -> tuple[LayoutPart, Placement]:
    moved = _map(part, lambda q: Point(q.x + p.move.x, q.y + p.move.y))
    return moved, replace(p, move=ORIGIN)


def _from_turned_corner(part: LayoutPart, p: Placement) -> tuple[LayoutPart, Placement]:
    if p.turn.exact is None:
        return part, p
    a, b, c, d = p.rows()
    corners = [(a * x + b * y, c * x + d * y) for x, y in part.exterior]
    x, y = (min(values) for values in zip(*corners, strict=True))
    return part, replace(p, move=Point(p.move.x - x, p.move.y - y))


def _flip(part: LayoutPart, p: Placement) -> tuple[LayoutPart, Placement]:
    return _map(part, lambda q: Point(q.x, -q.y)), p


def _map(part: LayoutPart, to: Callable[[Point], Point]) -> LayoutPart:
    exterior, *holes = (tuple(map(to, ring)) for ring in (part.exterior, *part.holes))
    return replace(part, exterior=exterior, holes=tuple(holes))


def _box(part: LayoutPart) -> tuple[Point, Point]:
    xs, ys = zip(*part.exterior, strict=True)
    return Point(min(xs), min(ys)), Point(max(xs), max(ys))


def _find_middle(part: LayoutPart) -> Point:
    low, high = _box(part)
    return Point((low.x + high.x) / 2, (low.y + high.y) / 2)


_CENTERS: dict[str, Callable[[LayoutPart], Point]] = {
    "the centroid": lambda part: find_centroid(part.exterior),
    "the center of the box": _find_middle,
    "the lower left corner of the box": lambda part: _box(part)[0],
    "the first vertex": lambda part: part.exterior[0],
}
