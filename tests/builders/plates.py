"""Plates with many holes: punched sheets, flanges, gratings, and parts made to go into them."""

from collections.abc import Iterator
from fractions import Fraction

from builders import outlines
from builders.entry import Entry, Ring, box, in_places, moved, scaled
from exactsweep import Region
from exactsweep.corpus.generator.cells import draw

TITLE = "Plates with many holes, and parts that go into some of them"


def entries() -> Iterator[Entry]:
    octagon: Ring = [(1, 0), (3, 0), (4, 1), (4, 3), (3, 4), (1, 4), (0, 3), (0, 1)]
    pin = Region(scaled(octagon, Fraction(1, 2)))
    for slug, title, d, g in [
        ("grating", "A grating of equal holes, the part as wide", grating(4, 3), draw("#")),
        ("grating-dense", "Twelve by eight holes", grating(12, 8), draw("#")),
        ("grating-slots", "A part for two holes at once", draw(*["# # #", "#####"] * 2), FORK),
        ("sizes", "Holes from too small to large", sizes(), Region(box(3, 3))),
        ("flange", "A flange with bolt holes, and a pin", flange(octagon), pin),
        ("flange-exact", "A pin as thick as the bolt holes", flange(octagon), Region(octagon)),
        ("ring", "A flange in the hole of a plate", housing(), flange(octagon)),
        ("letters", "A plate with letters cut out, and one of them", stencil(), letter("letter-t")),
        ("letters-other", "A letter that is not there", stencil(), letter("letter-z")),
        ("slots", "Slots of two directions", slots(), Region(box(4, 1))),
        ("slots-across", "A part that fits across only", slots(), Region(box(1, 4))),
        (
            "holed-part",
            "A plate with holes around a plate with holes",
            grating(3, 2),
            grating(2, 2),
        ),
        ("on-pins", "A grating that moves on two pins", draw("# #", "###"), grating(3, 2)),
        ("triangles", "Triangular holes, both ways up", triangles(), Region(TRIANGLE)),
    ]:
        if len(d) < 200:
            yield from in_places(slug, title, d, g)
        else:
            yield Entry(slug, title, d, g, inside=True)


TRIANGLE: Ring = [(0, 0), (4, 0), (2, 3)]
FORK = draw("# #", "###")


def grating(across: int, up: int) -> Region:
    """Unit holes, one apart."""
    holes = [box(1, 1, 2 * x + 1, 2 * y + 1) for x in range(across) for y in range(up)]
    return Region(box(2 * across + 1, 2 * up + 1), holes)


def sizes() -> Region:
    """Square holes with sides from 1 to 6."""
    left = [k * (k + 1) // 2 for k in range(1, 7)]
    return Region(box(30, 8), [box(k + 1, k + 1, x, 1) for k, x in enumerate(left)])


def flange(hole: Ring) -> Region:
    rim = outlines.arc(0, 0, 25, 0, 4)[:-1]
    middle = scaled(hole, 2)
    bolts = [moved(hole, x - 2, y - 2) for x, y in ((14, 0), (0, 14), (-14, 0), (0, -14))]
    return Region(rim, [moved(middle, -4, -4), *bolts])


def housing() -> Region:
    return Region(box(80, 60, -40, -30), [outlines.arc(0, 0, 25, 0, 4)[:-1]])


def letter(name: str) -> Region:
    return Region(outlines.ALONG_Y[name])


def stencil() -> Region:
    names = ["letter-t", "letter-f", "letter-e"]
    holes = [moved(outlines.ALONG_Y[name], 40 * k, 0) for k, name in enumerate(names)]
    return Region(box(130, 60, -10, -8), holes)


def slots() -> Region:
    return Region(box(12, 12), [box(5, 1, 1, 1), box(4, 1, 1, 4), box(1, 5, 8, 1), box(3, 1, 1, 8)])


def triangles() -> Region:
    up = [moved(TRIANGLE, 1, 1), moved(scaled(TRIANGLE, 2), 7, 1)]
    down = [moved([(0, 3), (2, 0), (4, 3)], 1, 6)]
    return Region(box(18, 12), [*up, *down])
