"""Bounds under which pairs of convex parts matter, held against the envelope that they bound."""

from collections.abc import Callable
from fractions import Fraction
from itertools import chain as join
from itertools import pairwise
from math import inf
from random import Random

import families
import pytest

from exactsweep import Polygon
from exactsweep.numbers.point import Vertex
from exactsweep.procedures.chain import inverse, split
from exactsweep.procedures.convex_part import (
    Box,
    ConvexPart,
    CrossingPart,
    measure_unit,
    split_chain,
    split_parts,
)
from exactsweep.procedures.envelope import GAP, Break, Envelope, Span, value
from exactsweep.procedures.mm import sweep_mm, trajectory_mm
from exactsweep.procedures.part_pairs import Boxes, Ceiling, add_to_run, find_facing


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
    ceiling = Ceiling(envelope, (low, high), rng.choice([1, 3, 40]), gaps)
    for left, right in [((low, 1), (high, 1))] if gaps is None else gaps:
        inside = [value(left), value(right), *(x for x in ends if value(left) < x < value(right))]
        inside.sort()
        inside += [(x + y) / 2 for x, y in pairwise(inside)]
        for at in inside:
            strip = int((at // 1 - low) // ceiling.width)
            assert any(first <= strip <= last for first, last in ceiling.windows)
            if at not in (value(left), value(right)):
                assert ceiling.tops[strip] >= height(envelope, at), (seed, at)


@pytest.mark.parametrize("seed", range(8))
def test_what_reaches_below_the_strips_is_found_and_nothing_else(seed: int) -> None:
    rng = Random(seed)
    top, bottom = draw(rng)
    inverted = inverse(top)
    unit = measure_unit(inverted, bottom)
    rows, columns = split_parts(inverted, unit), split_parts(bottom, unit)
    boxes = Boxes.of(columns)
    envelope = trajectory_mm(top, bottom)
    low = rows[0].box[0] + boxes.lefts[0]
    high = rows[-1].box[1] + boxes.rights[-1]
    third = (high - low) // 3
    gaps: list[Span] | None = None
    if seed % 2:
        gaps = [((low, 1), (low + third, 1)), ((high - third, 1), (high, 1))]
    ceiling = Ceiling(envelope, (low, high), 40, gaps)
    within = set(join.from_iterable(range(a, b + 1) for a, b in ceiling.windows))
    numbers = sorted(rng.sample(range(len(columns)), (len(columns) + 1) // 2))
    for row in rows:
        left, right, least = row.box
        found = ceiling.find_reaching(row.box, boxes, numbers)
        for k in numbers:
            first, last, lowest = boxes.boxes[k]
            strips = range(
                (left + first - low) // ceiling.width, (right + last - low) // ceiling.width + 1
            )
            reaches = any(least + lowest < ceiling.tops[strip] for strip in strips)
            assert (k in found) == (reaches and not within.isdisjoint(strips))
        assert found == sorted(found)


ROOF = Envelope.of([(0, 0), (4, 9), (10, 3), (12, 8), (18, 6), (20, 7), (30, 2)])
BROKEN = Envelope.of([(0, 5), (9, 2)])
BROKEN.take_all(Envelope.of([(15, 3), (17, 1), (24, 9)]))


@pytest.mark.parametrize("envelope", [ROOF, BROKEN])
@pytest.mark.parametrize("chains", [1, 2, 40])
@pytest.mark.parametrize(
    "gaps",
    [
        None,
        [(-3, 2)],
        [(1, 11), (12, 13)],
        [(3, 4), (5, 6), (22, 33)],
        [(16, 20), (31, 33)],
        [(-3, 2), (16, 20), (21, 33)],
    ],
)
def test_tops_are_the_highest_ends_of_what_crosses_a_strip(
    envelope: Envelope, chains: int, gaps: list[tuple[int, int]] | None
) -> None:
    """Of pieces that lie over a gap; beside the envelope there is nothing to be under."""
    low, high = -4, 33
    spans = [((a, 1), (b, 1)) for a, b in gaps] if gaps else None
    ceiling = Ceiling(envelope, (low, high), chains, spans)
    count = min(2 * len(envelope.pieces), 4 * chains)
    assert ceiling.width == -(-(high - low + 1) // count)
    ends = [*map(value, envelope.breaks)]
    whole = [(Fraction(low), ends[0]), *pairwise(ends), (ends[-1], Fraction(high))]
    tops: list[Fraction | float] = [-inf] * count
    windows: list[tuple[int, int]] = []

    def strip(x: Fraction | int) -> int:
        return int((x // 1 - low) // ceiling.width)

    for a, b in gaps or [(low, high)]:
        for number, (left, right) in enumerate(whole, -1):
            if left < b and a < right:
                top: Fraction | float = inf
                if 0 <= number < len(envelope.pieces) and envelope.pieces[number] != GAP:
                    at = (envelope.breaks[number + k] for k in (0, 1))
                    top = max(-(-Fraction(envelope.point(number, x)[1]) // 1) for x in at)
                elif number in (-1, len(envelope.pieces)):
                    left, right = max(left, Fraction(a)), min(right, Fraction(b))
                for k in range(strip(left), strip(right) + 1):
                    tops[k] = max(tops[k], top)
        windows.append((strip(a), strip(b)))
    # No strip is in two windows.
    merged = windows[:1]
    for first, last in windows[1:]:
        if first <= merged[-1][1]:
            first = merged.pop()[0]
        merged.append((first, last))
    assert ceiling.tops[:count] == tops
    assert set(ceiling.tops[count:]) <= {-inf}
    assert ceiling.windows == merged


def test_boxes_are_found_wherever_they_are_in_a_window() -> None:
    rng = Random(1)
    ceiling = Ceiling(ROOF, (0, 30), 40, [((0, 1), (3, 1)), ((12, 1), (16, 1)), ((28, 1), (30, 1))])
    for _ in range(40):
        lefts = sorted(rng.randint(0, 26) for _ in range(12))
        rights = sorted(left + rng.randint(0, 2) for left in lefts)
        boxes: list[Box] = [(a, b, rng.randint(0, 9)) for a, b in zip(lefts, rights, strict=True)]
        numbers = sorted(rng.sample(range(12), 9))
        begin = rng.randint(0, 2)
        part = begin, begin + rng.randint(0, 2), rng.randint(-2, 1)
        reaching, expected = [], []
        for k in numbers:
            left, right, least = (p + q for p, q in zip(boxes[k], part, strict=True))
            strips = range(int(left // ceiling.width), int(right // ceiling.width) + 1)
            if any(least < ceiling.tops[strip] for strip in strips):
                reaching.append(k)
                if any(a <= strip <= b for strip in strips for a, b in ceiling.windows):
                    expected.append(k)
        found = ceiling.find_reaching(part, Boxes(boxes, [*lefts], [*rights]), numbers)
        assert found == sorted({*found, *expected} & {*reaching})


def zigzag(size: int, bend: int, seed: int) -> list[Vertex]:
    rng = Random(seed)
    heights = (
        7 * (k % 2) + rng.randint(0, 3) + bend * (2 * k - size) ** 2 // 160 for k in range(size)
    )
    return [(3 * k + rng.randint(0, 1), y) for k, y in enumerate(heights)]


@pytest.mark.parametrize(
    ("top", "bottom", "most"),
    [
        (zigzag(31, 1, 1), zigzag(60, -1, 2), (285, 1125)),
        (zigzag(60, 1, 1), zigzag(31, 1, 2), (350, 1610)),
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


def test_parts_face_each_other_where_they_share_a_slope() -> None:
    """Be it but one; the first part has all that are flatter, the last one all that are steeper."""
    chain: list[Vertex] = [(0, 0)]
    for slope in (9, 6, 7, 4, 6, 2, 3, 0, 1, -5):
        chain.append((chain[-1][0] + 1, chain[-1][1] + slope))
    parts = split_chain(chain, 1)
    ends = [(part.flattest, part.steepest) for part in parts]
    assert ends == [(-inf, 9), (6, 7), (4, 6), (2, 3), (0, 1), (-5, inf)]
    columns = range(len(parts))
    for row in parts:
        low, high = row.flattest, row.steepest
        expected = [[k for k in columns if not (ends[k][1] < low or high < ends[k][0])]]
        assert find_facing([columns], [row], parts) == expected


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
