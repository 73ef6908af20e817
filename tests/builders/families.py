"""Parametric families of the shipped corpus: pairs or answers of any requested size.

`shipped` lists the members in the corpus, with their ids.
"""

from collections.abc import Iterable, Iterator, Sequence
from random import Random
from typing import Any

from exactsweep import Region
from exactsweep.corpus.generator import growing
from exactsweep.corpus.generator.any_shape import sort_by_angle
from exactsweep.corpus.generator.cells import build_block, connect, trace_outline
from exactsweep.corpus.generator.shapes import walk

Ring = Sequence[tuple[Any, Any]]
Shape = Ring | Region
UNIT: Ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
FLAT: Ring = [(0, 0), (900, -40), (1700, 0), (800, 30)]


def box(width: Any, height: Any, x: Any = 0, y: Any = 0) -> Ring:
    return [(x, y), (x + width, y), (x + width, y + height), (x, y + height)]


def turned(ring: Ring) -> Ring:
    """Reflect a ring in the origin."""
    return [(-x, -y) for x, y in ring]


def under(bottom: Iterable[tuple[Any, Any]], lid: Any) -> Ring:
    """A block with a given bottom chain, from left to right, and a flat top."""
    chain = [*bottom]
    return [*chain, (chain[-1][0], lid), (chain[0][0], lid)]


def columns(widths: Sequence[Any], heights: Sequence[Any]) -> list[tuple[Any, Any]]:
    """A chain of horizontal and vertical edges, starting at x = 0."""
    chain: list[tuple[Any, Any]] = []
    x = 0
    for width, height in zip(widths, heights, strict=True):
        chain += [(x, height), (x + width, height)]
        x += width
    return chain


def zigzag(size: int) -> Ring:
    ring = growing.zigzag(size + size % 2, Random(f"zigzag {size}"), 500, 700)
    return ring[: size // 2] + ring[size // 2 + size % 2 :]


def lying_comb(teeth: int) -> Ring:
    """Teeth that point right, with all tips at one x and all roots at another."""
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
    """Spikes around the origin, in evenly spread directions."""
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


def maze(cells: int) -> Region:
    """Walls around a tree of passages, one square wide; the way in is at the lower left."""
    random = Random(f"maze {cells}")
    side = 2 * cells + 1
    open_cells = {(1, 1), (1, 0)}
    path = [(1, 1)]
    while path:
        x, y = path[-1]
        directions = [
            (dx, dy)
            for dx, dy in ((2, 0), (0, 2), (-2, 0), (0, -2))
            if 0 < x + dx < side and 0 < y + dy < side and (x + dx, y + dy) not in open_cells
        ]
        if not directions:
            path.pop()
            continue
        dx, dy = random.choice(directions)
        open_cells |= {(x + dx // 2, y + dy // 2), (x + dx, y + dy)}
        path.append((x + dx, y + dy))
    return trace_outline(connect(build_block(side, side) - open_cells))


def grating(across: int, up: int) -> Region:
    """Unit holes at distance 1."""
    holes = [box(1, 1, 2 * x + 1, 2 * y + 1) for x in range(across) for y in range(up)]
    return Region(box(2 * across + 1, 2 * up + 1), holes)


def cave(unit: Any, entry: Any) -> Ring:
    """A room of three by three units, with an entry of a given width in its floor."""
    left, right = 2 * unit, 2 * unit + entry
    inside = [(left, 0), (left, unit), (unit, unit), (unit, 4 * unit), (4 * unit, 4 * unit)]
    inside += [(4 * unit, unit), (right, unit), (right, 0)]
    return [(0, 0), *inside, (5 * unit, 0), (5 * unit, 5 * unit), (0, 5 * unit)]


def wound(turns: int, gap: int) -> Region:
    directions = ((1, 0), (0, 1), (-1, 0), (0, -1))
    steps = [directions[k % 4] for k in range(turns) for _ in range((turns - k + 1) // 2 * gap + 1)]
    return trace_outline(walk(steps))


def many_slopes(n: int) -> Ring:
    """A convex polygon with 2 n edges of different slopes and their opposites."""
    steps = [(n, k) for k in range(-n // 2, n - n // 2)]
    chain = [(0, 0)]
    for dx, dy in [*steps, *((-x, -y) for x, y in steps)]:
        chain.append((chain[-1][0] + dx, chain[-1][1] + dy))
    return chain[:-1]


# irregular distances
PLACES = [0, 300, 691, 1013, 1502, 1844, 2365, 2700, 3131, 3651, 4000, 4507, 4900, 5403, 5801]
PLACES += [6388, 6700]


def mountains() -> Ring:
    """A polygon with peaks and valleys at PLACES on top, and a single point at the bottom."""
    top = [(4 * x, 10_000 * (k % 2)) for k, x in enumerate(PLACES)]
    return [(0, 0), (2 * PLACES[-1], -10_000), *top[:0:-1]]


def needles(count: int) -> Ring:
    """Needles that hang from a high ceiling, at distances of nearly the width of the zigzag."""
    apart, ceiling = 4 * PLACES[-1] - 2 * PLACES[1], 80_000
    tips = [(k * apart + aside, y) for k in range(count) for aside, y in ((-1, 1), (0, 0), (1, 1))]
    bottom = [(x, ceiling * y) for x, y in tips]
    return [*bottom, (bottom[-1][0] // 2, ceiling + 1)]


def shipped() -> Iterator[tuple[str, Shape, Shape]]:
    for size in 40, 41, 127, 128, 129, 255, 256, 257, 511, 512, 513:
        yield f"large-zigzag-{size}", zigzag(size), FLAT
    for m, n in (257, 3), (3, 257), (300, 300), (1000, 12):
        g, d = growing.cc(m + m % 2, n + n % 2)
        yield f"large-convex-{m}-{n}", d[:m], g[:n]
    for family, m, n in [
        (growing.cm_hard, 258, 12),
        (growing.cm_hard, 66, 64),
        (growing.cm_undercut, 130, 16),
        (growing.mm, 300, 30),
        (growing.mm, 64, 300),
        (growing.figure10, 34, 34),
    ]:
        g, d = family(m, n)
        yield f"large-{family.__name__.replace('_', '-')}-{m}-{n}", d, g
    for count in 65, 130:
        yield f"large-on-one-x-{count}", lying_comb(count), UNIT
    yield "large-on-one-y", upright_comb(260), UNIT
    yield "large-stairs", stairs(250), stairs(20)
    for size, other in (64, 5), (24, 24), (257, 5):
        small: Ring = [(x // 20, y // 20) for x, y in star(other, 10**6)]
        yield f"large-spikes-{size}-{other}", star(size, 10**6), small
    yield "large-plate", plate(13, 10), UNIT
    yield "large-maze", maze(15), UNIT
    yield "large-maze-wide", maze(9), box(2, 1)
    yield "plates-grating-dense", grating(12, 8), box(1, 1)
    for name, entry in ("closed", -1), ("exact", 0), ("open", 1):
        yield f"caves-near-{name}", cave(10**15, 10**15 + entry), box(10**15, 10**15)
    for turns in 4, 7, 12:
        for gap in 2, 3:
            for width in range(1, gap):
                yield f"spirals-{turns}-{gap}-square-{width}", wound(turns, gap), box(width, width)
    for n in 2, 4, 8:
        for teeth in 2, 4:
            for name, gap in ("trajectory", 2 * n * n), ("fine-comb", 2 * n * n // 5 + 1):
                d = growing.comb(4 * teeth, gap, 20 * n * n)
                yield f"lower-bounds-{name}-cm-{teeth}-{n}", d, many_slopes(n)
    for sizes in (2, 4, 8), (4, 4, 8), (6, 4, 4), (6, 6, 8), (2, 8, 4):
        g, d = growing.bumps(*sizes)
        id = f"lower-bounds-outer-mm-{'-'.join(map(str, sizes))}"
        yield id, d, g
        yield f"{id}-above", turned(d), turned(g)
    for count in 2, 3:
        yield f"lower-bounds-inner-mm-{count}", needles(count), mountains()
    for m, n in (7, 8), (10, 12), (13, 16):
        g, d = growing.ceilings(m, n)
        yield f"lower-bounds-undercuts-mm-{m}-{n}", d, g
