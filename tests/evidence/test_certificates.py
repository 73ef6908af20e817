"""Certificates of pairs with many convex parts, which small random polygons hardly ever have."""

import json
from collections.abc import Callable
from fractions import Fraction
from random import Random
from typing import Any

import pytest

from exactsweep import Polygon, Sweep, inner_fit_polygon, sweep
from exactsweep.check import verify
from exactsweep.evidence import drawn
from exactsweep.evidence.contact import list_edges
from exactsweep.geometry import segment


def zigzag(random: Random, n: int, size: int) -> list[tuple[int, int]]:
    """An X-monotone polygon of about n vertices on an irregular grid, some walls among them."""
    xs = sorted(random.choices(range(1, size), k=n))
    low, high = xs[::2], xs[1::2]
    bottom = [(x, -random.randrange(1, size)) for x in low]
    top = [(x, random.randrange(1, size)) for x in high]
    return [(0, 0), *bottom, (size, 0), *reversed(top)]


@pytest.mark.parametrize("size", [12, 60, 10**6])
@pytest.mark.parametrize(("n", "m"), [(8, 40), (24, 24), (40, 8)])
def test_sweeps_of_many_parts_are_proved(n: int, m: int, size: int) -> None:
    random = Random(f"{n} {m} {size}")
    proved = 0
    while proved < 2:
        try:
            s = sweep(zigzag(random, n, size), zigzag(random, m, size), direction=(1, 0))
        except ValueError:
            continue
        found = verify(json.loads(json.dumps(s.certificate())))
        assert found.proved, (s.generatrix.vertices, s.directrix.vertices, found)
        proved += 1


@pytest.mark.parametrize("is_convex", [True, False])
def test_polygons_without_a_common_lattice_have_certificates(is_convex: bool) -> None:
    """Once drawings were looked for on lines whole units apart, as if all were on a lattice."""
    rng = Random(1)

    def shift() -> Fraction:
        return Fraction(1, rng.getrandbits(1000 if is_convex else 450) | 1)

    def draw() -> Polygon:
        if is_convex:
            return Polygon([(x + shift(), x and x * x + shift()) for x in range(5)])
        low, high = (
            [(x + shift(), y + rng.randrange(5) + shift()) for x in range(5)] for y in (0, 20)
        )
        return Polygon(low + high[::-1])

    s = sweep(draw(), draw())
    assert s.directrix.lattice()[0] == 1
    assert not all(type(c) is int for point in s.directrix.lattice()[1] for c in point)
    assert s.kind == ("CC" if is_convex else "MM")
    assert verify(s.certificate()).proved


def count_work(
    monkeypatch: pytest.MonkeyPatch, run: Callable[[Sweep], object], *pair: list[tuple[int, int]]
) -> int:
    """Count the features and the pairs of features that evidence of a sweep looks at."""
    s = sweep(*pair)
    counted = 0

    def count(owner: object, name: str, *, measure: Callable[[Any], int] = lambda _: 1) -> None:
        original = getattr(owner, name)

        def wrapped(*arguments: Any) -> Any:
            nonlocal counted
            found = original(*arguments)
            counted += measure(found)
            return found

        patch.setattr(owner, name, wrapped)

    with monkeypatch.context() as patch:
        count(segment.Segment, "minus")
        count(drawn, "Feature")
        count(drawn.Tracer, "_find_near", measure=len)
        run(s)
    return counted


def draw_loops(s: Sweep) -> None:
    """Find what draws each edge of the inner and the outer loop."""
    for loop in (s.solution.inner, s.solution.outer):
        assert all(edge.choose() for edge in s._find_drawn_edges(list_edges(s._enter(loop))))


def test_what_draws_convex_loops_is_found_among_few(monkeypatch: pytest.MonkeyPatch) -> None:
    """Once every vertex of G was kept for each direction: 2.6 GB for 4,000 around 4,000."""
    found = []
    for n in (50, 100):
        parabola = [(2 * k, k * k) for k in range(n)]
        larger = [(3 * x + 1, 7 * y) for x, y in parabola]
        found.append(count_work(monkeypatch, draw_loops, parabola, larger))
    assert found[0] < 20 * 50
    assert found[1] < 2.2 * found[0]


def test_one_long_edge_does_not_make_all_parallel_ones_near(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A square around a comb: for each edge of a loop all paths were tried, on all lines."""
    square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    for teeth in (40, 80):
        steps = [
            (8 * k + x, y) for k in range(teeth) for x, y in ((0, 9), (3, 9), (3, 19), (8, 19))
        ]
        comb = [(0, 0), (8 * teeth, 0), *steps[::-1]]
        assert count_work(monkeypatch, draw_loops, square, comb) < 60 * teeth


@pytest.mark.parametrize("depth", [2, 8])
def test_the_search_stops_where_an_edge_is_covered(
    monkeypatch: pytest.MonkeyPatch, depth: int
) -> None:
    """Each tooth of G closes each gap of D: once all these positions were listed, 3.9 s for 500."""
    found = []
    for gaps in (20, 40):
        bottom = [(4 * k, -depth * (k % 2)) for k in range(2 * gaps + 1)]
        zigzag = [*bottom, (8 * gaps, 30), (0, 30)]
        tooth = (0, 9), (1, 9), (1, 0), (8, 0)
        top = [(8 * k + x, y) for k in range(gaps) for x, y in tooth]
        comb = [(0, -30), (8 * gaps, -30), *top[::-1]]

        def close(s: Sweep) -> None:
            assert all(len(undercut.positions) == 1 for undercut in s.undercuts)

        found.append(count_work(monkeypatch, close, zigzag, comb))
    assert found[1] < 2.5 * found[0]


def test_the_frame_of_an_inner_fit_lies_on_whole_numbers() -> None:
    part = [("1/3", 0), ("2", 0), ("2", "7/2")]
    fit = inner_fit_polygon([("1/2", "1/2"), ("19/2", "1/2"), ("19/2", "19/2"), (0, "17/2")], part)
    # The part is 5/3 wide and 7/2 high: 1 and 3, and one and two more.
    assert fit.certificate()["proof"]["frame"] == ["-2", "-4", "12", "14"]
