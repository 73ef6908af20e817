"""What exactsweep itself once answered wrongly, or was found to be easy to get wrong."""

from collections.abc import Iterator

from builders.entry import UNIT, Entry, Ring, mirrored, turned, under

TITLE = "Past failures of exactsweep itself"

FLAG = ("past-failure",)
TOWER: Ring = [(0, 0), (6, 0), (6, 1), (7, 1), (7, 5), (6, 5), (6, 3), (0, 3)]

PAIRS: list[tuple[str, str, Ring, Ring]] = [
    (
        "break-not-reduced-wall-in-g",
        "Two equal breaks, one of them written -12/6: a crash",
        [(0, 0), (1, -1), (2, -1)],
        [(4, -4), (5, -3), (4, 1), (4, 0), (2, 0), (1, 1)],
    ),
    (
        "break-not-reduced-straight-d",
        "Two equal breaks written differently, D straight below: a crash",
        [(4, 0), (3, 5), (3, 4), (1, 4), (0, 5)],
        [(3, -2), (4, -3), (5, -3), (5, 2), (4, 1), (0, 0)],
    ),
    (
        "break-not-reduced-wall-in-d",
        "Two equal breaks written differently, a wall in D: a wrong outer loop",
        [(14, 2), (18, 4), (24, 2), (24, 0), (28, 3), (0, 6)],
        [(4, -7), (5, -6), (12, -2), (6, 0), (2, -2)],
    ),
    (
        "pruned-neighbour-convex-d",
        "A part left out, without which a later one seemed to be lowest: a wrong outer loop",
        [(0, 0), (9, 0), (13, 1), (14, 0), (15, 5)],
        [
            *[(4, -1), (15, -2), (18, 0), (35, -1), (24, 3)],
            *[(19, 3), (18, 2), (14, 3), (3, 1), (1, 3)],
        ],
    ),
    (
        "pruned-neighbour-zigzag-d",
        "A part left out, D a zigzag: a wrong outer loop",
        [(1, 0), (5, -2), (6, 0), (7, -2), (17, -1), (0, 8)],
        [
            *[(6, -1), (12, 1), (29, 0), (18, 5), (17, 6)],
            *[(15, 6), (5, 4), (3, 6), (2, 4), (0, 6)],
        ],
    ),
    (
        "repeated-point",
        "A vertex that is there twice, taken for a reflex one: a hole in the trajectory",
        [(0, 0), (1, -1), (1, -1), (2, 0), (2, 0)],
        [(0, -1), (1, -1), (1, 0), (0, 0)],
    ),
    (
        "shared-point",
        "A vertex that two chains share, taken for an inner one: a wrong trajectory",
        under([(0, 2), (2, 0), (4, 2), (5, 1), (6, 1)], 4),
        [(0, 1), (1, 0), (2, 1), (1, 2)],
    ),
    (
        "wall-of-g-in-an-undercut",
        "The upper end of G's wall taken for the contact: a point that is not on D",
        TOWER,
        TOWER,
    ),
    (
        "step-behind-a-wall",
        "A pocket behind a wall of D: its contact on the wall",
        [(0, 1), (1, 1), (1, 3), (4, 0), (5, 0), (5, 4), (0, 4)],
        UNIT,
    ),
]


def entries() -> Iterator[Entry]:
    for slug, title, d, g in PAIRS:
        yield Entry(slug, title, d, g, FLAG)
        yield Entry(f"{slug}-turned", f"{title}, turned by half a turn", turned(d), turned(g), FLAG)
        yield Entry(f"{slug}-mirrored", f"{title}, mirrored", mirrored(d), mirrored(g), FLAG)
