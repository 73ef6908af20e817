"""Families of any shape: mostly sets of squares, which often fit each other."""

from collections.abc import Callable, Sequence
from fractions import Fraction

from exactsweep.corpus.generator import cells
from exactsweep.corpus.generator.prng import Prng
from exactsweep.corpus.generator.shapes import untangle, walk
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.geometry.vectors import angle_key, compare_angles

Regions = tuple[Region, Region]
Draw = Callable[[Prng], Regions]
SHEARS: list[cells.Matrix] = [
    ((1, 0), (0, 1)),
    ((1, 1), (0, 1)),
    ((1, 0), (2, 1)),
    ((2, 1), (1, 1)),
    ((0, -1), (1, 3)),
    ((3, -4), (4, 3)),
    ((1, 2), (3, -1)),
]
SCALES = [Fraction(1), Fraction(1), Fraction(1), Fraction(7, 3), Fraction(10**15)]


def polyominoes_pair(random: Prng) -> Regions:
    """Two clumps of squares, with cavities, holes and touching corners."""
    return cells.trace_outline(_draw_clump(random, 8)), cells.trace_outline(_draw_clump(random, 24))


def jigsaw_pair(random: Prng) -> Regions:
    """A clump of squares cut in two: the parts fit, along segments or in single positions."""
    squares = set(_draw_clump(random, 30)) | cells.build_block(2, 2)
    part = {random.choice(sorted(squares))}
    for _ in range(random.between(0, len(squares) // 2)):
        adjacent = sorted(set(cells.around(part)) & squares)
        if len(squares) > len(part) + 1:
            part.add(random.choice(adjacent))
    return cells.trace_outline(part), cells.trace_outline(cells.connect(squares - part))


def mould_pair(random: Prng) -> Regions:
    """A block with the part cut out of it, closed or open to one side."""
    part = _draw_clump(random, 7)
    low = [min(cell[k] for cell in part) for k in (0, 1)]
    inside = cells.move(part, (random.between(0, 1) - low[0], random.between(0, 1) - low[1]))
    width, height = (max(c[k] for c in inside) + random.between(1, 2) for k in (0, 1))
    block = cells.build_block(width + 2, height + 2, -1, -1)
    return cells.trace_outline(part), cells.trace_outline(cells.connect(block - inside))


def cave_pair(random: Prng) -> Regions:
    """A block with a cavity, and an entry about as wide as the part, or none."""
    width, height = random.between(3, 7), random.between(3, 7)
    cavity = cells.build_block(width - 2, height - 2, 1, 1)
    start = random.between(1, width - 2)
    entry = {(x, 0) for x in range(start, min(start + random.between(0, 2), width - 1))}
    pillars = {cell for cell in sorted(cavity) if random.chance(1, 10)}
    solid = cells.build_block(width, height) - cavity - entry | pillars
    part = cells.build_block(random.between(1, 2), random.between(1, 2))
    if random.chance(3, 10):
        part = set(_draw_clump(random, 5))
    return cells.trace_outline(part), cells.trace_outline(cells.connect(solid))


def spiral_pair(random: Prng) -> Regions:
    """A wall that winds inwards, along a corridor one or two squares wide."""
    turns, gap = random.between(3, 7), random.between(2, 3)
    directions = ((1, 0), (0, 1), (-1, 0), (0, -1))
    steps = [directions[k % 4] for k in range(turns) for _ in range((turns - k + 1) // 2 * gap + 1)]
    part = set(_draw_clump(random, 5))
    if random.chance(3, 5):
        part = cells.build_block(random.between(1, gap), random.between(1, gap))
    return cells.trace_outline(part), cells.trace_outline(walk(steps))


def rings_pair(random: Prng) -> Regions:
    """Two frames, one often as wide as the hole of the other: rings around rings."""
    width, height = random.between(3, 5), random.between(3, 5)
    more = [random.between(0, 2) if random.chance(1, 2) else 2 for _ in "xy"]
    inner = cells.build_frame(width, height)
    if random.chance(3, 10):
        inner.discard((1, 0))
    outer = cells.build_frame(width + more[0], height + more[1])
    return cells.trace_outline(outer), cells.trace_outline(cells.connect(inner))


def stars_pair(random: Prng) -> Regions:
    """Two star-shaped polygons with spikes and notches."""
    return _draw_star(random), _draw_star(random)


def tangles_pair(random: Prng) -> Regions:
    """Two random simple polygons on a 9 by 9 grid."""
    return Region(_draw_untangled(random, 12, 9)), Region(_draw_untangled(random, 12, 9))


def plate_pair(random: Prng) -> Regions:
    """A plate with holes, some as wide as the part or congruent to it."""
    part = _draw_untangled(random, 6, 4)
    low, high = part.bounding_box
    width, height = (int(c) + 1 for c in (high.x - low.x, high.y - low.y))
    across, up = random.between(1, 3), random.between(1, 2)
    holes = []
    for i in range(across):
        for j in range(up):
            corner = i * (width + 1) + 1, j * (height + 1) + 1
            drawn = random.between(1, 10)
            if drawn <= 5:
                holes.append(part.translated((corner[0] - low.x, corner[1] - low.y)))
            elif drawn <= 8:
                more = width - 1 + random.between(0, 1), height - random.between(0, 1)
                holes.append(_make_box(corner, (corner[0] + more[0], corner[1] + max(more[1], 1))))
    size = across * (width + 1) + 1, up * (height + 1) + 1
    return Region(part), Region(_make_box((0, 0), size), holes)


def container_pair(random: Prng) -> Regions:
    """A container, possibly with a defect, that the part fits loosely, exactly, or not at all."""
    part = _draw_untangled(random, 7, 5)
    low, high = part.bounding_box
    width, height = int(high.x - low.x), int(high.y - low.y)
    size = width + random.choice([0, 0, 1, 4]), height + random.choice([0, 0, 1, 4])
    holes: list[Polygon] = []
    if random.chance(2, 5) and min(size) > 2:
        x, y = random.between(1, size[0] - 2), random.between(1, size[1] - 2)
        holes.append(Polygon([(x, y), (x + 1, y), (x, y + 1)]))
    return Region(part), Region(_make_box((0, 0), size), holes)


def combs_pair(random: Prng) -> Regions:
    """Teeth and gaps that face each other, often of equal width."""

    def comb() -> set[cells.Cell]:
        squares: set[cells.Cell] = set()
        x = 0
        for k in range(2 * random.between(1, 3) + 1):
            width = random.choice([1, 1, 2])
            for _ in range(width):
                squares |= cells.build_block(1, 1 if k % 2 else random.between(2, 4), x)
                x += 1
        return squares

    return cells.trace_outline({(-x, -y) for x, y in comb()}), cells.trace_outline(comb())


def place(random: Prng, draw: Draw, scales: Sequence[Fraction] = SCALES) -> Regions:
    """Draw a pair; shear, scale and translate both polygons; sometimes exchange their roles."""
    while True:
        try:
            g, d = draw(random)
            break
        except PolygonError:  # points of a random ring coincide
            continue
    if random.chance(1, 5):
        g, d = d, g
    shear, scale = random.choice(SHEARS), random.choice(scales)

    def placed(shape: Region) -> Region:
        return cells.map_region(shape, shear, scale, (random.between(-9, 9), random.between(-9, 9)))

    return placed(g), placed(d)


def _draw_clump(random: Prng, most: int) -> frozenset[cells.Cell]:
    return cells.grow(random.between(0, 10**6) for _ in range(random.between(0, most - 1)))


def _make_box(low: cells.Cell, high: cells.Cell) -> Polygon:
    return Polygon([low, (high[0], low[1]), high, (low[0], high[1])])


def _draw_star(random: Prng) -> Region:
    size = random.choice([9, 30, 1000])
    points = {(size, -1), (-1, size), (-size, -size)}  # the origin is inside
    for _ in range(random.between(2, 11)):
        x, y = random.between(-size, size), random.between(-size, size)
        if (x, y) != (0, 0):
            points.add((x, y))
    return Region(Polygon(sort_by_angle(points)))


def sort_by_angle(points: set[cells.Cell]) -> list[cells.Cell]:
    """Sort points around the origin, and keep the first in each direction."""
    found: list[cells.Cell] = []
    for p in sorted(sorted(points), key=angle_key):
        if not found or compare_angles(found[-1], p):
            found.append(p)
    return found


def _draw_untangled(random: Prng, most: int, side: int) -> Polygon:
    """Draw a random simple polygon: reverse parts of a random tour until no edges cross."""
    while True:
        n = random.between(3, most)
        points = [(random.between(0, side), random.between(0, side)) for _ in range(n)]
        try:
            return Polygon(untangle(dict.fromkeys(points)))
        except PolygonError:
            continue
