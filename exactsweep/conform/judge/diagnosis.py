"""Diagnosis of a wrong loop: the mistake that produces it.

Let P = D + (-G), the positions of G's origin at which G overlaps D. Common mistakes give another
exact set: P for another reference point; -P, if roles are exchanged; D + G, if G is not reflected;
P at another scale or in other axes; the convex hull of P; or the answer to another question. The
whole loop must equal that set, so a diagnosis is a proof.
"""

from collections.abc import Iterator
from fractions import Fraction
from itertools import chain
from operator import itemgetter
from typing import NamedTuple

from exactsweep.conform.judge import witness
from exactsweep.conform.judge.closeness import are_close, find_box, is_near, match_rings
from exactsweep.conform.judge.rounding import name_arithmetic
from exactsweep.corpus import Case
from exactsweep.geometry.canonical import find_centroid, find_doubled_area
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.vectors import find_hull
from exactsweep.numbers.addition import add_up
from exactsweep.numbers.digits import abridge
from exactsweep.numbers.number import ORIGIN, Point, PointRings
from exactsweep.sweep import inner_fit_polygon, no_fit_polygon
from exactsweep.words import write_pair

_BOUNDARIES = (
    "the sum of the boundaries only: positions with one polygon inside the other are missing"
)
_MAX_ROUNDED = 16
_NEARLY = 4
_POSITIONS = ("trajectory", "no_fit", witness.SUM, "inner_fit")  # depend on the reference point
# Diagnoses in terms of a Minkowski sum of a = D and b = -G.
_SUMS = {
    "D + G, G not reflected": "exact for a + (-b), b reflected",
    "exchanged roles: D around G": "exact for -(a + b)",
    "D itself": "a itself",
    "G itself": "-b",
}
_GIVEN = "the reference point given"
_USUAL = ("G's first vertex as reference", "G's origin as reference")
_AXES = {
    "exchanged roles: D around G": (-1, 0, 0, -1),
    "other axes: y is negated": (1, 0, 0, -1),
    "other axes: x is negated": (-1, 0, 0, 1),
    "other axes: x and y are exchanged": (0, 1, 1, 0),
    "other axes: rotated by 90 degrees": (0, -1, 1, 0),
    "other axes: rotated by -90 degrees": (0, 1, -1, 0),
}


class _DiagnosedRings(NamedTuple):
    case: Case
    name: str
    exact: PointRings
    rings: PointRings
    rounding: Fraction
    low: Point  # the corners of the bounding box
    high: Point

    @property
    def reference(self) -> Point:
        return ORIGIN if self.name == witness.SUM else self.case.reference

    def equal(self, others: PointRings, times: int = 1) -> bool:
        """Decide whether the answered rings equal others up to a multiple of the rounding."""
        return bool(others) and are_close(others, self.rings, times * self.rounding)


def diagnose(case: Case, name: str, rings: PointRings, rounding: Fraction) -> tuple[str, ...]:
    """Name the questions that rings answer exactly, up to rounding; the likeliest comes first."""
    if not any(map(find_doubled_area, rings)):
        return () if rings else ("reports that G does not fit",)
    low, high = find_box(rings)
    if min(high.x - low.x, high.y - low.y) < _MAX_ROUNDED * rounding:
        # Such a rounding would make nearly all rings equal.
        rounding = Fraction(0)
    exact = witness.list_exact_rings(case, name)
    if not exact:
        return (f"the exact {witness.LOOP_NAMES[name]} has no rings",)
    theirs = _DiagnosedRings(case, name, exact, rings, rounding, low, high)
    left = list(rings)
    missing = list(match_rings(exact, left, rounding))
    if counted := tuple(_count_rings(theirs, missing, left)):
        return counted
    spoilt = name_arithmetic(exact, rings)
    if rounding and theirs.equal(exact, _NEARLY):
        # Such an error could be mistaken for another reference point or scale.
        named = spoilt or tuple(_name_vertices(exact, rings))
        return *named, f"exact except for {_NEARLY} times the permitted rounding"
    found = [*_other_loops(theirs)]
    if name in _POSITIONS and exact and not found:
        found += [*spoilt, *_other_positions(theirs)]
    if name == "outer" and not found and theirs.equal(_add(case, name)):
        found.append("D + G instead of the trajectory + G")
    if not found:
        found += spoilt or _name_vertices(exact, rings)
    if not found and len(missing) < len(exact):
        found.append(f"exact in {len(exact) - len(missing)} of {len(exact)} rings")
    if name == witness.SUM:
        found = [words.removeprefix("exact for another reference point: ") for words in found]
        found = [_SUMS.get(words.removeprefix("exact for "), words) for words in found]
    return tuple(dict.fromkeys(found))


def _count_rings(theirs: _DiagnosedRings, missing: PointRings, left: PointRings) -> Iterator[str]:
    """Count missing or additional rings if all others are exact."""
    exact, name = theirs.exact, theirs.name
    if len(missing) == len(exact):
        return
    if not missing:
        is_around = name in ("trajectory", "no_fit", witness.SUM)
        inside = _find_inside(theirs.case, theirs.reference) if is_around else []
        if inside and left and are_close(inside, left, theirs.rounding):
            yield _BOUNDARIES
        yield f"all exact rings, and {len(left)} more"
    elif not left and name != "inner_fit" and exact[0] not in missing:
        lost, holes = len(missing), len(exact) - 1
        yield "lacks the holes" if lost == holes else f"lacks {lost} of {holes} holes"
    elif not left:
        yield f"lacks {len(missing)} of {len(exact)} rings"


def _find_inside(case: Case, reference: Point) -> PointRings:
    """Find the positions at which G is inside D, or D inside G, with disjoint boundaries."""
    shapes = case.directrix, case.generatrix
    inside = inner_fit_polygon(*shapes, reference=reference)
    around = inner_fit_polygon(*shapes[::-1])
    turned = [_map(region.rings, -1, 0, 0, -1, reference) for region in around.regions]
    return [*chain.from_iterable(region.rings for region in inside.regions), *chain(*turned)]


def _name_vertices(exact: PointRings, theirs: PointRings) -> Iterator[str]:
    """Describe the wrong vertices of a single ring, most of which are right."""
    points, answered = {*chain(*exact)}, {*chain(*theirs)}
    missing, added = points - answered, answered - points
    if not len(exact) == len(theirs) == 1 or len(missing) > len(points) // 2:
        return
    if len(missing) == len(added) == 1:
        yield "one vertex is wrong, the others are exact"
    elif not added:
        yield f"lacks {'one vertex' if len(missing) == 1 else 'vertices'}, the others are exact"
    elif not missing:
        yield "has all exact vertices, and more"


def _other_loops(theirs: _DiagnosedRings) -> Iterator[str]:
    case, exact = theirs.case, theirs.exact
    for other, words in witness.LOOP_NAMES.items():
        if witness.SUM in (other, theirs.name):
            continue
        loop = witness.list_exact_rings(case, other)
        if loop not in ((), exact) and theirs.equal(loop):
            yield f"exact for the {words} instead"
    named: dict[str, PointRings] = {
        "D itself": case.directrix.rings,
        "G itself": case.generatrix.rings,
    }
    if exact:
        low, high = find_box(exact)
        box = Polygon([low, (high.x, low.y), high, (low.x, high.y)])
        named["the convex hull of the exact one"] = [Polygon(find_hull(chain(*exact))).vertices]
        named["the bounding box of the exact one"] = [box.vertices]
    for words, rings in named.items():
        if tuple(rings) != exact and theirs.equal(rings):
            yield words


def _other_positions(theirs: _DiagnosedRings) -> list[str]:
    """List the mistakes that explain the answer up to translation, most likely first."""
    case, rings = theirs.case, theirs.exact
    positions = _map(rings, 1, 0, 0, 1, witness.subtract(ORIGIN, theirs.reference))
    shapes: list[tuple[str, PointRings]] = [("", positions)]
    if theirs.name != "inner_fit":
        shapes.append(("D + G, G not reflected", _add(case, theirs.name)))
    shapes += ((words, _map(positions, *matrix)) for words, matrix in _AXES.items())
    found: list[tuple[int, str]] = []
    for words, shape in shapes:
        offset = _find_offset(shape, theirs)
        if offset is None:
            continue
        points = [*_name_offsets(theirs, offset)]
        if words and _GIVEN in points:
            found.append((1, f"exact for {words}"))
            continue
        joint = f"{words}, and for " if words else ""
        found += (
            (3 if words else 1 + (point not in _USUAL), f"exact for {joint}{point}")
            for point in points
        )
        if not points:
            by = write_pair(witness.subtract(offset, theirs.reference))
            found.append((4, f"exact for {joint}another reference point: translated by {by}"))
    factor = _find_scale(theirs)
    if factor is not None:
        found.append((5, f"exact for another scale: {abridge(factor)} times as large"))
    return [words for _, words in sorted(found, key=itemgetter(0))]


def _map(rings: PointRings, a: int, b: int, c: int, d: int, by: Point = ORIGIN) -> PointRings:
    image = [[Point(a * x + b * y + by.x, c * x + d * y + by.y) for x, y in r] for r in rings]
    return image if a * d > b * c else [ring[::-1] for ring in image]


def _add(case: Case, name: str) -> PointRings:
    found = no_fit_polygon(case.directrix, case.generatrix.reflected())
    holes = found.holes if name in ("no_fit", witness.SUM) else ()
    return [loop.vertices for loop in (found.exterior, *holes)]


def _name_offsets(theirs: _DiagnosedRings, offset: Point) -> Iterator[str]:
    """Name the points of G at an offset from its origin."""
    case = theirs.case
    if theirs.name == witness.SUM:
        if is_near(ORIGIN, offset, theirs.rounding):
            yield _GIVEN
        return
    ring, (low, high) = case.generatrix_ring, case.generatrix.bounding_box
    first, base = ring[0], case.directrix_ring[0]
    d_low, _ = case.directrix.bounding_box
    columns = zip(*ring, strict=True)
    named = {
        _GIVEN: case.reference,
        "G's first vertex as reference": first,
        "G's origin as reference": ORIGIN,
        "the reference point negated": witness.subtract(ORIGIN, case.reference),
        "the lower left corner of G's box as reference": low,
        "the center of G's box as reference": witness.find_middle(low, high),
        "G's centroid as reference": find_centroid(ring),
        "the mean of G's vertices as reference": Point(*(add_up(c) / len(ring) for c in columns)),
        "G's last vertex as reference": ring[-1],
        "G's lowest vertex as reference": min(ring, key=lambda p: (p.y, p.x)),
        "G's leftmost vertex as reference": min(ring),
        "G's rightmost vertex as reference": max(ring),
        "G's highest vertex as reference": max(ring, key=lambda p: (p.y, p.x)),
        "positions relative to D's first vertex": witness.subtract(case.reference, base),
        "G's first vertex as reference, relative to D's first": witness.subtract(first, base),
        "positions relative to the lower left corner of D's box": witness.subtract(low, d_low),
    }
    for name, point in named.items():
        if is_near(point, offset, theirs.rounding):
            yield name


def _find_offset(shape: PointRings, theirs: _DiagnosedRings) -> Point | None:
    by = witness.subtract(theirs.low, find_box(shape)[0])
    return by if theirs.equal(_map(shape, 1, 0, 0, 1, by), 2) else None


def _find_scale(theirs: _DiagnosedRings) -> Fraction | None:
    low, high = find_box(theirs.exact)
    factor = (theirs.high.x - theirs.low.x) / (high.x - low.x)
    scaled = [[Point(x * factor, y * factor) for x, y in ring] for ring in theirs.exact]
    return factor if factor not in (0, 1) and theirs.equal(scaled, 4) else None
