"""The free positions of two polygons of any shape, from their contact lines.

See `contact_lines` for (1) and (2). They imply:

(3) Consider a piece of a stretch between two neighbouring crossings. If another stretch runs
    through one of its ends and the piece leaves to the left of it, the piece overlaps, by (2).
(4) Each remaining piece bounds a free region on its right, or is an exact fit, if contact segments
    run along it both ways, or overlaps after all.
(5) Let a piece bound a free region. The next piece of the boundary is the first one
    counter-clockwise from the way back. (3) does not remove it, nor any later piece until the loop
    closes. So if a walk ends without closing, all of its pieces overlap. If it closes, one position
    decides the loop. The loop around all overlap, if that is bounded, needs no overlap test. The
    sum p of the least vertices of both sets is the least point of the closure of O, a corner of the
    unbounded free region. Several pieces may leave p if a hole touches its exterior there. The one
    furthest clockwise has that region on its right.
(6) A single free position has overlap in all directions. So every direction lies left of some
    contact segment through it. This takes more than two segments, or two that run both ways each.
(7) O is open and a piece between two crossings is free or overlaps as a whole. So the ends of a
    free piece are free, and pieces that end at a position of overlap overlap.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence, Set
from itertools import chain, groupby, pairwise
from operator import itemgetter
from typing import NamedTuple

from exactsweep.geometry.canonical import find_least
from exactsweep.geometry.vectors import way_key
from exactsweep.numbers.number import Fit, Point, Vertex, divide_exactly
from exactsweep.procedures.contact_lines import ReducedPoint, Stretch, StretchPlace


class Free(NamedTuple):
    """The boundary of the free positions, and the exact fits.

    Attributes:
        around: the loops around overlap.
        within: the loops around free regions, except for the unbounded one.
        fits: the exact fits, sorted: segments, or points as segments with two equal ends. If only
            one end lies on a loop, it comes first; otherwise the lesser end.

    Loops are canonical: counter-clockwise, corners only, the least vertex first, not closed.
    """

    around: list[list[Point]]
    within: list[list[Point]]
    fits: list[Fit]


_FreeEdge = tuple[ReducedPoint, ReducedPoint, int, int]
"""A piece of a stretch between crossings: start, end, direction. The right side is free."""

_TwoWayPiece = tuple[Stretch, ReducedPoint, ReducedPoint]
"""A piece with segments both ways, and its ends."""


def find_free_positions(
    stretches: Sequence[Stretch],
    overlap: Callable[[Point], bool],
    scale: int,
    least: Vertex | None = None,
) -> Free:
    """Find the loops and the exact fits among stretches that have been cut at their crossings.

    Args:
        stretches: the stretches of contact segments, with their cuts.
        overlap: decides whether a position overlaps.
        scale: the divisor of positions when they leave the lattice.
        least: the least point of the closure of all overlap, if that is bounded.

    Cost: O(k log k) for k cuts, and at most one call of `overlap` for each closed walk, each piece
    with segments both ways, and each position that (6) leaves. Few closed walks are not free.
    """
    pieces: list[_FreeEdge] = []
    both_ways: list[_TwoWayPiece] = []
    suspects: set[ReducedPoint] = set()
    for stretch in stretches:
        for low, high in _find_left_over(stretch, suspects):
            p, q = stretch.vertex(low), stretch.vertex(high)
            if stretch.left and stretch.right:
                both_ways.append((stretch, p, q))
            elif stretch.left:
                pieces.append((p, q, stretch.dx, stretch.dy))
            else:
                pieces.append((q, p, -stretch.dx, -stretch.dy))
    rings = list(_walk_rings(pieces, overlap, least))
    bounding = {start for ring in rings for start, _, _, _ in ring}
    free, alone = _decide(both_ways, suspects, bounding, overlap)
    fits = [*_join(free, bounding), *((p, p) for p in alone)]
    around: list[list[Point]] = []
    within: list[list[Point]] = []
    for ring in rings:
        loop, is_around = _make_canonical(ring, scale)
        (around if is_around else within).append(loop)
    return Free(around, within, sorted(_hang(fit, bounding, scale) for fit in fits))


def _find_left_over(
    stretch: Stretch, suspects: set[ReducedPoint]
) -> list[tuple[StretchPlace, StretchPlace]]:
    """Find the pieces of a stretch that (3) leaves, and add positions by (6) to the suspects.

    Cost: O(k log k) for k cuts.
    """
    left: list[tuple[StretchPlace, StretchPlace]] = []
    cuts, twice = stretch.cuts, stretch.left and stretch.right
    if not cuts:
        if not (stretch.low_covered or stretch.high_covered):
            left.append((stretch.low, stretch.high))
        return left
    cuts.sort(key=itemgetter(0))
    if any(a[0] == b[0] and a[1][0] * b[1][1] != b[1][0] * a[1][1] for a, b in pairwise(cuts)):
        cuts.sort(key=lambda cut: divide_exactly(*cut[1]))
    (since_n, since_d), covered = stretch.low, stretch.low_covered
    k, size = 0, len(cuts)
    while k < size:
        key, place, before, after, other_twice = cuts[k]
        n, d = place
        k += 1
        alone = True
        while k < size and cuts[k][0] == key and cuts[k][1][0] * d == n * cuts[k][1][1]:
            before = before or cuts[k][2]
            after = after or cuts[k][3]
            alone = False
            k += 1
        if since_n * d < n * since_d:
            if not (covered or before):
                left.append(((since_n, since_d), place))
            since_n, since_d, covered = n, d, after
        else:
            covered = covered or after
        # Where two stretches of one line meet, a crossing line has a cut with each of them.
        if not alone or (twice and other_twice):
            suspects.add(stretch.vertex(place))
    end_n, end_d = stretch.high
    if not (covered or stretch.high_covered) and since_n * end_d < end_n * since_d:
        left.append(((since_n, since_d), stretch.high))
    return left


def _walk_rings(
    pieces: Sequence[_FreeEdge], overlap: Callable[[Point], bool], least: Vertex | None
) -> Iterator[Sequence[_FreeEdge]]:
    """Walk the rings of free pieces, by (5), starting with the one that needs no overlap test."""
    leaving: defaultdict[ReducedPoint, list[int]] = defaultdict(list)
    for number, piece in enumerate(pieces):
        leaving[piece[0]].append(number)
    known = None if least is None else _find_outermost(pieces, leaving, least)
    undecided, on_way, done = 0, 1, 2
    state = [undecided] * len(pieces)
    for first in chain(() if known is None else (known,), range(len(pieces))):
        way: list[int] = []
        k: int | None = first
        while k is not None and state[k] == undecided:
            state[k] = on_way
            way.append(k)
            following = leaving.get(pieces[k][1], (None,))
            k = _find_next(pieces, pieces[k], following) if len(following) > 1 else following[0]
        if k is not None and state[k] == on_way:
            ring = way[way.index(k) :]
            if first == known or not overlap(_find_middle(pieces[k][0], pieces[k][1])):
                yield from _part_where_it_touches(pieces[number] for number in ring)
        for number in way:
            state[number] = done


def _find_outermost(
    pieces: Sequence[_FreeEdge], leaving: Mapping[ReducedPoint, list[int]], least: Vertex
) -> int:
    """Find a piece that bounds the unbounded free region, by (5)."""
    x, y = least
    found, *others = leaving[(*x.as_integer_ratio(), *y.as_integer_ratio())]
    for k in others:
        (_, _, dx, dy), (_, _, ex, ey) = pieces[found], pieces[k]
        if ex * dy > ey * dx:
            found = k
    return found


def _find_next(pieces: Sequence[_FreeEdge], piece: _FreeEdge, leaving: Sequence[int]) -> int:
    """Find the first piece counter-clockwise from the way back."""
    x, y = -piece[2], -piece[3]

    def mirrored(k: int) -> Vertex:
        """Return the direction of a piece, turned so that the way back is the X axis, clockwise."""
        _, _, dx, dy = pieces[k]
        return x * dx + y * dy, y * dx - x * dy

    # Clockwise, it is the last one, and the way back itself comes before all others.
    return max(leaving, key=lambda k: way_key(mirrored(k)))


def _part_where_it_touches(ring: Iterable[_FreeEdge]) -> Iterator[Sequence[_FreeEdge]]:
    """Split a ring where it returns to a point, as when two parts of the overlap touch."""
    way: list[_FreeEdge] = []
    places: dict[ReducedPoint, int] = {}
    for piece in ring:
        since = places.setdefault(piece[0], len(way))
        if since < len(way):
            yield way[since:]
            for passed in way[since + 1 :]:
                del places[passed[0]]
            del way[since:]
        way.append(piece)
    yield way


def _make_canonical(ring: Sequence[_FreeEdge], scale: int) -> tuple[list[Point], bool]:
    """Return the canonical loop of a ring, and whether the ring runs counter-clockwise."""
    corners = [
        (start, bx, by, dx, dy)
        for (_, _, bx, by), (start, _, dx, dy) in zip([ring[-1], *ring[:-1]], ring, strict=True)
        if bx != dx or by != dy
    ]
    points = [_leave(corner[0], scale) for corner in corners]
    first = find_least(points)
    # The least vertex is a convex corner.
    _, bx, by, dx, dy = corners[first]
    points = points[first:] + points[:first]
    if bx * dy > by * dx:
        return points, True
    return [points[0], *points[:0:-1]], False


def _leave(vertex: ReducedPoint, scale: int) -> Point:
    """Divide a vertex, on the lattice or between, by the scale."""
    xn, xd, yn, yd = vertex
    return Point(divide_exactly(xn, xd * scale), divide_exactly(yn, yd * scale))


def _find_middle(p: ReducedPoint, q: ReducedPoint) -> Point:
    (a, b, c, d), (e, f, g, h) = p, q
    return Point(divide_exactly(a * f + e * b, 2 * b * f), divide_exactly(c * h + g * d, 2 * d * h))


def _decide(
    both_ways: Sequence[_TwoWayPiece],
    suspects: Set[ReducedPoint],
    bounding: Set[ReducedPoint],
    overlap: Callable[[Point], bool],
) -> tuple[list[_TwoWayPiece], list[ReducedPoint]]:
    """Find the free pieces with segments both ways, and the single free positions, by (7).

    Exact fits come in rows along a slot, and overlapped pieces in bundles. So the last piece says
    what to test first, the next piece or its ends. The order changes no answer.
    """
    known: dict[ReducedPoint, bool] = {}
    touched = set(bounding)

    def overlaps(p: ReducedPoint) -> bool:
        if p not in known:
            known[p] = p not in touched and overlap(_leave(p, 1))
        return known[p]

    free: list[_TwoWayPiece] = []
    likely = True
    for piece in both_ways:
        _, p, q = piece
        if not likely and ((p in suspects and overlaps(p)) or (q in suspects and overlaps(q))):
            continue
        likely = not (known.get(p) or known.get(q) or overlap(_find_middle(p, q)))
        if likely:
            free.append(piece)
            touched |= {p, q}
    return free, [p for p in suspects - touched if not overlaps(p)]


def _join(
    fits: Iterable[_TwoWayPiece], bounding: Container[ReducedPoint]
) -> Iterator[tuple[ReducedPoint, ReducedPoint]]:
    """Join exact fits that continue each other on one line, unless a loop passes there."""
    for _, group in groupby(fits, key=lambda fit: (fit[0].dx, fit[0].dy, fit[0].c, fit[0].e)):
        start: ReducedPoint | None = None
        end: ReducedPoint | None = None
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


def _hang(
    fit: tuple[ReducedPoint, ReducedPoint], bounding: Container[ReducedPoint], scale: int
) -> Fit:
    """Put the end on a loop first, if only one is, else the lesser one; divide by the scale."""
    first, second = fit
    p, q = _leave(first, scale), _leave(second, scale)
    return (q, p) if second in bounding and first not in bounding else (p, q)
