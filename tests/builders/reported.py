"""After what users of other programs reported: pairs of the same kind, made anew."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from builders import outlines
from builders.entry import Entry, Ring, box, columns, mapped, moved, scaled, under
from exactsweep.corpus.generator.cells import draw

TITLE = "What users of other programs reported: exact bins, identical parts, lost holes, slivers"

FLAG = ("reported",)
L: Ring = [(0, 0), (7, 0), (7, 3), (3, 3), (3, 8), (0, 8)]
C: Ring = [(0, 0), (9, 0), (9, 3), (3, 3), (3, 6), (9, 6), (9, 9), (0, 9)]


def entries() -> Iterator[Entry]:
    for thread, cases in THREADS.items():
        for slug, title, d, g, *more in cases:
            d_holes, g_holes = [*more, (), ()][:2]
            note = f"The kind of pair of which https://github.com/{thread} tells."
            yield Entry(
                slug, title, d, g, FLAG, inside=True, note=note, d_holes=d_holes, g_holes=g_holes
            )


def quarter(radius: int) -> Ring:
    return outlines.arc(0, 0, radius, 0, 4)[:-1]


def finely(steps: int) -> Ring:
    """A bow of many short edges on a coarse grid of 1/8."""
    eighth = Fraction(1, 8)
    arch = [(k, eighth * round(8 * k * (steps - k) / Fraction(steps))) for k in range(steps + 1)]
    return [*reversed(arch), *((x, y - steps) for x, y in arch)]


CRYSTAL: Ring = [
    (0, 0),
    (Fraction(32, 3), Fraction(166, 3)),
    (Fraction(-100, 3), Fraction(196, 3)),
    (Fraction(-154, 3), 58),
    (Fraction(-200, 3), Fraction(38, 3)),
    (Fraction(-146, 3), -10),
    (-12, -4),
]
SLANTED = (59, -3, 3, 59)
TEN = 10**15
THREADS: dict[str, list[tuple[Any, ...]]] = {
    "kallaballa/libnfporb/issues/7": [
        ("identical-squares", "Two identical squares", box(12, 12), box(12, 12)),
        ("identical-l", "Two identical letters L", L, L),
        ("identical-apart", "Two identical squares, one moved", box(12, 12), box(12, 12, 30, 5)),
    ],
    "kallaballa/libnfporb/issues/15": [
        ("square-half", "A square and the half of it", box(12, 12), [(0, 0), (12, 0), (12, 12)]),
        ("half-square", "The half of a square, and it", [(0, 0), (12, 0), (12, 12)], box(12, 12)),
    ],
    "kallaballa/libnfporb/issues/20": [
        (
            "start-on-edge",
            "The first vertex is in the middle of an edge",
            [(9, 5), (9, 9), (0, 9), (0, 0), (9, 0)],
            box(2, 2),
        ),
        (
            "start-beside-edge",
            "The first vertex is a little beside an edge",
            [(8, 5), (9, 9), (0, 9), (0, 0), (9, 0)],
            box(2, 2),
        ),
        (
            "arch-in-arch",
            "A vaulted room and a vaulted part",
            finely(12),
            scaled(finely(6), Fraction(3, 4)),
        ),
    ],
    "kallaballa/libnfporb/issues/21": [
        (
            "slots-in-a-hole",
            "Two slots inside a hole, one of which fits",
            box(12, 12),
            [(0, 1), (2, 0), (2, 1), (4, 1), (4, 4), (2, 4), (2, 3), (0, 2)],
            (
                [
                    (3, 3),
                    (3, 1),
                    (11, 1),
                    (11, 10),
                    (3, 10),
                    (3, 7),
                    (5, 7),
                    (5, 6),
                    (4, 6),
                    (4, 4),
                    (5, 4),
                    (5, 3),
                ],
            ),
        ),
        (
            "crossing-bars",
            "Bars that cross in a hole",
            draw("#######", "## # ##", "#     #", "## # ##", "#######"),
            draw("#", "#", "#"),
        ),
    ],
    "kallaballa/libnfporb/issues/22": [
        (
            "all-corners-touch",
            "All corners of a square touch, and it overlaps",
            [
                (2, 1),
                (2, 3),
                (3, 3),
                (3, 1),
                (4, 2),
                (4, 3),
                (3, 4),
                (6, 4),
                (6, 8),
                (0, 8),
                (2, 4),
                (1, 3),
                (1, 2),
            ],
            box(1, 1),
        ),
        (
            "no-fit-in-notch",
            "A notch whose mouth is as wide as the part, and nothing behind it",
            under([(0, 0), (2, 0), (3, 2), (4, 0), (6, 0)], 5),
            box(2, 1),
        ),
    ],
    "kallaballa/libnfporb/issues/32": [
        (
            "shallow",
            "A long dish with shallow steps",
            [
                (17, 14),
                (14, 12),
                (11, 9),
                (8, 7),
                (5, 4),
                (5, 1),
                (31, 1),
                (110, 1),
                (110, 4),
                (98, 14),
                (94, 10),
                (89, 8),
                (73, 5),
                (58, 4),
                (42, 5),
                (26, 8),
                (21, 10),
            ],
            [(0, 0), (9, 0), (12, 3), (-3, 3)],
        ),
        (
            "shallow-itself",
            "The dish around itself",
            [(17, 14), (5, 4), (5, 1), (110, 1), (110, 4), (98, 14), (89, 8), (58, 4), (26, 8)],
            [(17, 14), (5, 4), (5, 1), (110, 1), (110, 4), (98, 14), (89, 8), (58, 4), (26, 8)],
        ),
    ],
    "Jack000/SVGnest/issues/73": [
        ("bin-of-two", "A bin for exactly two squares", box(24, 12), box(12, 12)),
        ("bin-of-two-upright", "The same upright", box(12, 24), box(12, 12)),
        (
            "bin-rest",
            "What is left of a bin once a square is in it",
            box(24, 12),
            box(12, 12),
            (box(10, 10, 1, 1),),
        ),
    ],
    "Jack000/SVGnest/issues/94": [
        ("bin-side", "One side as long as one of the bin", box(96, 48), box(60, 48)),
        (
            "bin-side-eighths",
            "One side longer by an eighth than the bin's",
            box(96, 48),
            box(60, Fraction(385, 8)),
        ),
    ],
    "deepnest-next/deepnest/pull/139": [
        ("bin-exact", "A part of the shape of its bin", box(100, 100), box(100, 100)),
        (
            "bin-exact-far",
            "The same, the part drawn elsewhere",
            box(100, 100),
            box(100, 100, 250, -75),
        ),
        (
            "bin-a-little-larger",
            "A bin larger by 1/100000",
            box(100, 100 + Fraction(1, 10**5)),
            box(100, 100),
        ),
        ("bin-exact-l", "A bin of the shape of a letter L, and the part", L, L),
    ],
    "Jack000/SVGnest/issues/32": [
        (
            "defects",
            "A sheet with two defects",
            box(40, 20),
            L,
            (box(4, 4, 12, 8), [(30, 5), (33, 9), (29, 11)]),
        ),
        (
            "defect-at-rim",
            "A defect that touches the rim in a point",
            box(20, 20),
            L,
            ([(10, 0), (13, 5), (8, 6)],),
        ),
    ],
    "mattatz/Fit/issues/4": [
        ("round-bin", "A bin that is nearly round", quarter(25), box(20, 10)),
        (
            "round-bin-exact",
            "A rectangle whose corners all touch a round bin",
            quarter(25),
            box(30, 40),
        ),
        ("irregular-bin", "A bin of the shape of a letter C", C, box(3, 3)),
    ],
    "CGAL/cgal/issues/2517": [
        (
            "eroded-hole",
            "A hole that G fits into with a room of one, in a bulky plate",
            [(-4, -4), (5, -4), (5, 6), (3, 6), (3, 5), (-4, 5)],
            box(2, 2),
            (box(3, 3, 0, 0),),
        ),
        (
            "eroded-hole-plain",
            "The same in a rectangle",
            box(9, 10, -4, -4),
            box(2, 2),
            (box(3, 3, 0, 0),),
        ),
    ],
    "CGAL/cgal/issues/5830": [
        (
            "large-hole-among-small",
            "One large hole, and nine that are too small",
            box(50, 30),
            quarter(5),
            (
                box(14, 14, 30, 8),
                *(box(2, 2, 3 + 8 * i, 3 + 9 * j) for i in range(3) for j in range(3)),
            ),
        ),
        (
            "small-holes",
            "Nine holes, all too small",
            box(28, 28),
            quarter(5),
            tuple(box(2, 2, 3 + 9 * i, 3 + 9 * j) for i in range(3) for j in range(3)),
        ),
        (
            "holes-just-right",
            "Nine holes, each as wide as G",
            box(40, 40),
            quarter(5),
            tuple(box(10, 10, 2 + 12 * i, 2 + 12 * j) for i in range(3) for j in range(3)),
        ),
    ],
    "AngusJohnson/Clipper2/issues/583": [
        ("fine-arcs", "Arcs of edges about as short as the grid", finely(40), finely(24)),
        ("fine-arc-square", "A square around such an arc", finely(40), box(3, 3)),
    ],
    "AngusJohnson/Clipper2/issues/729": [
        (
            "steps-and-segment",
            "Steps, swept by a bar as flat as can be",
            [*columns([10, 20, 20, 20, 30], [0, 10, 15, 10, 20]), (100, -5), (0, -5)],
            box(2, Fraction(1, 10**6)),
        ),
        (
            "edges-become-collinear",
            "Steps that become collinear under the sum",
            [*columns([10, 20, 10, 20, 10], [10, 10, 20, 10, 10]), (70, 0), (0, 0)],
            box(10, 10),
        ),
    ],
    "AngusJohnson/Clipper2/issues/409": [
        (
            "pentagon-bar",
            "A pentagon and a thin bar",
            [(0, 50), (-48, 15), (-29, -40), (29, -40), (48, 15)],
            box(10, Fraction(1, 100)),
        ),
    ],
    "petrasvestartas/OpenNest/issues/1": [
        (
            "false-holes",
            "The sum of the boundaries has a hole, that of the polygons none",
            C,
            box(2, 2),
        ),
        (
            "false-holes-large",
            "Two large blocks, whose boundaries leave a hole",
            box(30, 30),
            box(9, 9),
        ),
    ],
    "dharani811/NestingCShaprt/issues/1": [
        (
            "not-the-largest",
            "Two holes larger than G, and a cave",
            draw("#########", "#   #   #", "#   #   #", "#########", "#   #", "#   #", "#  ##"),
            draw("##", "##"),
        ),
    ],
    "Jack000/Deepnest/issues/98": [
        (
            "inset",
            "An outline and the same with an inset",
            scaled(quarter(25), 2),
            quarter(25),
            (moved(quarter(25), 5, 0),),
        ),
        (
            "inset-exact",
            "An inset of exactly the part's shape",
            scaled(quarter(25), 2),
            quarter(25),
            (quarter(25),),
        ),
    ],
    "fel88/DeepNestPort/issues/39": [
        (
            "neighbours",
            "Identical parts with tenths, side by side",
            scaled(L, Fraction(1, 10)),
            moved(scaled(L, Fraction(1, 10)), Fraction(7, 10), 0),
        ),
        (
            "neighbours-slanted",
            "Identical parts, slanted, on decimals",
            mapped(scaled(L, Fraction(1, 1000)), SLANTED),
            mapped(scaled(L, Fraction(1, 1000)), SLANTED),
        ),
    ],
    "libgeos/geos/issues/1344": [
        (
            "near-parallel-bars",
            "Two bars whose sides differ by one part in 10^12 in direction",
            [(0, 0), (TEN, 33), (TEN, 33 + TEN // 3), (0, TEN // 3)],
            [(0, 0), (TEN, 34), (TEN - 999, 34 + TEN // 3), (-999, TEN // 3)],
        ),
        (
            "near-parallel-slivers",
            "Slivers whose sides nearly coincide",
            [(0, 0), (TEN, 1), (TEN, 3)],
            [(0, 0), (TEN, 2), (TEN + 1, 5)],
        ),
        (
            "near-parallel-slot",
            "A slot with walls parallel but for one part in 10^15",
            [
                (0, 0),
                (TEN, 0),
                (TEN + 1, 2 * TEN),
                (2 * TEN, 2 * TEN),
                (2 * TEN, 0),
                (3 * TEN, 0),
                (3 * TEN, 3 * TEN),
                (0, 3 * TEN),
            ],
            box(TEN, TEN),
        ),
    ],
    "seanys/2D-Irregular-Packing-Algorithm/issues/4": [
        (
            "crystals",
            "Convex parts on thirds",
            CRYSTAL,
            [(x / 2, -y / 2) for x, y in CRYSTAL[::-1]],
        ),
        ("crystal-itself", "A part on thirds around itself", CRYSTAL, CRYSTAL),
    ],
}
