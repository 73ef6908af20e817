"""The contacts of a sweep, compared with a trial of every pair of features."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise, product

from exactsweep import Point, Polygon, Sweep
from exactsweep.evidence.steps import Step
from exactsweep.geometry.vectors import is_on_segment
from exactsweep.numbers.point import Vertex
from exactsweep.paper.functions import list_edges, look_up
from exactsweep.paper.pairs import SweepPair


def contacts_are_right(s: Sweep) -> str:
    """Say which contact is listed wrongly, or missing; empty if none is."""
    g, d = s.generatrix.exterior, s.directrix.exterior
    pair = SweepPair(*([(int(x), int(y)) for x, y in polygon.vertices] for polygon in (g, d)))
    corners = s.trajectory.vertices
    if corners != look_up(pair).trajectory:
        return "the trajectory is not that of the definition"
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
        if now != (expected := list_lasting(s.generatrix.exterior, s.directrix.exterior, t)):
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


def list_lasting(g: Polygon, d: Polygon, t: Point) -> list[tuple[str, int, int]]:
    """The contacts of G + t and D that last: two edges that touch stand for their ends, too."""
    found = list_touching(g, d, t)
    ends = [
        {
            p.edge_index(k): {p.vertex_index(k), p.vertex_index((k + 1) % len(p))}
            for k in range(len(p))
        }
        for p in (g, d)
    ]
    edges = [(i, j) for event, i, j in found if event == "EE"]
    hidden = {("VE", v, j) for i, j in edges for v in ends[0][i]}
    hidden |= {("EV", i, v) for i, j in edges for v in ends[1][j]}
    return [contact for contact in found if contact not in hidden]


def list_touching(g: Polygon, d: Polygon, t: Point) -> list[tuple[str, int, int]]:
    """All contacts of G + t and D, every feature of one tried with every one of the other."""
    gs, ds = ([p.vertices[k - len(p)] for k in range(len(p) + 1)] for p in (g, d))
    gs = [Point(x + t.x, y + t.y) for x, y in gs]
    found = []
    for i, j in product(range(len(g)), range(len(d))):
        (p, q), (v, w) = gs[i : i + 2], ds[j : j + 2]
        if _are_apart((p, q), (v, w)):
            continue
        corner, at = (g.vertex_index(i), d.vertex_index(j)), (g.edge_index(i), d.edge_index(j))
        if p == v:
            found.append(("VV", *corner))
        if v not in (p, q) and is_on_segment(v, p, q):
            found.append(("EV", at[0], corner[1]))
        if p not in (v, w) and is_on_segment(p, v, w):
            found.append(("VE", corner[0], at[1]))
        ends = {o for o in (p, q, v, w) if is_on_segment(o, p, q) and is_on_segment(o, v, w)}
        if len(ends) > 1:
            found.append(("EE", *at))
    return sorted(found)


def _are_apart(one: Sequence[Vertex], other: Sequence[Vertex]) -> bool:
    """Decide whether the boxes of two edges have no point in common."""
    return any(
        max(p[k] for p in one) < min(p[k] for p in other)
        or max(p[k] for p in other) < min(p[k] for p in one)
        for k in (0, 1)
    )
