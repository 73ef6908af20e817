"""Shortest moves that repair faults of placed parts, judged before they are returned.

Let r be the required distance plus the errors of both solids. For r = 0, the shortest move ends at
the nearest point of the no-fit polygon's boundary or of an exact fit. For r > 0, the moved part is
enlarged by a polygon about a disc of radius r, so that contact keeps the distance; then the move
is shortened in its direction. It exceeds the shortest move by at most r (1/cos(pi/32) - 1), about
0.5 percent of r.
"""

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from functools import partial
from itertools import pairwise

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.distance import find_foot
from exactsweep.geometry.overlap import Relation
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.layout.board import Board
from exactsweep.layout.clearance import find_clearance, relate
from exactsweep.layout.rounded import RoundedPiece, bound_root, inscribe, list_disc, to_region
from exactsweep.layout.solid import OutsideForm, Solid, share_scale
from exactsweep.layout.verdict import judge_pair
from exactsweep.numbers.digits import find_magnitude
from exactsweep.numbers.number import ORIGIN, Edge, Point
from exactsweep.sweep import free_positions, inner_fit_polygon, no_fit_polygon

_SIDES, _STEPS, _DIGITS, _BITS = 32, 30, (6, 9, 12), 64
_MAX_STEPS = 8
# For radii below this share of the part, a square is precise enough.
_TINY = Fraction(1, 10**6)


def find_depth_move(board: Board, placements: Sequence[int], bits: int) -> Point | None:
    """Find the shortest move of the last placement that removes all overlap; ignore errors."""
    if not board.is_rounded(placements):
        return _find_move(board, placements, bits, Fraction(0))
    is_free = _make_overlap_judge(board, placements, bits)
    move = _find_rounded_move(board, placements, bits, Fraction(0))
    if move is None or not is_free(move):
        move = _find_move(board, placements, bits, Fraction(0))
    return move and _shorten(move, is_free, digits=())


def find_repair(board: Board, placements: Sequence[int], bits: int) -> Point | None:
    """Find a shortest move that the judge accepts, for two placements, or one and the container."""
    k = placements[-1]
    solid = board.solid(k, bits)
    if len(placements) > 1:
        required = board.layout.spacing
        slack = solid.slack + board.solid(placements[0], bits).slack
    else:
        required = board.greatest_margin
        slack = solid.slack + max((wall.slack for wall in board.obstacles), default=Fraction(0))
    room = required + slack
    is_rounded_pair = board.is_rounded(placements)
    is_free = make_judge(board, placements, bits)
    move = _find_rounded_move(board, placements, bits, room) if is_rounded_pair else None
    if move is None or not is_free(move):
        move = _find_move(board, placements, bits, room)
    if move is None:
        return None
    if (room or is_rounded_pair) and move != ORIGIN:
        move = _shorten(move, is_free)
    return move if is_free(move) else None


def find_free_move(board: Board, k: int) -> Point | None:
    """Find a shortest move, up to half the part's size, that frees a placement from all others."""
    layout = board.layout
    if board.is_rounded([k]):
        return None
    left, right, low, high = (Fraction(side) / board.solid(k).scale for side in board.solid(k).box)
    reach = max(right - left, high - low) / 2
    placed = board.list_neighbors(k, 2 * reach)
    room = max(layout.spacing, board.greatest_margin) + board.solid(k).slack
    room += max((board.solid(j).slack for j in placed), default=Fraction(0)) + layout.error
    obstacles = [to_region(defect.shape) for defect in layout.defects]
    obstacles += [board.turned(j).translated(layout.placements[j].move) for j in placed]
    moved = board.turned(k)
    if room:
        moved = enlarge(moved, room)
    inner = free_positions(_make_room(board), obstacles, moved)
    loops = [ring for one in inner.regions for ring in (one.exterior, *one.holes)]
    move = _find_nearest(layout.placements[k].move, loops, inner.exact_fits)
    return None if move is None or max(abs(move.x), abs(move.y)) > reach else move


def make_judge(board: Board, placements: Sequence[int], bits: int) -> Callable[[Point], bool]:
    k = placements[-1]
    at = board.layout.placements[k].move

    def is_free(move: Point) -> bool:
        there = Point(at.x + move.x, at.y + move.y)

        def moved(fixed: Callable[[int], Solid]) -> Callable[[int], tuple[Solid, Solid]]:
            return lambda b: (board.solid_at(k, there, b), fixed(b))

        if len(placements) > 1:
            pairs = [(moved(partial(board.solid, placements[0])), board.layout.spacing)]
        else:
            pairs = [
                (moved(partial(_return_solid, wall)), board.required(k))
                for k, wall in enumerate(board.obstacles)
            ]
        for pair, required in pairs:
            found = judge_pair(pair, bits, required)
            if found.too_close is not False or found.meeting is Relation.OVERLAP:
                return False
        return True

    return is_free


def _return_solid(solid: Solid, bits: int) -> Solid:
    return solid


def _find_move(board: Board, placements: Sequence[int], bits: int, room: Fraction) -> Point | None:
    k = placements[-1]
    at, moved = board.layout.placements[k].move, board.turned(k, bits)
    if room:
        moved = enlarge(moved, room)
    loops: Iterable[Polygon]
    if len(placements) > 1:
        j = placements[0]
        there = board.layout.placements[j].move
        at = Point(at.x - there.x, at.y - there.y)
        no_fit = no_fit_polygon(stationary=board.turned(j, bits), orbiting=moved)
        loops, fits = [no_fit.exterior, *no_fit.holes], no_fit.exact_fits
    else:
        defects = [to_region(defect.shape) for defect in board.layout.defects]
        container = _make_room(board)
        if defects:
            inner = free_positions(container, defects, moved)
        else:
            inner = inner_fit_polygon(container, moved)
        loops = [ring for one in inner.regions for ring in (one.exterior, *one.holes)]
        fits = inner.exact_fits
    return _find_nearest(at, loops, fits)


def _find_rounded_move(
    board: Board, placements: Sequence[int], bits: int, room: Fraction
) -> Point | None:
    """Find a move of rounded solids; each step separates the two pieces that overlap most.

    If the first step frees the solids, it is their shortest move, with relative error at most 2^-60
    if irrational. Return None if the steps do not end, or for a container that has defects, is not
    rounded, or has a radius less than a piece's radius plus `room`.
    """
    k, move = placements[-1], ORIGIN
    if len(placements) > 1:
        fixed = board.solid(placements[0], bits)
    elif len(board.obstacles) == 1 and isinstance(board.obstacles[0].form, OutsideForm):
        fixed = board.obstacles[0]
    else:
        return None
    at, is_outside = board.layout.placements[k].move, len(placements) < 2
    for _ in range(_MAX_STEPS):
        part = board.solid_at(k, Point(at.x + move.x, at.y + move.y), bits)
        pair = share_scale(part, fixed) if is_outside else share_scale(fixed, part)
        found = find_clearance(*pair)
        assert found is not None
        missing, (x, y) = room - found.bound(up=False), found.hulls.normal
        if missing <= 0:
            return move
        if is_outside and found.radius + room > 0:
            # The shrunk container is not a rounded piece.
            return None
        share = missing / bound_root(Fraction(x * x + y * y), _BITS)[0]
        move = Point(move.x + share * x, move.y + share * y)
    return None


def _make_overlap_judge(
    board: Board, placements: Sequence[int], bits: int
) -> Callable[[Point], bool]:
    k = placements[-1]
    at = board.layout.placements[k].move
    fixed = [board.solid(placements[0], bits)] if len(placements) > 1 else board.obstacles

    def is_free(move: Point) -> bool:
        moved = board.solid_at(k, Point(at.x + move.x, at.y + move.y), bits)
        return all(relate(*share_scale(moved, one)) is not Relation.OVERLAP for one in fixed)

    return is_free


def _find_nearest(at: Point, loops: Iterable[Polygon], fits: Iterable[Edge]) -> Point | None:
    edges = [(a, b) for loop in loops for a, b in pairwise((*loop.vertices, loop.vertices[0]))]
    moves = [
        Point(foot.x - at.x, foot.y - at.y)
        for foot in (find_foot(at, edge) for edge in (*edges, *fits))
    ]
    return min(moves, key=lambda by: (by.x * by.x + by.y * by.y, by), default=None)


def _make_room(board: Board) -> Region:
    container = board.layout.container
    if isinstance(container, RoundedPiece):
        return inscribe(container)
    return container or make_box(board.frame)


def make_box(frame: tuple[int, int, int, int]) -> Region:
    west, south, east, north = frame
    across, up = east - west, north - south
    left, low, right, high = west - across, south - up, east + across, north + up
    return Region([(left, low), (right, low), (right, high), (left, high)])


def enlarge(region: Region, radius: Fraction) -> Region:
    """Return a region that contains all points within `radius` of another region."""
    low, high = region.bounding_box
    sides = 4 if radius < _TINY * min(high.x - low.x, high.y - low.y) else _SIDES
    disc = Region([(x * radius, y * radius) for x, y in list_disc(sides)])
    grown = no_fit_polygon(stationary=region, orbiting=disc)
    try:
        return Region(grown.exterior, [hole.vertices for hole in grown.holes])
    except PolygonError:
        # Holes touch; without them the region is larger.
        return Region(grown.exterior)


def _shorten(
    move: Point, is_free: Callable[[Point], bool], digits: Sequence[int] = _DIGITS
) -> Point:
    if not is_free(move):
        return move
    low, high = Fraction(0), Fraction(1)
    for _ in range(_STEPS):
        middle = (low + high) / 2
        if is_free(Point(move.x * middle, move.y * middle)):
            high = middle
        else:
            low = middle
    shorter = Point(move.x * high, move.y * high)
    for number in digits:
        rounded = Point(_round(shorter.x, number), _round(shorter.y, number))
        if is_free(rounded):
            return rounded
    return shorter


def _round(value: Fraction, digits: int) -> Fraction:
    if not value:
        return value
    unit = Fraction(10) ** (find_magnitude(abs(value)) - digits + 1)
    return round(value / unit) * unit
