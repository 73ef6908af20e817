"""The contacts of a sweep, held against the checking side, whatever becomes of the other loops."""

from __future__ import annotations

from itertools import product

from exactsweep import Point, Polygon, Sweep
from exactsweep.check.certificate import CertificateError
from exactsweep.check.contacts import check_contacts
from exactsweep.check.loop import MonotoneLoop, NodeFrame
from exactsweep.geometry.vectors import is_on_segment
from exactsweep.numbers.point import ORIGIN
from exactsweep.paper.functions import look_up
from exactsweep.paper.pairs import SweepPair


def contacts_are_right(s: Sweep) -> str:
    """Say which contact is listed wrongly, or missing; empty if none is."""
    g, d = s.generatrix.exterior, s.directrix.exterior
    pair = SweepPair(*([(int(x), int(y)) for x, y in polygon.vertices] for polygon in (g, d)))
    if s.trajectory.vertices != look_up(pair).trajectory:
        return "the trajectory is not that of the definition"
    frame = NodeFrame((1, 0), 1)
    generatrix = MonotoneLoop(frame.enter(g.vertices, ORIGIN), "generatrix", frame)
    trajectory = MonotoneLoop(frame.enter(s.trajectory.vertices, s.reference), "trajectory", frame)
    directrix = MonotoneLoop(frame.enter(d.vertices, ORIGIN), "directrix", frame)
    of_g, of_d = _numbers(g), _numbers(d)
    listed = [
        [(event, of_g[event[0], i], of_d[event[1], j]) for event, i, j in found if event != "VV"]
        for found in s.contacts
    ]
    try:
        check_contacts(trajectory, directrix, generatrix.turn_half(), listed, frame)
    except CertificateError as flaw:
        return str(flaw)
    for t, at in zip(s.trajectory.vertices, s.vertex_contacts, strict=True):
        if sorted(at) != (expected := list_touching(g, d, t)):
            return f"at ({t.x}, {t.y}) contacts are {sorted(at)}, not {expected}"
    return ""


def list_touching(g: Polygon, d: Polygon, t: Point) -> list[tuple[str, int, int]]:
    """All contacts of G + t and D, every feature of one tried with every one of the other."""
    gs, ds = ([p.vertices[k - len(p)] for k in range(len(p) + 1)] for p in (g, d))
    gs = [Point(x + t.x, y + t.y) for x, y in gs]
    found = []
    for i, j in product(range(len(g)), range(len(d))):
        (p, q), (v, w) = gs[i : i + 2], ds[j : j + 2]
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


def _numbers(polygon: Polygon) -> dict[tuple[str, int], int]:
    """Vertices and edges by their numbers as given: their numbers in canonical order."""
    ks = range(len(polygon))
    vertices = {("V", polygon.vertex_index(k)): k for k in ks}
    return vertices | {("E", polygon.edge_index(k)): k for k in ks}
