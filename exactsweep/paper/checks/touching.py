"""The contacts of a sweep, compared with a test of all pairs of features."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise, product
from math import lcm

from exactsweep import Point, Sweep
from exactsweep.evidence.steps import Step
from exactsweep.geometry.outline import number_features
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.vectors import is_on_segment
from exactsweep.numbers.number import Vertex
from exactsweep.paper.functions import compare_loops, list_edges

_Bounded = tuple[str, int, list[tuple[int, int]]]
"""A vertex or an edge: "V" or "E", its number and its ends."""


def contacts_are_right(s: Sweep) -> Iterator[str]:
    """Report missing and superfluous contacts of a sweep."""
    g, d = s.generatrix, s.directrix
    yield from compare_loops(s, "trajectory")
    for k, (start, end) in enumerate(list_edges(s.trajectory.vertices)):
        now = {c for t in list_moments(s, start, end) for c in list_lasting(g, d, t)}
        for t, listed, expected in (
            (start, s.vertex_contacts[k], list_touching(g, d, start)),
            (end, s.contacts[k], sorted(now)),
        ):
            if sorted(listed) != expected:
                where = "at" if t is start else f"from ({start.x}, {start.y}) to"
                yield f"{where} ({t.x}, {t.y}) contacts are {sorted(listed)}, not {expected}"


def touches_are_right(s: Sweep, step: Step) -> Iterator[str]:
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
