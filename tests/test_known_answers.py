"""Sweeps worked by hand, of every class; D is drawn with #, undercuts with +, exact fits with :."""

from fractions import Fraction
from typing import Any

import pytest
from strategies import points

from exactsweep import Polygon, Sweep, sweep
from exactsweep.chain import Vertex
from exactsweep.mm import sweep_mm, trajectory_mm

Loop = list[tuple[Any, Any]]
half, third = Fraction(1, 2), Fraction(1, 3)

UNIT: Loop = [(0, 0), (1, 0), (1, 1), (0, 1)]


def check(s: Sweep, kind: str, trajectory: Loop, inner: Loop, outer: Loop) -> None:
    """The loops as lists from their least vertex on, counter-clockwise."""
    assert s.kind == kind
    assert list(s.trajectory.vertices) == trajectory
    assert list(s.inner.vertices) == inner
    assert list(s.outer.vertices) == outer


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


def test_triangle_around_a_square() -> None:
    """CC: G's slanted edge, and both its catheti, slide along corners of D (EV).

    ::

        .        # #
        . .      # #
    """
    square: Loop = [(0, 0), (2, 0), (2, 2), (0, 2)]
    check(
        sweep([(0, 0), (1, 0), (0, 1)], square),
        "CC",
        [(-1, 0), (0, -1), (2, -1), (2, 2), (-1, 2)],
        square,
        [(-1, 0), (0, -1), (3, -1), (3, 2), (2, 3), (-1, 3)],
    )


ROOF: Loop = [(0, 0), (2, 2), (4, 0), (4, 4), (0, 4)]


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


STAIR: Loop = [(0, 0), (2, 0), (2, 1), (4, 1), (4, 3), (0, 3)]


def test_step_up() -> None:
    """CM, a wall inside D_b: the trajectory steps up where G's left side meets the wall.

    ::

        # # # #        (-1,3) ________ (4,3)
        # # # #              |     ___|
        # #          (-1,-1) |____|(2,-1)
    """
    s = sweep(UNIT, STAIR)
    check(
        s,
        "CM",
        [(-1, -1), (2, -1), (2, 0), (4, 0), (4, 3), (-1, 3)],
        STAIR,
        [(-1, -1), (3, -1), (3, 0), (5, 0), (5, 4), (-1, 4)],
    )
    assert s.undercuts == ()
    # G's left edge along the wall.
    assert s.contacts[1] == (("EE", 3, 1),)


def test_step_down() -> None:
    """The mirror image of `test_step_up`: a unit to the right, as G's right side meets the wall.

    ::

        # # # #
        # # # #
            # #
    """
    mirrored: Loop = [(-x, y) for x, y in STAIR]
    check(
        sweep(UNIT, mirrored),
        "CM",
        [(-5, 0), (-3, 0), (-3, -1), (0, -1), (0, 3), (-5, 3)],
        [(-4, 1), (-2, 1), (-2, 0), (0, 0), (0, 3), (-4, 3)],
        [(-5, 0), (-3, 0), (-3, -1), (1, -1), (1, 4), (-5, 4)],
    )


def test_wide_slot_is_entered() -> None:
    """CM, walls down and up again: a slot of width 2 is a slot of width 1 for the square.

    ::

        #   #
        #   #
        # # # #
    """
    slot: Loop = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (1, 1), (1, 3), (0, 3)]
    s = sweep(UNIT, slot)
    check(
        s,
        "CM",
        [(-1, -1), (4, -1), (4, 3), (2, 3), (2, 1), (1, 1), (1, 3), (-1, 3)],
        slot,
        [(-1, -1), (5, -1), (5, 4), (-1, 4)],
    )
    assert s.exact_fits == ()
    assert s.undercuts == ()


def test_exact_fit() -> None:
    """CM: the loops pass a slot of the square's width by; the fit is reported apart.

    ::

        # : #
        # : #      the square's corner slides down from (1, 3) to (1, 1)
        # # #
    """
    slot: Loop = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    s = sweep(UNIT, slot)
    check(
        s,
        "CM",
        [(-1, -1), (3, -1), (3, 3), (-1, 3)],
        [(0, 0), (3, 0), (3, 3), (0, 3)],
        [(-1, -1), (4, -1), (4, 4), (-1, 4)],
    )
    assert s.exact_fits == (points((1, 3), (1, 1)),)
    (undercut,) = s.undercuts
    assert undercut.polygon == Polygon([(1, 1), (2, 1), (2, 3), (1, 3)])
    # Both walls, the floor under the square, and the corners.
    assert s.contacts_at((1, 1)) == (
        ("EE", 0, 4),
        ("EE", 1, 3),
        ("EE", 3, 5),
        ("VE", 2, 3),
        ("VE", 3, 5),
        ("VV", 0, 5),
        ("VV", 1, 4),
    )


def test_whisker() -> None:
    """MM: a horn exactly as wide as D's slot; neither loop grows a whisker of width zero into it.

    T is -2 while the horn is under D, -1 while only the base is; at x = 0 the horn fits, up to
    where the base stops it, from -2 to -1.

    ::

        # # #
        # : #           #
        # : #         # # #   G
    """
    slot: Loop = [(0, 0), (1, 0), (1, 2), (2, 2), (2, 0), (3, 0), (3, 3), (0, 3)]
    horn: Loop = [(0, 0), (3, 0), (3, 1), (2, 1), (2, 2), (1, 2), (1, 1), (0, 1)]
    s = sweep(horn, slot)
    check(
        s,
        "MM",
        [(-3, -1), (-2, -1), (-2, -2), (2, -2), (2, -1), (3, -1), (3, 3), (-3, 3)],
        [(0, 0), (3, 0), (3, 3), (0, 3)],
        # Below: the base's floor under T; above: G_t over the flat top, high between the horns.
        [
            (-3, -1),
            (-2, -1),
            (-2, -2),
            (5, -2),
            (5, -1),
            (6, -1),
            (6, 4),
            (5, 4),
            (5, 5),
            (-2, 5),
            (-2, 4),
            (-3, 4),
        ],
    )
    assert s.exact_fits == (points((0, -2), (0, -1)),)


def test_inside_sweep_is_cut_to_the_range_of_the_directrix() -> None:
    r"""MM chains, the erratum to Lemma 5.3: past D's ends, I(G) would only partly overlap T.

    A notched lid under a flat D: T = -1 all along, and nothing of D is out of reach.

    ::

        ____  D_b     \_/  G_t = 1 at both tips, 0 in the middle
    """
    top: list[Vertex] = [(2, 1), (1, 0), (0, 1)]
    bottom: list[Vertex] = [(0, -1), (2, -1)]
    flat: list[Vertex] = [(0, 0), (4, 0)]
    assert list(trajectory_mm(top, flat)) == [(-2, -1), (4, -1)]
    assert sweep_mm(top, bottom, flat) == (flat, [(-2, -2), (6, -2)])


def test_polygon_around_itself_and_its_inverse() -> None:
    """CC: around itself a triangle draws a hexagon; around its inverse, the double triangle.

    ::

        .         # #
        . .         #
    """
    triangle: Loop = [(0, 0), (1, 0), (0, 1)]
    inverse: Loop = [(-1, 0), (0, -1), (0, 0)]
    hexagon: Loop = [(-1, 0), (0, -1), (1, -1), (1, 0), (0, 1), (-1, 1)]
    assert list(sweep(triangle, triangle).trajectory.vertices) == hexagon
    assert sweep(triangle, inverse).trajectory.vertices == points((-2, 0), (0, -2), (0, 0))


@pytest.mark.parametrize("unit", [10**30, Fraction(1, 10**30), Fraction(1, 7)])
def test_size_of_the_numbers_does_not_matter(unit: Fraction) -> None:
    """`test_square_under_a_roof`, larger and smaller."""

    def times(loop: Loop) -> Loop:
        return [(x * unit, y * unit) for x, y in loop]

    plain, scaled = sweep(UNIT, ROOF), sweep(times(UNIT), times(ROOF))
    assert list(scaled.trajectory.vertices) == times(list(plain.trajectory.vertices))
    assert list(scaled.inner.vertices) == times(list(plain.inner.vertices))
    assert list(scaled.outer.vertices) == times(list(plain.outer.vertices))
