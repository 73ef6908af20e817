"""Spirals: walls that wind inwards, with a corridor wider than G, as wide, and narrower."""

from collections.abc import Iterator
from fractions import Fraction

from builders.entry import Entry, Ring, in_places
from exactsweep import Region
from exactsweep.corpus.generator.cells import build_block, draw, trace_outline
from exactsweep.corpus.generator.shapes import walk

TITLE = "Spirals with a corridor wider than G, as wide, and narrower"


def entries() -> Iterator[Entry]:
    for turns in 4, 7, 12:
        for gap in 2, 3:
            for width in range(1, gap):
                part = trace_outline(build_block(width, width))
                title = f"{turns} turns {gap} apart, a square of {width}"
                yield from in_places(
                    f"{turns}-{gap}-square-{width}", title, wound(turns, gap), part
                )
    for slug, title, d, g in [
        ("bar", "A bar that gets around no corner", wound(7, 3), draw("####")),
        ("bent", "A bent bar", wound(7, 3), draw("##", "# ")),
        ("itself", "A spiral around itself", wound(5, 2), wound(5, 2)),
        ("inverse", "A spiral around its inverse", wound(5, 3), wound(5, 3).reflected()),
        ("two", "Two spirals that wind into each other", wound(6, 4), wound(4, 4).reflected()),
        ("pointed", "A spiral with pointed turns", POINTED, Region([(0, 0), (1, 0), (0, 1)])),
    ]:
        yield from in_places(slug, title, d, g)
    half = Fraction(1, 2)
    yield Entry("narrow", "A square a little too wide", wound(7, 2), SQUARE, inside=True)
    yield Entry(
        "wide", "A square of half the width", wound(7, 2), [(half * x, half * y) for x, y in UNITS]
    )


def wound(turns: int, gap: int) -> Region:
    directions = ((1, 0), (0, 1), (-1, 0), (0, -1))
    steps = [directions[k % 4] for k in range(turns) for _ in range((turns - k + 1) // 2 * gap + 1)]
    return trace_outline(walk(steps))


UNITS: Ring = [(0, 0), (1, 0), (1, 1), (0, 1)]
SQUARE: Ring = [(x * Fraction(10**9 + 1, 10**9), y) for x, y in UNITS]
POINTED = Region(
    [
        *[(0, 0), (12, -2), (14, 10), (2, 12), (3, 4), (9, 3), (9, 7), (7, 7), (7, 5), (5, 6)],
        *[(4, 10), (12, 8), (10, 0), (1, 2)],
    ]
)
