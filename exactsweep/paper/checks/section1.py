"""Section 1: definitions of the sweep, the swept area and the path, and remarks on them."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import pairwise, product

from exactsweep import Point, Sweep, sweep
from exactsweep.check import classify, point_in_polygon
from exactsweep.corpus.generator.prng import Prng
from exactsweep.numbers.number import Vertex
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation, find_first_failure
from exactsweep.paper.definition import LinearPiece, PiecewiseLinear, min_plus_convolution, mirror
from exactsweep.paper.functions import (
    compare_loops,
    describe_difference,
    frame_around,
    no_fit_is_the_definition,
    take_bottom,
)
from exactsweep.paper.laws import find_violation, search_grid, shrink
from exactsweep.paper.pairs import SweepPair

# Edges are tested at this share of their length, where a contact rarely ends; the positions inside
# and outside T are about STEP away from the edge, relative to its length.
SHARE, STEP = Fraction(5, 17), Fraction(1, 10**9)


def edge_positions(s: Sweep) -> Iterator[tuple[Point, Point, Point]]:
    """For each edge of the trajectory, yield positions on it, just inside T and just outside."""
    corners = s.trajectory.vertices
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True):
        x, y = ax + SHARE * (bx - ax), ay + SHARE * (by - ay)
        dx, dy = STEP * (ay - by), STEP * (bx - ax)
        yield Point(x, y), Point(x + dx, y + dy), Point(x - dx, y - dy)


def touches_without_overlap(pair: SweepPair) -> Iterator[str]:
    """On the trajectory, G touches D; just inside it, G overlaps D; just outside, G is free."""
    s = sweep(*pair)
    for vertex in s.trajectory.vertices:
        if classify(s.directrix, s.generatrix, vertex).verdict != "CONTACT":
            yield f"no contact at ({vertex.x}, {vertex.y}), a vertex of the trajectory"
    for positions in edge_positions(s):
        found = [classify(s.directrix, s.generatrix, t).verdict for t in positions]
        if found != ["CONTACT", "OVERLAP", "FREE"]:
            t = positions[0]
            yield f"at ({t.x}, {t.y}), just inside and just outside: {', '.join(found)}"


def find_exact_fit(effort: Effort) -> Iterator[Observation]:
    def fits(pair: SweepPair) -> Iterator[str]:
        for (ax, ay), (bx, by) in sweep(*pair).exact_fits[:1]:
            middle = (ax + bx) / 2, (ay + by) / 2
            if classify(pair.directrix, pair.generatrix, middle).verdict == "CONTACT":
                yield f"({middle[0]}, {middle[1]}) is a contact position, but not on the trajectory"

    slot = SweepPair(
        [(0, 0), (1, 0), (1, 1), (0, 1)],
        [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)],
    )
    if any(fits(slot)):
        least = shrink(fits, slot)
        how = "a square and its slot, reduced while the square still fits exactly"
        yield Counterexample(find_first_failure(fits(least)), how, *least)
    combs = [draw_slots(effort.random(f"slots {k}")) for k in range(effort.cases(20))]
    yield from fits_are_whole(slot)
    yield find_violation(no_fit_is_the_definition, [slot, *combs])
    yield Evidence(f"A slot, and {len(combs)} plates with slots above and below.")


def draw_slots(random: Prng) -> SweepPair:
    """Draw a box, and a plate with slots in both sides, some as wide as the box."""
    wide, bottom, top = random.between(1, 3), [(0, 0)], [(0, 40)]
    for side, sign in ((bottom, 1), (top, -1)):
        for _ in range(random.between(1, 4)):
            (x, y), room = side[-1], random.choice([wide, wide, wide - 1, wide + 1])
            start, depth = x + random.between(1, 2), sign * random.between(1, 9)
            ends = [(start, y), (start, y + depth), (start + room, y + depth), (start + room, y)]
            side += ends if room else []
    end = max(bottom[-1][0], top[-1][0]) + 1
    box = [(0, 0), (wide, 0), (wide, 2), (0, 2)]
    return SweepPair(box, [*bottom, (end, 0), (end, 40), *top[::-1]])


def fits_are_whole(pair: SweepPair) -> Iterator[str]:
    """Along an exact fit G touches D; beyond its inner end G overlaps D."""
    s = sweep(*pair)
    for start, end in s.exact_fits:
        if point_in_polygon(start, s.trajectory) != 0:
            yield f"the exact fit from ({start.x}, {start.y}) does not start on the trajectory"
        by = end.x - start.x, end.y - start.y
        for share, expected in ((SHARE, "CONTACT"), (1, "CONTACT"), (1 + STEP, "OVERLAP")):
            t = Point(start.x + share * by[0], start.y + share * by[1])
            found = classify(s.directrix, s.generatrix, t).verdict
            if found != expected and not (found == "CONTACT" and start == end):
                yield f"at ({t.x}, {t.y}) along an exact fit: {found}"


def swept_by_contact(s: Sweep, p: Point) -> bool:
    """Decide by `classify` alone whether G covers a point from some position on the trajectory."""
    # It does if the inverse of G, placed at the point, meets the trajectory.
    inverse, path = s.generatrix.reflected(), s.trajectory
    shapes = path, frame_around(path, inverse)
    return all(classify(shape, inverse, p).verdict != "FREE" for shape in shapes)


def area_is_covered(pair: SweepPair) -> Iterator[str]:
    """Among 36 points, G sweeps exactly those between the inner and outer loop."""
    s = sweep(*pair)
    yield from compare_loops(s, "inner", "outer")
    if s.area != s.outer.area - s.inner.area:
        yield "the area differs from that between the loops"
    (left, low), (right, high) = s.outer.bounding_box
    for i, j in product(range(-1, 5), repeat=2):
        p = Point(left + (right - left) * (7 * i + 2) / 29, low + (high - low) * (7 * j + 2) / 29)
        between = point_in_polygon(p, s.outer) >= 0 >= point_in_polygon(p, s.inner)
        if between != swept_by_contact(s, p):
            yield f"({p.x}, {p.y}) is {'' if between else 'not '}between the loops"


def path_is_the_definition(pair: SweepPair) -> Iterator[str]:
    """The trajectory matches the definition."""
    yield from compare_loops(sweep(*pair), "trajectory")


def paths_are_translates(pair: SweepPair) -> Iterator[str]:
    """The paths of two points of G are translates of each other."""
    (ax, ay), (bx, by) = pair.generatrix[:2]
    first, second = (sweep(*pair, reference=g).trajectory for g in ((ax, ay), (bx, by)))
    if first.translated((bx - ax, by - ay)) != second:
        yield f"the paths of ({ax}, {ay}) and ({bx}, {by}) differ in shape"


def find_overlap_along_directrix(effort: Effort) -> Iterator[Observation]:
    """Search for a G that overlaps D while one of its vertices is on D's boundary."""

    def overlaps(pair: SweepPair) -> Iterator[str]:
        reference_point = pair.generatrix[0]
        for x, y in pair.directrix:
            t = x - reference_point[0], y - reference_point[1]
            if classify(pair.directrix, pair.generatrix, t).verdict == "OVERLAP":
                yield f"with its vertex {reference_point} on ({x}, {y}), G overlaps D"

    found = search_grid(2, 6, "convex", "convex", overlaps)
    yield replace(found, cases=())
    yield "" if found.cases else "no such overlap"
    for text, _, g, d in found.cases:
        yield Evidence(f"For G = {g} and D = {d}: {text}.")
        yield from touches_without_overlap(SweepPair([*g], [*d]))


def path_is_not_the_directrix(pair: SweepPair) -> Iterator[str]:
    """The trajectory is not a translate of D."""
    s = sweep(*pair)
    (left, low), (x, y) = s.directrix.vertices[0], s.trajectory.vertices[0]
    if s.directrix.translated((x - left, y - low)) == s.trajectory:
        yield "the trajectory is a translate of D"


def sum_is_the_swept_area(pair: SweepPair) -> Iterator[str]:
    """The Minkowski sum of G and T, evaluated as functions of x, has the loops of the sweep."""
    s, (top, bottom, directrix) = sweep(*pair), pair.chains
    path, low, high = map(_read_function, (take_bottom(s.trajectory.vertices), bottom, top[::-1]))
    ends = directrix[0][0], directrix[-1][0]
    outer = min_plus_convolution(path, low)
    inner = mirror(min_plus_convolution(mirror(path), mirror(high), ends))
    for name, loop, pieces in (("outer", s.outer, outer), ("inner", s.inner, inner)):
        chain = [*(piece[:2] for piece in pieces), pieces[-1][2:]]
        yield describe_difference(f"the {name} loop", take_bottom(loop.vertices), chain, "as a sum")


def _read_function(chain: Sequence[Vertex]) -> PiecewiseLinear:
    return tuple(LinearPiece(*p, *q) for p, q in pairwise(chain))
