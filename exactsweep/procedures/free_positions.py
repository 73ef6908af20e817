"""The free positions of two polygons of any shape, from their contact lines.

See `contact_lines` for (1) and (2). What follows from them, step by step:

(3) A piece of a stretch between two neighbouring crossings cannot be free if at one of its ends it
    goes off to the left of a stretch that runs through there: there is overlap by (2).
(4) The pieces that are left bound a free region on their right, or, if contact segments run along
    them both ways, are exact fits, or are overlapped after all.
(5) From a piece that bounds a free region, the next one of its boundary is the first that is met by
    turning counter-clockwise from the way back. It is left by (3), too, and so are all others
    until the loop closes. So a walk that comes to an end shows that all of its pieces are
    overlapped, and one position of a loop that closes decides all of it.
(6) A single free position has overlap in all directions, and so contact segments through it that
    have every direction on their left: more than two, or two that run both ways each.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Container, Iterable, Iterator, Sequence
from functools import cmp_to_key
from itertools import groupby, pairwise
from operator import itemgetter
from typing import NamedTuple

from exactsweep.geometry.number import quotient
from exactsweep.geometry.point import Point
from exactsweep.procedures.contact_lines import Cut, Stretch
from exactsweep.procedures.envelope import Break, precedes

Fit = tuple[Point, Point]


class Free(NamedTuple):
    """Free positions, as they are bounded.

    Attributes:
        loops: counter-clockwise around overlap and clockwise around free regions, corners only.
        fits: exact fits, sorted: segments, an end on a loop first if the other one is not, else the
            lesser end; and points as segments of two equal ends.
    """

    loops: list[list[Point]]
    fits: list[Fit]


class _Piece(NamedTuple):
    """A piece of a stretch between crossings, with the free region on its right."""

    start: Point
    end: Point
    dx: int
    dy: int


def free_positions(stretches: Sequence[Stretch], overlap: Callable[[Point], bool]) -> Free:
    """Find the loops and the exact fits among stretches that have been cut at their crossings.

    Args:
        stretches: of contact segments, with their cuts.
        overlap: whether there is overlap at a position.

    Cost: O(k log k) for k cuts, and a question of `overlap` for each loop of pieces, which few are
    but the free ones, each piece with segments both ways, and each position that (6) leaves.
    """
    pieces: list[_Piece] = []
    both_ways: list[tuple[Stretch, Point, Point]] = []
    suspects: set[Point] = set()
    for stretch in stretches:
        for low, high in _left_over(stretch, suspects):
            p, q = stretch.point(low), stretch.point(high)
            if stretch.left and stretch.right:
                both_ways.append((stretch, p, q))
            elif stretch.left:
                pieces.append(_Piece(p, q, stretch.dx, stretch.dy))
            else:
                pieces.append(_Piece(q, p, -stretch.dx, -stretch.dy))
    rings = list(_loops(pieces, overlap))
    bounding = {point for ring in rings for point in ring}
    fits = list(_joined((f for f in both_ways if not overlap(_middle(*f[1:]))), bounding))
    known = bounding | {end for fit in fits for end in fit}
    fits += [
        (p, p)
        for p in suspects - known
        if not overlap(p) and not any(_lies_on(p, fit) for fit in fits)
    ]
    hung = [(q, p) if q in bounding and p not in bounding else (p, q) for p, q in fits]
    return Free([_corners(ring) for ring in rings], sorted(hung))


def _left_over(stretch: Stretch, suspects: set[Point]) -> Iterator[tuple[Break, Break]]:
    """The pieces of a stretch that (3) leaves; adds the positions that (6) does to the suspects."""
    since, covered = stretch.low, stretch.low_covered
    twice = stretch.left and stretch.right
    for place, cuts in _in_order(stretch.cuts):
        if precedes(since, place):
            if not (covered or any(cut.before for cut in cuts)):
                yield since, place
            since, covered = place, False
        covered = covered or any(cut.after for cut in cuts)
        if len(cuts) > 1 or (twice and cuts[0].twice) or _goes_on(stretch, place):
            suspects.add(stretch.point(place))
    if precedes(since, stretch.high) and not (covered or stretch.high_covered):
        yield since, stretch.high


def _goes_on(stretch: Stretch, place: Break) -> bool:
    """Whether a place is an end at which another stretch of the line begins."""
    n, d = place
    return (stretch.low_through is not None and n == stretch.low[0] * d) or (
        stretch.high_through is not None and n == stretch.high[0] * d
    )


def _in_order(cuts: list[Cut]) -> Iterator[tuple[Break, list[Cut]]]:
    """Cuts from low to high, those at one place together. Cost: O(k log k)."""
    cuts.sort(key=itemgetter(0))
    if any(a.key == b.key for a, b in pairwise(cuts)):
        cuts.sort(key=lambda cut: (cut.key, quotient(*cut.place)))
    at_place: list[Cut] = []
    for cut in cuts:
        if at_place and precedes(at_place[0].place, cut.place):
            yield at_place[0].place, at_place
            at_place = []
        at_place.append(cut)
    if at_place:
        yield at_place[0].place, at_place


def _loops(pieces: Sequence[_Piece], overlap: Callable[[Point], bool]) -> Iterator[list[Point]]:
    """The loops of free pieces, by (5)."""
    leaving: defaultdict[Point, list[int]] = defaultdict(list)
    for number, piece in enumerate(pieces):
        leaving[piece.start].append(number)
    undecided, on_way, done = 0, 1, 2
    state = [undecided] * len(pieces)
    for first in range(len(pieces)):
        way: list[int] = []
        k: int | None = first
        while k is not None and state[k] == undecided:
            state[k] = on_way
            way.append(k)
            k = _next(pieces, pieces[k], leaving[pieces[k].end])
        if k is not None and state[k] == on_way:
            ring = way[way.index(k) :]
            if not overlap(_middle(pieces[k].start, pieces[k].end)):
                yield from _simple(pieces[number].start for number in ring)
        for number in way:
            state[number] = done


def _simple(ring: Iterable[Point]) -> Iterator[list[Point]]:
    """Part a loop where it comes back to a point: positions of overlap in several pieces touch."""
    way: list[Point] = []
    places: dict[Point, int] = {}
    for point in ring:
        if point in places:
            since = places[point]
            yield way[since:]
            for passed in way[since + 1 :]:
                del places[passed]
            del way[since + 1 :]
        else:
            places[point] = len(way)
            way.append(point)
    yield way


def _next(pieces: Sequence[_Piece], piece: _Piece, leaving: Sequence[int]) -> int | None:
    """The first piece counter-clockwise from the way back."""
    if len(leaving) < 2:
        return leaving[0] if leaving else None
    x, y = -piece.dx, -piece.dy

    def turned(k: int) -> tuple[bool, int]:
        """Whether a piece is more than half a turn on."""
        turn = x * pieces[k].dy - y * pieces[k].dx
        return turn < 0 or (turn == 0 and x * pieces[k].dx + y * pieces[k].dy > 0), k

    def compare(a: tuple[bool, int], b: tuple[bool, int]) -> int:
        if a[0] != b[0]:
            return 1 if a[0] else -1
        p, q = pieces[a[1]], pieces[b[1]]
        return q.dx * p.dy - q.dy * p.dx

    return min(map(turned, leaving), key=cmp_to_key(compare))[1]


def _middle(p: Point, q: Point) -> Point:
    return Point((p.x + q.x) / 2, (p.y + q.y) / 2)


def _joined(
    fits: Iterable[tuple[Stretch, Point, Point]], bounding: Container[Point]
) -> Iterator[Fit]:
    """Join exact fits that go on in one line, unless they meet a loop there."""
    for _, group in groupby(fits, key=lambda fit: (fit[0].dx, fit[0].dy, fit[0].c)):
        start: Point | None = None
        end: Point | None = None
        for _, p, q in group:
            if start is None or end is None:
                start = p
            elif p != end or p in bounding:
                yield start, end
                start = p
            end = q
        assert start is not None
        assert end is not None
        yield start, end


def _lies_on(p: Point, fit: Fit) -> bool:
    (ax, ay), (bx, by) = fit
    return (bx - ax) * (p.y - ay) == (by - ay) * (p.x - ax) and fit[0] <= p <= fit[1]


def _corners(ring: Sequence[Point]) -> list[Point]:
    """Leave out the vertices of a loop that lie straight between their neighbours."""
    return [
        q
        for p, q, r in zip([ring[-1], *ring], ring, [*ring[1:], ring[0]], strict=False)
        if (q.x - p.x) * (r.y - q.y) != (q.y - p.y) * (r.x - q.x)
    ]
