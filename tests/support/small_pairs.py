"""Small pairs of all classes, random or mutated from others; shapes are lists of rings.

The exterior comes first; coordinates are ints.
"""

from collections.abc import Callable
from functools import cache
from random import Random
from typing import Any, NamedTuple

import families
from shape_families import untangled

from exactsweep import Region
from exactsweep.check import point_in_polygon
from exactsweep.corpus.generator.cells import connect, grow, trace_outline
from exactsweep.geometry.canonical import PolygonError, canonicalize_ring
from exactsweep.geometry.vectors import find_hull

Ring = list[tuple[Any, Any]]
Shape = list[Ring]
Draw = Callable[[Random], Shape]
FARTHEST = 2**40  # the maximum distance from the origin along either axis
SMALL = 14
TABLE = 3000  # shapes that are monotone in no direction
FACTOR = 2**34  # beyond the precision to which the kernel rounds slopes and parameters


class SmallPair(NamedTuple):
    """G and D."""

    generatrix: Shape
    directrix: Shape

    def size(self) -> tuple[int, int]:
        """Return the number of vertices, and the sum of the coordinates."""
        rings = [*self.generatrix, *self.directrix]
        return sum(map(len, rings)), sum(abs(c) for ring in rings for p in ring for c in p)


def convex(rng: Random) -> Shape:
    return [families.convex(rng, [1, 2, 3, 4, 6], 7)]


def monotone(rng: Random) -> Shape:
    return [families.jagged(rng, rng.choice([0, 4]), (1, 3))]


def rectilinear(rng: Random) -> Shape:
    return [families.rectilinear(rng)]


def teeth(rng: Random) -> Shape:
    return [families.teeth(rng, [1, 2], 4)]


def tangle(rng: Random) -> Shape:
    """Draw a simple polygon on a small grid."""
    return _rings(Region(untangled(rng, 12, rng.choice([4, 5, 7]))))


def clump(rng: Random) -> Shape:
    """Draw a few squares, perhaps around a hole."""
    return _rings(trace_outline(grow(rng.randrange(10**6) for _ in range(rng.randint(3, 12)))))


def bent(rng: Random) -> Shape:
    """Draw a shape that is monotone in no direction."""
    return _bent(rng.randrange(TABLE))


@cache
def _bent(number: int) -> Shape:
    """Draw a shape from a table, because most small shapes are monotone in some direction."""
    rng = Random(number)
    while shares_direction(SmallPair(shape := rng.choice([tangle, clump])(rng), shape)):
        pass
    return shape


def standing(rng: Random) -> Shape:
    """Draw a polygon that is monotone in Y."""
    return _turned(rng.choice(MONOTONE)(rng), TURNS[0])


def _rings(region: Region) -> Shape:
    return [[(int(x), int(y)) for x, y in ring] for ring in region.rings]


CONVEX: list[Draw] = [convex]
MONOTONE: list[Draw] = [monotone, rectilinear, teeth]
CLASSES = [(CONVEX, CONVEX), (CONVEX, MONOTONE), (MONOTONE, CONVEX), (MONOTONE, MONOTONE)]
STANDING: list[Draw] = [standing]
BENT: list[Draw] = [bent]
SHAPELESS = [
    (MONOTONE, STANDING),
    (STANDING, MONOTONE),
    (CONVEX + MONOTONE, BENT),
    (BENT, CONVEX + MONOTONE + BENT),
]
TURNS = [(0, -1, 1, 0), (-1, 0, 0, -1), (0, 1, -1, 0), (1, 0, 0, -1)]
STRETCHED = [
    (1, 0, FACTOR, 1),
    (FACTOR, 0, 0, 1),
    (1, 0, 0, FACTOR),
    (FACTOR, 1, -1, FACTOR),
]


def draw(rng: Random) -> SmallPair:
    """Draw a pair of any class but SS, perhaps rotated by multiples of 90 degrees or scaled."""
    return _placed(rng, _draw_pair(rng, CLASSES))


def draw_shapeless(rng: Random) -> SmallPair:
    """Draw a pair of class SS."""
    pair = _draw_pair(rng, SHAPELESS)
    while shares_direction(pair):
        pair = _draw_pair(rng, SHAPELESS)
    return _placed(rng, pair)


def draw_touching(rng: Random) -> SmallPair:
    """Draw a pair whose D has touching rings: at a common vertex, or a vertex on an edge."""
    while not _has_touching_rings(directrix := rng.choice([_pinched, _dented])(rng)):
        pass
    generatrix = rng.choice([convex, convex, monotone, clump, _pinched])(rng)
    return _placed(rng, SmallPair(generatrix, directrix))


def draw_around(rng: Random) -> SmallPair:
    """Draw a container with defects, and a part with holes that may enclose some of them."""
    side = rng.randint(3, 5)
    while len(part := _cut_out(rng, side, rng.randint(side - 2, side), rng.randint(1, 3))) == 1:
        pass
    # Defects create islands of overlap if their distance from the walls exceeds the part's width.
    margin = rng.choice([0, side, side + 1])
    width, holes = 2 * margin + rng.randint(side + 1, 2 * side), rng.randint(1, 5)
    container = _cut_out(rng, width, rng.randint(1, 2), holes, margin)
    return _placed(rng, SmallPair(part, container))


def _pinched(rng: Random) -> Shape:
    """Draw squares around holes that meet at corners."""
    width, height = rng.randint(4, 6), rng.randint(3, 5)
    cells = {(x, y) for x in range(width) for y in range(height)}
    left_out = {cell for cell in sorted(cells) if rng.random() < 0.3}
    return _rings(trace_outline(connect(cells - left_out or cells)))


def _dented(rng: Random) -> Shape:
    side = rng.randint(4, 8)
    return _cut_out(rng, side, side, rng.randint(4, 12))


def _cut_out(rng: Random, side: int, width: int, tries: int, margin: int = 0) -> Shape:
    """Cut boxes, triangles and quadrilaterals out of a square while it stays connected."""
    rings: Shape = [_box(0, 0, side)]
    for _ in range(tries):
        left, low = (rng.randint(margin, side - width - margin) for _ in "xy")
        box = _box(left, low, width)
        points = [
            (left + rng.randint(0, width), low + rng.randint(0, width))
            for _ in range(rng.choice([3, 4]))
        ]
        hole = [*find_hull(rng.choice([box, points]))]
        try:
            Region(rings[0], [*rings[1:], hole])
        except PolygonError:
            continue
        rings.append(hole)
    return rings


def _box(left: int, low: int, side: int) -> Ring:
    right, high = left + side, low + side
    return [(left, low), (right, low), (right, high), (left, high)]


def _has_touching_rings(shape: Shape) -> bool:
    region = Region(shape[0], shape[1:])
    return any(
        point_in_polygon(p, other) == 0
        for ring in region.rings
        for other in region.rings
        if other is not ring
        for p in ring
    )


def _draw_pair(rng: Random, classes: list[tuple[list[Draw], list[Draw]]]) -> SmallPair:
    generatrix, directrix = (rng.choice(shapes)(rng) for shapes in rng.choice(classes))
    if rng.random() < 0.1:
        directrix = [[(-x, -y) for x, y in ring] for ring in generatrix]
    return SmallPair(generatrix, directrix)


def shares_direction(pair: SmallPair) -> bool:
    """Decide whether both are monotone in one direction; polygons with holes are not."""
    rings = [tuple(ring) for shape in pair for ring in shape]
    return len(rings) == 2 and has_shared_direction(rings)


def _placed(rng: Random, pair: SmallPair) -> SmallPair:
    chance = rng.random()
    if chance < 0.5:
        return pair
    matrix = rng.choice(TURNS if chance < 0.9 else STRETCHED)
    return SmallPair(*(_turned(shape, matrix) for shape in pair))


def _turned(shape: Shape, matrix: tuple[int, int, int, int]) -> Shape:
    a, b, c, d = matrix
    return [[(a * x + b * y, c * x + d * y) for x, y in ring] for ring in shape]


def breed(rng: Random, pair: SmallPair) -> SmallPair:
    """Apply one to three mutations to a pair.

    Shapes with holes are only scaled or exchanged.
    """
    for _ in range(8):
        shapes = [[list(ring) for ring in shape] for shape in pair]
        for _ in range(rng.randint(1, 3)):
            rng.choice(_CHANGES)(rng, shapes, rng.randrange(2))
        if all(map(_is_sound, shapes)):
            return SmallPair(*shapes)
    return pair


def _is_sound(shape: Shape) -> bool:
    if any(abs(c) > FARTHEST for ring in shape for p in ring for c in p):
        return False
    try:
        canonicalize_ring(shape[0])
    except PolygonError:
        return False
    return True


def _move(rng: Random, shapes: list[Shape], k: int) -> None:
    if len(shapes[k]) == 1:
        ring = shapes[k][0]
        i = rng.randrange(len(ring))
        x, y = ring[i]
        ring[i] = (x + rng.randint(-1, 1), y + rng.randint(-1, 1))


def _drop(rng: Random, shapes: list[Shape], k: int) -> None:
    if len(shapes[k]) == 1 and len(shapes[k][0]) > 3:
        del shapes[k][0][rng.randrange(len(shapes[k][0]))]


def _insert(rng: Random, shapes: list[Shape], k: int) -> None:
    """Insert a vertex near the midpoint of an edge."""
    ring = shapes[k][0]
    if len(shapes[k]) == 1 and len(ring) < 12:
        i = rng.randrange(len(ring))
        (ax, ay), (bx, by) = ring[i - 1], ring[i]
        middle = (ax + bx) // 2 + rng.randint(-1, 1), (ay + by) // 2 + rng.randint(-1, 1)
        ring.insert(i, middle)


def _copy_edge(rng: Random, shapes: list[Shape], k: int) -> None:
    """Make an edge of one polygon equal to an edge vector of the other."""
    ring, other = shapes[k][0], shapes[1 - k][0]
    if len(shapes[k]) == 1:
        i, j, sign = rng.randrange(len(ring)), rng.randrange(len(other)), rng.choice([1, -1])
        (ax, ay), (bx, by) = other[j - 1], other[j]
        x, y = ring[i - 1]
        ring[i] = (x + sign * (bx - ax), y + sign * (by - ay))


def _double(rng: Random, shapes: list[Shape], k: int) -> None:
    if max(abs(c) for p in shapes[k][0] for c in p) <= SMALL:
        shapes[k] = [[(2 * x, 2 * y) for x, y in ring] for ring in shapes[k]]


def _exchange(rng: Random, shapes: list[Shape], k: int) -> None:
    shapes.reverse()


def _invert(rng: Random, shapes: list[Shape], k: int) -> None:
    shapes[k] = [[(-x, -y) for x, y in ring] for ring in shapes[k]]


_CHANGES = [_move, _move, _move, _insert, _drop, _copy_edge, _double, _exchange, _invert]


def shrink(pair: SmallPair, fails: Callable[[SmallPair], bool]) -> SmallPair:
    """Reduce a failing pair by dropping and moving single vertices."""
    while True:
        for candidate in sorted(_smaller(pair), key=SmallPair.size):
            is_smaller = all(map(_is_sound, candidate)) and candidate.size() < pair.size()
            if is_smaller and fails(candidate):
                pair = candidate
                break
        else:
            return pair


def _smaller(pair: SmallPair) -> list[SmallPair]:
    found = []
    for k, shape in enumerate(pair):
        for r, ring in enumerate(shape):
            rings = [[*ring[:i], *ring[i + 1 :]] for i in range(len(ring)) if len(ring) > 3]
            for i, (x, y) in enumerate(ring):
                for p in ((_nearer(x), y), (x, _nearer(y)), (x // 2, y), (x, y // 2)):
                    rings.append([*ring[:i], p, *ring[i + 1 :]])
            if r:
                rings.append([])
            low_x, low_y = (min(p[axis] for p in ring) for axis in (0, 1))
            if len(shape) == 1:
                rings.append([(x - low_x, y - low_y) for x, y in ring])
            for other in rings:
                changed = [*shape[:r], *([other] if other else []), *shape[r + 1 :]]
                found.append(SmallPair(*(changed if j == k else s for j, s in enumerate(pair))))
    return found


def _nearer(c: int) -> int:
    return c - (c > 0) + (c < 0)


def has_shared_direction(rings: Any) -> bool:
    """Decide whether all rings are weakly monotone in one direction perpendicular to some edge."""
    edges = [
        [(q[0] - p[0], q[1] - p[1]) for p, q in zip(r, [*r[1:], r[0]], strict=True)] for r in rings
    ]
    return any(
        all(_count_turns([x * u + y * v for x, y in own]) == 2 for own in edges)
        for u, v in {(-y, x) for own in edges for x, y in own}
    )


def _count_turns(along: Any) -> int:
    signs = [n > 0 for n in along if n]
    return sum(a != b for a, b in zip(signs, signs[1:] + signs[:1], strict=True))
