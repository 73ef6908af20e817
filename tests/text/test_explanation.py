"""Sweeps worked out by hand, and their explanations."""

from fractions import Fraction

import pytest
from linear import require_linear

from exactsweep import Point, sweep
from exactsweep.cli.pair import DIRECTRIX, GENERATRIX
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import Landmark, Step, Touch, explain
from exactsweep.text.explanation import tell

SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
SLOT = [(0, 0), (3, 0), (3, 5), (2, 5), (2, 1), (1, 1), (1, 3), (0, 3)]


def points(*pairs: tuple[int | str, int | str]) -> tuple[Point, ...]:
    return tuple(Point(Fraction(x), Fraction(y)) for x, y in pairs)


def test_the_house_is_stopped_by_the_other_wall_of_the_notch() -> None:
    step = explain(sweep(GENERATRIX, DIRECTRIX))[5]
    start, end = points((5, 5), ("13/5", "13/5"))
    assert step == Step(
        start,
        end,
        (-1, -1),
        "upper",
        (Touch(Contact("VE", 1, 3), start, end),),
        (Landmark("undercut", 0, end),),
        "stop",
        (Contact("VE", 0, 4),),
    )


def test_the_slot_is_passed_by() -> None:
    step = explain(sweep(SQUARE, SLOT))[3]
    start, end = points((1, 5), (1, 3))
    assert step == Step(
        start,
        end,
        (0, -1),
        "upper",
        (Touch(Contact("EE", 1, 3), start, end),),
        (Landmark("undercut", 0, end), Landmark("exact fit", 0, end)),
        "exact fit",
        (),
    )


def test_a_contact_may_end_on_the_way() -> None:
    # Two feet on one floor: the left one walks off it while the right one carries on.
    #        3-----------+
    #        |  +-----+  |
    #     G  |__|0    |__|2     D: y = 0 from 0 to 8
    #        0  1     2  3
    table = [(0, 0), (1, 0), (1, 2), (2, 2), (2, 0), (3, 0), (3, 3), (0, 3)]
    floor = [(0, 0), (8, 0), (8, -1), (0, -1)]
    s = sweep(table, floor)
    top = next(step for step in explain(s) if step.half == "upper")
    start, right_on, left_off, end = points((8, 0), (6, 0), (-1, 0), (-3, 0))
    assert top.touches == (
        Touch(Contact("EE", 0, 0), start, left_off),
        Touch(Contact("EE", 4, 0), right_on, end),
    )
    told = "\n".join(tell(s))
    assert "slides along edge 0 of D, (8,0)-(0,0), until (-1,0)" in told
    assert "slides along edge 0 of D, (8,0)-(0,0), from (6,0) on" in told


def test_landmarks_of_one_step_are_in_the_order_of_travel() -> None:
    tips = [(0, 0), (8, 0), (8, 3), (6, 3), (5, 1), (4, 3), (3, 1), (2, 3), (0, 3)]
    top = next(step for step in explain(sweep(TABLE, tips)) if step.half == "upper")
    first, second, third, fourth = points((4, 3), (2, 3), (0, 3), (-2, 3))
    assert top.landmarks == (
        Landmark("undercut opens", 0, first),
        Landmark("undercut opens", 1, second),
        Landmark("undercut closes", 0, third),
        Landmark("undercut closes", 1, fourth),
    )


SADDLE = [(0, -3), (6, -3), (6, 3), (3, 0), (0, 3)]
SPIKE = [(0, 0), (1, -2), (2, 0)]
STAIR = [(0, 0), (4, 0), (4, 3), (3, 3), (3, 1), (0, 1)]
TABLE = [(0, 0), (6, 0), (6, 1), (0, 1)]
TWO_TIPS = [(0, 0), (6, 0), (6, 3), (4, 3), (3, 1), (2, 3), (0, 3)]
TWO_POSITIONS = [(0, 0), (1, -3), (2, 0), (3, -2), (4, 0), (4, 2), (2, 1), (0, 2)]
TWO_NOTCHES = [(0, 0), (10, 0), (10, 4), (8, 4), (7, 1), (6, 3), (5, 1), (3, 4), (2, 4), (0, 1)]


@pytest.mark.parametrize(
    ("generatrix", "directrix", "expected"),
    [
        (
            SQUARE,
            STAIR,
            "  Stop: edge 0 of G, (0,0)-(1,0), closes flat on edge 4 of D, (3,1)-(0,1); "
            "G turns right, along edge 0 of G and edge 4 of D",
        ),
        (
            SPIKE,
            SADDLE,
            "  Stop: vertex 1 of G, (1,-2), comes into the reflex corner at vertex 3 of D, (3,0); "
            "G turns right, along edge 3 of D",
        ),
        (
            SADDLE,
            SPIKE,
            "  Stop: vertex 1 of D, (1,-2), comes into the reflex corner at vertex 3 of G, (3,0); "
            "G turns right, along edge 3 of G",
        ),
        (
            GENERATRIX,
            DIRECTRIX,
            "  Stop: vertex 0 of G, (0,0), runs into edge 4 of D, (3,1)-(2,5), at (13/5,13/5); "
            "G turns right, along edge 4 of D",
        ),
        (
            GENERATRIX,
            DIRECTRIX,
            "  Here G closes undercut 0, of area 8/5, by touching (23/5,13/5) and (13/5,13/5) "
            "at once",
        ),
        (
            SQUARE,
            SLOT,
            "  Slot: nothing stops G, but straight on it would enter an exact fit; "
            "G turns right, along edge 0 of G and edge 6 of D",
        ),
        (
            SQUARE,
            SLOT,
            "  Here exact fit 0 begins: G could go down to (1,1), touching D on both sides",
        ),
        # Figure 7b: one edge of G over two tips of one height.
        (
            TABLE,
            TWO_TIPS,
            "  On the way, at (2,3), undercut 0, of area 2, closes: from here one edge of G "
            "slides over both (4,3) and (2,3)",
        ),
        (
            TABLE,
            TWO_TIPS,
            "  On the way, at (-2,3), undercut 0 is left: the edge of G slides off it",
        ),
        (
            TWO_POSITIONS,
            TWO_NOTCHES,
            "  Here begin the positions that close undercut 0, of area 13/12, from (23/3,3) "
            "and (6,3)",
        ),
        (SPIKE, STAIR, "Contacts: 3 EV, 4 VE, 1 EE; 7 corners, 1 stop; 1 undercut, no exact fits."),
    ],
)
def test_the_story_says(
    generatrix: list[tuple[int, int]], directrix: list[tuple[int, int]], expected: str
) -> None:
    lines = list(tell(sweep(generatrix, directrix)))
    assert expected in lines, "\n".join(lines)


@pytest.mark.long
def test_many_steps_take_linear_time() -> None:
    # A parabola of 100 edges between teeth so deep that it turns wholly about each of them.
    parabola = [(x, x * x) for x in range(100)]

    def explain_teeth(teeth: int) -> None:
        top = [(100 * k, 10**7 * (k % 2)) for k in range(teeth, -1, -1)]
        s = sweep(parabola, [(0, -1), (100 * teeth, -1), *top])
        assert sum(line.startswith("Step") for line in tell(s)) == len(s.trajectory) > 50 * teeth

    require_linear(explain_teeth, 12)
