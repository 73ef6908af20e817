"""What verifying a claim may take: no fewer steps than the operations that they stand for."""

from collections.abc import Callable
from fractions import Fraction
from math import cos, lcm, pi, sin
from random import Random
from typing import Any

import pytest
from cells import Holed
from shape_certificates import HEAD, no_fit_certificate, outline

from exactsweep import Polygon, sweep
from exactsweep.check import (
    arrangement,
    claimed_shape,
    columns,
    contact_segments,
    convex,
    uncovered,
    verify,
)
from exactsweep.check.size import UNLIMITED, Budget

Points = list[tuple[int, int]]
HOOK = [(0, 0), (6, 0), (6, 6), (1, 6), (1, 3), (2, 3), (2, 5), (5, 5), (5, 1), (0, 1)]


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


class Counter:
    """Counts work of the kinds that take most of the time, in what would be microseconds."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.work = 0.0
        self.steps = 0
        self._patch = monkeypatch
        self.watch(uncovered, "_find_shadow", lambda ring, *_: 0.4 * len(ring))
        self.watch(uncovered, "_measure_heights", lambda ring, _: 0.2 * len(ring))
        self.watch(convex, "_is_blocked", lambda p, q, walls: 0.1 * len(walls))
        self.watch(convex, "_find_first_wall", lambda p, ray, walls: 0.5 * len(walls))
        self.watch(arrangement, "_find_common_point", lambda *_: 3)
        self.watch(contact_segments, "find_common_direction", lambda *_: 1)
        self.watch(claimed_shape, "cross", lambda *_: 0.3)
        self.watch(convex, "_merge", lambda *_: 4)
        near, take = columns.BoxColumns.near, Budget.take

        def count_near(boxes: columns.BoxColumns, *ends: Any) -> Any:
            for k in near(boxes, *ends):
                self.work += 0.1
                yield k

        def count_steps(budget: Budget, steps: int, bits: int = 0) -> None:
            self.steps += steps
            take(budget, steps, bits)

        monkeypatch.setattr(columns.BoxColumns, "near", count_near)
        monkeypatch.setattr(Budget, "take", count_steps)

    def watch(self, module: Any, name: str, cost: Callable[..., float]) -> None:
        do = getattr(module, name)

        def count(*arguments: Any) -> Any:
            self.work += cost(*arguments)
            return do(*arguments)

        self._patch.setattr(module, name, count)


def claim(d: Points, g: Points) -> dict[str, Any]:
    """That a triangle is the no-fit polygon: it is refused once the true one is known."""
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
    counted = Counter(monkeypatch)
    assert verify(claim(*HOSTILE[name])).reason.startswith("exterior: at the witness")
    assert 0 < counted.work < counted.steps


@pytest.mark.parametrize("name", ["two fans", "two zigzags"])
def test_work_ends_where_the_steps_do(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    certificate = claim(*HOSTILE[name])
    counted = Counter(monkeypatch)
    verify(certificate)
    whole = counted.steps
    for share in (8, 2):
        counted.work = counted.steps = 0
        refused = verify(certificate, max_steps=whole // share)
        assert refused.reason.startswith("too large: ")
        assert counted.work <= whole // share


def test_pieces_far_apart_do_not_count() -> None:
    """There are 1.2 million sums of pieces with contact segments near few of them."""
    teeth = [(k, 2 * (k % 2)) for k in range(401)]
    d = [*teeth, (400, 9), (0, 9)]
    reason = verify(claim(d, d), max_steps=2 * 10**6).reason
    assert reason.startswith("exterior: at the witness")


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
    """Of the edges of a trajectory each is taken by itself, with its own two crossings."""
    random = Random(7)
    ways = [(cos(pi * k / 9), sin(pi * k / 9)) for k in range(18)]
    stars = []
    for _ in range(2):
        radii = [random.uniform(300, 999) for _ in ways]
        stars.append([(round(r * x), round(r * y)) for r, (x, y) in zip(radii, ways, strict=True)])
    s = sweep(*stars)
    denominators = [lcm(x.denominator, y.denominator) for x, y in s.trajectory.vertices]
    assert verify(s.certificate()).proved
    assert lcm(*denominators).bit_length() > 150
    assert len(seen) == 2
    assert max(seen) <= 2 * max(d.bit_length() for d in denominators) + 12


def test_unrelated_denominators_are_no_common_lattice(seen: list[int]) -> None:
    """Of eight vertices with two numbers of 660 bits each, no more than four are put together."""
    random = Random(5)

    def near(c: int) -> Fraction:
        return c + Fraction(1, random.getrandbits(660) | 1)

    low = [(near(10 * k), near(60 * (k % 2))) for k in range(4)]
    band = [*low, *((x, y + 25) for x, y in low[::-1])]
    assert verify(no_fit_certificate(Holed(Polygon(band)), Holed(Polygon(HOOK)))).proved
    assert 0 < max(seen) < 9 * 660


def test_diagonals_take_time_by_walls(monkeypatch: pytest.MonkeyPatch) -> None:
    counted = Counter(monkeypatch)
    for shape in (behind_a_wall(60), fan(60), needles(60)):
        counted.work = 0
        (ring,) = (tuple((int(x), int(y)) for x, y in Polygon(shape).vertices),)
        pieces = convex.cut_to_convex((ring,), UNLIMITED)
        assert len(pieces) < len(ring)
        assert counted.work < 3 * len(ring) ** 2
