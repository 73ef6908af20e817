"""Sweeps worked by hand, of every class; D is drawn with #, undercuts with +, exact fits with :."""

from fractions import Fraction

from known import ROOF, UNIT, Loop, check, half, third
from strategies import points

from exactsweep import Polygon, sweep


def test_square_around_a_triangle() -> None:
    r"""CC: the edges in order of slope; the trajectory has the parallel ones added up.

    ::

        #          (-1,4) __ (0,4)
        # #              |  \
        #   #            |    \ (4,0)
        # # # #  (-1,-1) |_____| (4,-1)
    """
    triangle: Loop = [(0, 0), (4, 0), (0, 4)]
    s = sweep(UNIT, triangle)
    check(
        s,
        "CC",
        [(-1, -1), (4, -1), (4, 0), (0, 4), (-1, 4)],
        triangle,
        [(-1, -1), (5, -1), (5, 1), (1, 5), (-1, 5)],
    )
    # The box of side 6 less half of the square of side 4; less D.
    assert s.area == 36 - 8 - 8
    assert s.undercuts == ()
    assert s.exact_fits == ()


def test_square_under_a_roof() -> None:
    r"""CM: the square is caught by its two upper corners; a point undercut under the ridge.

    T(x) = min(D_b(x), D_b(x + 1)) - 1: two slopes that meet at x = 3/2, where D_b = 3/2. The
    outer boundary is the least of T over [x - 1, x], G's bottom being flat.

    ::

        # # # # #
        # # # # #
        # # + # #
        # /---\ #     G at (3/2, 1/2), its top from (3/2, 3/2) to (5/2, 3/2)
        #       #
    """
    s = sweep(UNIT, ROOF)
    check(
        s,
        "CM",
        [(-1, -1), (0, -1), (3 * half, half), (3, -1), (4, -1), (4, 4), (-1, 4)],
        [(0, 0), (3 * half, 3 * half), (5 * half, 3 * half), (4, 0), (4, 4), (0, 4)],
        [(-1, -1), (1, -1), (2, 0), (3, -1), (5, -1), (5, 5), (-1, 5)],
    )
    assert s.direction == (1, 0)
    (undercut,) = s.undercuts
    assert undercut.polygon == Polygon([(3 * half, 3 * half), (5 * half, 3 * half), (2, 2)])
    assert undercut.polygon.area == Fraction(1, 4)
    assert undercut.extremes == points((3 * half, 3 * half), (5 * half, 3 * half))
    assert undercut.bottom == undercut.extremes
    assert undercut.intersection == "point"
    assert undercut.positions == points((3 * half, half))
    # The upper left corner of G on the left slope, the upper right one on the right slope.
    assert s.contacts_at((3 * half, half)) == (("VE", 2, 1), ("VE", 3, 0))


def test_kite_under_a_roof_leaves_a_bottom_chain_of_two_edges() -> None:
    r"""CM: a blunt tip, slopes 1/2 and -1/2, touches both slopes; a kink in the bottom chain.

    G_t = 1 - |x| / 2 on [-2, 2]. The tip's end edges lie on the slopes where
    2 - |a - 2| = t + 1 - |a - 2| / 2 has just its ends a = 0 and a = 4: G's corners at D's.

    ::

        # # # # #
        # # + # #
        # + + + #
        # /   \ #
    """
    kite: Loop = [(-2, 0), (0, -1), (2, 0), (0, 1)]
    s = sweep(kite, ROOF)
    check(
        s,
        "CM",
        [(-2, 0), (0, -1), (2, 0), (4, -1), (6, 0), (6, 4), (4, 5), (0, 5), (-2, 4)],
        [(0, 0), (2, 1), (4, 0), (4, 4), (0, 4)],
        [(-4, 0), (0, -2), (2, -1), (4, -2), (8, 0), (8, 4), (4, 6), (0, 6), (-4, 4)],
    )
    (undercut,) = s.undercuts
    assert undercut.polygon == Polygon([(0, 0), (2, 1), (4, 0), (2, 2)])
    assert undercut.bottom == points((0, 0), (2, 1), (4, 0))
    assert undercut.positions == points((2, 0))
    assert undercut.intersection == "point"


def test_long_bar_slides_past_a_notch() -> None:
    """CM: the bar's flat top lies on both rims of the notch while it slides: a segment undercut.

    ::

        # # # # # #
        # # +++ # #
        # # +++ # #
           =====>       the bar, of length 3, slides from (1, -1) to (2, -1)
    """
    notched: Loop = [(0, 0), (2, 0), (3, 1), (4, 0), (6, 0), (6, 4), (0, 4)]
    s = sweep([(0, 0), (3, 0), (3, 1), (0, 1)], notched)
    check(
        s,
        "CM",
        [(-3, -1), (6, -1), (6, 4), (-3, 4)],
        [(0, 0), (6, 0), (6, 4), (0, 4)],
        [(-3, -1), (9, -1), (9, 5), (-3, 5)],
    )
    (undercut,) = s.undercuts
    assert undercut.polygon == Polygon([(2, 0), (4, 0), (3, 1)])
    assert undercut.extremes == points((2, 0), (4, 0))
    assert undercut.intersection == "segment"
    assert undercut.positions == points((1, -1), (2, -1))
    # One edge of the trajectory: the top of the bar along both bottom edges of D, D's vertices
    # being the ends of those.
    assert s.contacts[0] == (("EE", 2, 0), ("EE", 2, 3))


HORNS: Loop = [(0, -12), (12, -12), (12, 0), (10, 1), (10, -10), (2, -10), (2, 1), (0, 0)]
TENT: Loop = [(-4, -4), (0, 0), (4, -4), (4, 1), (-4, 1)]


def test_two_positions_close_one_undercut() -> None:
    r"""MM: two horns with tops that slope inwards, far apart; each closes half of the pocket.

    The left horn's top runs from (0, 0) to (2, 1). Its ends are on both slopes -|a| of the tent
    at t = (-3/2, -3/2): from (-3/2, -3/2) to (1/2, -1/2). The right horn's, at (-21/2, -3/2), is
    the mirror image. The higher of the two tops is what can be reached: they cross in (0, -3/4).

    ::

        # # # # # # #
        # # # + # # #       /|        |\
        # # +   + # #      | |        | |   G
        # /       \ #      | |________| |
        #           #      |____________|
    """
    s = sweep(HORNS, TENT)
    check(
        s,
        "MM",
        [
            (-16, -4),
            (-14, -5),
            (-21 * half, -3 * half),
            (-8, -4),
            (-6, -5),
            (-4, -4),
            (-3 * half, -3 * half),
            (2, -5),
            (4, -4),
            (4, 13),
            (-16, 13),
        ],
        [(-4, -4), (-half, -half), (0, -3 * half / 2), (half, -half), (4, -4), (4, 1), (-4, 1)],
        [
            (-16, -16),
            (-14, -17),
            (14, -17),
            (16, -16),
            (16, 13),
            (14, 14),
            (-14, 14),
            (-16, 13),
        ],
    )
    (undercut,) = s.undercuts
    assert undercut.polygon == Polygon([(-half, -half), (0, -3 * half / 2), (half, -half), (0, 0)])
    assert undercut.positions == points((-21 * half, -3 * half), (-3 * half, -3 * half))


def test_paths_of_two_horns_close_one_undercut() -> None:
    r"""MM: a swallowtail G, G_t = |x - 1| * 2 on [0, 2], under a roof of slopes 1 and -1.

    The tips reach D_b at (2, 2) and (4, 2) when t = (2, 0); further up, each is stopped by the
    other. Moving off, the left tip draws the line from (2, 2) to (3, 1), the right one that from
    (3, 1) to (4, 2). Outside, D's corner (0, 0) gets into the notch, up to where the right tip
    meets the slope: x = -2 x - 2.

    ::

            #
          # + #
        # + + + #
        #   +   #        \  /
        #       #         \/   G
    """
    tail: Loop = [(0, -1), (2, -1), (2, 2), (1, 0), (0, 2)]
    tall: Loop = [(0, 0), (3, 3), (6, 0), (6, 4), (0, 4)]
    s = sweep(tail, tall)
    check(
        s,
        "MM",
        [
            (-2, -2),
            (-2 * third, -2 * third),
            (0, -2),
            (2, 0),
            (4, -2),
            (14 * third, -2 * third),
            (6, -2),
            (6, 5),
            (-2, 5),
        ],
        [(0, 0), (2, 2), (3, 1), (4, 2), (6, 0), (6, 4), (0, 4)],
        [(-2, -3), (2, -3), (3, -2), (4, -3), (8, -3), (8, 7), (-2, 7)],
    )
    (undercut,) = s.undercuts
    assert undercut.polygon == Polygon([(2, 2), (3, 1), (4, 2), (3, 3)])
    assert undercut.polygon.area == 2
