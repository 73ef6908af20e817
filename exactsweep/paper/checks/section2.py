"""Section 2: the chains of a sweep, its two loops, and the contacts of Table 1."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import pairwise, product

from exactsweep import Polygon, sweep
from exactsweep.check import reference_swept
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import explain
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.outline import number_features
from exactsweep.geometry.region import AnyPolygon
from exactsweep.paper.checks.touching import contacts_are_right, touches_are_right
from exactsweep.paper.claim import (
    Counterexample,
    Effort,
    Evidence,
    Table,
    find_first_failure,
    join_evidence,
)
from exactsweep.paper.functions import (
    find_common_points,
    list_edges,
    look_up,
    reaches,
    take_bottom,
    tell_boundaries,
    tell_loops,
)
from exactsweep.paper.pairs import SweepPair, draw_pairs, list_corners
from exactsweep.paper.tiny import expect_none, search, search_grid
from exactsweep.procedures.chain import split
from exactsweep.procedures.monotone import LowerSweep

KINDS = ("CC", "CM", "MM")


# A cave with a mouth of one and a half times the width of G.
CAVE = SweepPair([(0, 0), (2, 0), (1, 1)], [(0, 0), (9, 0), (6, 4), (8, 1), (1, 1), (3, 4)])


def like_chains_stay_apart(pair: SweepPair) -> str:
    """From end to end of the trajectory, no two top chains have a point in common, nor bottoms."""
    (g_bottom, g_top), (d_bottom, d_top) = map(split, pair)
    for (px, py), (qx, qy) in list_edges(look_up(pair).trajectory):
        for tx, ty in ((px, py), ((px + qx) / 2, (py + qy) / 2)):
            for g, d in ((g_bottom, d_bottom), (g_top[::-1], d_top[::-1])):
                placed = [(x + tx, y + ty) for x, y in g]
                inside = [
                    x for x in find_common_points(placed, d) if reaches(placed, x) and reaches(d, x)
                ]
                if inside:
                    return f"at ({tx}, {ty}) two like chains touch over {inside[0]}"
    return ""


def like_chains_have_no_contact(pair: SweepPair) -> str:
    """No contact, lasting or not, is inside two bottom chains or inside two top chains."""
    s = sweep(*pair)
    if failure := contacts_are_right(s):
        return failure
    for event, *features in {c for at in (*s.contacts, *s.vertex_contacts) for c in at}:
        sides = list(map(_side, (s.generatrix, s.directrix), event, features))
        if sides[0] == sides[1] != "end":
            return f"{event} of two {sides[0]} chains: {features[0]} of G, {features[1]} of D"
    return ""


def _side(shape: AnyPolygon, letter: str, index: int) -> str:
    """Return the chain that a feature is inside of; "end" for features at or beyond its ends."""
    corners, edges = number_features(shape)
    feature = corners[index] if letter == "V" else tuple(corners[k] for k in edges[index])
    for name, chain in zip(("bottom", "top"), split(shape.vertices), strict=True):
        if feature in (chain[1:-1] if letter == "V" else pairwise(chain)):
            return name
    return "end"


def swept_area_is_the_definition(pair: SweepPair) -> str:
    """The outer loop, the inner one and all others are those of the definition."""
    s, expected = sweep(*pair), reference_swept(*pair[::-1])
    found = s.outer.vertices, s.inner.vertices, tuple(loop.vertices for loop in s.unswept)
    for name, one, other in zip(
        ("outer loop", "inner loop", "other loops"), found, expected, strict=True
    ):
        if one != other:
            return f"the {name} are not those of the definition"
    return ""


def is_annulus(pair: SweepPair) -> str:
    """The swept area has the outer and the inner loop of the definition, and there is no other."""
    loops = len(reference_swept(*pair[::-1]).unswept)
    return f"{loops} more loops" if loops else swept_area_is_the_definition(pair)


def find_void(effort: Effort) -> Evidence:
    """Find the loops of what G sweeps around a cave that it goes into."""
    sizes = (10,) if effort.quick else (9, 10, 11)
    directrix = [(10 * x, 10 * y) for x, y in CAVE.directrix]
    pairs = [SweepPair([(k * x, k * y) for x, y in CAVE.generatrix], directrix) for k in sizes]
    failure = find_first_failure(map(swept_area_is_the_definition, pairs))
    against = None
    if all(len(reference_swept(*pair[::-1]).unswept) == 1 for pair in pairs):
        against = Counterexample(
            "the swept area leaves 3 parts of the plane free, not 2: G goes in and out of the cave "
            "along its walls, and passes by its middle"
            + ("" if effort.quick else "; and so with G a tenth smaller or larger"),
            "by hand",
            *CAVE,
        )
    return Evidence("A cave.", failure, against)


def boundaries_are_bottom_chains(pair: SweepPair) -> str:
    """The boundaries of a lower sweep are the bottom chains of both loops by the definition."""
    half = LowerSweep(sweep(*pair).kind, *pair.chains)
    return tell_boundaries(pair, half.inner, half.outer)


def halves_are_alike(pair: SweepPair) -> str:
    """The loops of the pair upside down are the loops, upside down."""
    upside_down = SweepPair(*([(x, -y) for x, y in reversed(ring)] for ring in pair))
    s, other = sweep(*pair), sweep(*upside_down)
    for name in ("trajectory", "inner", "outer"):
        turned = [(x, -y) for x, y in getattr(other, name).vertices]
        if Polygon(turned[::-1]) != getattr(s, name):
            return f"upside down, the {name} is another one"
    return tell_loops(s, "trajectory")


def widths_add_up(pair: SweepPair) -> str:
    """The trajectory is as wide as G and D together."""
    s = sweep(*pair)
    boxes = (shape.bounding_box for shape in (s.generatrix, s.directrix, s.trajectory))
    g, d, t = (high.x - low.x for low, high in boxes)
    return tell_loops(s, "trajectory") or ("" if g + d == t else f"widths {g}, {d}, {t} of G, D, T")


def steps_have_contacts(pair: SweepPair) -> str:
    """All along every edge of the trajectory an EV, VE or EE contact lasts, as its step says."""
    s = sweep(*pair)
    return contacts_are_right(s) or find_first_failure(
        touches_are_right(s, step) for step in explain(s)
    )


def count_events(effort: Effort) -> Evidence:
    """Count the contacts at vertices of trajectories, by kind."""
    events = Counter(
        contact.event
        for kind in KINDS
        for pair in draw_pairs(effort, kind, effort.cases(150))
        for at in sweep(*pair).vertex_contacts
        for contact in at
    )
    missing = {"EE", "EV", "VE", "VV"} - set(events)
    rows = [[event, f"{count:,}"] for event, count in sorted(events.items())]
    table = Table("Contacts at the vertices of trajectories", ("event", "how often"), rows)
    failure = f"never seen: {', '.join(sorted(missing))}" if missing else ""
    return Evidence("", failure, tables=(table,))


def vertices_belong_to_events(pair: SweepPair) -> str:
    """Two vertices that touch are the end of an EV, VE or EE contact before or after."""
    s = sweep(*pair)
    if failure := contacts_are_right(s):
        return failure
    edges = [number_features(shape)[1] for shape in (s.generatrix, s.directrix)]

    def ends(vertices: Contact, other: Contact) -> bool:
        """Decide whether a contact of two vertices is an end of a lasting contact."""
        parts = zip(vertices[1:], other.event, other[1:], edges, strict=True)
        return all(v == k if letter == "V" else v in own[k] for v, letter, k, own in parts)

    for k, at in enumerate(s.vertex_contacts):
        lasting = {*s.contacts[k - 1], *s.contacts[k]}
        for contact in at:
            if contact.event == "VV" and not any(ends(contact, other) for other in lasting):
                _, i, j = contact
                return f"at vertex {k} of the trajectory, the VV of {i} and {j} ends no other event"
    return ""


def find_passing_vertices(effort: Effort) -> Evidence:
    """Try all convex pairs on a tiny grid, and all pairs of an apex and teeth on another."""
    convex = search_grid(2, 6 if effort.quick else 8, "convex", "convex", vertices_belong_to_events)
    found = search(_apexes_and_teeth(), vertices_belong_to_events, "of an apex and teeth")
    count = effort.cases(300)
    seen = sum(map(bool, map(vertices_belong_to_events, draw_pairs(effort, "CM", count))))
    tried = f"Of {count} random CM pairs {seen} have such a contact."
    return join_evidence(expect_none(convex), found, Evidence(tried))


def _apexes_and_teeth() -> Iterator[SweepPair]:
    """A triangle under all bottom chains of five vertices with heights from 0 to 2."""
    generatrix = [(0, 0), (8, 0), (4, 2)]
    for heights in product(range(3), repeat=5):
        try:
            corners = list_corners([*enumerate(heights), (2, 9)])
        except PolygonError:
            continue
        if len(corners) == 6:
            yield SweepPair(generatrix, corners)


def starts_and_stops_at_the_ends(pair: SweepPair) -> str:
    """The sweep starts with G's right end on D's left end, and stops with the others together."""
    s, (top, _, directrix) = sweep(*pair), pair.chains
    path = take_bottom(s.trajectory.vertices)
    for name, t, own, other in (
        ("starts", path[0], top[0], directrix[0]),
        ("stops", path[-1], top[-1], directrix[-1]),
    ):
        if (t[0] + own[0], t[1] + own[1]) != other:
            return f"it {name} at ({t[0]}, {t[1]}), with ({own[0]}, {own[1]}) not on D's end"
    return ""
