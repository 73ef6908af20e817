"""Section 2: the chains of a sweep, its two loops, and the contacts of Table 1."""

from __future__ import annotations

from collections import Counter
from itertools import pairwise

from exactsweep import Point, Polygon, Sweep, sweep
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import Step, explain
from exactsweep.paper.checks.planar import contact_pieces, free_parts, swept_polygons
from exactsweep.paper.checks.touching import contacts_are_right
from exactsweep.paper.claim import (
    Claim,
    Counterexample,
    Evidence,
    Run,
    Status,
    Table,
    first_failure,
)
from exactsweep.paper.functions import (
    bottom_of,
    common_points,
    differs,
    over,
    reference,
)
from exactsweep.paper.laws import Trial, wrong
from exactsweep.paper.pairs import Kind, Pair, Ring, random_pairs
from exactsweep.procedures.chain import split
from exactsweep.procedures.lower_sweep import LowerSweep

KINDS: tuple[Kind, ...] = ("CC", "CM", "MM")


# A cave with a mouth of one and a half times the width of G.
CAVE = Pair([(0, 0), (2, 0), (1, 1)], [(0, 0), (9, 0), (6, 4), (8, 1), (1, 1), (3, 4)])

# At (-1, -3) G touches D in two pairs of vertices, where its way along one edge of D ends and
# that along another begins.
IN_PASSING = Pair([(0, 5), (2, 0), (3, 3), (1, 3)], [(0, 0), (1, 1), (2, 0), (1, 4)])


def like_chains_stay_apart(pair: Pair) -> str:
    """From end to end of the trajectory, no two top chains have a point in common, nor bottoms."""
    corners = reference(pair).trajectory
    (g_bottom, g_top), (d_bottom, d_top) = map(split, pair)
    for (px, py), (qx, qy) in pairwise([*corners, corners[0]]):
        for tx, ty in ((px, py), ((px + qx) / 2, (py + qy) / 2)):
            for g, d in ((g_bottom, d_bottom), (g_top[::-1], d_top[::-1])):
                placed = [(x + tx, y + ty) for x, y in g]
                inside = [x for x in common_points(placed, d) if over(placed, x) and over(d, x)]
                if inside:
                    return f"at ({tx}, {ty}) two like chains touch over {inside[0]}"
    return ""


def like_chains_have_no_contact(pair: Pair) -> str:
    """No contact, lasting or not, is inside two bottom chains or inside two top chains."""
    s = sweep(*pair)
    if failure := contacts_are_right(s):
        return failure
    found = {c for at in (*s.contacts, *s.vertex_contacts) for c in at}
    for contact in found:
        sides = _side(s.generatrix, contact, 0), _side(s.directrix, contact, 1)
        if sides[0] == sides[1] != "end":
            return f"{contact.event} of two {sides[0]} chains: {contact[1]} of G, {contact[2]} of D"
    return ""


def _side(polygon: Polygon, contact: Contact, which: int) -> str:
    """The chain that a feature is inside of; "end" for what is at its ends or beyond."""
    index = contact[1 + which]
    bottom, top = split(polygon.vertices)
    numbers = range(len(polygon))
    if contact.event[which] == "V":
        k = next(k for k in numbers if polygon.vertex_index(k) == index)
        point = polygon.vertices[k]
        return "bottom" if point in bottom[1:-1] else "top" if point in top[1:-1] else "end"
    k = next(k for k in numbers if polygon.edge_index(k) == index)
    edge = polygon.vertices[k], polygon.vertices[(k + 1) % len(polygon)]
    return "bottom" if edge in pairwise(bottom) else "top" if edge in pairwise(top) else "end"


def _check_theorem_2_1(run: Run) -> Evidence:
    trial = Trial(run)
    for kind in KINDS:
        trial.of(like_chains_stay_apart, kind, 30)
        trial.of(like_chains_have_no_contact, kind, 60)
        trial.of(like_chains_have_no_contact, kind, 60, strict=False)
    return Evidence(trial.tried, trial.failure)


def sweep_pieces(s: Sweep) -> list[tuple[Point, Point]]:
    """The edges of the trajectory."""
    corners = s.trajectory.vertices
    return list(zip(corners, corners[1:] + corners[:1], strict=True))


def is_annulus(pair: Pair) -> str:
    """What G passes over leaves two parts of the plane free, D's and the outside."""
    parts = free_parts(swept_polygons(pair.generatrix, sweep_pieces(sweep(*pair))))
    return "" if parts == 2 else f"the swept area leaves {parts} parts of the plane free"


def scaled(ring: Ring, factor: int) -> Ring:
    """A polygon, larger."""
    return [(factor * x, factor * y) for x, y in ring]


def _check_theorem_2_2(run: Run) -> Evidence:
    trial = Trial(run)
    trial.of(is_annulus, "CC", 30).of(is_annulus, "CM", 40).of(is_annulus, "MM", 10)
    trial.of(is_annulus, "CM", 20, strict=False)
    directrix = scaled(CAVE.directrix, 10)
    sizes = [scaled(CAVE.generatrix, factor) for factor in (9, 10, 11)]
    parts = {free_parts(swept_polygons(g, contact_pieces(g, directrix))) for g in sizes}
    against = None
    if parts == {3}:
        against = Counterexample(
            "the swept area leaves 3 parts of the plane free, not 2: G goes in and out of the cave "
            "along its walls, and passes by its middle; and so with G a tenth smaller or larger",
            "by hand; positions by classification over an arrangement of segments, free parts "
            "counted slab by slab",
            *CAVE,
        )
    return Evidence(trial.tried, trial.failure, against)


def _check_definition_2_1(run: Run) -> Evidence:
    def law(pair: Pair) -> str:
        """The boundaries of a lower sweep are the bottom chains of both loops by the definition."""
        loops, (top, bottom, directrix) = reference(pair), pair.chains
        kind = sweep(*pair).kind
        half = LowerSweep(kind, top, bottom, directrix)
        return differs("the outer boundary", half.outer, bottom_of(loops.outer)) or differs(
            "the inner boundary", half.inner, bottom_of(loops.inner)
        )

    trial = Trial(run)
    for kind in KINDS:
        trial.of(law, kind, 80).of(law, kind, 40, strict=False)
    return Evidence(trial.tried, trial.failure)


def _check_distance(run: Run) -> Evidence:
    def law(pair: Pair) -> str:
        """The trajectory is as wide as G and D together."""
        (g, d), t = pair, reference(pair).trajectory
        widths = [max(x for x, _ in ring) - min(x for x, _ in ring) for ring in (g, d, t)]
        found = sweep(*pair).trajectory.bounding_box
        if found[1].x - found[0].x != widths[2]:
            return "the trajectory is not that of the definition"
        return "" if widths[0] + widths[1] == widths[2] else f"widths {widths} of G, D and T"

    trial = Trial(run)
    for kind in KINDS:
        trial.of(law, kind, 60).of(law, kind, 60, strict=False)
    return Evidence(trial.tried, trial.failure)


def steps_have_contacts(pair: Pair) -> str:
    """All along every edge of the trajectory there is an EV, VE or EE contact."""
    s = sweep(*pair)
    return contacts_are_right(s) or first_failure(map(_uncovered, explain(s)))


def _uncovered(step: Step) -> str:
    start, end = step.start, step.end
    reached = start
    forward = 1 if start < end else -1
    for touch in step.touches:
        if touch.contact.event == "VV":
            return f"a VV contact that lasts, from {touch.start} to {touch.end}"
        if (touch.start > reached) - (touch.start < reached) == forward:
            break
        reached = max(reached, touch.end) if forward > 0 else min(reached, touch.end)
    return "" if reached == end else f"no contact after {reached} on the edge from {start} to {end}"


def _check_table_1(run: Run) -> Evidence:
    trial = Trial(run)
    for kind in KINDS:
        trial.of(steps_have_contacts, kind, 80).of(steps_have_contacts, kind, 40, strict=False)
    events = Counter(
        contact.event
        for kind in KINDS
        for pair in random_pairs(run, kind, run.effort(150))
        for at in sweep(*pair).vertex_contacts
        for contact in at
    )
    missing = {"EE", "EV", "VE", "VV"} - set(events)
    rows = [[event, f"{count:,}"] for event, count in sorted(events.items())]
    table = Table("Contacts at the vertices of trajectories", ("event", "how often"), rows)
    failure = trial.failure or (f"never seen: {', '.join(sorted(missing))}" if missing else "")
    return Evidence(trial.tried, failure, tables=(table,))


def vertices_belong_to_events(pair: Pair) -> str:
    """Two vertices that touch are the end of an EV, VE or EE contact before or after."""
    s = sweep(*pair)
    if failure := contacts_are_right(s):
        return failure
    edges = s.contacts
    for k, at in enumerate(s.vertex_contacts):
        lasting = {*edges[k - 1], *edges[k]}
        for contact in at:
            if contact.event == "VV" and not any(_shares(s, contact, c) for c in lasting):
                return f"at vertex {k} of the trajectory, {contact} belongs to no other event"
    return ""


def _check_incidental(run: Run) -> Evidence:
    trial = Trial(run)
    for kind in ("CC", "CM"):
        trial.of(vertices_belong_to_events, kind, 80)
    note = ""
    if wrong(vertices_belong_to_events, IN_PASSING):
        g, d = IN_PASSING
        note = f" For the non-convex G = {g} and D = {d} two vertices touch in passing."
    return Evidence(trial.tried + note, trial.failure)


def _shares(s: Sweep, vertices: Contact, other: Contact) -> bool:
    """Whether a contact of two vertices is an end of a lasting contact."""
    return _has(s.generatrix, vertices[1], other.event[0], other[1]) and _has(
        s.directrix, vertices[2], other.event[1], other[2]
    )


def _has(polygon: Polygon, vertex: int, feature: str, index: int) -> bool:
    if feature == "V":
        return vertex == index
    numbers = range(len(polygon))
    k = next(k for k in numbers if polygon.edge_index(k) == index)
    return vertex in (polygon.vertex_index(k), polygon.vertex_index((k + 1) % len(polygon)))


CLAIMS = (
    Claim(
        "Theorem 2.1",
        "2",
        "Ends aside, the top chain of G never touches the top chain of D, nor the bottom chain "
        "the bottom chain.",
        Status.REPRODUCED,
        ("exactsweep.evidence.contact.edge_contacts", "exactsweep.evidence.contact.contacts_at"),
        _check_theorem_2_1,
        "Vertical edges inside the chains do no harm.",
    ),
    Claim(
        "Theorem 2.2",
        "2",
        "For any simply connected G and D, the swept area is an annulus: connected, with one "
        "inner and one outer loop.",
        Status.REFUTED,
        ("exactsweep.evidence.swept.Swept.inner", "exactsweep.evidence.swept.Swept.outer"),
        _check_theorem_2_2,
        "It holds for polygons that are monotone to a shared direction: over each x the two loops "
        "bound the free places, and they are functions of x. Otherwise there can be further loops, "
        "around places that no position in contact reaches.",
    ),
    Claim(
        "Definition 2.1",
        "2",
        "The outer boundary of the lower sweep is the bottom chain of what it sweeps; the inner "
        "one is what lies over D's range of x on the top.",
        Status.REPRODUCED,
        (
            "exactsweep.procedures.lower_sweep.LowerSweep.outer",
            "exactsweep.procedures.lower_sweep.LowerSweep.inner",
        ),
        _check_definition_2_1,
    ),
    Claim(
        "Distance travelled",
        "2",
        "From one end to the other, the lower sweep takes G as far to the right as G and D are "
        "wide together (said without proof).",
        Status.REPRODUCED,
        ("exactsweep.evidence.swept.Swept.trajectory",),
        _check_distance,
    ),
    Claim(
        "Table 1",
        "2",
        "Contacts are of four kinds, by what touches: a vertex or an edge of G, a vertex or an "
        "edge of D.",
        Status.REPRODUCED,
        (
            "exactsweep.evidence.contact.Contact",
            "exactsweep.evidence.contact.edge_contacts",
            "exactsweep.evidence.steps.explain",
        ),
        _check_table_1,
    ),
    Claim(
        "VV is incidental",
        "2",
        "The contact of two vertices only comes along with contacts of the other kinds (said "
        "without proof).",
        Status.REPRODUCED,
        ("exactsweep.evidence.contact.contacts_at",),
        _check_incidental,
        "In an MM sweep two vertices can also touch in passing, while other contacts, before and "
        "after, guide G.",
    ),
)
