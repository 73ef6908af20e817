"""The contacts of a sweep, compared with a trial of every pair of features."""

from __future__ import annotations

from itertools import pairwise, product
from math import lcm

from exactsweep import Point, Sweep
from exactsweep.evidence.steps import Step
from exactsweep.geometry.outline import number_features
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.vectors import is_on_segment
from exactsweep.numbers.number import Vertex
from exactsweep.paper.functions import list_edges, tell_loops


def contacts_are_right(s: Sweep) -> str:
    """Say which contact is listed wrongly, or missing; empty if none is."""
    g, d, corners = s.generatrix, s.directrix, s.trajectory.vertices
    if failure := tell_loops(s, "trajectory"):
        return failure
    for k, (start, end) in enumerate(list_edges(corners)):
        now = {c for t in list_moments(s, start, end) for c in list_lasting(g, d, t)}
        for t, listed, expected in (
            (start, s.vertex_contacts[k], list_touching(g, d, start)),
            (end, s.contacts[k], sorted(now)),
        ):
            if sorted(listed) != expected:
                where = "at" if t is start else f"from ({start.x}, {start.y}) to"
                return f"{where} ({t.x}, {t.y}) contacts are {sorted(listed)}, not {expected}"
    return ""


def touches_are_right(s: Sweep, step: Step) -> str:
    """Say where the contacts of a step do not last from where they begin to where they end."""
    for t in list_moments(s, step.start, step.end):
        now = sorted(touch.contact for touch in step.touches if lasts(t, touch.start, touch.end))
        if now != (expected := list_lasting(s.generatrix, s.directrix, t)):
            return f"at ({t.x}, {t.y}) these contacts last: {now}, and not {expected}"
        if not now or any(event == "VV" for event, _, _ in now):
            return f"at ({t.x}, {t.y}), on an edge of the trajectory, these contacts last: {now}"
    return ""


def lasts(t: Point, start: Point, end: Point) -> bool:
    """Decide whether a position on an edge lies strictly between two others."""
    return min(start, end) < t < max(start, end)


def list_moments(s: Sweep, start: Point, end: Point) -> list[Point]:
    """Positions along an edge of the trajectory, one between each two that may differ in contact.

    A contact begins or ends only where a vertex of G is on one of D.
    """
    cuts = {start, end}
    low, high = min(start, end), max(start, end)
    for w, v in product(s.directrix.vertices, s.generatrix.vertices):
        t = Point(w.x - v.x, w.y - v.y)
        if low < t < high and is_on_segment(t, start, end):
            cuts.add(t)
    return [Point((p.x + q.x) / 2, (p.y + q.y) / 2) for p, q in pairwise(sorted(cuts))]


def list_lasting(g: AnyPolygon, d: AnyPolygon, t: Point) -> list[tuple[str, int, int]]:
    """The contacts of G + t and D that last: two edges that touch stand for their ends, too."""
    found = list_touching(g, d, t)
    (_, g_ends), (_, d_ends) = map(number_features, (g, d))
    flat = [(i, j) for event, i, j in found if event == "EE"]
    hidden = {("VE", v, j) for i, j in flat for v in g_ends[i]}
    hidden |= {("EV", i, v) for i, j in flat for v in d_ends[j]}
    return [contact for contact in found if contact not in hidden]


def list_touching(g: AnyPolygon, d: AnyPolygon, t: Point) -> list[tuple[str, int, int]]:
    """All contacts of G + t and D, every feature of one tried with every one of the other."""
    (g_corners, g_edges), (d_corners, d_edges) = map(number_features, (g, d))
    moved = {i: (x + t.x, y + t.y) for i, (x, y) in g_corners.items()}
    # Ints compare much faster than Fractions.
    scale = lcm(*(c.denominator for p in (*moved.values(), *d_corners.values()) for c in p))
    scaled = [
        {k: (int(x * scale), int(y * scale)) for k, (x, y) in corners.items()}
        for corners in (moved, d_corners)
    ]
    ours, theirs = (
        {k: sorted((corners[a], corners[b])) for k, (a, b) in ends.items()}
        for corners, ends in zip(scaled, (g_edges, d_edges), strict=True)
    )
    gs, ds = (corners.items() for corners in scaled)
    found = [("VV", i, j) for (i, p), (j, v) in product(gs, ds) if p == v]
    found += [("EV", i, j) for (i, e), (j, v) in product(ours.items(), ds) if _is_inside(v, *e)]
    found += [("VE", i, j) for (i, p), (j, f) in product(gs, theirs.items()) if _is_inside(p, *f)]
    for (i, e), (j, f) in product(ours.items(), theirs.items()):
        low, high = max(e[0], f[0]), min(e[1], f[1])
        if low < high and all(is_on_segment(p, *edge) for p in (low, high) for edge in (e, f)):
            found.append(("EE", i, j))
    return sorted(found)


def _is_inside(point: Vertex, low: Vertex, high: Vertex) -> bool:
    """Decide whether a point is inside a segment, as `is_between` does, but quickly."""
    return low < point < high and is_on_segment(point, low, high)
