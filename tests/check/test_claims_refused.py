"""Claims about shapes with holes: bad input and bad loops, and the names that the reasons give."""

from collections import Counter
from fractions import Fraction
from random import Random
from typing import Any

import pytest
from cells import Holed, grid
from shape_certificates import (
    HEAD,
    inner_fit_certificate,
    no_fit_certificate,
    outline,
    read,
    sweep_certificate,
    write,
)
from shape_families import untangled

from exactsweep import Point, Polygon, PolygonError, Region
from exactsweep.check import standalone, verify

UNIT = grid("#")
FULL = grid("###", "#.#", "###")
CROSSED = [["0", "0"], ["1", "1"], ["1", "0"], ["0", "1"]]
NO_FIT = no_fit_certificate(FULL, grid("##", "#."))
HOLLOW = no_fit_certificate(grid("####", "#..#", "#..#", "####"), UNIT)
INNER = inner_fit_certificate(grid("#####", "#####", "##.##", "#####", "#####"), UNIT)
SWEEP = sweep_certificate(FULL, UNIT)


def _refuse(certificate: Any, **steps: int) -> str:
    result = verify(certificate, **steps)
    assert not result.proved
    return result.reason


@pytest.mark.parametrize(
    ("certificate", "key"),
    [
        *((claim, key) for claim in (NO_FIT, SWEEP) for key in ("directrix", "generatrix")),
        *((INNER, key) for key in ("container", "part")),
    ],
)
def test_both_shapes_have_to_be_polygons(certificate: Any, key: str) -> None:
    changed = {**certificate, key: {"exterior": CROSSED, "holes": []}}
    assert _refuse(changed).startswith(f"{key}: a ring is not simple")


@pytest.mark.parametrize(
    ("certificate", "path"),
    [
        (NO_FIT, ("exterior",)),
        (HOLLOW, ("holes", 0)),
        (INNER, ("regions", 0, "exterior")),
        (INNER, ("regions", 0, "holes", 0)),
        (SWEEP, ("outer",)),
        (SWEEP, ("inner",)),
    ],
)
def test_loops_of_a_claim_are_canonical(certificate: Any, path: tuple[Any, ...]) -> None:
    """Walked clockwise they are refused, and with a straight vertex; the reason names the key."""
    at = certificate
    for key in path:
        at = at[key]
    (ax, ay), (bx, by) = at[:2]
    middle = [str((int(ax) + int(bx)) // 2), str((int(ay) + int(by)) // 2)]
    for false in ([at[0], *at[:0:-1]], [at[0], middle, *at[1:]]):
        assert _refuse(_put(certificate, path, false)).startswith(str(path[0]))


def _put(value: Any, path: tuple[Any, ...], new: Any) -> Any:
    if not path:
        return new
    changed = value.copy()
    changed[path[0]] = _put(value[path[0]], path[1:], new)
    return changed


def test_a_hole_left_out_of_a_region_is_missed_where_it_is() -> None:
    changed = _put(INNER, ("regions", 0, "holes"), [])
    assert _refuse(changed) == "regions[0]: not in the answer"


def test_a_sweep_with_a_shared_direction_is_not_one_of_any_shape() -> None:
    reason = _refuse(sweep_certificate(grid("##", "#."), UNIT))
    assert reason == "kind: there is a shared direction, so it is not SS"


SIZES = [
    (grid("####", "####"), 4),
    (grid("#.", "##"), 6),
    (grid(".#.", "###", ".#."), 12),
    (FULL, 8),
]


@pytest.mark.parametrize(("d", "m"), SIZES)
@pytest.mark.parametrize(("g", "n"), SIZES)
@pytest.mark.parametrize("names", [("directrix", "generatrix"), ("container", "part")])
def test_work_on_all_pairs_of_edges_is_told_before_it_is_begun(
    d: Holed, m: int, g: Holed, n: int, names: tuple[str, str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """A straight vertex is one more. The claim itself is a triangle, and false."""

    def begin(*_: Any) -> None:
        raise standalone.Refused("begun")

    monkeypatch.setattr(standalone, "check_shape", begin)
    triangle = [["0", "0"], ["1", "0"], ["0", "1"]]
    claimed = {"exterior": triangle, "holes": []}
    certificate = {**HEAD, "claim": "no_fit", "exact_fits": [], **claimed}
    if "part" in names:
        certificate = {**HEAD, "claim": "inner_fit", "exact_fits": [], "regions": [claimed]}
    for name, shape in zip(names, (d, g), strict=True):
        written = outline(shape.mapped(((1, 0), (0, 1)), Fraction(1, 2)))
        first, second = read(written["exterior"][:2])
        middle = Point((first.x + second.x) / 2, (first.y + second.y) / 2)
        written["exterior"][1:1] = write([middle])
        certificate[name] = written
    m, n = m + 1, n + 1
    steps = 3 * m * n + m * m + n * n + 100 * (m + n)
    assert _refuse(certificate, max_steps=steps - 1).startswith("too large")
    assert _refuse(certificate, max_steps=steps) == f"{names[0]}: begun"


def _draw_rings(rng: Random) -> list[Polygon]:
    """An exterior and a few holes on a small grid, where they touch, cross and overlap."""
    rings = [untangled(rng, 7, 6)]
    if rng.random() < 0.7:
        rings = [Polygon([(0, 0), (6, 0), (6, 6), (rng.randint(3, 5), 3), (0, 6)])]
    if rng.random() < 0.1:
        rings = [Polygon([(-1, -1), (8, -1), (-1, 8)]), Polygon([(0, 0), (4, 0), (5, 2), (0, 5)])]
    for _ in range(rng.randint(1, 2)):
        hole = untangled(rng, 4, rng.choice([1, 2, 4]))
        rings.append(hole.translated((rng.randint(0, 4), rng.randint(0, 4))))
    return rings


def test_rings_are_judged_as_by_the_kernel() -> None:
    rng = Random(8)
    seen: Counter[str] = Counter()
    for _ in range(400):
        exterior, *holes = _draw_rings(rng)
        shape = standalone.shape(outline(Holed(exterior, tuple(holes))))
        try:
            Region(exterior, holes)
            expected = ""
        except PolygonError as error:
            expected = str(error)
        try:
            standalone.check_shape(shape, standalone.Work(10**6))
            found = ""
        except standalone.Refused as error:
            found = str(error)
        assert bool(found) == bool(expected), (exterior, holes, expected, found)
        seen[found] += 1
    assert {"", "rings of a shape cross", "the interior of a shape falls apart"} < seen.keys()
    assert len(seen) == 4
    assert min(seen.values()) > 4


def test_a_single_ring_is_judged_as_by_the_kernel() -> None:
    """Most rings on a small grid cross or touch themselves."""
    rng, seen = Random(4), Counter[bool]()
    for _ in range(1000):
        points = [(rng.randrange(5), rng.randrange(4)) for _ in range(rng.randint(3, 6))]
        try:
            expected = bool(Polygon(points))
        except PolygonError:
            expected = False
        try:
            item = [[str(x), str(y)] for x, y in points]
            standalone.check_shape(standalone.shape({"exterior": item}), standalone.Work(10**6))
            found = True
        except standalone.Refused:
            found = False
        assert found == expected, points
        seen[found] += 1
    assert min(seen.values()) > 200


def test_a_deeply_nested_claim_is_refused_without_its_points() -> None:
    nested: Any = ["0", "0"]
    for _ in range(10**4):
        nested = [nested]
    for key in ("exterior", "holes", "exact_fits"):
        assert _refuse({**NO_FIT, key: nested}).startswith(key)
