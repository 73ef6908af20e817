"""The lower half of a sweep of two chains, compared with its definition at a few x."""

from collections.abc import Callable, Sequence
from fractions import Fraction
from random import Random

import pytest
from tiers import mostly_long

from exactsweep.geometry.vectors import find_hull
from exactsweep.numbers.number import Rational, Vertex
from exactsweep.paper.kernel import (
    invert_top,
    sweep_inner_cm,
    sweep_mm,
    sweep_outer_cm,
    trajectory_mm,
)
from exactsweep.procedures import ceiling
from exactsweep.procedures.chain import Chain, split
from exactsweep.procedures.exact_fit import list_edges
from exactsweep.procedures.mm import find_untouched
from exactsweep.procedures.undercuts import keep_corners

Choice = Callable[[list[Fraction]], Fraction]  # min or max


class Function:
    """A chain, left to right, as a function of x, with one-sided limits at walls and ends."""

    def __init__(self, chain: Sequence[Vertex]) -> None:
        self._edges = list_edges(chain)
        self.xs = {x for edge in self._edges for x, _ in edge}
        self.range = min(self.xs), max(self.xs)

    def limits(self, x: Rational) -> list[Fraction]:
        return [
            py + Fraction(x - px) * (qy - py) / (qx - px)
            for (px, py), (qx, qy) in self._edges
            if px <= x <= qx
        ]


def combine(f: Function, g: Function, x: Fraction, choose: Choice) -> Fraction:
    """Return the minimum or maximum of f(x - w) + g(w), at an x that is no sum of vertices."""
    arguments = {*g.xs, *(x - u for u in f.xs)}
    return choose([a + b for w in arguments for a in f.limits(x - w) for b in g.limits(w)])


def draw_chain(rng: Random, edges: int) -> list[Vertex]:
    """Draw steps on a small grid, including walls, but not at the ends."""
    steepest = rng.choice([1, 2, 6])
    chain: list[Vertex] = [(0, rng.randint(-steepest, steepest))]
    for k in range(edges):
        x, y = chain[-1]
        if 0 < k < edges - 1 and chain[-2][0] < x and rng.random() < 0.2:
            chain.append((x, y + rng.choice([-2, -1, 1, 2])))
        else:
            chain.append((x + rng.randint(1, 3), y + rng.randint(-steepest, steepest)))
    return keep_corners(chain)


@pytest.mark.parametrize("strips", [1, ceiling.STRIPS])
@pytest.mark.parametrize("seed", mostly_long(range(0, 120, 12), [0]))
def test_halves_are_minima_and_maxima_of_sums(
    seed: int, strips: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(ceiling, "STRIPS", strips)
    for number in range(seed, seed + 12):
        rng = Random(number)
        bottom, top = draw_chain(rng, rng.randint(2, 9)), draw_chain(rng, rng.randint(2, 7))
        lowest = min(y for _, y in top) - 1
        below: list[Vertex] = [(x, lowest - rng.randint(0, 3)) for x in range(int(top[-1][0]) + 1)]
        check(rng, bottom, top, below)
        lid, floor = find_half(top, 1)[::-1], find_half(below, 0)
        check(rng, bottom, lid, floor)
        boundaries = sweep_inner_cm(lid[::-1], bottom), [*sweep_outer_cm(lid[::-1], floor, bottom)]
        assert boundaries == sweep_mm(lid[::-1], floor, bottom), (bottom, lid, floor)


def find_half(chain: Sequence[Vertex], upper: int) -> list[Vertex]:
    """Find the lower or upper half of a convex hull; the upper one from right to left."""
    hull = find_hull(chain)
    return list(split(hull)[upper]) if len(hull) > 2 else hull[:: 1 - 2 * upper]


def check(rng: Random, d: Sequence[Vertex], top: Sequence[Vertex], below: Sequence[Vertex]) -> None:
    envelope = trajectory_mm(top[::-1], d)
    path = list(envelope)
    inner, outer = sweep_mm(top[::-1], below, d)
    directrix, upper, lower = Function(d), Function(top), Function(below)
    trajectory = Function(path)
    negative = Function([(-x, -y) for x, y in reversed(top)])
    for found, f, g, choose in (
        (trajectory, directrix, negative, min),
        (Function(inner), trajectory, upper, max),
        (Function(outer), trajectory, lower, min),
    ):
        left, right = found.range
        for _ in range(8):
            # No sum of vertices has this denominator, so x lies strictly between them.
            x = left + (right - left) * Fraction(rng.randrange(1, 9973), 9973)
            (height,) = found.limits(x)
            assert height == combine(f, g, x, choose), (d, top, below, x)
    untouched = find_untouched(invert_top(top[::-1]), Chain.of(d), envelope)
    gaps = [(Fraction(*left), Fraction(*right)) for _, left, _, right in untouched]
    closed = Function(inner)
    ranges: list[tuple[Rational, Rational]] = [*[(d[0][0], d[-1][0])] * 4, *gaps]
    for left, right in ranges:
        x = left + (right - left) * Fraction(rng.randrange(1, 9973), 9973)
        is_touched = not any(begin < x < end for begin, end in gaps)
        assert not is_touched or closed.limits(x) == directrix.limits(x), (d, top, x)
