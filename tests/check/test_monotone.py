"""The steps by which sweeps of polygons with a shared direction are proved, by what they mean."""

import json
from collections import Counter
from contextlib import nullcontext
from fractions import Fraction
from itertools import pairwise, product
from random import Random
from typing import Any

import pytest
import tampering
from hypothesis import assume, example, given
from hypothesis import strategies as st
from layouts import box
from producer import SLOT, UNIT, VALLEY, Vertices, edges, find_meetings
from small_pairs import draw
from strategies import monotone_rings
from tiers import examples

from exactsweep import Point, Polygon, sweep
from exactsweep.check import point_in_polygon, reference_loops, standalone, verify
from exactsweep.check.standalone import Chain, Monotone, MonotoneLoop, Node, Refused, Work
from exactsweep.geometry.direction import is_monotone

Steps = list[tuple[int, int]]

ANY = Work(10**12)
PROVER = Monotone(sweep(UNIT, UNIT).certificate(), ANY)
STAIRS = [(0, 0), (5, 0), (5, 2), (3, 2), (3, 3), (0, 3)]
TENT = [(0, 0), (3, -1), (4, -1), (6, 1), (2, 3), (0, 2)]
# Both edges of the trajectory on one line, and a contact that begins where the first one ends.
CLEFT = [(0, -2), (1, 0), (2, -2), (2, 1), (1, 2), (0, 1)]
BOOT = [(0, -2), (2, -2), (3, -1), (3, 2), (2, 1), (0, 1)]
SHAPES = [UNIT, SLOT, VALLEY, STAIRS, TENT, CLEFT, BOOT]


def _loop(vertices: Vertices) -> MonotoneLoop:
    return PROVER.read("loop", [standalone.node(x, y) for x, y in vertices])


# --- Chains --------------------------------------------------------------------------------------


def _take_steps(steps: Steps) -> list[Node]:
    """From the origin, without straight angles; (0, dy) is a jump, never the first or the last."""
    nodes: list[Node] = [(0, 0, 1)]
    for k, (dx, dy) in enumerate(steps):
        x, y, _ = nodes[-1]
        ahead = dx or dy == 0 or k in (0, len(steps) - 1) or nodes[-1][0] == nodes[-2][0]
        nodes.append((x + (dx or 1) if ahead else x, y + dy, 1))
    kept = nodes[:1]
    for p, q in pairwise(nodes[1:]):
        if standalone.side(standalone.line(kept[-1], p), q):
            kept.append(p)
    return [*kept, nodes[-1]]


def _chain(nodes: list[Node]) -> Chain:
    lines = [standalone.line(p, q) for p, q in pairwise(nodes)]
    return standalone.lower_chain(nodes, [*lines, (0, -1, 0)], 0, len(nodes) - 1)


def _limits(nodes: list[Node], u: Fraction) -> tuple[Fraction | None, Fraction | None]:
    """The limits of a chain from the left and from the right, where it has them."""
    left = right = None
    for (x, y, _), (z, t, _) in pairwise(nodes):
        if x < z:
            value = y + (u - x) * (t - y) / (z - x)
            left = value if x < u <= z else left
            right = value if x <= u < z else right
    return left, right


def _list_heights(a: list[Node], b: list[Node], o: Node, side: int) -> set[Fraction]:
    """The limits of A(u) + B(x - u) - y inside each interval, and beside x those of one side."""
    x, y = Fraction(o[0], o[2]), Fraction(o[1], o[2])
    found = set()
    for u in {Fraction(p[0]) for p in a} | {x - p[0] for p in b}:
        (a_left, a_right), (b_left, b_right) = _limits(a, u), _limits(b, x - u)
        beside = {1: (a_right, b_right), -1: (a_left, b_left), 0: (None, None)}[side]
        for p, q in ((a_left, b_right), beside, (a_right, b_left)):
            if p is not None and q is not None:
                found.add(p + q - y)
    return found


_steps = st.lists(st.tuples(st.integers(0, 2), st.integers(-2, 2)), min_size=1, max_size=5)


@given(
    _steps,
    _steps,
    st.tuples(st.integers(-1, 16), st.integers(-3, 3), st.integers(1, 2)),
    st.sampled_from([-1, 0, 1]),
)
@example([(1, 0), (1, 1)], [(1, 0), (0, 1), (1, 0)], (2, 0, 1), 0)
@example([(1, 0), (1, 1), (1, 0)], [(1, 0), (0, -1), (1, 0)], (2, 0, 1), 0)
@example([(1, 0), (0, 1), (1, 1)], [(1, 0), (0, -1), (1, 0)], (2, 0, 1), 1)
def test_gaps_are_the_limits_of_a_sum(one: Steps, other: Steps, o: Node, side: int) -> None:
    a, b = _take_steps(one), _take_steps(other)
    x, y = standalone.place(o)
    assume(x not in (0, a[-1][0] + b[-1][0]))
    found = standalone.gaps(standalone.turn_chain(_chain(b).level, x), _chain(a).level, side)
    assert all(unit > 0 for _, unit, _ in found)
    assert {Fraction(n, unit) - y for n, unit, _ in found} == _list_heights(a, b, o, side)


@examples(500)
@given(st.lists(st.tuples(st.integers(0, 3), st.integers(0, 3)), min_size=3, max_size=7))
@example([(0, 1), (2, 0), (0, 0), (1, 2)])
@example([(0, 0), (0, 1), (2, 0), (2, 1)])
@example([(0, 0), (2, 1), (2, 0), (0, 1)])
@example([(0, 0), (1, 3), (2, 0), (3, 2), (0, 2)])
@example([(0, 0), (1, 0), (1, 2), (2, 2), (2, 4), (1, 4), (1, 1), (0, 1)])
@example([(0, 2), (1, 2), (1, 0), (2, 0), (2, 1), (1, 1), (1, 4), (0, 4)])
@example([(2, 1), (1, 1), (1, 4), (0, 4), (0, 2), (1, 2), (1, 0), (2, 0)])
@example([(0, 0), (2, 1), (4, 0), (4, 3), (2, 1), (0, 3)])
def test_loop_is_what_a_canonical_monotone_polygon_is(ring: list[tuple[int, int]]) -> None:
    start = ring.index(min(ring))
    vertices = tuple(Point(Fraction(x), Fraction(y)) for x, y in ring[start:] + ring[:start])
    try:
        polygon = Polygon(vertices)
        good = polygon.vertices == vertices and is_monotone(polygon, (1, 0))
    except ValueError:
        good = False
    if good:
        assert _loop(vertices).is_convex == Polygon(vertices).is_convex
    else:
        with pytest.raises(Refused, match="loop: not"):
            _loop(vertices)


@pytest.mark.parametrize("direction", [(1, 0), (0, 1), (2, 3), (3, -2), (1, -5)])
def test_what_leaves_a_frame_is_what_entered_it(direction: tuple[int, int]) -> None:
    lozenge = [(0, 0), (1, "1/6"), ("7/6", "7/6"), ("1/6", 1)]
    prover = Monotone(sweep(lozenge, lozenge, direction=direction).certificate(), ANY)
    points = [(Fraction(k, 7), Fraction(5, k + 2)) for k in range(5)]
    entered = [prover.enter(standalone.node(*p)) for p in points]
    assert [*map(prover.leave, entered)] == points
    assert [prover.leave((-x, -y, w), -1) for x, y, w in entered] == points


# --- The lemma -----------------------------------------------------------------------------------


@examples(80)
@given(st.data())
def test_sum_within_agrees_with_the_definition(data: st.DataObject) -> None:
    """The lemma: of Q, which is A + B with a vertex moved, dropped, or a notch cut in."""
    a, b = (Polygon(data.draw(monotone_rings())) for _ in range(2))
    true = reference_loops(b.reflected(), a).trajectory
    changed = list(true)
    for _ in range(data.draw(st.integers(0, 2))):
        k = data.draw(st.integers(0, len(changed) - 1))
        x, y = changed[k]
        by = Fraction(data.draw(st.integers(-3, 3)), 2)
        there = changed[(k + 1) % len(changed)]
        middle = (x + there.x) / 2, (y + there.y) / 2
        changed[k : k + 1] = data.draw(
            st.sampled_from(
                [
                    [Point(x + by, y)],
                    [Point(x, y + by)],
                    [Point(x, y), Point(middle[0], middle[1] + by)],
                    [Point(x, y), Point(*middle), Point(middle[0], middle[1] + by)],
                    [],
                ]
            )
        )
    try:
        q = Polygon(changed)
        loops = [_loop(p.vertices) for p in (q, a, b)]
    except (ValueError, Refused):
        return
    if _holds(q, true):
        PROVER.prove_held(loops[0], loops[1].chains, loops[2].chains, "outside")
        return
    with pytest.raises(Refused, match="outside") as found:
        PROVER.prove_held(loops[0], loops[1].chains, loops[2].chains, "outside")
    witness = found.value.witness
    assert witness is not None
    assert point_in_polygon(witness, q) <= 0 <= point_in_polygon(witness, true)


def _holds(q: Polygon, loop: Vertices) -> bool:
    """Decide whether a loop is in Q: its vertices, the points where it meets edges of Q, and a
    point of each part between.
    """
    for edge in edges(loop):
        stops = {*edge, *(m for other in edges(q.vertices) for m in find_meetings(edge, other))}
        parts = [((a.x + b.x) / 2, (a.y + b.y) / 2) for a, b in pairwise(sorted(stops))]
        if any(point_in_polygon(p, q) < 0 for p in [*stops, *parts]):
            return False
    return True


@pytest.mark.parametrize(("x", "y"), [(1, 1), (-1, -1), (-1, 1)])
def test_a_corner_on_a_wall_of_the_sum(x: int, y: int) -> None:
    """At x = 2 the sum drops from 4 to 0. A corner of Q on that wall is not inside the sum, but the
    edge beside it is: from below, from above and in the mirror."""
    a = Polygon([(x * u, y * v) for u, v in [(0, 4), (1, 4), (1, 0), (2, 8), (2, 20), (0, 20)]])
    q = Polygon([(x * u, y * v) for u, v in [(0, 0), (2, 0), (2, 3), (4, 3), (4, 40), (0, 40)]])
    outer, part = _loop(q.vertices), _loop(a.vertices)
    with pytest.raises(Refused) as found:
        PROVER.prove_held(outer, part.chains, part.chains, "outside")
    assert found.value.witness == Point(Fraction(2 * x), Fraction(3 * y))


@pytest.mark.parametrize("by", [Fraction(1), Fraction(1, 7)])
@pytest.mark.parametrize("side", range(4))
def test_a_loop_that_is_narrower_than_the_sum_is_refused_at_the_side(
    side: int, by: Fraction
) -> None:
    ends = [Fraction(0), Fraction(0), Fraction(2), Fraction(2)]
    part, around = _loop(Polygon(UNIT).vertices), Polygon(box(*ends))
    PROVER.prove_held(_loop(around.vertices), part.chains, part.chains, "outside")
    ends[side] += by if side < 2 else -by
    narrow = Polygon(box(*ends))
    with pytest.raises(Refused, match="outside") as found:
        PROVER.prove_held(_loop(narrow.vertices), part.chains, part.chains, "outside")
    assert found.value.witness is not None
    assert point_in_polygon(found.value.witness, narrow) <= 0
    assert point_in_polygon(found.value.witness, around) >= 0


# --- Contacts and drawings -----------------------------------------------------------------------


@pytest.mark.parametrize("directrix", SHAPES[1:])
@pytest.mark.parametrize("generatrix", SHAPES)
def test_contacts_are_listed_completely_and_in_one_order(generatrix: Any, directrix: Any) -> None:
    certificate = sweep(generatrix, directrix, direction=(1, 0)).certificate()
    assert verify(certificate).proved
    for k, contacts in enumerate(certificate["contacts"]):
        dropped = [contacts[:m] + contacts[m + 1 :] for m in range(len(contacts))]
        for instead in (*dropped, [*contacts, contacts[0]], contacts[::-1]):
            listed = [*certificate["contacts"][:k], instead, *certificate["contacts"][k + 1 :]]
            reason = f"contacts[{k}]: not the contacts along the edge, in order: "
            found = verify({**certificate, "contacts": listed}).reason
            assert found.startswith(reason) if instead != contacts else found == "proved"


@pytest.mark.parametrize("generatrix", [UNIT, SLOT, TENT])
def test_drawings_are_along_their_edge(generatrix: Any) -> None:
    """Any pair of features instead of those listed: of those beside the line none is right."""
    certificate = json.loads(json.dumps(sweep(generatrix, VALLEY).certificate()))
    prover, rng = Monotone(certificate, ANY), Random(1)
    sizes = len(certificate["trajectory"]), len(generatrix)
    features = [[[kind, k] for k in range(n) for kind in ("vertex", "edge")] for n in sizes]
    for name, loop in (("inner", prover.inner), ("outer", prover.outer)):
        listed = certificate[f"{name}_drawn"]
        places = [*product(range(len(listed)), product(*features))]
        for k, pair in rng.sample(places, min(len(places), 200)):
            for instead in ([pair], [*listed[k], pair] if [*pair] not in listed[k] else [pair]):
                changed = [*listed[:k], [*map(list, instead)], *listed[k + 1 :]]
                right = tampering.draws(certificate, name, k, instead)
                with nullcontext() if right else pytest.raises(Refused, match=r"along|draws all"):
                    prover.prove_drawn(name, loop, changed)


# --- Numbers -------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", ["CC", "CM", "MM"])
def test_without_a_lattice_the_same_is_proved_and_refused(
    kind: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """True and changed certificates, with the same reasons and witnesses."""
    rng = Random(f"lattice {kind}")
    seen = Counter[bool]()
    while not seen[True]:
        generatrix, directrix = draw(rng)
        thirds, halves = (
            [(Fraction(x, over), Fraction(y, over + 4)) for x, y in shape[0]]
            for over, shape in ((3, generatrix), (2, directrix))
        )
        s = sweep(thirds, halves)
        if s.kind != kind:
            continue
        certificate = s.certificate()
        for _, listed in [("", certificate), *tampering.changes(certificate, rng)]:
            monkeypatch.undo()
            expected = verify(listed)
            monkeypatch.setattr(standalone, "find_scale", lambda _: 1)
            assert verify(listed) == expected
            seen[expected.proved] += 1
    assert seen[False] > 30


def test_numbers_stay_as_long_as_those_of_a_few_points(monkeypatch: pytest.MonkeyPatch) -> None:
    """Once all of 40 were over the product of all denominators: 66 seconds instead of two."""
    longest = 0
    reduce = standalone.reduce

    def watch(a: int, b: int, c: int) -> Node:
        nonlocal longest
        longest = max(longest, *(abs(n).bit_length() for n in (a, b, c)))
        return reduce(a, b, c)

    monkeypatch.setattr(standalone, "reduce", watch)
    rng = Random(40)
    parabola = [
        tuple(c + Fraction(1, rng.getrandbits(400) | 1) for c in (k, k * k)) for k in range(24)
    ]
    certificate = sweep(parabola, [(2 * x, 3 * y) for x, y in parabola]).certificate()
    assert verify(certificate).proved
    assert 400 < longest < 20 * 400


def test_exact_fits_are_found_without_a_lattice(monkeypatch: pytest.MonkeyPatch) -> None:
    """A slot, and what fits into it, at unrelated places, of unlike denominators."""
    monkeypatch.setattr(standalone, "find_scale", lambda _: 1)
    left, wide, high = Fraction(1, 5), Fraction(5, 7), Fraction(33, 10)
    low, right = Fraction(51, 97), left + wide
    slot = [(0, 0), (2, 0), (2, high), (right, high), (right, low), (left, low), (left, 4), (0, 4)]
    part = [(x + Fraction(1, 11), y + Fraction(1, 13)) for x in (0, wide) for y in (0, 1)]
    s = sweep([part[0], part[2], part[3], part[1]], slot)
    assert s.exact_fits
    assert verify(s.certificate()).proved
    assert not verify({**s.certificate(), "exact_fits": []}).proved


def test_a_common_denominator_is_of_use_where_it_is_short() -> None:
    """At most 256 bits, or twice as many as the longest one of the points."""
    for power, scale in ((114, 2**114 * 3**60 * 5**20), (115, 1)):
        assert (2**power * 3**60 * 5**20).bit_length() == 142 + power
        assert standalone.find_scale([(1, 1, n) for n in (2**power, 3**60, 5**20)]) == scale
    primes = [2**521 - 1, 2**607 - 1, 2**1279 - 1, 2**2203 - 1]
    assert standalone.find_scale([(1, 1, p) for p in primes[:2]]) == primes[0] * primes[1]
    assert standalone.find_scale([(1, 1, p) for p in (*primes, 2**1400)]) == 1
