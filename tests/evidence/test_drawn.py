"""The features of G that draw the loops, at positions on the trajectory, on the edge they draw."""

from collections.abc import Iterator
from itertools import product

import pytest
from many_contacts import FORK, ROOF, STAIRS, STEPS, TABLE

from exactsweep import Sweep, sweep
from exactsweep.check import verify
from exactsweep.evidence.contact import list_edges
from exactsweep.evidence.trace import Feature, Trace
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.segment import Segment, choose_cover, make_segment
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.point import Edge

TEETH = [(0, 0), (1, 2), (2, 0), (4, 3), (5, 1), (8, 4), (9, 0), (9, 6), (0, 6)]
PLOUGH = [(0, 0), (4, -2), (5, 1), (3, 2), (2, 1), (1, 2)]
PAIRS = [(FORK, TABLE), (FORK, ROOF), (ROOF, TABLE), (STEPS, STAIRS), (TEETH, ROOF), (ROOF, TEETH)]
PAIRS += [(PLOUGH, TEETH), (TEETH, PLOUGH), (PLOUGH, TABLE), (PLOUGH, PLOUGH), (TABLE, TABLE)]


def known() -> Iterator[Sweep]:
    for g, d in PAIRS:
        yield sweep(g, d, direction=(1, 0))
        yield sweep(*([(-x, -y) for x, y in shape] for shape in (g, d)), direction=(1, 0))


def gather(edge: Edge, path: Outline, g: Outline) -> list[list[tuple[Segment, Trace]]]:
    """All pieces that G draws on an edge: edges from its ends, along paths, edges at vertices."""
    whole = make_segment(edge)
    from_ends, along, at_all = [], [], []
    for (k, t), (i, own) in product(enumerate(path.vertices), enumerate(g.edges)):
        piece = make_segment(own).moved(t)
        trace = Trace(Feature("vertex", k), Feature("edge", i))
        if any(minus(p, q) == t for p in edge for q in own):
            from_ends.append((piece, trace))
        at_all.append((piece, trace))
    for (k, (p, q)), (i, w) in product(enumerate(path.edges), enumerate(g.vertices)):
        ends = g.edge(i)
        is_parallel = make_segment(ends).direction == make_segment((p, q)).direction
        moved = [(u + x, v + y) for u, v in (ends if is_parallel else (w,)) for x, y in (p, q)]
        total = make_segment((min(moved), max(moved)))
        feature = Feature("edge" if is_parallel else "vertex", i)
        along.append((total, Trace(Feature("edge", k), feature)))
    return [
        [(piece, trace) for piece, trace in group if on_line(piece, whole)]
        for group in (from_ends, along, at_all)
    ]


def on_line(piece: Segment, whole: Segment) -> bool:
    is_same = (piece.direction, piece.offset) == (whole.direction, whole.offset)
    return is_same and piece.shares_piece(whole)


@pytest.mark.parametrize("s", [*known()])
def test_what_draws_an_edge_covers_it_and_is_looked_for_in_order(s: Sweep) -> None:
    assert verify(s.certificate()).proved
    path, g = s._route, s._boundaries[0]
    for loop in s.solution.inner, s.solution.outer:
        for edge in list_edges(s._enter(loop)):
            whole = make_segment(edge)
            found = s._tracer.trace(edge)
            tried: list[tuple[Segment, Trace]] = []
            for group in gather(edge, path, g):
                tried += group
                if choose_cover(whole, [(piece, 0) for piece, _ in tried]) is not None:
                    break
            pieces = {trace: piece for piece, trace in tried}
            assert {*found} <= pieces.keys()
            is_one = any(p.low <= whole.low and whole.high <= p.high for p in pieces.values())
            assert (len(found) == 1) == is_one
            # None of them is needless, and they come from one end to the other.
            drawn = [(pieces[trace], 0) for trace in found]
            assert choose_cover(whole, drawn) is not None
            for k in range(len(drawn)):
                assert choose_cover(whole, drawn[:k] + drawn[k + 1 :]) is None
            assert drawn == sorted(drawn)
