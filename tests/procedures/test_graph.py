"""Lower envelopes: known ones, and the minimum of all chains at single points."""

from fractions import Fraction
from itertools import pairwise, product
from random import Random

import pytest
import strategies as own
from hypothesis import given
from hypothesis import strategies as st
from tiers import examples

from exactsweep import Polygon
from exactsweep.numbers.number import Rational, Vertex
from exactsweep.paper.kernel import find_convex_parts, to_graph, trajectory_cc, trajectory_cm
from exactsweep.procedures.chain import Break, ChainError, split
from exactsweep.procedures.graph import GAP, find_piece, lower_envelope_cm, lower_envelope_mm
from exactsweep.procedures.undercuts import keep_corners

Chain = list[Vertex]
usually = examples(100)


@st.composite
def graphs(draw: st.DrawFn) -> Chain:
    """Chains without walls, on a grid, over x-ranges that contain [4, 5]."""
    xs = {*draw(st.sets(own.tiny(0, 9), max_size=4)), draw(own.tiny(0, 4)), draw(own.tiny(5, 9))}
    return keep_corners([(x, draw(own.tiny(0, 5))) for x in sorted(xs)])


def value(at: Break) -> Fraction:
    return Fraction(*at)


def height(chain: Chain, x: Fraction) -> Fraction | None:
    """Return the height of a chain at the abscissa of no vertex."""
    for (px, py), (qx, qy) in pairwise(chain):
        if px < x < qx:
            return py + Fraction(qy - py) * (x - px) / (qx - px)
    return None


@given(st.lists(graphs(), min_size=1, max_size=6))
@usually
def test_envelope_is_the_minimum_of_all_chains(chains: list[Chain]) -> None:
    found = list(lower_envelope_mm([to_graph(chain) for chain in chains]))
    corners = {x for x, _ in found}
    for k in range(9 * 7):
        # Not the x of a grid point; where chains cross, the envelope has a corner.
        x = Fraction(k, 7) + Fraction(1, 97)
        heights = [y for chain in chains if (y := height(chain, x)) is not None]
        if x not in corners:
            assert height(found, x) == min(heights, default=None)


@st.composite
def graphs_anywhere(draw: st.DrawFn) -> Chain:
    """Chains without walls, on a grid, over any x-ranges."""
    xs = draw(st.sets(own.tiny(0, 9), min_size=2, max_size=4))
    return keep_corners([(x, draw(own.tiny(0, 5))) for x in sorted(xs)])


@given(st.lists(graphs_anywhere(), min_size=1, max_size=6))
@usually
def test_missing_chains_leave_a_gap(chains: list[Chain]) -> None:
    found = lower_envelope_mm([to_graph(chain) for chain in chains])
    start, end = found.breaks[0], found.breaks[-1]
    assert value(start) == min(chain[0][0] for chain in chains)
    assert value(end) == max(chain[-1][0] for chain in chains)
    for k in range(9 * 7):
        x = Fraction(k, 7) + Fraction(1, 97)
        if not value(start) < x < value(end):
            continue
        dx, dy, c, _, _ = piece = found.pieces[find_piece(found, x.as_integer_ratio())]
        heights = [y for chain in chains if (y := height(chain, x)) is not None]
        low = None if piece == GAP else (dy * x + c) / dx
        assert low == min(heights, default=None)


@given(st.lists(graphs(), min_size=1, max_size=6), st.randoms())
@usually
def test_order_does_not_matter(chains: list[Chain], rng: Random) -> None:
    found = list(lower_envelope_mm([to_graph(chain) for chain in chains]))
    rng.shuffle(chains)
    assert list(lower_envelope_mm([to_graph(chain) for chain in chains])) == found
    twice = [to_graph(chain) for chain in (*chains, *chains)]
    assert list(lower_envelope_mm(twice)) == found


@given(st.lists(graphs(), min_size=1, max_size=6))
@usually
def test_no_three_vertices_are_collinear(chains: list[Chain]) -> None:
    v = list(lower_envelope_mm([to_graph(chain) for chain in chains]))
    assert keep_corners(v) == v


@given(own.pairs("CM"))
@usually
def test_cm_walk_gives_the_mm_envelope(pair: tuple[Polygon, Polygon]) -> None:
    """Lemmas A.3 and 5.1: sub-trajectories of a convex G meet as LowerEnvelope_CM needs it."""
    (_, top), (bottom, _) = (split(polygon.vertices) for polygon in pair)
    pieces = [trajectory_cc(top, part) for part in find_convex_parts(bottom)]
    partial = to_graph(pieces[0])
    for piece in pieces[1:]:
        assert lower_envelope_cm(partial, to_graph(piece)) is partial
    whole = lower_envelope_mm([to_graph(piece) for piece in pieces])
    assert list(partial) == list(whole)


@st.composite
def walled(draw: st.DrawFn) -> Chain:
    """Chains with walls, on a grid so small that they often meet."""
    x, y = 0, draw(own.tiny(0, 4))
    chain: Chain = [(x, y)]
    for width in draw(st.lists(own.tiny(0, 2), min_size=1, max_size=6)):
        x, y = x + width, draw(own.tiny(0, 4))
        chain.append((x, y))
    return keep_corners([(-1, draw(own.tiny(0, 4))), *chain, (x + 1, draw(own.tiny(0, 4)))])


def list_borders(*chains: Chain) -> list[Fraction]:
    """Return the abscissas of vertices and crossings."""
    places = {Fraction(x) for chain in chains for x, _ in chain}
    edges = [edge for chain in chains for edge in pairwise(chain)]
    for ((px, py), (qx, qy)), ((rx, ry), (sx, sy)) in product(edges, edges):
        u, v, w, z = qx - px, qy - py, sx - rx, sy - ry
        if u * z != v * w:
            places.add(px + u * Fraction((rx - px) * z - (ry - py) * w) / (u * z - v * w))
    return sorted(places)


def limits(chain: Chain, x: Fraction) -> list[Fraction]:
    """Return the heights of a chain just before and just after an abscissa."""
    edges = [((px, py), (qx, qy)) for (px, py), (qx, qy) in pairwise(chain) if px < qx]
    return [
        py + (qy - py) * (x - px) / (qx - px)
        for (px, py), (qx, qy) in edges
        if px < x <= qx or px <= x < qx
    ]


@given(walled(), graphs_anywhere(), st.sampled_from([(1, 1), (1, 7), (Fraction(1, 1000), 1)]))
@examples(200)
def test_a_piece_takes_over_where_it_stays_lower(
    partial: Chain, drawn: Chain, spelled: tuple[Rational, int]
) -> None:
    """In any unit, with breaks not in lowest terms, and also beyond the end of the envelope."""
    unit, times = spelled
    piece: Chain = [(x - 1, y) for x, y in drawn]
    given = [to_graph([(unit * x, unit * y) for x, y in chain]) for chain in (partial, piece)]
    for graph in given:
        graph.breaks[:] = [(times * n, times * d) for n, d in graph.breaks]
    joined = lower_envelope_cm(*given)
    if piece[0][0] > partial[-1][0]:
        assert GAP in joined.pieces
        return
    found: Chain = [(Fraction(x) / unit, Fraction(y) / unit) for x, y in joined]
    borders = list_borders(partial, piece)
    (start, _), (end, _) = piece[0], piece[-1]
    touched = [
        x
        for x in borders
        if (below := limits(partial, x)) and (above := limits(piece, x))
        # At a step the limit from the left counts.
        if below[0] <= above[0]
    ]
    last = max(touched, default=start)
    # A piece that ends first and is not lower at its end changes nothing.
    last = partial[-1][0] if last == end < partial[-1][0] else last
    for x in ((x + y) / 2 for x, y in pairwise(borders)):
        of = partial if x < max(last, start) else piece
        assert height(found, x) == height(of, x)
    assert (found[0][0], found[-1][0]) == (partial[0][0], max(last, end))


def test_a_piece_that_starts_earlier_replaces_everything_above_it() -> None:
    partial = to_graph([(0, 0), (4, 2)])
    assert list(lower_envelope_cm(partial, to_graph([(-1, -1), (6, -1)]))) == [(-1, -1), (6, -1)]
    # Left of the crossing the sum of an earlier part is lower.
    partial = to_graph([(0, 0), (4, 4)])
    found = list(lower_envelope_cm(partial, to_graph([(-1, 2), (6, 2)])))
    assert found == [(0, 0), (2, 2), (6, 2)]


def test_a_gap_of_the_partial_envelope_counts_as_infinitely_high() -> None:
    """The walk continues across a gap, and left of it, as long as the piece is lower."""
    for left, expected in (
        (-1, [(0, 0), (2, 0), (2, -1), (9, -1)]),
        (1, [(0, 0), (1, 0), (1, -1), (9, -1)]),
    ):
        partial = lower_envelope_cm(to_graph([(0, 0), (2, 0)]), to_graph([(4, 0), (6, 0)]))
        assert partial.pieces[1] == GAP
        piece: Chain = [(2, -1), (9, -1)] if left < 0 else [(left, -1), (9, -1)]
        assert list(lower_envelope_cm(partial, to_graph(piece))) == expected
    partial = lower_envelope_cm(to_graph([(0, 0), (2, 0)]), to_graph([(4, 1), (6, 1)]))
    late = lower_envelope_cm(partial, to_graph([(3, 1), (5, -1), (9, -1)]))
    assert [piece == GAP for piece in late.pieces] == [False, True, False, False]
    assert [value(at) for at in late.breaks] == [0, 2, 3, 5, 9]


def test_a_hole_between_chains_is_rejected_on_reading() -> None:
    gapped = lower_envelope_mm([to_graph([(0, 0), (1, 0)]), to_graph([(2, 0), (3, 0)])])
    with pytest.raises(ChainError, match="the envelope has a gap"):
        list(gapped)


def test_equal_breaks_may_have_different_forms() -> None:
    """A former crash: a piece from x = -12/6 on, joined to a partial envelope up to x = -2."""
    partial, piece = to_graph([(-4, 0), (-2, -1)]), to_graph([(-3, 0), (-1, -2), (0, -2)])
    piece.breaks[0] = (-12, 6)
    assert list(lower_envelope_cm(partial, piece)) == [(-4, 0), (-2, -1), (-1, -2), (0, -2)]


def test_chains_may_share_their_points() -> None:
    """Equal constants are one object; a former version then missed a reflex vertex."""
    shared = (4, 2)
    first, second = to_graph([(0, 2), (2, 0), shared]), to_graph([shared, (5, 1), (6, 1)])
    joined = lower_envelope_cm(first, second)
    assert list(joined) == [(0, 2), (2, 0), (4, 2), (5, 1), (6, 1)]
    lid: Chain = [(2, 1), (1, 2), (0, 1)]
    again = trajectory_cm(lid, [(0, 2), (2, 0), (4, 2), (5, 1), (6, 1)])
    assert list(trajectory_cm(lid, list(joined))) == list(again)
    straight = lower_envelope_cm(to_graph([(0, 0), shared]), to_graph([shared, (8, 4)]))
    assert list(straight) == [(0, 0), (8, 4)]
