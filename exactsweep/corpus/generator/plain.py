"""Families of generic and degenerate pairs."""

from collections.abc import Sequence

from exactsweep.corpus.generator import shapes
from exactsweep.corpus.generator.prng import Prng

RingPair = Sequence[shapes.Ring]  # a generatrix and a directrix
TINY_GRID = shapes.Grid(cells=(1, 5), widths=(1, 1, 1, 2), height=2, walls=2)
# Invertible integer matrices by rows; one reverses the orientation.
MATRICES = [
    ((0, -1), (1, 0)),
    ((1, 1), (0, 1)),
    ((1, 0), (1, 1)),
    ((3, -4), (4, 3)),
    ((2, 1), (1, 1)),
    ((1, 2), (3, -1)),
    ((7, 1000), (1, 143)),
]


def convex_pair(random: Prng) -> RingPair:
    """Two convex polygons on a 100 by 100 grid."""
    return shapes.draw_convex(random, 12, 100), shapes.draw_convex(random, 12, 100)


def notched_pair(random: Prng) -> RingPair:
    """A convex polygon around a monotone one on a 20 by 20 grid."""
    grid = shapes.Grid(cells=(2, 7), widths=(3, 5, 8), height=20, walls=1)
    return shapes.draw_convex(random, 8, random.choice([6, 12])), shapes.draw_monotone(random, grid)


def monotone_pair(random: Prng) -> RingPair:
    """Two monotone polygons on a 20 by 20 grid."""
    grid = shapes.Grid(cells=(2, 6), widths=(3, 5, 8), height=20, walls=1)
    return shapes.draw_monotone(random, grid), shapes.draw_monotone(random, grid)


def grid_pair(random: Prng) -> RingPair:
    """Two polygons on a 3 by 3 grid; most edges are parallel, collinear or equal."""
    directrix = _on_grid(random)
    chosen = random.between(0, 7)
    if chosen == 0:
        return directrix, directrix
    if chosen == 1:
        return shapes.reflect_ring(directrix), directrix
    return _on_grid(random), directrix


def rectilinear_pair(random: Prng) -> RingPair:
    """Two rectilinear polygons with slots and teeth of few widths."""
    widths = random.choice([(1,), (1, 2), (2, 3)])
    generatrix = shapes.draw_rectilinear(random, (1, 4), widths, 2)
    return generatrix, shapes.draw_rectilinear(random, (2, 7), widths, 3)


def fits_pair(random: Prng) -> RingPair:
    """A block with slots as wide as G or a part of it, of equal, greater or smaller depth."""
    widths = [random.between(1, 3) for _ in range(random.between(1, 3))]
    heights = [random.between(1, 4) for _ in widths]
    generatrix = shapes.build_columns(widths, heights)
    generatrix = [(0, -1), (sum(widths), -1), *reversed(generatrix)]
    slot = [(w, h + random.between(-1, 1)) for w, h in zip(widths, heights, strict=True)]
    cells: list[tuple[int, int]] = []
    for _ in range(random.between(1, 2)):
        cells += [(random.between(1, 2), 0), *slot]
    cells.append((random.between(1, 2), 0))
    bottom = shapes.build_columns([w for w, _ in cells], [h for _, h in cells])
    lid = max(h for _, h in cells) + 1
    rings = [generatrix, [*bottom, (bottom[-1][0], lid), (0, lid)]]
    return rings if random.chance(1, 2) else [shapes.reflect_ring(ring) for ring in rings]


def equal_slopes_pair(random: Prng) -> RingPair:
    """Teeth with the same two slopes in both polygons, which have many parallel edges."""
    depth = random.choice([1, 3, 1000])
    steps = [(1, depth), (1, -depth), (1, depth), (1, -depth), (2, 2 * depth), (2, 0)]

    def teeth() -> shapes.Ring:
        bottom, top = (
            shapes.walk([random.choice(steps) for _ in range(random.between(2, 8))]) for _ in "bt"
        )
        return shapes.close_between(random, bottom, top)

    return teeth(), teeth()


def tangent_pair(random: Prng) -> RingPair:
    """The bottom of D is molded over the top of G in several places: many points of contact."""
    width = random.between(2, 6)
    top = [random.between(0, 4) for _ in range(width + 1)]
    places = [(random.between(0, 5), random.between(-1, 1)) for _ in range(random.between(2, 4))]
    length = max(x for x, _ in places) + width
    # Between two integers the mold is straight and above G.
    mold = []
    for x in range(length + 1):
        under = [top[x - at] + rise for at, rise in places if 0 <= x - at <= width]
        mold.append((x, max(under) if under else random.between(-2, 2)))
    floor, lid = min(top) - 1, max(y for _, y in mold) + 1
    generatrix = [(0, floor), (width, floor), *((x, top[x]) for x in range(width, -1, -1))]
    return generatrix, [*mold, (length, lid), (0, lid)]


def turned_pair(random: Prng) -> RingPair:
    """A pair of the family "grid", "monotone" or "fits", mapped by an integer matrix.

    It is usually not x-monotone.
    """
    rings = random.choice([grid_pair, monotone_pair, fits_pair])(random)
    (a, b), (c, d) = random.choice(MATRICES)
    return [[(a * x + b * y, c * x + d * y) for x, y in ring] for ring in rings]


def respelled_pair(random: Prng) -> RingPair:
    """A pair of the family "grid", doubled, with collinear and repeated vertices.

    The rings have either orientation and start at any vertex.
    """
    return [_respell(random, ring) for ring in grid_pair(random)]


def _on_grid(random: Prng) -> shapes.Ring:
    if random.chance(1, 3):
        return shapes.draw_convex(random, 8, random.choice([1, 2, 3]))
    return shapes.draw_monotone(random, TINY_GRID)


def _respell(random: Prng, ring: shapes.Ring) -> shapes.Ring:
    first = random.between(0, len(ring) - 1)
    ring = [(2 * x, 2 * y) for x, y in ring[first:] + ring[:first]]
    spelled: shapes.Ring = []
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1], strict=True):
        spelled += [(ax, ay)] * random.choice([1, 1, 2])
        if random.chance(2, 5):
            spelled.append(((ax + bx) // 2, (ay + by) // 2))
    return spelled[::-1] if random.chance(1, 2) else spelled
