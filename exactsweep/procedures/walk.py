"""Loops and exact fits, traced along the pieces of contact segments between crossings.

(1) If a piece bounds a free region, the next piece of the boundary is the first one
    counter-clockwise from the reverse direction, and no crossing proves that it is in O. So a walk
    passes pieces in O first, if any, and a test of the first piece of a ring decides the ring. If a
    walk does not close, all of its pieces are in O.
(2) The least point of the closure of O is the sum of the least vertices. The loop around all
    overlap passes through it, and leaves it along the first piece counter-clockwise from straight
    down.
"""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from functools import cache
from itertools import chain, groupby
from typing import NamedTuple

from exactsweep.geometry.frame import HomogeneousPoint
from exactsweep.geometry.vectors import angle_key
from exactsweep.numbers.number import Fit, Point, divide
from exactsweep.procedures.crossings import OneSidedPiece, Pieces, TwoSidedPiece

PieceRing = Sequence[OneSidedPiece]
OverlapTest = Callable[[HomogeneousPoint], bool]
"""A predicate for positions in O, which need not be reduced."""


class FreeBoundary(NamedTuple):
    """The boundary of the free positions as canonical loops, and the exact fits.

    Attributes:
        around: the loops around overlap.
        within: the loops around free regions, except for the unbounded one, sorted.
        fits: the exact fits, sorted: segments, or points as segments with two equal ends. If only
            one end lies on a loop, it comes first; otherwise the lesser end.
    """

    around: list[list[Point]]
    within: list[list[Point]]
    fits: list[Fit]


def find_free(
    pieces: Pieces,
    overlaps: OverlapTest,
    scale: int = 1,
    *,
    least: HomogeneousPoint | None = None,
    around_overlap: bool = False,
) -> FreeBoundary:
    """Find the loops and the exact fits among pieces of contact segments.

    `overlaps` decides whether a position is in O; all coordinates are divided by the scale. The
    least point of the closure of O saves a test, by (2). With `around_overlap`, loops that meet at
    a point are split so that each bounds one component of O, otherwise of the free positions.

    Cost: O(k) for k pieces, plus one test for each ring, each two-sided piece and each meeting.
    """
    overlaps = cache(overlaps)
    rings = list(_walk_rings(pieces.one_sided, overlaps, least=least))
    if around_overlap:
        # The same pieces, all of which are known to bound free regions, so no test is needed.
        rings = list(_walk_rings([*chain.from_iterable(rings)], lambda _: False, min))
    bounding = {piece[0] for ring in rings for piece in ring}
    free = [(line, p, q) for line, p, q in pieces.two_sided if not overlaps(_find_middle(p, q))]
    touched = bounding.union(*(piece[1:] for piece in free))
    fits = [(p, p) for p in pieces.meetings - touched if not overlaps(p)]
    found = FreeBoundary([], [], [])
    for ring in rings:
        loop, is_around = _make_canonical(ring, scale)
        (found.around if is_around else found.within).append(loop)
    for p, q in fits + list(_join_fits(free, bounding)):
        fit = _divide(p, scale), _divide(q, scale)
        found.fits.append(fit[::-1] if q in bounding and p not in bounding else fit)
    found.within.sort()
    found.fits.sort()
    return found


def _walk_rings(
    pieces: Sequence[OneSidedPiece],
    overlaps: OverlapTest,
    choose: Callable[..., OneSidedPiece] = max,
    least: HomogeneousPoint | None = None,
) -> Iterator[PieceRing]:
    """Trace the boundaries of free regions by (1); yield a ring where a walk revisits a point.

    With `min`, trace the boundaries of overlap; all pieces must bound it.
    """
    leaving: defaultdict[HomogeneousPoint, list[OneSidedPiece]] = defaultdict(list)
    for piece in pieces:
        leaving[piece[0]].append(piece)
    # The first piece counter-clockwise from straight down, by (2).
    outermost = _follow((least, least, 0, 1), leaving) if least else None
    done: set[OneSidedPiece] = set()
    for first in [outermost, *pieces] if outermost else pieces:
        # The pieces of the walk that are in no ring yet, and the place of each by its start.
        path: list[OneSidedPiece] = []
        places: dict[HomogeneousPoint, int] = {}
        following: OneSidedPiece | None = first
        while following is not None and following not in done:
            start, end, _, _ = following
            done.add(following)
            places[start] = len(path)
            path.append(following)
            if end in places:
                ring = path[places[end] :]
                if first is outermost or not overlaps(_find_middle(ring[0][0], ring[0][1])):
                    yield ring
                    del path[places[end] :]
                    for piece in ring:
                        del places[piece[0]]
            following = _follow(following, leaving, choose)


def _follow(
    piece: OneSidedPiece,
    leaving: Mapping[HomogeneousPoint, list[OneSidedPiece]],
    choose: Callable[..., OneSidedPiece] = max,
) -> OneSidedPiece | None:
    """Return the first piece counter-clockwise (`min`: clockwise) from the reverse of a piece."""
    _, end, dx, dy = piece
    found = leaving.get(end, ())
    if len(found) < 2:
        return found[0] if found else None
    # The greatest clockwise angle from the reverse of the piece, which is rotated to the X axis, is
    # the least counter-clockwise one.
    return choose(found, key=lambda p: angle_key((-dx * p[2] - dy * p[3], dx * p[3] - dy * p[2])))


def _make_canonical(ring: PieceRing, scale: int) -> tuple[list[Point], bool]:
    """Return the canonical loop of a ring, and whether the ring runs counter-clockwise."""
    corners = [
        piece
        for before, piece in zip([ring[-1], *ring[:-1]], ring, strict=True)
        if before[2:] != piece[2:]
    ]
    points = [_divide(piece[0], scale) for piece in corners]
    k = points.index(min(points))
    points = points[k:] + points[:k]
    # The least vertex is convex, so the turn there is the orientation of the loop.
    (_, _, bx, by), (_, _, dx, dy) = corners[k - 1], corners[k]
    if bx * dy > by * dx:
        return points, True
    return [points[0], *points[:0:-1]], False


def _join_fits(
    pieces: Iterable[TwoSidedPiece], bounding: Container[HomogeneousPoint]
) -> Iterator[tuple[HomogeneousPoint, HomogeneousPoint]]:
    """Join consecutive collinear free pieces, unless a loop passes through their common end."""
    for _, group in groupby(pieces, key=lambda piece: piece[0]):
        (_, start, end), *others = group
        for _, p, q in others:
            if p != end or p in bounding:
                yield start, end
                start = p
            end = q
        yield start, end


def _find_middle(p: HomogeneousPoint, q: HomogeneousPoint) -> HomogeneousPoint:
    """Return the midpoint of two points, not reduced."""
    (x, y, w), (u, v, z) = p, q
    return x * z + u * w, y * z + v * w, 2 * w * z


def _divide(point: HomogeneousPoint, scale: int) -> Point:
    x, y, w = point
    return Point(divide(x, w * scale), divide(y, w * scale))
