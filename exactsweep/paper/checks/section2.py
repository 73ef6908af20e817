"""Section 2: the chains of a sweep, its two loops, and the contacts of Table 1."""

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from itertools import chain, pairwise, product
from math import lcm

from exactsweep import Point, Polygon, Sweep, sweep
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import Step, explain
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.direction import X_AXIS
from exactsweep.geometry.outline import number_features
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.vectors import is_on_segment
from exactsweep.numbers.number import Vertex
from exactsweep.paper import functions
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation, Table
from exactsweep.paper.laws import expect_none, search, search_grid
from exactsweep.paper.pairs import SweepPair, draw_pairs, list_corners
from exactsweep.procedures.chain import split
from exactsweep.procedures.monotone import MonotoneSolution

KINDS = ("CC", "CM", "MM")
# The opening of the cavity is 1.5 times as wide as G.
CAVITY = SweepPair([(0, 0), (2, 0), (1, 1)], [(0, 0), (9, 0), (6, 4), (8, 1), (1, 1), (3, 4)])


def like_chains_stay_apart(pair: SweepPair) -> Iterator[str]:
    """Along the trajectory, the two top chains are disjoint, and so are the two bottom chains."""
    (g_bottom, g_top), (d_bottom, d_top) = map(split, pair)
    for (px, py), (qx, qy) in functions.list_edges(functions.look_up(pair).trajectory):
        for tx, ty in ((px, py), ((px + qx) / 2, (py + qy) / 2)):
            for g, d in ((g_bottom, d_bottom), (g_top[::-1], d_top[::-1])):
                placed = [(x + tx, y + ty) for x, y in g]
                inside = [
                    x
                    for x in functions.find_common_points(placed, d)
                    if functions.reaches(placed, x) and functions.reaches(d, x)
                ]
                if inside:
                    yield f"at ({tx}, {ty}) two top or two bottom chains touch over {inside[0]}"


def like_chains_have_no_contact(pair: SweepPair) -> Iterator[str]:
    """No contact is interior to both bottom chains or to both top chains."""
    s = sweep(*pair)
    yield from contacts_are_correct(s)
    for event, *features in {c for at in (*s.contacts, *s.vertex_contacts) for c in at}:
        sides = list(map(_side, (s.generatrix, s.directrix), event, features))
        if sides[0] == sides[1] != "end":
            yield f"{event} of two {sides[0]} chains: {features[0]} of G, {features[1]} of D"


def _side(shape: AnyPolygon, letter: str, index: int) -> str:
    """Return the chain that contains a feature in its interior, "bottom" or "top", else "end"."""
    corners, edges = number_features(shape)
    feature = corners[index] if letter == "V" else tuple(corners[k] for k in edges[index])
    for name, side in zip(("bottom", "top"), split(shape.vertices), strict=True):
        if feature in (side[1:-1] if letter == "V" else pairwise(side)):
            return name
    return "end"


def swept_area_is_the_definition(pair: SweepPair) -> Iterator[str]:
    """The outer loop, the inner loop and all unswept holes match the definition."""
    yield functions.explain_unproved(sweep(*pair))


def is_annulus(pair: SweepPair) -> Iterator[str]:
    """The swept area has the outer and the inner loop as defined, and no other loop."""
    if loops := sweep(*pair).unswept:
        yield f"the swept area has {len(loops)} more loops"
    yield from swept_area_is_the_definition(pair)


def find_extra_loop(effort: Effort) -> Iterator[Observation]:
    sizes = (10,) if effort.quick else (9, 10, 11)
    directrix = [(10 * x, 10 * y) for x, y in CAVITY.directrix]
    pairs = [SweepPair([(k * x, k * y) for x, y in CAVITY.generatrix], directrix) for k in sizes]
    yield Evidence("A cavity.")
    yield from chain.from_iterable(map(swept_area_is_the_definition, pairs))
    if all(len(sweep(*pair).unswept) == 1 for pair in pairs):
        yield Counterexample(
            "the complement of the swept area has 3 components, not 2: G enters the cavity, "
            "follows its walls and leaves without covering its middle"
            + ("" if effort.quick else "; the same happens if G is a tenth smaller or larger"),
            "by hand",
            *CAVITY,
        )


def boundaries_are_bottom_chains(pair: SweepPair) -> Iterator[str]:
    """The boundaries of a lower sweep are the bottom chains of both loops by the definition."""
    g, d = map(Polygon, pair)
    half, _ = MonotoneSolution(g, d, X_AXIS).halves
    yield from functions.compare_boundaries(
        pair, inner=half.sweep_inner(), outer=half.sweep_outer()
    )


def halves_are_alike(pair: SweepPair) -> Iterator[str]:
    """The loops of the mirrored pair are the mirrored loops."""
    upside_down = SweepPair(*([(x, -y) for x, y in reversed(ring)] for ring in pair))
    s, other = sweep(*pair), sweep(*upside_down)
    for name in ("trajectory", "inner", "outer"):
        mirrored = [(x, -y) for x, y in getattr(other, name).vertices]
        if Polygon(mirrored[::-1]) != getattr(s, name):
            yield f"the {name} of the mirrored pair is not the mirrored {name}"
    yield from functions.compare_loops(s, "trajectory")


def widths_add_up(pair: SweepPair) -> Iterator[str]:
    """The trajectory is as wide as G and D together."""
    s = sweep(*pair)
    boxes = (shape.bounding_box for shape in (s.generatrix, s.directrix, s.trajectory))
    g, d, t = (high.x - low.x for low, high in boxes)
    yield from functions.compare_loops(s, "trajectory")
    if g + d != t:
        yield f"the widths of G, D and T are {g}, {d} and {t}"


def steps_have_contacts(pair: SweepPair) -> Iterator[str]:
    """There are contacts all along each edge of the trajectory, as its step states."""
    s = sweep(*pair)
    yield from contacts_are_correct(s)
    for step in explain(s):
        yield from touches_are_correct(s, step)


def count_events(effort: Effort) -> Iterator[Observation]:
    events = Counter(
        contact.event
        for kind in KINDS
        for pair in draw_pairs(effort, kind, effort.cases(150))
        for at in sweep(*pair).vertex_contacts
        for contact in at
    )
    rows = [[event, f"{count:,}"] for event, count in sorted(events.items())]
    yield Table("Contacts at the vertices of trajectories", ("event", "count"), rows)
    if missing := {"EE", "EV", "VE", "VV"} - set(events):
        yield f"no contact of kind {', '.join(sorted(missing))}"


def vertices_belong_to_events(pair: SweepPair) -> Iterator[str]:
    """Each VV contact is an end of an EV, VE or EE contact before or after it."""
    s = sweep(*pair)
    yield from contacts_are_correct(s)
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
                yield f"the VV contact of {i} and {j} at vertex {k} of T ends no other contact"


def find_passing_vertices(effort: Effort) -> Iterator[Observation]:
    """Test all convex pairs on a tiny grid, and a triangle with all rows of teeth on another."""
    most = 6 if effort.quick else 8
    yield expect_none(search_grid(2, most, "convex", "convex", vertices_belong_to_events))
    yield search(_apexes_and_teeth(), vertices_belong_to_events, "of an apex and teeth")
    count = effort.cases(300)
    seen = sum(map(any, map(vertices_belong_to_events, draw_pairs(effort, "CM", count))))
    yield Evidence(f"{seen} of {count} random CM pairs have such a contact.")


def _apexes_and_teeth() -> Iterator[SweepPair]:
    """Yield a triangle with each bottom chain of five vertices at heights from 0 to 2."""
    generatrix = [(0, 0), (8, 0), (4, 2)]
    for heights in product(range(3), repeat=5):
        with suppress(PolygonError):
            corners = list_corners([*enumerate(heights), (2, 9)])
            if len(corners) == 6:
                yield SweepPair(generatrix, corners)


def starts_and_stops_at_the_ends(pair: SweepPair) -> Iterator[str]:
    """The sweep starts with G's right end on D's left end, and stops with G's left on D's right."""
    s, (top, _, directrix) = sweep(*pair), pair.chains
    path = functions.take_bottom(s.trajectory.vertices)
    for name, t, own, other in (
        ("starts", path[0], top[0], directrix[0]),
        ("stops", path[-1], top[-1], directrix[-1]),
    ):
        if (t[0] + own[0], t[1] + own[1]) != other:
            yield f"the sweep {name} at ({t[0]}, {t[1]}), where ({own[0]}, {own[1]}) is off D's end"


_Bounded = tuple[str, int, list[tuple[int, int]]]
"""A vertex or an edge: "V" or "E", its number and its ends."""


def contacts_are_correct(s: Sweep) -> Iterator[str]:
    g, d = s.generatrix, s.directrix
    yield from functions.compare_loops(s, "trajectory")
    for k, (start, end) in enumerate(functions.list_edges(s.trajectory.vertices)):
        now = {c for t in list_moments(s, start, end) for c in list_lasting(g, d, t)}
        for t, listed, expected in (
            (start, s.vertex_contacts[k], list_touching(g, d, start)),
            (end, s.contacts[k], sorted(now)),
        ):
            if sorted(listed) != expected:
                where = "at" if t is start else f"from ({start.x}, {start.y}) to"
                yield f"{where} ({t.x}, {t.y}) contacts are {sorted(listed)}, not {expected}"


def touches_are_correct(s: Sweep, step: Step) -> Iterator[str]:
    """Report contacts of a step that start or end at a wrong position."""
    for t in list_moments(s, step.start, step.end):
        now = sorted(touch.contact for touch in step.touches if lasts(t, touch.start, touch.end))
        if now != (expected := list_lasting(s.generatrix, s.directrix, t)):
            yield f"at ({t.x}, {t.y}) the lasting contacts are {now}, not {expected}"
        if not now or any(event == "VV" for event, _, _ in now):
            yield f"at ({t.x}, {t.y}), on an edge of the trajectory, the lasting contacts are {now}"


def lasts(t: Point, start: Point, end: Point) -> bool:
    return min(start, end) < t < max(start, end)


def list_moments(s: Sweep, start: Point, end: Point) -> list[Point]:
    """List positions along an edge of the trajectory, one in each interval of constant contact."""
    # A contact begins or ends only where a vertex of G is on a vertex of D.
    cuts = {start, end}
    low, high = min(start, end), max(start, end)
    for w, v in product(s.directrix.vertices, s.generatrix.vertices):
        t = Point(w.x - v.x, w.y - v.y)
        if low < t < high and is_on_segment(t, start, end):
            cuts.add(t)
    return [Point((p.x + q.x) / 2, (p.y + q.y) / 2) for p, q in pairwise(sorted(cuts))]


def list_lasting(g: AnyPolygon, d: AnyPolygon, t: Point) -> list[tuple[str, int, int]]:
    """List lasting contacts of G + t and D; a contact of two edges includes those of their ends."""
    found = list_touching(g, d, t)
    (_, g_ends), (_, d_ends) = map(number_features, (g, d))
    flat = [(i, j) for event, i, j in found if event == "EE"]
    hidden = {("VE", v, j) for i, j in flat for v in g_ends[i]}
    hidden |= {("EV", i, v) for i, j in flat for v in d_ends[j]}
    return [contact for contact in found if contact not in hidden]


def list_touching(g: AnyPolygon, d: AnyPolygon, t: Point) -> list[tuple[str, int, int]]:
    """List all contacts of G + t and D by testing all pairs of features."""
    (g_corners, g_edges), (d_corners, d_edges) = map(number_features, (g, d))
    moved = {i: (x + t.x, y + t.y) for i, (x, y) in g_corners.items()}
    # Ints compare much faster than Fractions.
    scale = lcm(*(c.denominator for p in (*moved.values(), *d_corners.values()) for c in p))

    def lay(corners: Mapping[int, Vertex], edges: Mapping[int, tuple[int, int]]) -> list[_Bounded]:
        points = {k: (int(x * scale), int(y * scale)) for k, (x, y) in corners.items()}
        ends = {k: sorted((points[a], points[b])) for k, (a, b) in edges.items()}
        return [("V", k, [p, p]) for k, p in points.items()] + [("E", *e) for e in ends.items()]

    features = product(lay(moved, g_edges), lay(d_corners, d_edges))
    return sorted((one + other, i, j) for (one, i, e), (other, j, f) in features if _touch(e, f))


def _touch(e: Sequence[Vertex], f: Sequence[Vertex]) -> bool:
    """Decide whether two features share a segment, or a point that is not an end of an edge."""
    low, high = max(e[0], f[0]), min(e[1], f[1])
    inside = low == high and all(p == q or low not in (p, q) for p, q in (e, f))
    is_met = low < high or inside
    return is_met and all(is_on_segment(p, *ends) for p in (low, high) for ends in (e, f))
