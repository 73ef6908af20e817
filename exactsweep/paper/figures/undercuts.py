"""Figures 6, 7, 12 and 13: envelopes, undercuts, contacts, and the motion of the contact."""

from fractions import Fraction
from typing import NamedTuple

from exactsweep.draw import ContactInterval, cut_trajectory
from exactsweep.draw.intervals import SweepFeatures
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.undercut import Undercut
from exactsweep.geometry.region import Vertices
from exactsweep.numbers.number import Point, Vertex
from exactsweep.paper import kernel
from exactsweep.paper.checks.section4 import lowest
from exactsweep.paper.figures.figure import (
    PaperFigure,
    find_middle,
    join_panels,
    place,
    shift,
    take_half,
    write_list,
)
from exactsweep.paper.functions import keep_corners, take_bottom
from exactsweep.procedures.chain import split
from exactsweep.sweep import Sweep, sweep

DIRECTRIX = [(0, 4), (3, 0), (6, 5), (9, 1), (12, 5), (6, 8)]
# A roof, and a long straight edge parallel to the line through the two lowest vertices of D.
GENERATRICES: tuple[Vertices, ...] = (
    [(0, 0), (5, -4), (9, 0), (4, 3)],
    [(0, -1), (6, -4), (11, 0), (10, "3/2"), (1, 0)],
)
REFERENCES = ((5, -4), (6, -4))


def sweep_examples() -> tuple[Sweep, Sweep]:
    first, second = (
        sweep(g, DIRECTRIX, reference=r) for g, r in zip(GENERATRICES, REFERENCES, strict=True)
    )
    return first, second


def find_undercut(s: Sweep) -> Undercut:
    (found,) = s.undercuts
    return found


def compute_undercuts() -> PaperFigure:
    panels = zip("ab", sweep_examples(), ("point", "segment"), strict=True)
    return join_panels({letter: _show_undercut(letter, s, kind) for letter, s, kind in panels})


def _show_undercut(letter: str, s: Sweep, kind: str) -> PaperFigure:
    found, half, gap = find_undercut(s), take_half(s), s.inner.area - s.directrix.area
    parts = (
        kernel.trajectory_cc(half.top, part) for part in kernel.find_convex_parts(half.directrix)
    )
    first, *others = place(s, found.positions)
    return PaperFigure(
        facts=[
            (f"({letter}) undercuts", len(s.undercuts)),
            (f"({letter}) the sub-trajectories meet in a", found.intersection),
            (f"({letter}) edges of the bottom chain", len(found.bottom) - 1),
            (f"({letter}) contact points", " ".join(f"({p.x}, {p.y})" for p in found.extremes)),
        ],
        laws=[
            ("kind", found.intersection, kind),
            ("positions", len(found.positions), 1 if kind == "point" else 2),
            ("area between D and the inner loop", gap, found.polygon.area),
        ],
        shapes={
            "first": first,
            "others": others,
            "parts": [shift(part, s.reference) for part in parts],
        }
        | {"path": take_bottom(s.trajectory.vertices), "bottom": found.bottom}
        | {"touched": found.extremes, "positions": found.positions},
        sweeps=[(s, found.positions)],
    )


OFFSETS = {"VE": (-10, 6), "EV": (4, -10)}


def compute_vertex_event() -> PaperFigure:
    s = sweep_examples()[1]
    every = cut_trajectory(s)
    alone = [segment for segment in every if segment.event == "VE"]
    several = [segment for segment in every if len(segment.contacts) > 1]
    middles = [find_middle(segment.start, segment.end) for segment in every]
    laws: list[tuple[str, object, object]] = [
        (f"contacts missing at ({t.x}, {t.y})", set(o.contacts) - set(s.contacts_at(t)), set())
        for o, t in zip(every, middles, strict=True)
    ]
    for segment in several:
        laws.append(("edges of G", len({c.generatrix for c in segment.contacts}), 1))
        kinds = {c.event for c in segment.contacts}
        laws.append(("a VE event among several", "VE" in kinds, False))
    whole = PaperFigure(
        facts=[
            ("contact intervals of the trajectory", len(every)),
            ("with a VE event", len(alone)),
            ("with a VE event and another one", sum(len(one.contacts) > 1 for one in alone)),
            ("with several events", len(several)),
            ("events there", write_list(sorted({c.event for o in several for c in o.contacts}))),
        ],
        laws=laws,
        sweeps=[(s, middles)],
    )
    panels = {"": whole}
    for letter, kind in (("a", ("VE", 1)), ("b", ("EV", 2))):
        # The last such interval of the lower sweep.
        found = (o for o in every if (o.event, len(o.contacts)) == kind and o.start.x < o.end.x)
        panels[letter] = _show_contacts(s, max(found, key=lambda one: one.start.x))
    return join_panels(panels)


def _show_contacts(s: Sweep, segment: ContactInterval) -> PaperFigure:
    t = find_middle(segment.start, segment.end)
    (ring,) = place(s, [t])
    dx, dy = segment.end.x - segment.start.x, segment.end.y - segment.start.y
    by = 2 * dx / max(dx, abs(dy)), 2 * dy / max(dx, abs(dy))
    spots = [SweepFeatures(s).spot(contact, t)[0] for contact in segment.contacts]
    lowest = min(ring, key=lambda p: p.y)
    return PaperFigure(
        shapes={"placed": ring, "name": find_middle(min(ring), max(ring)), "spots": spots}
        | {"lines": [[_move(spot, by, -2), _move(spot, by, 3)] for spot in spots]}
        | {"offsets": [OFFSETS[contact.event] for contact in segment.contacts]}
        | {"onward": [_move(lowest, by, Fraction(k, 4)) for k in (1, 6)]},
        words={"events": [contact.event for contact in segment.contacts]},
    )


def _move(p: Vertex, by: Vertex, times: int | Fraction) -> Vertex:
    return p[0] + times * by[0], p[1] + times * by[1]


class Frozen(NamedTuple):
    """A position of G with its leftmost and its rightmost point of contact."""

    at: Point
    left: Point
    right: Point


def _freeze(s: Sweep, contacts: tuple[Contact, ...], at: Point) -> Frozen:
    spots = [p for c in contacts for p in SweepFeatures(s).spot(c, at)]
    return Frozen(at, min(spots), max(spots))


def compute_contact_motion() -> PaperFigure:
    """Compute Figure 13 from the lower sweep of Figure 7b, stopped where G closes the undercut."""
    s = sweep_examples()[1]
    # The extreme contacts at both ends of each segment.
    path = [
        _freeze(s, segment.contacts, at)
        for segment in cut_trajectory(s)
        if segment.start.x < segment.end.x
        for at in (segment.start, segment.end)
    ]
    one, other = find_undercut(s).positions
    at = find_middle(one, other)
    found = _freeze(s, tuple(s.contacts_at(at)), at)
    lefts, rights = [moment.left.x for moment in path], [moment.right.x for moment in path]
    ticks = sorted({*lefts, *rights})
    (ring,), first = place(s, [at]), path[0].at.x
    distance, wide = path[-1].at.x - first, s.directrix.bounding_box[1].x
    low, high = min(y for _, y in ring) - 1, s.directrix.bounding_box[1].y
    edge = min(x for x, _ in ring) - 2
    # The ray up from p_l, the part of G_t from p_l to v_l, and the ray down from v_l.
    passed = [p for p in split(ring)[1] if p[0] < found.left.x]
    border = [(found.left.x, high), found.left, *passed, (passed[-1][0], low)]
    middle = (one.x + other.x) / 2 - first
    ends = write_list(f"({p.x}, {p.y})" for p in (found.left, found.right))
    return PaperFigure(
        facts=[
            ("p_l and p_r at the position drawn", ends),
            ("positions compared", len(path)),
            ("p_l moves from, to", f"{lefts[0]}, {lefts[-1]}"),
            ("p_r moves from, to", f"{rights[0]}, {rights[-1]}"),
        ],
        laws=[
            ("the left end only moves right", lefts, sorted(lefts)),
            ("the right end only moves right", rights, sorted(rights)),
        ],
        shapes={"placed": ring, "first": min(ring), "name": find_middle(min(ring), max(ring))}
        | {"bottom": take_half(s).directrix, "border": border, "frame": [(edge, low), (edge, high)]}
        | {"half": [(edge, low), (edge, high), *border], "left": found.left, "right": found.right}
        | {"axes": [[(0, 0), (distance + 1, 0)], [(0, 0), (0, wide + 1)]]}
        | {"chart": [(0, 0), (distance + 1, wide + 1)], "high": (0, wide)}
        | {"b_lefts": [(moment.at.x - first, moment.left.x) for moment in path]}
        | {"b_rights": [(moment.at.x - first, moment.right.x) for moment in path]}
        | {"ticks": [(0, x) for x in ticks], "along": (distance / 2, 0)}
        | {"stop_left": (middle, found.left.x), "stop_right": (middle, found.right.x)},
        words={"ticks": [str(x) for x in ticks]},
        sweeps=[(s, [moment.at for moment in path])],
    )


ENVELOPE_GENERATRIX = [(0, 0), (1, -2), (4, -1), (5, 0), (3, 3), (1, 2)]
ENVELOPE_DIRECTRIX = [(0, 5), (2, 1), (5, 0), (8, 4), (10, 0), (14, 1), (16, 5), (12, 7), (4, 7)]


def compute_envelopes() -> PaperFigure:
    s = sweep(ENVELOPE_GENERATRIX, ENVELOPE_DIRECTRIX, reference=(2, 0))
    half = take_half(s)
    chain = half.directrix
    parts = kernel.find_convex_parts(chain)
    paths = [shift(kernel.trajectory_cc(half.top, part), s.reference) for part in parts]
    outers = [kernel.sweep_outer_cc(half.top, half.bottom, part) for part in parts]
    path = shift(kernel.trajectory_cm(half.top, chain), s.reference)
    outer = list(kernel.sweep_outer_cm(half.top, half.bottom, chain))
    meeting = s.undercuts[0].positions[:1]
    return PaperFigure(
        facts=[
            ("convex parts of D_b", len(parts)),
            ("their edges", write_list(len(part) - 1 for part in parts)),
            ("edges of the sub-trajectories", write_list(len(p) - 1 for p in paths)),
            ("edges of the trajectory", len(path) - 1),
            ("edges of the sub-outer chains", write_list(len(p) - 1 for p in outers)),
            ("edges of the outer boundary", len(outer) - 1),
            ("undercuts", len(s.undercuts)),
        ],
        laws=[
            ("trajectory", keep_corners(path), take_bottom(s.trajectory.vertices)),
            ("outer boundary", keep_corners(outer), take_bottom(s.outer.vertices)),
            ("lowest sub-trajectories", lowest("sub-trajectory", paths, path), ""),
            ("lowest sub-outer chains", lowest("sub-outer chain", outers, outer), ""),
            ("the sub-trajectories meet on the trajectory", meeting[0] in path, True),
        ],
        shapes={"top": split(s.directrix.vertices)[1], "bottom": chain, "parts": parts}
        | {"paths": paths, "outers": outers, "path": path, "lower": outer}
        | {"detached": shift(s.generatrix.vertices, (-5, 0)), "meeting": meeting}
        | {"ends": [(x, 0) for x, _ in (outer[0], outer[-1])]}
        | {"below": (chain[3][0] - 2, min(y for _, y in outer))},
        sweeps=[(s, meeting)],
    )
