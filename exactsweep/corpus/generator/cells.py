"""Sets of unit squares, and their shapes."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction

from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region

Cell = tuple[int, int]
Matrix = tuple[Cell, Cell]
SIDES = ((1, 0), (0, 1), (-1, 0), (0, -1))


def build_block(width: int, height: int, x: int = 0, y: int = 0) -> set[Cell]:
    return {(x + i, y + j) for i in range(width) for j in range(height)}


def build_frame(width: int, height: int) -> set[Cell]:
    return build_block(width, height) - build_block(width - 2, height - 2, 1, 1)


def list_neighbors(cell: Cell) -> list[Cell]:
    return [(cell[0] + dx, cell[1] + dy) for dx, dy in SIDES]


def around(cells: Iterable[Cell]) -> list[Cell]:
    own = set(cells)
    return sorted({near for cell in own for near in list_neighbors(cell)} - own)


def grow(choices: Iterable[int]) -> frozenset[Cell]:
    """Make a connected set of squares by adding neighbors."""
    cells = {(0, 0)}
    for choice in choices:
        adjacent = around(cells)
        cells.add(adjacent[choice % len(adjacent)])
    return frozenset(cells)


def connect(cells: Iterable[Cell]) -> set[Cell]:
    """Keep the squares that are connected to the least one by edges."""
    given = set(cells)
    found, left = {min(given)}, [min(given)]
    while left:
        adjacent = set(list_neighbors(left.pop())) & given - found
        found |= adjacent
        left += adjacent
    return found


def move(cells: Iterable[Cell], by: Sequence[int]) -> set[Cell]:
    return {(x + by[0], y + by[1]) for x, y in cells}


def trace_outline(cells: Iterable[Cell]) -> Region:
    """Return the shape of a connected set of squares; rings may touch at corners.

    >>> trace_outline(build_frame(3, 3))
    Region([(0, 0), (3, 0), (3, 3), (0, 3)], [[(1, 1), (2, 1), (2, 2), (1, 2)]])
    """
    filled = set(cells)
    ahead: dict[Cell, list[Cell]] = defaultdict(list)
    for x, y in filled:
        corners = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
        beyond = [(x, y - 1), (x + 1, y), (x, y + 1), (x - 1, y)]
        for k in range(4):
            if beyond[k] not in filled:
                ahead[corners[k]].append(corners[(k + 1) % 4])
    rings: list[Polygon] = []
    while ahead:
        start = p = min(ahead)
        ring = [p]
        q = ahead[p][0]
        while True:
            ahead[p].remove(q)
            if not ahead[p]:
                del ahead[p]
            if q == start:
                break
            ring.append(q)
            right = (q[0] + q[1] - p[1], q[1] - q[0] + p[0])
            p, q = q, right if right in ahead[q] else ahead[q][0]
        rings.append(Polygon(ring))
    # The exterior is the widest ring.
    exterior = min(rings, key=lambda ring: ring.vertices)
    return Region(exterior, [ring for ring in rings if ring is not exterior])


def map_region(
    shape: Region, matrix: Matrix, scale: Fraction = Fraction(1), by: Cell = (0, 0)
) -> Region:
    (a, b), (c, d) = matrix
    exterior, *holes = (
        [((a * x + b * y + by[0]) * scale, (c * x + d * y + by[1]) * scale) for x, y in ring]
        for ring in shape.rings
    )
    return Region(exterior, holes)
