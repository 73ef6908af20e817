r"""Undercuts, exact fits and contacts of shipped pairs, computed by hand.

In all of them the answer takes a few lines of arithmetic. Under a roof of slopes 1 and -1 a square
is caught by its two upper corners, where the roof is one wide; a kite with slopes 1/2 and -1/2 by
both of its ends, so that the chain which closes the pocket has a corner. Two horns with tops that
slope inwards close one half each of the pocket of a tent, where the higher top is what can be
reached: they cross in (0, -3/4). The two tips of a swallowtail draw the lines from (2, 2) and
(4, 2) to (3, 1) while they move off.
"""

from typing import Any

import pytest
from strategies import points

from exactsweep import Polygon, sweep
from exactsweep.corpus import find_case
from exactsweep.numbers.number import Vertex
from exactsweep.paper.kernel import sweep_mm, trajectory_mm

Corners = list[tuple[Any, Any]]

# The undercut, its bottom chain, the kind of intersection and the closing positions of G; the
# last two are missing where paths close it.
UNDERCUTS: dict[str, tuple[Corners, Corners, str, Corners]] = {
    "worked-roof": (
        [("3/2", "3/2"), ("5/2", "3/2"), (2, 2)],
        [("3/2", "3/2"), ("5/2", "3/2")],
        "point",
        [("3/2", "1/2")],
    ),
    "figures-7-undercut-of-two-edges": (
        [(0, 0), (2, 1), (4, 0), (2, 2)],
        [(0, 0), (2, 1), (4, 0)],
        "point",
        [(2, 0)],
    ),
    "worked-bar-over-notch": (
        [(2, 0), (4, 0), (3, 1)],
        [(2, 0), (4, 0)],
        "segment",
        [(1, -1), (2, -1)],
    ),
    "worked-two-horns": (
        [("-1/2", "-1/2"), (0, "-3/4"), ("1/2", "-1/2"), (0, 0)],
        [("-1/2", "-1/2"), (0, "-3/4"), ("1/2", "-1/2")],
        "",
        [("-21/2", "-3/2"), ("-3/2", "-3/2")],
    ),
    "worked-swallowtail": (
        [(2, 2), (3, 1), (4, 2), (3, 3)],
        [(2, 2), (3, 1), (4, 2)],
        "",
        [],
    ),
}


@pytest.mark.parametrize("id", UNDERCUTS)
def test_known_undercuts(id: str) -> None:
    case = find_case(id)
    s = case.sweep()
    assert (s.trajectory, s.inner, s.outer) == (case.trajectory, case.inner, case.outer)
    polygon, bottom, intersection, positions = UNDERCUTS[id]
    (undercut,) = s.undercuts
    assert undercut.polygon == Polygon(polygon)
    assert undercut.bottom == points(*bottom)
    assert undercut.extremes == (undercut.bottom[0], undercut.bottom[-1])
    assert intersection in ("", undercut.intersection)
    if positions:
        assert undercut.positions == points(*positions)


@pytest.mark.parametrize("id", ["worked-step-up", "worked-step-down", "worked-square-triangle"])
def test_reachable_boundaries_have_no_undercut(id: str) -> None:
    case = find_case(id)
    s = case.sweep()
    assert (s.undercuts, s.exact_fits) == ((), ())
    assert (s.trajectory, s.inner, s.outer) == (case.trajectory, case.directrix, case.outer)


def test_a_whisker_is_a_fit_and_not_part_of_a_loop() -> None:
    """A horn exactly as wide as D's slot slides up from -2 until its base is blocked at -1."""
    case = find_case("fits-horn")
    s = case.sweep()
    assert (s.trajectory, s.inner, s.outer) == (case.trajectory, case.inner, case.outer)
    assert s.exact_fits == (points((0, -2), (0, -1)),)


def test_known_contacts() -> None:
    """One contact at the bottom of a slot as wide as G, and two vertices on edges of the roof."""
    slot = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    s = sweep([(0, 0), (1, 0), (1, 1), (0, 1)], slot)
    assert s.exact_fits == (points((1, 3), (1, 1)),)
    assert s.contacts_at((1, 1)) == (
        *(("EE", 0, 4), ("EE", 1, 3), ("EE", 3, 5)),
        *(("VE", 2, 3), ("VE", 3, 5), ("VV", 0, 5), ("VV", 1, 4)),
    )
    roof = find_case("worked-roof").sweep()
    assert roof.contacts_at(("3/2", "1/2")) == (("VE", 2, 1), ("VE", 3, 0))
    # The top of the bar along both bottom edges of D, whose vertices are the ends of those.
    bar = find_case("worked-bar-over-notch").sweep()
    assert bar.contacts[0] == (("EE", 2, 0), ("EE", 2, 3))


def test_inside_sweep_is_cut_to_the_range_of_the_directrix() -> None:
    """The erratum to Lemma 5.3: past D's ends, I(G) would overlap T only in part.

    A notched lid under a flat D: T = -1 all along, and nothing of D is out of reach.
    """
    top: list[Vertex] = [(2, 1), (1, 0), (0, 1)]
    bottom: list[Vertex] = [(0, -1), (2, -1)]
    flat: list[Vertex] = [(0, 0), (4, 0)]
    assert list(trajectory_mm(top, flat)) == [(-2, -1), (4, -1)]
    assert sweep_mm(top, bottom, flat) == (flat, [(-2, -2), (6, -2)])
