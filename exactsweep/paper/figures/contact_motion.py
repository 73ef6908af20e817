"""Figure 13: the contact only moves to the right."""

from __future__ import annotations

from typing import NamedTuple

from exactsweep.draw import cut_trajectory
from exactsweep.draw.features import SweepFeatures
from exactsweep.evidence.contact import Contact
from exactsweep.numbers.number import Point
from exactsweep.paper.figures.figure import PaperFigure, find_middle, place, take_half, write_list
from exactsweep.paper.figures.undercuts import find_undercut, sweep_examples
from exactsweep.procedures.chain import split
from exactsweep.sweep import Sweep


class Frozen(NamedTuple):
    """A position of G with its leftmost and its rightmost point of contact."""

    at: Point
    left: Point
    right: Point


def _freeze(s: Sweep, contacts: tuple[Contact, ...], at: Point) -> Frozen:
    spots = [p for c in contacts for p in SweepFeatures(s).spot(c, at)]
    return Frozen(at, min(spots), max(spots))


def compute() -> PaperFigure:
    """Compute the figure: the lower sweep of Figure 7b, stopped where G closes the undercut."""
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
    travelled, wide = path[-1].at.x - first, s.directrix.bounding_box[1].x
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
        | {"axes": [[(0, 0), (travelled + 1, 0)], [(0, 0), (0, wide + 1)]]}
        | {"chart": [(0, 0), (travelled + 1, wide + 1)], "high": (0, wide)}
        | {"b_lefts": [(moment.at.x - first, moment.left.x) for moment in path]}
        | {"b_rights": [(moment.at.x - first, moment.right.x) for moment in path]}
        | {"ticks": [(0, x) for x in ticks], "along": (travelled / 2, 0)}
        | {"stop_left": (middle, found.left.x), "stop_right": (middle, found.right.x)},
        words={"ticks": [str(x) for x in ticks]},
        sweeps=[(s, [moment.at for moment in path])],
    )
