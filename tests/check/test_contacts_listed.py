"""Contacts of a certificate: which one is missing, and where it touches."""

from fractions import Fraction
from itertools import product
from typing import Any

import pytest
from producer import SLOT, UNIT, VALLEY

from exactsweep import Point, Sweep, sweep
from exactsweep.check import size, verify

STAIRS = [(0, 0), (5, 0), (5, 2), (3, 2), (3, 3), (0, 3)]
TENT = [(0, 0), (3, -1), (4, -1), (6, 1), (2, 3), (0, 2)]
# Both edges of the trajectory on one line, and a contact that begins where the first one ends.
CLEFT = [(0, -2), (1, 0), (2, -2), (2, 1), (1, 2), (0, 1)]
BOOT = [(0, -2), (2, -2), (3, -1), (3, 2), (2, 1), (0, 1)]
SHAPES = [UNIT, SLOT, VALLEY, STAIRS, TENT, CLEFT, BOOT]


def _features(ring: Any, is_edge: bool, k: int) -> list[Point]:
    return [ring[k], ring[(k + 1) % len(ring)]] if is_edge else [ring[k]]


def _find_middle(s: Sweep, k: int, event: str, i: int, j: int) -> Point:
    """Of what an edge of the trajectory has in common with all D_j - G_i."""
    of_g = _features(s.generatrix.vertices, event[0] == "E", i)
    of_d = _features(s.directrix.vertices, event[1] == "E", j)
    drawn = [Point(p.x - q.x, p.y - q.y) for p, q in product(of_d, of_g)]
    edge = _features(s.trajectory.vertices, True, k)
    a, b = max(min(drawn), min(edge)), min(max(drawn), max(edge))
    assert a < b
    return Point((a.x + b.x) / 2, (a.y + b.y) / 2)


@pytest.mark.parametrize("directrix", SHAPES[1:])
@pytest.mark.parametrize("generatrix", SHAPES)
def test_a_contact_left_out_is_seen_where_it_touches(generatrix: Any, directrix: Any) -> None:
    s = sweep(generatrix, directrix, direction=(1, 0))
    certificate = s.certificate()
    assert verify(certificate).proved
    for k, contacts in enumerate(certificate["contacts"]):
        for m, (event, i, j) in enumerate(contacts):
            listed = [*certificate["contacts"]]
            listed[k] = contacts[:m] + contacts[m + 1 :]
            result = verify({**certificate, "contacts": listed})
            assert result.reason == f"contacts[{k}]: {event} ({i}, {j}) is missing"
            assert result.witness == _find_middle(s, k, event, i, j)


def test_contacts_of_an_edge_have_one_order() -> None:
    notched = [(0, 0), (2, 0), (2, 1), (1, "1/2"), (0, 1)]
    certificate = sweep(notched, SLOT, direction=(1, 0)).certificate()
    several = [k for k, found in enumerate(certificate["contacts"]) if len(found) > 1]
    listed = [found[::-1] for found in certificate["contacts"]]
    result = verify({**certificate, "contacts": listed})
    assert result.reason == f"contacts[{several[0]}]: not in increasing order"


def test_without_a_lattice_parallel_edges_are_known(monkeypatch: pytest.MonkeyPatch) -> None:
    """2 x + 2 y = 3 is a line of coprime numbers, and so is x + y = 1."""
    for name in ("_SHORT", "_FEW"):
        monkeypatch.setattr(size, name, 0)
    for half in (Fraction(1, 2), Fraction(3, 2), Fraction(1, 3)):
        triangle, other = ([(0, 0), (c, 0), (0, c)] for c in (half, -1))
        for g, d in ((other, triangle), (triangle, other)):
            s = sweep(g, d)
            assert size.find_common_scale(s.directrix.vertices + s.generatrix.vertices) == 1
            certificate = s.certificate()
            events = {event for contacts in certificate["contacts"] for event, _, _ in contacts}
            assert "EE" in events
            assert verify(certificate) == (True, "proved", None)


def test_the_size_of_loops_alone_may_be_allowed() -> None:
    """The refusal names the fault of a loop with just as many steps as points of loops, and
    one for the area. With 7,200 bits a step counts for 113 and 12 more."""
    far = str(2**7200)
    certificate = sweep(UNIT, VALLEY).certificate()
    certificate["directrix"] = [["0", "0"], ["2", "0"], ["1", "1"], ["2", far]]
    certificate["contacts"] = [[] for _ in certificate["contacts"]]
    loops = ("generatrix", "directrix", "trajectory", "inner", "outer")
    steps = sum(len(certificate[loop]) for loop in loops) * 125 + 1
    too_large = f"too large: to check it would take more than {steps - 1} steps"
    assert verify(certificate, max_steps=steps - 1).reason == too_large
    reason = "directrix: not monotone to the direction, it turns back again at vertex"
    assert verify(certificate, max_steps=steps).reason.startswith(reason)
