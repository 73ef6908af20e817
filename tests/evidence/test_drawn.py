"""The features of G that draw the loops, at positions on the trajectory, on the edge they draw."""

from collections.abc import Iterator
from itertools import product

import pytest
from many_contacts import FORK, ROOF, STAIRS, STEPS, TABLE

from exactsweep import Sweep, sweep
from exactsweep.check import verify
from exactsweep.evidence.contact import list_edges
from exactsweep.evidence.drawn import DrawnPiece, Feature, find_drawn_edges
from exactsweep.geometry.outline import Outline
from exactsweep.geometry.segment import Segment, choose_cover, make_segment
from exactsweep.geometry.vectors import minus
from exactsweep.numbers.number import Edge

TEETH = [(0, 0), (1, 2), (2, 0), (4, 3), (5, 1), (8, 4), (9, 0), (9, 6), (0, 6)]
PLOUGH = [(0, 0), (4, -2), (5, 1), (3, 2), (2, 1), (1, 2)]
PAIRS = [(FORK, TABLE), (FORK, ROOF), (ROOF, TABLE), (STEPS, STAIRS), (TEETH, ROOF), (ROOF, TEETH)]
PAIRS += [(PLOUGH, TEETH), (TEETH, PLOUGH), (PLOUGH, TABLE), (PLOUGH, PLOUGH), (TABLE, TABLE)]


def known() -> Iterator[Sweep]:
    for g, d in PAIRS:
        yield sweep(g, d, direction=(1, 0))
        yield sweep(*([(-x, -y) for x, y in shape] for shape in (g, d)), direction=(1, 0))


def gather(edge: Edge, path: Outline, g: Outline) -> list[list[DrawnPiece]]:
    """All pieces that G draws on an edge: edges from its ends, along paths, edges at vertices."""
    whole = make_segment(edge)
    from_ends, along, at_all = [], [], []
    for (k, t), (i, own) in product(enumerate(path.vertices), enumerate(g.edges)):
        start, end = ((x + t[0], y + t[1]) for x, y in own)
        drawn = DrawnPiece(Feature("vertex", k), Feature("edge", i), make_segment((start, end)))
        if any(minus(p, q) == t for p in edge for q in own):
            from_ends.append(drawn)
        at_all.append(drawn)
    for (k, (p, q)), (i, w) in product(enumerate(path.edges), enumerate(g.vertices)):
        ends = g.edge(i)
        is_parallel = make_segment(ends).direction == make_segment((p, q)).direction
        moved = [(u + x, v + y) for u, v in (ends if is_parallel else (w,)) for x, y in (p, q)]
        total = make_segment((min(moved), max(moved)))
        feature = Feature("edge" if is_parallel else "vertex", i)
        along.append(DrawnPiece(Feature("edge", k), feature, total))
    return [
        [drawn for drawn in group if on_line(drawn.piece, whole)]
        for group in (from_ends, along, at_all)
    ]


def on_line(piece: Segment, whole: Segment) -> bool:
    is_same = (piece.direction, piece.offset) == (whole.direction, whole.offset)
    return is_same and piece.shares_piece(whole)


@pytest.mark.parametrize("s", [*known()])
def test_what_draws_an_edge_covers_it_and_is_looked_for_in_order(s: Sweep) -> None:
    assert verify(s.certificate()).proved
    path, g = s._route, s._boundaries[0]
    for loop in (s.solution.inner, s.solution.outer):
        edges = list_edges(s._enter(loop))
        for edge, at in zip(edges, find_drawn_edges(edges, path, g), strict=True):
            whole = make_segment(edge)
            found = at.choose()
            tried: list[DrawnPiece] = []
            for group in gather(edge, path, g):
                tried += group
                if choose_cover(whole, [(drawn.piece, 0) for drawn in tried]) is not None:
                    break
            assert {*found} <= {*tried}
            is_one = any(p.low <= whole.low and whole.high <= p.high for _, _, p in tried)
            assert (len(found) == 1) == is_one
            # None of them is needless, and they come from one end to the other.
            drawn = [(drawn.piece, 0) for drawn in found]
            assert choose_cover(whole, drawn) is not None
            for k in range(len(drawn)):
                assert choose_cover(whole, drawn[:k] + drawn[k + 1 :]) is None
            assert drawn == sorted(drawn)
