"""Answers worked by hand: steps, slots, exact fits, whiskers and numbers of any size."""

from known import UNIT, Loop, check
from strategies import points

from exactsweep import Polygon, sweep
from exactsweep.numbers.point import Vertex
from exactsweep.procedures.mm import sweep_mm, trajectory_mm

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
