"""Verified witnesses: positions and points at which an answer is wrong.

Let P be the region inside the exact trajectory of G's origin, and H(p) = p - G the translations at
which G covers a point p. By Theorems 2.1 and 2.2,

- p is inside the outer loop if and only if H(p) overlaps P: the sweep passes or encloses a position
  at which G covers p;
- p is inside the inner loop if and only if P contains H(p): G overlaps D wherever it covers p.

So the witness for a point of an inner or outer loop is a translation in H(p), or the point itself
if there is none.
"""

from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import partial

from exactsweep.check import classify, point_in_polygon
from exactsweep.check.location import locate, locate_in_shape
from exactsweep.conform.judge.region import Trapezoid, find_differences
from exactsweep.conform.judge.verdict import Witness
from exactsweep.corpus import Case
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.geometry.vectors import orientation
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import ORIGIN, Fit, Point, PointRings
from exactsweep.words import write_pair

LOOP_NAMES = {
    "trajectory": "trajectory",
    "inner": "inner loop",
    "outer": "outer loop",
    "no_fit": "no-fit polygon",
    "minkowski_sum": "Minkowski sum",
    "inner_fit": "inner fit",
}
NAME = "exact_fits"
INSIDE = "inner_exact_fits"
SUM = "minkowski_sum"
PART_NAMES = {**LOOP_NAMES, NAME: "exact fits", INSIDE: "exact fits inside"}
# The exact fits of loops of positions; a sum's exact fits are its slits.
FITS_OF = {"trajectory": NAME, "no_fit": NAME, SUM: NAME, "inner_fit": INSIDE}
_DOES = {
    "FREE": "does not touch D",
    "CONTACT": "touches D without overlap",
    "OVERLAP": "overlaps D",
}
_DOES_INSIDE = {
    "FREE": "lies inside D",
    "CONTACT": "lies inside D and touches its boundary",
    "OVERLAP": "extends beyond D",
}
_SEVERITY = tuple(_DOES)


def list_exact_rings(case: Case, name: str) -> tuple[tuple[Point, ...], ...]:
    """List the rings of an exact loop, counter-clockwise: the exterior, then the holes.

    The inner loop precedes other unswept regions. An exact fit is a ring of two points.
    """
    if name == SUM:
        # The sum of a = D and b = -G is the no-fit polygon for the origin of G.
        by = subtract(ORIGIN, case.reference)
        return tuple(tuple(add(p, by) for p in ring) for ring in list_exact_rings(case, "no_fit"))
    if name == "inner_fit":
        return tuple(ring for region in case.inner_regions or () for ring in region.rings)
    if name in (NAME, INSIDE):
        return list_exact_fits(case, name)
    loops = {
        "trajectory": (case.trajectory,),
        "inner": (case.inner, *case.unswept),
        "outer": (case.outer,),
        "no_fit": (case.trajectory, *case.holes),
    }
    return tuple(loop.vertices for loop in loops[name])


def list_exact_fits(case: Case, name: str) -> tuple[Fit, ...]:
    if name == SUM:
        by = subtract(ORIGIN, case.reference)
        return tuple((add(p, by), add(q, by)) for p, q in case.exact_fits)
    return case.inner_exact_fits if name == INSIDE else case.exact_fits


class WitnessError(ExactSweepError):
    """A case whose expected answer contradicts the definition; the message states where."""


def find_witness(case: Case, name: str, theirs: PointRings, cells: Iterable[Trapezoid]) -> Witness:
    cell = max(cells, key=lambda cell: cell.area)
    show = {"inner": _find_inner_witness, "outer": _find_outer_witness}.get(
        name, partial(_find_position_witness, name=name)
    )
    for point in cell.points():
        if is_inside(point, theirs) != cell.first and (found := show(case, point, cell.first)):
            side = "outside" if cell.first else "inside"
            return replace(
                found, says=f"{found.says}; it is {side} the answered {LOOP_NAMES[name]}"
            )
    raise WitnessError(
        f"case {case.id}: the definition contradicts its {name} near {write_pair(point)}"
    )


def is_inside(point: Point, rings: PointRings) -> bool:
    """Decide whether a point off all edges has an odd winding number."""
    return sum(locate(point, ring) > 0 for ring in rings) % 2 == 1


def at_position(case: Case, position: Point, *, inside: bool = False) -> Witness:
    """Classify a position of the reference point, around D or inside D."""
    translation = subtract(position, case.reference)
    does, obstacles = _DOES, [case.directrix]
    if inside:
        does, obstacles = _DOES_INSIDE, _obstacles(case, translation)
    found = [classify(obstacle, case.generatrix, translation) for obstacle in obstacles]
    verdict, point = max(found, key=lambda one: _SEVERITY.index(one.verdict))
    return Witness(f"at {write_pair(position)} G {does[verdict]}", translation, verdict, point)


def _obstacles(case: Case, t: Point) -> list[AnyPolygon]:
    """List the shapes outside D: its complement in a box around G + t, and its holes."""
    exterior, *holes = Region(case.directrix).rings
    corners = [*exterior, *(add(p, t) for p in case.generatrix_ring)]
    (left, right), (low, high) = ((min(c) - 1, max(c) + 1) for c in zip(*corners, strict=True))
    box = [(left, low), (right, low), (right, high), (left, high)]
    return [Region(box, [exterior]), *map(Polygon, holes)]


def _find_position_witness(case: Case, position: Point, missed: bool, name: str) -> Witness | None:
    is_inside = name == "inner_fit"
    if name == SUM:
        found = at_position(case, add(position, case.reference))
        if found.classified != ("OVERLAP" if missed else "FREE"):
            return None
        return replace(
            found, says=f"{write_pair(position)} is {_describe_sum(position, found.point)}"
        )
    found = at_position(case, position, inside=is_inside)
    holes = case.holes if name == "trajectory" and missed else ()
    if any(point_in_polygon(position, hole) >= 0 for hole in holes):
        return replace(found, says=f"{found.says}, but cannot reach this position from outside")
    return found if found.classified == ("FREE" if missed == is_inside else "OVERLAP") else None


def _describe_sum(position: Point, a: Point | None) -> str:
    if a is None:
        return "not the sum of a point of a and a point of b"
    return f"{write_pair(a)} in a plus {write_pair(subtract(position, a))} in b"


def _find_inner_witness(case: Case, point: Point, permitted: bool) -> Witness | None:
    onto, positions = _list_covering_translations(case, point), _positions(case)
    escapes = [c for c in find_differences(onto.rings, [positions.vertices]) if c.first]
    if permitted and case.kind == "SS":
        if escapes and classify(positions, onto, (0, 0)).verdict == "OVERLAP":
            return None
        return Witness(f"on the trajectory, G never covers {write_pair(point)}", point=point)
    if not permitted:
        if not escapes:
            return None
        t = next(max(escapes, key=lambda cell: cell.area).points())
        return _cover_point(case, point, t)
    if escapes:
        return None
    # All positions are witnesses; the largest cell has short coordinates.
    t = next(max(find_differences(onto.rings, []), key=lambda cell: cell.area).points())
    found = _cover_point(case, point, t)
    return found and replace(found, says=f"{found.says}, as wherever it covers that point")


def _find_outer_witness(case: Case, point: Point, permitted: bool) -> Witness | None:
    onto, positions = _list_covering_translations(case, point), _positions(case)
    if not permitted:
        if classify(positions, onto, (0, 0)).verdict == "OVERLAP":
            return None
        return Witness(f"wherever G covers {write_pair(point)}, it {_DOES['FREE']}", point=point)
    for t in _on_boundary(positions, onto):
        return _cover_point(case, point, t)
    for shape, name in (
        (case.directrix, "D"),
        (case.inner, "the inner loop"),
        *((loop, "an unswept hole") for loop in case.unswept),
    ):
        if locate_in_shape(point, shape.rings) >= 0:
            return Witness(f"{write_pair(point)} is in {name}", point=point)
    return None


def _cover_point(case: Case, point: Point, t: Point) -> Witness | None:
    if locate_in_shape(point, case.generatrix.translated(t).rings) < 0:
        return None
    verdict, _ = classify(case.directrix, case.generatrix, t)
    at = write_pair(add(t, case.reference))
    return Witness(f"at {at} G covers {write_pair(point)} and {_DOES[verdict]}", t, verdict, point)


def _list_covering_translations(case: Case, point: Point) -> AnyPolygon:
    return case.generatrix.reflected((point.x / 2, point.y / 2))


def _positions(case: Case) -> Polygon:
    return case.trajectory.translated((-case.reference.x, -case.reference.y))


def _on_boundary(positions: Polygon, onto: AnyPolygon) -> Iterator[Point]:
    """Yield boundary points of a polygon that lie in a shape: vertices, then crossings."""
    vertices = positions.vertices
    yield from (vertex for vertex in vertices if locate_in_shape(vertex, onto.rings) >= 0)
    for k, b in enumerate(vertices):
        for ring in onto.rings:
            for j, d in enumerate(ring):
                if crossing := crossing_of(vertices[k - 1], b, ring[j - 1], d):
                    yield crossing


def crossing_of(a: Point, b: Point, c: Point, d: Point) -> Point | None:
    of_a, of_b, of_c, of_d = (
        orientation(c, d, a),
        orientation(c, d, b),
        orientation(a, b, c),
        orientation(a, b, d),
    )
    if of_a == of_b or of_a * of_b > 0 or of_c * of_d > 0:
        return None
    s = Fraction(of_a) / (of_a - of_b)
    return Point(a.x + s * (b.x - a.x), a.y + s * (b.y - a.y))


def find_middle(p: Point, q: Point) -> Point:
    return Point((p.x + q.x) / 2, (p.y + q.y) / 2)


def add(p: Point, q: Point) -> Point:
    return Point(p.x + q.x, p.y + q.y)


def subtract(p: Point, q: Point) -> Point:
    return Point(p.x - q.x, p.y - q.y)
