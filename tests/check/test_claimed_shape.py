"""The test whether rings are a polygon with holes, compared with the kernel's own test."""

from collections import Counter
from random import Random

from shape_families import untangled

from exactsweep import Polygon, PolygonError, Region
from exactsweep.check.certificate import CertificateError
from exactsweep.check.claim import ClaimedShape
from exactsweep.check.claimed_shape import check_shape


def draw_rings(rng: Random) -> list[Polygon]:
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
    for _ in range(900):
        exterior, *holes = draw_rings(rng)
        sorted_holes = sorted(hole.vertices for hole in holes)
        shape = ClaimedShape(exterior.vertices, tuple(sorted_holes))
        try:
            Region(exterior, holes)
            expected = ""
        except PolygonError as error:
            expected = str(error)
        try:
            check_shape(shape, "shape")
            found = ""
        except CertificateError as error:
            found = str(error.args[0])
        assert bool(found) == bool(expected), (exterior, holes, expected, found)
        seen[" ".join(found.split()[-1:])] += 1
    assert seen.keys() == {"", "points", "exterior", "apart", "overlap"}
    assert min(seen.values()) > 4
