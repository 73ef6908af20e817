"""Polyominoes: shapes of unit squares, with free positions by counting squares.

At an integer position (x, y), polyominoes overlap if they share a square. Inside a unit edge or a
unit square of positions, a square of G lies over two or four squares of D, so they overlap if they
share a square at one of the integer positions at its ends or corners.
"""

from collections.abc import Iterator
from itertools import product

from cells import shape_of
from hypothesis import strategies as st

from exactsweep import Region
from exactsweep.corpus.generator.cells import Cell

Cells = frozenset[Cell]
Matrix = tuple[int, int, int, int]


@st.composite
def polyominoes(draw: st.DrawFn, most: int = 12, side: int = 5) -> Cells:
    """Draw squares joined along edges, half of them with holes."""
    cells = {(0, 0)}
    for _ in range(draw(st.integers(0, most - 1))):
        near = sorted(
            {
                (x + dx, y + dy)
                for x, y in cells
                for dx, dy in ((1, 0), (0, 1), (-1, 0), (0, -1))
                if 0 <= x + dx < side and 0 <= y + dy < side
            }
            - cells
        )
        if near:
            cells.add(draw(st.sampled_from(near)))
    return frozenset(cells)


def frame(cells: Cells, width: int = 1) -> Cells:
    """Draw a rectangle with a polyomino cut out."""
    xs, ys = zip(*cells, strict=True)
    whole = product(
        range(min(xs) - width, max(xs) + width + 1), range(min(ys) - width, max(ys) + width + 1)
    )
    return frozenset(whole) - cells


def region(cells: Cells, matrix: Matrix = (1, 0, 0, 1)) -> Region:
    """Return a polyomino as a Region, mapped by a regular integer matrix."""
    a, b, c, d = matrix
    loops = [[(a * x + b * y, c * x + d * y) for x, y in loop] for loop in rings(cells)]
    return Region(loops[0], loops[1:])


def rings(cells: Cells) -> list[list[Cell]]:
    """Return the rings, exterior first; rings touch where squares touch at a point."""
    exterior, holes = shape_of(cells)
    return [[(int(x), int(y)) for x, y in ring.vertices] for ring in (exterior, *holes)]


def free_cells(stationary: Cells, orbiting: Cells) -> tuple[set[Cell], set[Cell], set[Cell]]:
    """Find bounded free positions and exact fits by unit squares.

    Returns:
        Free unit squares enclosed by positions of overlap, by their lower left corners; exact fits
        in units of one half: midpoints of free unit edges between two squares of overlap; and
        isolated free points.
    """
    overlapped = {(dx - gx, dy - gy) for dx, dy in stationary for gx, gy in orbiting}

    def free(x: int, y: int) -> bool:
        """Decide whether a position is free, in units of one half: odd between grid lines."""
        return not any(
            (i, j) in overlapped for i in {x // 2, -(-x // 2)} for j in {y // 2, -(-y // 2)}
        )

    xs, ys = zip(*overlapped, strict=True)
    left, right, low, high = 2 * min(xs) - 4, 2 * max(xs) + 4, 2 * min(ys) - 4, 2 * max(ys) + 4
    squares = {
        (x, y) for x in range(left + 1, right, 2) for y in range(low + 1, high, 2) if free(x, y)
    }
    outside = {(left + 1, low + 1)}
    front = list(outside)
    while front:
        x, y = front.pop()
        for near in ((x + 2, y), (x - 2, y), (x, y + 2), (x, y - 2)):
            if near in squares and near not in outside:
                outside.add(near)
                front.append(near)
    edges = set()
    points = set()
    for x, y in product(range(left + 1, right), range(low + 1, high)):
        if x % 2 == y % 2 == 1 or not free(x, y):
            continue
        if x % 2 != y % 2:
            step = (1, 0) if x % 2 == 0 else (0, 1)
            sides = ((x + step[0], y + step[1]), (x - step[0], y - step[1]))
            if not any(side in squares for side in sides):
                edges.add((x, y))
    for x, y in product(range(left + 2, right, 2), range(low + 2, high, 2)):
        around = product((x - 1, x, x + 1), (y - 1, y, y + 1))
        if free(x, y) and not any(free(*near) for near in around if near != (x, y)):
            points.add((x, y))
    return {((x - 1) // 2, (y - 1) // 2) for x, y in squares - outside}, edges, points


def unit_edges(fit: tuple[Cell, Cell]) -> Iterator[Cell]:
    """Return the midpoints of the unit edges of a fit along the grid, in units of one half."""
    (ax, ay), (bx, by) = sorted(fit)
    for k in range(max(bx - ax, by - ay)):
        yield (2 * ax + 2 * k + 1, 2 * ay) if ay == by else (2 * ax, 2 * ay + 2 * k + 1)
