"""Contacts along the trajectory, as pictures and pages show them."""

from fractions import Fraction

from hypothesis import given
from strategies import pairs, points
from tiers import examples

from exactsweep import Point, Polygon, Sweep, sweep
from exactsweep.draw import ContactInterval, cut_trajectory
from exactsweep.draw.intervals import SweepFeatures
from exactsweep.evidence.contact import Contact

any_pair = pairs("CC") | pairs("CM") | pairs("MM")


def middle(interval: ContactInterval) -> Point:
    (ax, ay), (bx, by) = interval.start, interval.end
    return Point((ax + bx) / 2, (ay + by) / 2)


def swept(pair: tuple[Polygon, Polygon]) -> Sweep:
    return sweep(*pair, reference=("1/3", 2))


@examples(60)
@given(any_pair)
def test_intervals_go_once_around_the_trajectory(pair: tuple[Polygon, Polygon]) -> None:
    s = swept(pair)
    found = cut_trajectory(s)
    for before, after in zip(found, found[1:] + found[:1], strict=True):
        assert before.start != before.end == after.start
    corners = {interval.start: interval.edge for interval in reversed(found)}
    assert [corners[vertex] for vertex in s.trajectory.vertices] == list(range(len(s.trajectory)))


@examples(40)
@given(any_pair)
def test_contacts_of_an_interval_hold_in_its_middle(pair: tuple[Polygon, Polygon]) -> None:
    s = swept(pair)
    for interval in cut_trajectory(s):
        touching = s.contacts_at(middle(interval))
        assert interval.contacts
        assert set(interval.contacts) <= set(touching)
        flat = {contact for contact in touching if contact.event == "EE"}
        assert flat <= set(interval.contacts)


@examples(40)
@given(any_pair)
def test_edges_touch_in_a_segment_and_vertices_in_a_point(pair: tuple[Polygon, Polygon]) -> None:
    s = swept(pair)
    features = SweepFeatures(s)
    for interval in cut_trajectory(s)[:12]:
        for contact in interval.contacts:
            low, high = features.spot(contact, middle(interval))
            assert (low < high) == (contact.event == "EE")


def test_edges_are_cut_at_changes_of_contact() -> None:
    # Over the gap, which is narrower than the block, the block rests on both sides for a while.
    block = [(0, 0), (3, 0), (3, 1), (0, 1)]
    gap = [(0, -3), (8, -3), (8, 0), (5, 0), (4, -1), (3, 0), (0, 0)]
    over = [interval for interval in cut_trajectory(sweep(block, gap)) if interval.edge == 2]
    right, left = Contact("EE", 0, 2), Contact("EE", 0, 5)
    a, b, c, d = points((8, 0), (3, 0), (2, 0), (-3, 0))
    assert over == [
        ContactInterval(2, a, b, (right,)),
        ContactInterval(2, b, c, (right, left)),
        ContactInterval(2, c, d, (left,)),
    ]


def test_simultaneous_events_are_marked_as_several() -> None:
    at = Point(Fraction(0), Fraction(0))
    contacts = (Contact("EV", 0, 0), Contact("VE", 1, 1), Contact("EV", 1, 2))
    assert ContactInterval(0, at, at, contacts).event == "several"
    assert ContactInterval(0, at, at, contacts[::2]).event == "EV"
