"""Polygons that are all but flat."""

from collections.abc import Iterator

from builders.entry import UNIT, Entry, Ring, box, columns, scaled, turned, under

TITLE = "Polygons that are all but flat"

LONG = 10**6
NEEDLE: Ring = [(0, 0), (LONG, 1), (LONG, 2)]
WEDGE: Ring = [(0, 0), (LONG, 0), (LONG, 1)]
RHOMB: Ring = [(0, 0), (LONG, -1), (2 * LONG, 0), (LONG, 1)]
FLAG = ("sliver",)


def entries() -> Iterator[Entry]:
    yield Entry("needle-itself", "A needle around itself", NEEDLE, NEEDLE, FLAG)
    yield Entry("needle-inverse", "A needle around its inverse", turned(NEEDLE), NEEDLE, FLAG)
    yield Entry("needle-square", "A needle around a square", UNIT, NEEDLE, FLAG)
    yield Entry("square-needle", "A square around a needle", NEEDLE, UNIT, FLAG)
    yield Entry("wedge-rhomb", "Slopes of nearly nothing", RHOMB, WEDGE, FLAG)
    yield Entry("rhomb-tiny-square", "A square as high as the rhomb", RHOMB, scaled(UNIT, 2), FLAG)
    yield Entry("upright", "A needle standing up", [(0, 0), (2, LONG), (1, LONG)], box(1, 2), FLAG)
    yield Entry(
        "upright-and-lying",
        "A needle standing up around one that lies",
        NEEDLE,
        [(0, 0), (2, LONG), (1, LONG)],
        FLAG,
    )
    yield Entry(
        "corrugated", "A sheet of thickness one part in 10^9, folded", CORRUGATED, TILE, FLAG
    )
    yield Entry("corrugated-itself", "The folded sheet around itself", CORRUGATED, CORRUGATED, FLAG)
    yield Entry(
        "thin-wall",
        "A wall between two pockets, of a thickness of one part in 10^9",
        THIN_WALL,
        TILE,
        FLAG,
    )
    yield Entry(
        "area-of-10-18", "Twice the area is one, and the sides are 10^18", GOLDEN, UNIT, FLAG
    )


N = 10**9
FOLDS = [(0, 0), (2 * N, 2 * N), (4 * N, 0), (6 * N, 2 * N), (8 * N, 0)]
CORRUGATED: Ring = [*FOLDS, *((x, y + 1) for x, y in reversed(FOLDS))]
THIN_WALL: Ring = under(
    columns([N, 2 * N, 1, 2 * N, N], [0, 2 * N, 0, 2 * N, 0]),
    4 * N,
)
TILE: Ring = box(N, N)


def fibonacci(count: int) -> list[int]:
    numbers = [0, 1]
    while len(numbers) <= count:
        numbers.append(numbers[-2] + numbers[-1])
    return numbers


# Neighbouring Fibonacci numbers: the cross product of these two sides is 1.
_F = fibonacci(88)
GOLDEN: Ring = [(0, 0), (_F[87], _F[86]), (_F[88], _F[87])]
