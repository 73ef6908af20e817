"""The pruning step of the MM sweep, which changes no answer."""

from collections.abc import Iterator
from fractions import Fraction
from math import inf
from random import Random
from typing import Any

import families
import pytest

from exactsweep import Polygon, sweep
from exactsweep.corpus import cases
from exactsweep.numbers.number import Vertex
from exactsweep.paper.kernel import list_sub_trajectories, sweep_mm, trajectory_mm
from exactsweep.paper.pairs import Chains
from exactsweep.procedures import cc, ceiling, mm
from exactsweep.procedures.ceiling import Ceiling
from exactsweep.procedures.chain import split
from exactsweep.procedures.graph import Graph


def answer_corpus() -> Iterator[tuple[object, ...]]:
    """Sweep the pairs of the corpus that share a direction, without cached answers."""
    for case in cases():
        if case.kind == "MM":
            s = sweep(case.generatrix, case.directrix)
            yield case.id, s.trajectory.vertices, s.inner.vertices, s.outer.vertices, s.exact_fits


@pytest.mark.long
def test_answers_of_the_corpus_do_not_depend_on_pruning(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pruned = [*answer_corpus()]
    monkeypatch.setattr(mm, "subtrajectories", lambda g, d, _: cc.subtrajectories(g, d))
    assert [*answer_corpus()] == pruned


def draw(rng: Random) -> Chains:
    (bottom, top), (directrix, _) = (
        split(Polygon(families.long(rng)).lattice()[1]) for _ in ("G", "D")
    )
    return Chains(top, bottom, directrix)


@pytest.mark.parametrize("strips", [1, 8])
@pytest.mark.parametrize("seed", range(6))
def test_the_ceiling_changes_no_boundary(
    seed: int, strips: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Use few strips, so that short chains are pruned, too."""
    chains = draw(Random(seed))
    monkeypatch.setattr(ceiling, "STRIPS", strips)
    pruned = [*trajectory_mm(*chains[::2])], sweep_mm(*chains)
    monkeypatch.setattr(mm, "subtrajectories", lambda g, d, _: cc.subtrajectories(g, d))
    assert ([*trajectory_mm(*chains[::2])], sweep_mm(*chains)) == pruned


@pytest.mark.parametrize("seed", range(6))
def test_no_strip_is_lower_than_the_sums_that_lowered_it(seed: int) -> None:
    rng = Random(seed)
    graphs = list_sub_trajectories(draw(rng))
    left = min(Fraction(*graph.breaks[0]) for graph in graphs) // 1 - rng.randint(0, 3)
    right = max(-(-Fraction(*graph.breaks[-1]) // 1) for graph in graphs)
    found = Ceiling(left, right, rng.choice([3, 40]), None)
    # Convex parts of a trajectory, between two crossings.
    pieces = [Graph(graph.breaks[:2], graph.pieces[:1]) for graph in graphs]
    for piece in pieces:
        found.lower(piece)
    for strip, height in enumerate(found.heights):
        start = left + strip * found.width
        for x in (start, start + found.width):
            over = [
                Fraction(dy * x + c) / dx
                for piece in pieces
                for dx, dy, c, (p, _, _), (q, _, _) in piece.pieces
                if p[0] <= start * p[2] and q[0] >= (start + found.width) * q[2]
            ]
            assert height == inf or height >= min(over)


def zigzag(size: int, bend: int, seed: int) -> list[Vertex]:
    rng = Random(seed)
    heights = (
        7 * (k % 2) + rng.randint(0, 3) + bend * (2 * k - size) ** 2 // 160 for k in range(size)
    )
    return [(3 * k + rng.randint(0, 1), y) for k, y in enumerate(heights)]


@pytest.mark.parametrize(
    ("top", "bottom", "most"),
    [
        (zigzag(31, 1, 1), zigzag(60, -1, 2), (300, 1500)),
        (zigzag(60, 1, 1), zigzag(31, 1, 2), (360, 2200)),
    ],
)
def test_most_sums_are_never_computed(
    top: list[Vertex], bottom: list[Vertex], most: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """At most the given number of 480 pairs, and of several thousand for both loops."""
    computed: list[Any] = []
    right = cc.subtrajectory

    def count(*parts: Any) -> Any:
        computed.append(parts)
        return right(*parts)

    monkeypatch.setattr(cc, "subtrajectory", count)
    trajectory_mm(top[::-1], bottom)
    assert len(computed) <= most[0]
    computed.clear()
    sweep_mm(top[::-1], [(x, y - 30) for x, y in top], bottom)
    assert len(computed) <= most[1]
