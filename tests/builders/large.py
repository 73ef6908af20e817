"""Polygons of up to a thousand vertices, answers of thousands, and sizes next to powers of two."""

from collections.abc import Iterator
from random import Random

from builders.entry import UNIT, Entry, Ring, box, columns
from exactsweep import Region
from exactsweep.corpus.generator import growing
from exactsweep.corpus.generator.any_shape import sort_by_angle
from exactsweep.corpus.generator.cells import build_block, connect, trace_outline

TITLE = "Up to a thousand vertices, answers of thousands, sizes next to powers of two"

FLAT: Ring = [(0, 0), (900, -40), (1700, 0), (800, 30)]


def entries() -> Iterator[Entry]:
    for size in 40, 41, 127, 128, 129, 255, 256, 257, 511, 512, 513:
        title = f"A zigzag of {size} vertices"
        yield Entry(f"zigzag-{size}", title, zigzag(size), FLAT)
    for m, n in (257, 3), (3, 257), (300, 300), (1000, 12):
        g, d = growing.cc(m + m % 2, n + n % 2)
        yield Entry(f"convex-{m}-{n}", f"Convex, {m} and {n} vertices", d[:m], g[:n])
    for family, m, n in [
        (growing.cm_hard, 258, 12),
        (growing.cm_hard, 66, 64),
        (growing.cm_undercut, 130, 16),
        (growing.mm, 300, 30),
        (growing.mm, 64, 300),
        (growing.figure10, 34, 34),
    ]:
        g, d = family(m, n)
        name = family.__name__.replace("_", "-")
        title = f"{m} and {n} vertices of the family {name}"
        yield Entry(f"{name}-{m}-{n}", title, d, g)
    for count in 65, 130:
        yield Entry(
            f"on-one-x-{count}",
            f"{count} vertices of each loop on one x",
            lying_comb(count),
            UNIT,
        )
    yield Entry("on-one-y", "Hundreds of vertices on one y", upright_comb(260), UNIT)
    yield Entry("stairs", "Stairs of 250 steps around stairs of 20", stairs(250), stairs(20))
    for size, other in (64, 5), (24, 24), (257, 5):
        title = f"Spikes all round, {size} and {other} vertices"
        small: Ring = [(x // 20, y // 20) for x, y in star(other, 10**6)]
        yield Entry(f"spikes-{size}-{other}", title, star(size, 10**6), small)
    yield Entry("plate", "A plate with 130 holes, as wide as the part", plate(13, 10), UNIT)
    yield Entry("plate-of-triangles", "A plate with 100 triangles cut out", cut(10, 10), SMALL)
    yield Entry("maze", "A maze with a corridor as wide as the part", maze(15), UNIT)
    yield Entry("maze-wide", "A maze, the part wider than its corridors", maze(9), box(2, 1))


def zigzag(size: int) -> Ring:
    ring = growing.zigzag(size + size % 2, Random(f"zigzag {size}"), 500, 700)
    return ring[: size // 2] + ring[size // 2 + size % 2 :]


def lying_comb(teeth: int) -> Ring:
    """Teeth to the right, their tips and their roots each on one x."""
    right = [
        (x, y)
        for k in range(teeth)
        for x, y in ((9, 3 * k), (9, 3 * k + 1), (4, 3 * k + 1), (4, 3 * k + 3))
    ]
    return [(0, 0), *right[:-2], (0, 3 * teeth - 2)]


def upright_comb(teeth: int) -> Ring:
    bottom = columns([1, 2] * teeth + [1], [0, 5] * teeth + [0])
    return [*bottom, (bottom[-1][0], 9), (0, 9)]


def stairs(steps: int) -> Ring:
    up = columns([2] * steps, [3 * k for k in range(steps)])
    return [(0, -1), (2 * steps, -1), *reversed(up)]


def star(size: int, reach: int) -> Ring:
    """Spikes around the origin, in directions as different as can be."""
    random = Random(f"star {size}")
    points: set[tuple[int, int]] = {(reach, -7), (-5, reach), (-reach, -reach)}
    while len(sort_by_angle(points)) < size:
        x, y = (random.randrange(-reach, reach + 1) for _ in "xy")
        if abs(x) + abs(y) > reach // 4:
            points.add((x, y))
    return sort_by_angle(points)


def plate(across: int, up: int) -> Region:
    holes = []
    for x in range(across):
        for y in range(up):
            holes.append(box(1 + (x + y) % 2, 1 + (x * y) % 2, 3 * x + 1, 3 * y + 1))
    return Region(box(3 * across + 1, 3 * up + 1), holes)


SMALL: Ring = [(0, 0), (2, 0), (0, 2)]


def cut(across: int, up: int) -> Region:
    holes: list[Ring] = []
    for x in range(across):
        for y in range(up):
            side = 1 + (x + 2 * y) % 4
            a, b = 5 * x + 1, 5 * y + 1
            holes.append([(a, b), (a + side, b), (a, b + side)])
    return Region(box(5 * across + 1, 5 * up + 1), holes)


def maze(rooms: int) -> Region:
    """Walls around a tree of passages, one square wide; the way in is at the lower left."""
    random = Random(f"maze {rooms}")
    side = 2 * rooms + 1
    open_cells = {(1, 1), (1, 0)}
    path = [(1, 1)]
    while path:
        x, y = path[-1]
        ways = [
            (dx, dy)
            for dx, dy in ((2, 0), (0, 2), (-2, 0), (0, -2))
            if 0 < x + dx < side and 0 < y + dy < side and (x + dx, y + dy) not in open_cells
        ]
        if not ways:
            path.pop()
            continue
        dx, dy = random.choice(ways)
        open_cells |= {(x + dx // 2, y + dy // 2), (x + dx, y + dy)}
        path.append((x + dx, y + dy))
    return trace_outline(connect(build_block(side, side) - open_cells))
