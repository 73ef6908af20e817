"""The contacts of a sweep, held against the checking side, whatever becomes of the other loops."""

from __future__ import annotations

from exactsweep import Polygon, Sweep
from exactsweep.check.certificate import CertificateError
from exactsweep.check.contacts import check_contacts
from exactsweep.check.loop import MonotoneLoop, NodeFrame
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
    return ""


def _numbers(polygon: Polygon) -> dict[tuple[str, int], int]:
    """Vertices and edges by their numbers as given: their numbers in canonical order."""
    ks = range(len(polygon))
    vertices = {("V", polygon.vertex_index(k)): k for k in ks}
    return vertices | {("E", polygon.edge_index(k)): k for k in ks}
