"""Polygons with holes: G in a hole of D, and D in a hole of G."""

from collections.abc import Iterator
from fractions import Fraction

from builders.entry import UNIT, Entry, Ring, box, in_places, moved, scaled
from exactsweep import Region
from exactsweep.corpus.generator.cells import draw

TITLE = "Polygons with holes: room in them, an exact fit, none"

PLATE = draw("#####", "#   #", "#   #", "#####")
SQUARE, TALL, LARGE = draw("#"), draw("#", "#"), draw("##", "##")
TRIANGLE: Ring = [(0, 0), (4, 0), (0, 4)]
NEAR = 10**15


def entries() -> Iterator[Entry]:
    yield from in_places("room", "A square in a hole with room", PLATE, SQUARE)
    yield from in_places("as-high", "A part exactly as high as the hole", PLATE, TALL)
    yield from in_places("as-large", "A part of the shape of the hole", PLATE, draw("###", "###"))
    yield from in_places("too-large", "A part too large for the hole", PLATE, draw("####", "####"))
    yield from in_places("around", "A plate that moves around what lies in its hole", SQUARE, PLATE)
    yield from in_places("around-tight", "A plate whose hole is as high as D", TALL, PLATE)
    yield from in_places("both", "A plate in the hole of a plate", BIG, PLATE)
    yield from in_places("of-a-triangle", "A triangle in a hole of its shape", TRIANGULAR, SMALL)
    yield from in_places("touching-holes", "Holes that touch in a corner", TOUCHING, SQUARE)
    yield from in_places("hole-at-the-rim", "A hole that touches the exterior", RIM, SQUARE)
    for slug, title, hole in [
        ("clockwise", "The hole is given clockwise", box(2, 2, 1, 1)[::-1]),
        ("collinear", "The hole is given with vertices on its edges", COLLINEAR),
        ("repeated", "The hole is given with its first vertex twice", [(1, 1), *box(2, 2, 1, 1)]),
    ]:
        yield Entry(slug, title, box(4, 4), UNIT, d_holes=(hole,))
    yield Entry(
        "all-clockwise",
        "Everything is given clockwise",
        box(4, 4)[::-1],
        UNIT[::-1],
        d_holes=(box(2, 2, 1, 1)[::-1],),
    )
    for slug, title, size in [
        ("near-too-narrow", "A hole too narrow by one part in 10^15", NEAR - 1),
        ("near-exact", "A hole of 10^15 that fits", NEAR),
        ("near-too-wide", "A hole wider by one part in 10^15", NEAR + 1),
    ]:
        hole = box(size, 2 * NEAR, NEAR, NEAR)
        yield Entry(slug, title, box(4 * NEAR, 4 * NEAR), box(NEAR, NEAR), d_holes=(hole,))
    for slug, title, factor in [
        ("huge", "A hole at 10^30", Fraction(10**30)),
        ("tiny", "A hole at 10^-30", Fraction(1, 10**30)),
        ("beyond-binary64", "A hole at 10^400", Fraction(10**400)),
    ]:
        hole = scaled(box(2, 2, 1, 1), factor)
        yield Entry(slug, title, scaled(box(4, 4), factor), scaled(UNIT, factor), d_holes=(hole,))
    yield Entry("far", "A hole 10^18 away", moved(box(4, 4), 10**18, 7), UNIT, d_holes=(FAR_HOLE,))
    yield Entry(
        "sliver", "A hole thinner than G by far", box(8, 8), UNIT, d_holes=(box(6, THIN, 1, 1),)
    )


BIG = draw("########", "#      #", "#      #", "#      #", "#      #", "########")
TRIANGULAR = Region([(-3, -2), (9, -2), (-3, 10)], [TRIANGLE])
SMALL = Region([(0, 0), (2, 0), (0, 2)])
TOUCHING = draw("######", "#  ###", "#  ###", "###  #", "###  #", "######")
RIM = Region(box(6, 6), [[(0, 3), (2, 1), (4, 3), (2, 5)]])
COLLINEAR: Ring = [(1, 1), (2, 1), (3, 1), (3, 2), (3, 3), (1, 3)]
FAR_HOLE = moved(box(2, 2, 1, 1), 10**18, 7)
THIN = Fraction(1, 10**9)
