"""Bounds under which pairs of convex parts are relevant, compared with their envelope."""

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from math import inf
from random import Random

import families
import pytest

from exactsweep import Polygon
from exactsweep.numbers.number import Vertex
from exactsweep.procedures.chain import split
from exactsweep.procedures.convex_part import (
    Box,
    ConvexPart,
    CrossingPart,
)
from exactsweep.procedures.envelope import Break, Envelope, Span, value
from exactsweep.procedures.mm import sweep_mm, trajectory_mm
from exactsweep.procedures.part_pairs import Ceiling, add_to_run


def height(envelope: Envelope, at: Fraction) -> Fraction | float:
    """Of an envelope without vertical pieces beside its ends; outside it is infinity."""
    ends = list(map(value, envelope.breaks))
    if not ends[0] <= at <= ends[-1]:
        return inf
    heights: list[Fraction | float] = [
        (dy * at + c) / Fraction(dx) if dx else inf
        for (dx, dy, c, _, _), left, right in zip(envelope.pieces, ends, ends[1:], strict=False)
        if left <= at <= right
    ]
    return max(heights)


def draw(rng: Random) -> tuple[list[Vertex], list[Vertex]]:
    """G_t and D_b."""
    (_, top), (bottom, _) = (split(Polygon(families.long(rng)).lattice()[1]) for _ in ("G", "D"))
    return top, bottom


@pytest.mark.parametrize("seed", range(12))
def test_no_strip_is_lower_than_the_envelope_over_it(seed: int) -> None:
    rng = Random(seed)
    top, bottom = draw(rng)
    envelope = trajectory_mm(top, bottom)
    ends = list(map(value, envelope.breaks))
    low, high = int(ends[0] // 1) - rng.randint(0, 3), int(-(-ends[-1] // 1)) + rng.randint(0, 3)
    gaps: list[Span] | None = None
    if seed % 3:
        inner: list[Break] = rng.sample(envelope.breaks, min(4, len(envelope.breaks)))
        borders = sorted([*inner, (low, 1), (high, 1)][seed % 2 :], key=value)
        gaps = list(zip(borders[::2], borders[1::2], strict=False))
    # Boxes of so many parts, whose sums lie between the two ends.
    columns: list[Box] = [(low, low, 0) for _ in range(rng.choice([1, 3, 40]))]
    columns.append((low, high, 0))
    ceiling = Ceiling(envelope, [(0, 0, 0)], columns, gaps)
    for left, right in [((low, 1), (high, 1))] if gaps is None else gaps:
        inside = [value(left), value(right), *(x for x in ends if value(left) < x < value(right))]
        inside.sort()
        inside += [(x + y) / 2 for x, y in pairwise(inside)]
        for at in inside:
            strip = int((at // 1 - low) // ceiling.width)
            assert ceiling.tops[strip] > -inf
            if at not in (value(left), value(right)):
                assert ceiling.tops[strip] >= height(envelope, at), (seed, at)


def zigzag(size: int, bend: int, seed: int) -> list[Vertex]:
    rng = Random(seed)
    heights = (
        7 * (k % 2) + rng.randint(0, 3) + bend * (2 * k - size) ** 2 // 160 for k in range(size)
    )
    return [(3 * k + rng.randint(0, 1), y) for k, y in enumerate(heights)]


@pytest.mark.parametrize(
    ("top", "bottom", "most"),
    [
        (zigzag(31, 1, 1), zigzag(60, -1, 2), (285, 1160)),
        (zigzag(60, 1, 1), zigzag(31, 1, 2), (350, 1650)),
    ],
)
def test_most_pairs_are_never_swept(
    top: list[Vertex], bottom: list[Vertex], most: tuple[int, int], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Of 480 pairs, and of both loops' some thousands, no more than so many."""
    swept = 0

    def count(sweep: Callable[..., Envelope | None]) -> Callable[..., Envelope | None]:
        def counted(*given: object) -> Envelope | None:
            nonlocal swept
            swept += 1
            return sweep(*given)

        return counted

    for kind in ConvexPart, CrossingPart:
        monkeypatch.setattr(kind, "sweep", count(kind.sweep))
    trajectory = trajectory_mm(top[::-1], bottom)
    assert swept <= most[0]
    sweep_mm(top[::-1], [(x, y - 30) for x, y in top], bottom, trajectory)
    assert swept <= most[1]


@pytest.mark.parametrize(
    ("piece", "expected"),
    [
        ([(8, 2), (9, 0)], [(0, 1), (1, 0), (7, 0), (8, 1), (8, 2), (9, 0)]),
        ([(9, 1), (10, 0)], None),
        ([(0, 3), (8, -1)], [(0, 1), (1, 0), (6, 0), (8, -1)]),
        ([(1, 4), (3, 1), (9, -2)], [(0, 1), (1, 0), (5, 0), (9, -2)]),
        ([(-1, 2), (9, -2)], []),
        ([(2, -2), (4, -3), (7, -2)], []),
        ([(-1, -2), (7, -2)], []),
    ],
    ids=["at the end", "after", "as long", "longer", "before", "within", "from before"],
)
@pytest.mark.parametrize("scale", [1, 3])
def test_a_run_is_joined_by_what_begins_over_it_and_does_not_end_before_it(
    piece: list[Vertex], expected: list[Vertex] | None, scale: int
) -> None:
    run, given = Envelope.of([(0, 1), (1, 0), (7, 0), (8, 1)]), Envelope.of(piece, 1)
    given.breaks = [(scale * n, scale * d) for n, d in given.breaks]
    before = [*run]
    joined = add_to_run(run, given)
    assert joined == (expected != [])
    if expected is None:
        assert run.sources == [0, 0, 0, -1, 1]
    else:
        assert [*run] == (expected or before)
