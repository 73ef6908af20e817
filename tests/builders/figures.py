"""The paper's classes, figures and corollaries; drawn after them, not measured off them."""

from collections.abc import Iterator

from builders.entry import UNIT, Entry, Ring, box, mapped, turned, under
from exactsweep.corpus.generator.growing import bumps, comb

TITLE = "The paper's classes, figures and lemmas"

HOUSE: Ring = [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
ARROW: Ring = [(0, 0), (3, 2), (6, 0), (3, 6)]
PENTAGON: Ring = [(0, 0), (3, -2), (6, 0), (5, 4), (1, 4)]
NOTCHED: Ring = [(0, 0), (8, 0), (8, 5), (7, 5), (3, 1), (2, 5), (0, 5)]
ROOF: Ring = [(0, 0), (2, 2), (4, 0), (4, 4), (0, 4)]
HILLS: Ring = [(0, 0), (3, -3), (5, 1), (8, -4), (11, 0), (9, 4), (6, 3), (3, 6)]
# Convex, with m and n edges of different slopes.
HEXAGON: Ring = [(0, 0), (3, -2), (7, -1), (8, 2), (5, 5), (1, 4)]
QUADRILATERAL: Ring = [(0, 0), (2, -1), (3, 2), (1, 3)]


def entries() -> Iterator[Entry]:
    for entry in drawn():
        yield entry._replace(flags=("figure", *entry.flags))


def drawn() -> Iterator[Entry]:
    yield Entry("1-sweep", "Figure 1: an arrow around a block with an undercut", NOTCHED, ARROW)
    yield Entry("2-chains", "Figure 2: monotone chains of several convex parts", HILLS, ARROW)
    yield Entry("3-boundaries", "Figure 3: the boundaries of a lower sweep", HILLS, PENTAGON)
    yield from contact_events()
    yield from classes()
    yield from convex_sizes()
    yield Entry(
        "6-two-parts",
        "Figure 6: two convex parts of D, whose trajectories cross in a point",
        under([(0, 0), (3, -3), (6, 0), (8, -2), (12, 0)], 4),
        [(0, 0), (3, -1), (4, 1), (2, 3)],
    )
    yield Entry(
        "6-two-parts-along-an-edge",
        "Lemma A.3: two trajectories of parts share a segment, with two EE contacts on one edge",
        under([(0, 0), (2, 0), (3, 1), (4, 0), (6, 0)], 4),
        box(3, 1),
        ("tangent",),
    )
    yield Entry("7-undercut", "Figure 7: the bottom chain of an undercut", ROOF, UNIT)
    yield Entry(
        "7-undercut-of-two-edges",
        "Figure 7: an undercut whose bottom chain has a kink",
        ROOF,
        [(-2, 0), (0, -1), (2, 0), (0, 1)],
    )
    yield Entry("8-inverse", "Figure 8: around D, the inverse of figure 1", NOTCHED, turned(ARROW))
    yield Entry(
        "9-inverse-generatrix",
        "Figure 9: the inverse of G meets the trajectory from both sides",
        under([(0, 0), (4, -4), (6, 2), (8, -4), (12, 0)], 4),
        [(0, 0), (1, -2), (4, -1), (4, 1), (2, 2)],
    )
    yield from figure_10()
    yield Entry(
        "12-singular-edge",
        "Figure 12: G moves on an edge of D while a vertex of D comes near, and no contact is made",
        under([(0, 0), (6, -6), (7, -1), (9, -1), (10, 0)], 3),
        [(0, 0), (4, -3), (5, 0), (2, 2)],
    )
    yield Entry(
        "a1-same-edge",
        "Lemma A.1: two vertices of D touch the same edge of G at once",
        under([(0, 0), (2, -4), (4, 0), (6, -4), (8, 0)], 4),
        [(0, 0), (3, -3), (6, 0)],
        ("tangent",),
    )
    yield Entry(
        "13-contact-moves-right",
        "Figure 13: the contact moves to the right, and jumps over what is out of reach",
        under([(0, 0), (2, -3), (3, 0), (4, -1), (5, 0), (7, -4), (9, 0)], 4),
        [(0, 0), (2, -2), (5, -1), (6, 1), (3, 2)],
    )
    yield Entry(
        "5-3-ends-cut-off",
        "Lemma 5.3 as corrected: beyond D's ends the inverse of G overlaps the trajectory in part",
        box(4, 3),
        [(0, -1), (2, -1), (2, 1), (1, 0), (0, 1)],
    )
    yield Entry(
        "5-3-ends-cut-off-slanted",
        "Lemma 5.3 as corrected, D's ends being slanted",
        under([(0, 2), (1, 0), (4, 0), (5, 2)], 4),
        [(0, -1), (3, -1), (3, 1), (1, 0), (0, 1)],
    )


def contact_events() -> Iterator[Entry]:
    triangle: Ring = [(0, 0), (4, 0), (0, 4)]
    yield Entry("t1-ee", "Table 1, EE: edges slide along edges", box(3, 2), UNIT)
    yield Entry("t1-ev", "Table 1, EV: edges of G slide along vertices of D", UNIT, triangle)
    yield Entry("t1-ve", "Table 1, VE: vertices of G slide along edges of D", triangle, UNIT)
    yield Entry(
        "t1-vv",
        "Table 1, VV: no edges are parallel; between EV and VE vertices meet",
        HEXAGON,
        QUADRILATERAL,
    )


def classes() -> Iterator[Entry]:
    yield Entry("cc", "Section 3: both convex", HEXAGON, PENTAGON)
    yield Entry("cm", "Section 4: G convex, D monotone", HILLS, HOUSE)
    yield Entry("mm", "Section 5: both monotone", HILLS, NOTCHED)
    yield Entry("mc", "Section 5: G monotone, D convex, which the paper counts as MM", HOUSE, HILLS)


def convex_sizes() -> Iterator[Entry]:
    yield Entry(
        "4-slopes", "Figure 4: edges of D and G in order of their slopes", HEXAGON, ARROWHEAD
    )
    yield Entry(
        "5-outer", "Figure 5: edges of G's bottom come into the outer boundary", ROUND, KITE
    )
    yield Entry(
        "3-3-sizes",
        "Corollary 3.3: m + n and m + 2 n edges, all slopes being different",
        HEXAGON,
        mapped(QUADRILATERAL, (5, 1, -1, 7)),
        ("lower-bound",),
    )


ARROWHEAD: Ring = [(0, 0), (5, -1), (6, 0), (1, 3)]
ROUND: Ring = [(0, 0), (1, -2), (3, -3), (5, -3), (7, -2), (8, 0), (7, 2), (5, 3), (3, 3), (1, 2)]
KITE: Ring = [(0, 0), (1, -3), (2, 0), (1, 1)]


def figure_10() -> Iterator[Entry]:
    names = {1: "one tooth", 2: "two teeth", 3: "three teeth"}
    peaks = {1: "one peak", 2: "two peaks", 3: "three peaks"}
    sizes = [(2, 4, 6), (2, 2, 4), (2, 4, 4), (4, 4, 6), (4, 6, 6), (2, 6, 8), (6, 6, 6)]
    for m_b, n_t, n_b in sizes:
        generatrix, directrix = bumps(m_b, n_t, n_b)
        flat = {2: "two", 4: "four", 6: "six"}[n_b - 2]
        yield Entry(
            f"10-{m_b}-{n_t}-{n_b}",
            f"Figure 10: {names[m_b // 2]}, {peaks[n_t // 2]} and a tip of {flat} flat edges",
            directrix,
            generatrix,
            ("lower-bound",),
        )
    yield Entry(
        "4-3-trajectory",
        "Corollary 4.3: a convex G turns wholly about each of three teeth",
        comb(12, 6, 60),
        ROUND,
        ("lower-bound",),
    )
    yield Entry(
        "4-4-inner-loop",
        "Corollary 4.4: G rests on two teeth at a time, and each undercut shows its round top",
        comb(16, 7, 60),
        ROUND,
        ("lower-bound",),
    )
