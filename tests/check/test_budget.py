"""Limits of steps for verifying a claim, compared with counts of operations."""

import sys
from collections import defaultdict
from collections.abc import Callable, Iterator
from fractions import Fraction
from math import cos, lcm, pi, sin
from pathlib import Path
from random import Random
from typing import Any

import pytest
from cells import Holed
from exactsweep.check.convex import measure_bits
from exactsweep.check.no_fit import UNLIMITED
from known_layouts import FAULTY, TILE, VALID
from layouts import box, lay, put
from shape_certificates import HEAD, no_fit_certificate, outline
from steps import count_steps
from test_standalone import CERTIFICATES

from exactsweep import Polygon, sweep
from exactsweep.check import (
    arrangement,
    boxes,
    contact_segments,
    convex,
    convex_sums,
    standalone,
    uncovered,
    verify,
)
from exactsweep.check.standalone import Work
from exactsweep.layout import judge_layout

FILE = Path(__file__).with_name("steps.txt")
Points = list[tuple[int, int]]
HOOK = [(0, 0), (6, 0), (6, 6), (1, 6), (1, 3), (2, 3), (2, 5), (5, 5), (5, 1), (0, 1)]

INSIDE: dict[str, tuple[Holed, Any]] = {
    "sieve": (
        Holed(
            Polygon([(0, 0), (300, 0), (300, 20), (0, 20)]),
            tuple(Polygon([(x, 9), (x + 1, 10), (x, 10)]) for x in range(10, 290, 10)),
        ),
        HOOK,
    ),
    # The positions in one room and in the other meet in a point.
    "two rooms": (
        Holed(Polygon([(0, 0), (3, 0), (3, 2), (5, 2), (5, 5), (2, 5), (2, 3), (0, 3)])),
        TILE,
    ),
}


def comb(n: int) -> Points:
    """Teeth to the right, one above the other: boxes in one column."""
    teeth = [
        (x, y + dy) for y in range(0, 4 * n, 4) for x, dy in ((90, 0), (90, 2), (1, 2), (1, 4))
    ]
    return [(0, 0), *teeth[:-2], (0, 4 * n - 2)]


def needles(n: int) -> Points:
    """At half a right angle and long, so that all boxes overlap."""
    notches = [p for x in range(0, 10 * n, 10) for p in ((x, 0), (x + 905, 900), (x + 6, 0))]
    return [(-10, -10), (10 * n, -10), *notches[::-1]]


def fan(n: int) -> Points:
    """Spikes all around that share the neighbourhood of one point."""
    ends = [(10**6 if k % 2 else 10**4, pi * k / n) for k in range(2 * n)]
    return [(round(r * cos(angle)), round(r * sin(angle))) for r, angle in ends]


def star(n: int) -> Points:
    """Spikes of random lengths, most of which are hidden from each other."""
    random = Random(7)
    ends = [(random.uniform(300, 999), pi * k / n) for k in range(2 * n)]
    return [(round(r * cos(angle)), round(r * sin(angle))) for r, angle in ends]


def tuft(n: int) -> Points:
    """Spikes upwards that cross each other's columns."""
    spikes = [
        p
        for i in range(n)
        for p in (((i - n // 2) * 1000, 10**6 + i * i), (2 * i + 1 - n, 1000 + i % 3))
    ]
    return [(-n, 0), (n, 0), *spikes[::-1]]


def zigzag(n: int) -> Points:
    """A band."""
    random = Random(1)
    low = [(10 * k, 60 * (k % 2) + random.randrange(9)) for k in range(n)]
    return low + [(x, y + 25) for x, y in low[::-1]]


def behind_a_wall(n: int) -> Points:
    """Below a tongue of the right-hand wall; the teeth above, nearer in x, are not seen."""
    floor = [(9 * k, 40 * (k % 2)) for k in range(n)]
    teeth = [(9 * k + 4, 900 - 500 * (k % 2)) for k in range(n)]
    tongue = [(9999, -9), (9999, 200), (-900, 200), (-900, 300), (9999, 300)]
    return [(-999, -9), *floor, *tongue, (9999, 999), *teeth[::-1], (-999, 999)]


HOSTILE: dict[str, tuple[Points, Points]] = {
    "comb": (comb(40), HOOK),
    "two combs": (comb(12), [(-y, x) for x, y in comb(12)]),
    "needles": (needles(30), HOOK),
    "fan": (fan(30), HOOK),
    "two fans": (fan(12), fan(9)),
    "tuft": (tuft(20), HOOK),
    "two tufts": (tuft(8), tuft(9)),
    "zigzag": (zigzag(60), HOOK),
    "two zigzags": (zigzag(14), [(-y, x) for x, y in zigzag(14)]),
    "behind a wall": (behind_a_wall(30), HOOK),
}


def lengthen(points: Points) -> Points:
    """Return nearly the same shape in numbers of 200 bits more, which have no divisor in common."""
    return [((x << 200) + 7919 * k % 101, (y << 200) + k % 97) for k, (x, y) in enumerate(points)]


class Ledger:
    """Work, in what would be microseconds, and steps, both by the function that takes the steps."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.work: dict[str, float] = defaultdict(float)
        self.steps: dict[str, int] = defaultdict(int)
        self._patch = monkeypatch
        lines, diagonals = "_leave_on", "_find_diagonal"
        self.watch(uncovered, "_find_shadow", lines, lambda ring, *_: 2 + 0.1 * len(ring))
        self.watch(convex, "_is_blocked", diagonals, lambda p, q, walls: 0.12 * len(walls))
        self.watch(arrangement, "_find_common_point", "_find_cuts", lambda *_: 3)
        self.watch(contact_segments, "find_common_direction", "_take_all_pairs", lambda *_: 1)
        self.watch(standalone, "lies", "_take_all_pairs", lambda *_: 1)
        self.watch(convex_sums, "_measure_width", "__init__", lambda _: 6)
        self.watch(boxes, "meet", "near", lambda *_: 0.15)
        take = Work.take

        def count_steps(budget: Work, steps: int, bits: int = 0) -> None:
            # The one of them that takes steps by a function of its own is `_find_diagonal`.
            caller = sys._getframe(1).f_code.co_name
            self.steps[diagonals if caller == "<lambda>" else caller] += steps
            take(budget, steps, bits)

        monkeypatch.setattr(Work, "take", count_steps)

    def watch(self, module: Any, name: str, payer: str, cost: Callable[..., float]) -> None:
        do = getattr(module, name)

        def count(*arguments: Any) -> Any:
            self.work[payer] += cost(*arguments)
            return do(*arguments)

        self._patch.setattr(module, name, count)


def claim(d: Points, g: Points) -> dict[str, Any]:
    """The false claim that a triangle is the no-fit polygon: the true one refutes it."""
    triangle = [["0", "0"], ["1", "0"], ["0", "1"]]
    shapes = zip(("directrix", "generatrix"), (d, g), strict=True)
    written = {name: outline(Holed(Polygon(points))) for name, points in shapes}
    return {
        **HEAD,
        "claim": "no_fit",
        **written,
        "exterior": triangle,
        "holes": [],
        "exact_fits": [],
    }


@pytest.mark.parametrize("name", HOSTILE)
def test_there_are_no_fewer_steps_than_work(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    ledger = Ledger(monkeypatch)
    assert verify(claim(*HOSTILE[name])).reason.startswith("exterior[0]: not in the answer")
    assert {*ledger.work} >= {"_leave_on", "near", "_take_all_pairs", "__init__"}
    assert not {payer: work for payer, work in ledger.work.items() if work > ledger.steps[payer]}


def list_steps() -> Iterator[str]:
    """List the steps of checks, which say what each part of a check costs."""
    layouts = VALID | {name: layout for name, (layout, _) in FAULTY.items()}
    checked = CERTIFICATES | {name: claim(*pair) for name, pair in HOSTILE.items()}
    long = {f"long {name}": [*map(lengthen, HOSTILE[name])] for name in ("two fans", "two zigzags")}
    checked |= {name: claim(d, g) for name, (d, g) in long.items()}
    for name, (container, part) in INSIDE.items():
        asked = {"container": outline(container), "part": outline(Holed(Polygon(part)))}
        checked[name] = {**HEAD, "claim": "inner_fit", **asked, "regions": [], "exact_fits": []}
    checked |= {name: judge_layout(layout).certificate() for name, layout in layouts.items()}
    for name, certificate in checked.items():
        yield f"{name}: {' '.join(map(str, count_steps(certificate)))}"


def test_steps_are_as_recorded() -> None:
    """Steps that are too few let a certificate keep the checker busy; too many refuse true ones."""
    assert [*list_steps()] == FILE.read_text(encoding="utf-8").splitlines()


@pytest.mark.parametrize("is_tall", [False, True])
def test_steps_grow_as_parts_do(is_tall: bool) -> None:
    """A layout of many parts that differ is no dearer for each of them than one of few."""

    def turn(x: int, y: int) -> tuple[int, int]:
        return (y, x) if is_tall else (x, y)

    def count(n: int) -> int:
        parts = {str(k): {"exterior": TILE, "demand": 1, "turns": [0]} for k in range(n)}
        placed = [put(id, turn(10 * k, 0)) for k, id in enumerate(parts)]
        layout = lay(box(-5, -5, *turn(10 * n, 5)), parts, *placed)
        return count_steps(judge_layout(layout).certificate())[0]

    assert count(160) < 2.1 * count(80)


@pytest.mark.parametrize("name", ["two fans", "two zigzags"])
def test_work_ends_where_the_steps_do(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    certificate = claim(*HOSTILE[name])
    ledger = Ledger(monkeypatch)
    verify(certificate)
    whole = sum(ledger.steps.values())
    for share in (8, 2):
        ledger.work.clear()
        refused = verify(certificate, max_steps=whole // share)
        assert refused.reason.startswith("too large: ")
        assert sum(ledger.work.values()) <= whole // share


def test_pieces_far_apart_do_not_count() -> None:
    """There are 1.2 million sums of pieces with contact segments near few of them."""
    teeth = [(k, 2 * (k % 2)) for k in range(401)]
    d = [*teeth, (400, 9), (0, 9)]
    reason = verify(claim(d, d), max_steps=2 * 10**6).reason
    assert reason.startswith("exterior[0]: not in the answer")


@pytest.fixture
def seen(monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """The bits of the longest number of all unions of sets that are made."""
    longest: list[int] = []
    begin = uncovered.OpenSets.__init__

    def look(sets: uncovered.OpenSets, *arguments: Any) -> None:
        begin(sets, *arguments)
        longest.append(sets.bits)

    monkeypatch.setattr(uncovered.OpenSets, "__init__", look)
    return longest


def test_the_common_lattice_of_crossings_is_not_used(seen: list[int]) -> None:
    """Unless it is short: each vertex of a trajectory has a denominator of its own."""
    s = sweep(star(14), [(-y, x) for x, y in star(12)])
    denominators = [lcm(x.denominator, y.denominator) for x, y in s.trajectory.vertices]
    assert verify(s.certificate()).proved
    assert lcm(*denominators).bit_length() > 256
    assert len(seen) == 3
    assert max(seen) <= 2 * max(d.bit_length() for d in denominators) + 24


def test_unrelated_denominators_are_no_common_lattice(seen: list[int]) -> None:
    """Of twelve denominators of 660 bits no more than those of four vertices come together."""
    random = Random(5)

    def near(c: int) -> Fraction:
        return c + Fraction(1, random.getrandbits(660) | 1)

    low = [(near(10 * k), near(60 * (k % 2))) for k in range(6)]
    band = [*low, *((x, y + 25) for x, y in low[::-1])]
    assert verify(no_fit_certificate(Holed(Polygon(band)), Holed(Polygon(HOOK)))).proved
    assert 0 < max(seen) < 8 * 660


@pytest.mark.parametrize("shape", [behind_a_wall(60), fan(60), needles(60), star(60)])
def test_a_diagonal_takes_steps_by_walls(shape: Points, monkeypatch: pytest.MonkeyPatch) -> None:
    ledger = Ledger(monkeypatch)
    ring = tuple((int(x), int(y)) for x, y in Polygon(shape).vertices)
    assert len(convex.cut_to_convex((ring,), UNLIMITED)) > 1
    assert 0 < ledger.work["_find_diagonal"] <= ledger.steps["_find_diagonal"]


def test_numbers_over_others_count_more() -> None:
    assert measure_bits([(1, -9, 1), (2, 3, 1)]) == 4
    assert measure_bits([(9, 1, 9), (2, 3, 1)]) == 7


def test_each_question_takes_steps() -> None:
    """One step for a set that holds the point, or does not, if only its box does."""
    budget = Work(10**6)
    sets = uncovered.OpenSets([[(0, 0), (9, 0), (0, 9)]], [[(0, 0), (1, 0), (0, 1)]], budget)
    for point, inside in (((1, 1), True), ((7, 7), False)):
        before = budget.left
        assert sets.holds(point) == inside
        assert before is not None
        assert budget.left is not None
        assert before - budget.left >= 3


def test_steps_of_a_sheet_are_linear_in_its_defects() -> None:
    def count(n: int) -> int:
        defects = [box(2 * k + 1, 1, 2 * k + 2, 2) for k in range(n)]
        layout = lay(box(0, 0, 2 * n + 1, 9), {"tile": TILE}, put("tile"), defects=defects)
        (steps,) = count_steps(judge_layout(layout).certificate())
        return steps

    assert count(80) < 3 * count(40)
