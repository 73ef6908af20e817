"""Beyond the paper: polygons of any shape, compared with the definition."""

from bisect import bisect_left, bisect_right
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import chain, combinations, product

from exactsweep import Point, Polygon, Region, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.check import classify, point_in_polygon
from exactsweep.check.cone import Cone, by_turn, find_common_direction, subtract
from exactsweep.check.meeting import Cones, find_cones_of, split_where_touching
from exactsweep.check.shape import LatticeShape, list_edges
from exactsweep.corpus.generator.growing import cm_hard, forks
from exactsweep.corpus.generator.shapes import Ring
from exactsweep.geometry.segment import Segment, choose_cover, lay_point, make_segment
from exactsweep.numbers.number import Edge, Vertex
from exactsweep.paper import functions, kernel, read_toml
from exactsweep.paper.checks.section1 import SHARE, STEP
from exactsweep.paper.checks.section2 import CAVITY, swept_area_is_the_definition
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation
from exactsweep.paper.costs import count_all
from exactsweep.paper.counting import count_chains, count_operations, grow, make_counted
from exactsweep.paper.growth import BOUNDS
from exactsweep.paper.pairs import Chains, SweepPair, read_pair
from exactsweep.procedures.chain import inverse
from exactsweep.procedures.segments import find_contact_segments

_DATA = read_toml("checks/containers.toml")
CONTAINERS = _DATA["container"]
HELD, ROOM = (read_pair(_DATA[name]) for name in ("held", "room"))


def loops_are_simple(pair: SweepPair) -> Iterator[str]:
    """Each loop of the no-fit polygon is a simple polygon, and no two share an interior point."""
    found = no_fit_polygon(*pair[::-1])
    for loop in (found.exterior, *found.holes):
        if Polygon(loop.vertices).vertices != loop.vertices:
            yield "a loop is not a canonical simple polygon"
    for hole, other in combinations(found.holes, 2):
        if classify(hole, other, (0, 0)).verdict == "OVERLAP":
            yield "two holes overlap"
    yield from functions.no_fit_is_the_definition(pair)


def boundary_is_contact(pair: SweepPair) -> Iterator[str]:
    """Loops and exact fits lie on contact segments; there are at most 2mn contact segments."""
    found = no_fit_polygon(*pair[::-1])
    known, _ = find_contacts((tuple(pair.directrix),), (tuple(inverse(pair.generatrix)),))
    if len(known) > 2 * len(pair.generatrix) * len(pair.directrix):
        yield f"{len(known)} contact segments, more than 2mn"
    segments = [make_segment((a, b)) for a, b in known]
    loops = (found.exterior, *found.holes)
    edges = [edge for loop in loops for edge in functions.list_edges(loop.vertices)]
    for edge in (*edges, *found.exact_fits):
        if not covers(segments, edge):
            yield f"off all contact segments: {functions.show_fits([edge])}"
    yield from functions.no_fit_is_the_definition(pair)


def covers(known: Iterable[Segment], edge: Edge) -> bool:
    """Decide whether segments cover an edge, which may be a point."""
    if edge[0] == edge[1]:
        spots = ((s, lay_point(edge[0], s.direction)) for s in known)
        return any(s[:2] == spot[:2] and s.low <= spot.low <= s.high for s, spot in spots)
    whole = make_segment(edge)
    return choose_cover(whole, [(s, 0) for s in known if s[:2] == whole[:2]]) is not None


def fits_have_no_room(pair: SweepPair) -> Iterator[str]:
    """Along an exact fit G touches D; at every position next to it, G overlaps D."""
    for p, q in no_fit_polygon(*pair[::-1]).exact_fits:
        t = Point(p.x + SHARE * (q.x - p.x), p.y + SHARE * (q.y - p.y))
        steps = _AROUND if p == q else [(p.y - q.y, q.x - p.x), (q.y - p.y, p.x - q.x)]
        near = [(t.x + STEP * x, t.y + STEP * y) for x, y in steps]
        at, *around = (classify(*pair[::-1], position).verdict for position in (t, *near))
        if (at, {*around}) != ("CONTACT", {"OVERLAP"}):
            yield f"at ({t.x}, {t.y}) on an exact fit: {at}; next to it: {set(around)}"
    yield from functions.no_fit_is_the_definition(pair)


_AROUND = [(Fraction(x), Fraction(y)) for x, y in product((-2, -1, 0, 1, 2), repeat=2) if x or y]


def monotone_fits_are_segments(pair: SweepPair) -> Iterator[str]:
    """No exact fit is a single position."""
    for p, q in sweep(*pair).exact_fits:
        if p == q:
            yield f"the exact fit ({p.x}, {p.y}) is a single position"


def find_held_position(effort: Effort) -> Iterator[Observation]:
    """Show an isolated free position, from which every move leads to an overlap."""
    fits = no_fit_polygon(*HELD[::-1]).exact_fits
    yield Evidence(f"A square in a cavity of the same size: {functions.show_fits(fits)}.")
    yield from fits_have_no_room(HELD)
    if [p == q for p, q in fits] != [True]:
        yield f"a square in a cavity of the same size: exact fits {functions.show_fits(fits)}"


def inner_fit_is_the_definition(pair: SweepPair) -> Iterator[str]:
    """The inner fit agrees with the definition in regions, holes and exact fits."""
    yield from compare_inner_fits(_enlarge(pair.directrix), pair.generatrix)


def compare_inner_fits(container: Region | Ring, part: Ring) -> Iterator[str]:
    yield functions.explain_unproved(inner_fit_polygon(container, part))


def inner_fit_is_in_a_frame(pair: SweepPair) -> Iterator[str]:
    """The inner fit consists of the holes of the no-fit polygon of a frame around the container."""
    container, part = Polygon(_enlarge(pair.directrix)), Polygon(pair.generatrix)
    frame = functions.frame_around(container, part)
    around = no_fit_polygon(frame, part)
    found = inner_fit_polygon(container, part)
    if around.holes != tuple(region.exterior for region in found.regions):
        yield "the frame's no-fit polygon and the inner fit have different regions"

    def is_inside(t: Point) -> bool:
        boxes = frame.bounding_box, part.translated(t).bounding_box
        (left, low), (right, high), (a, b), (c, d) = chain(*boxes)
        return left < a and low < b and c < right and d < high

    if tuple(fit for fit in around.exact_fits if is_inside(fit[0])) != found.exact_fits:
        yield "the frame's no-fit polygon and the inner fit have different exact fits"


def _enlarge(ring: Ring) -> Ring:
    return [(2 * x, 2 * y) for x, y in ring]


def find_touching_loops(effort: Effort) -> Iterator[Observation]:
    """Test containers with touching regions, touching loops, defects, or an exact fit."""
    yield Evidence("Also 5 containers made by hand.")
    for case in CONTAINERS:
        container, part = Region(case["exterior"], case["defects"]), case["part"]
        found = inner_fit_polygon(container, part)
        loops = [loop for region in found.regions for loop in (region.exterior, *region.holes)]
        yield from compare_inner_fits(container, part)
        if [len(region.holes) for region in found.regions] != case["holes"]:
            yield f"{len(loops)} loops"
        if any(point_in_polygon(p, loop) != 0 for p in case["common"] for loop in loops):
            yield f"a loop is off {case['common']}"
        if len(found.exact_fits) != (not loops):
            yield f"exact fits {functions.show_fits(found.exact_fits)}"


def find_room(effort: Effort) -> Iterator[Observation]:
    yield Evidence("Also a cavity in which G can move.")
    yield from loops_are_simple(ROOM)
    if len(holes := no_fit_polygon(*ROOM[::-1]).holes) != 1:
        yield f"{len(holes)} holes, not 1"


def find_unswept(effort: Effort) -> Iterator[Observation]:
    """Show the cavity of Theorem 2.2, with one unswept hole, and two such cavities back to back."""
    corners = CAVITY.directrix
    twice = [*corners[:1], *((x, -y) for x, y in corners[:1:-1]), *corners[1:]]
    yield Evidence(
        "Also the cavity of Theorem 2.2, with one more loop, and two such cavities, with two."
    )
    for number, pair in enumerate((CAVITY, CAVITY._replace(directrix=twice)), 1):
        yield from swept_area_is_the_definition(pair)
        if len(loops := sweep(*pair).unswept) != number:
            yield f"{len(loops)} loops"


def holes(pair: SweepPair) -> int:
    return len(no_fit_polygon(*pair[::-1]).holes)


def count_holes(effort: Effort) -> Iterator[Observation]:
    yield Evidence("A family of forks; a small pair is compared with the definition.")
    yield from functions.no_fit_is_the_definition(SweepPair(*forks(18, 18)))
    sizes = [(6 + 12 * k, 6 + 12 * k) for k in range(1, 3 if effort.quick else 4)]
    bound = BOUNDS["(m - 6)²(n - 6)²"]
    together = grow("holes of the no-fit polygon", forks, bound, sizes, holes)
    for series in (together, *count_all("Size of a no-fit polygon", effort)):
        yield series
        for p in series.points:
            if p.count < ((p.m // 6 - 1) * (p.n // 6 - 1) - 1) ** 2:
                yield f"{p.count} holes for ({p.m}, {p.n}), fewer than proved"


def segments(pair: SweepPair) -> int:
    """Count the contact segments after merging them along each line."""
    return len(find_contact_segments([pair.directrix], [inverse(pair.generatrix)]))


def count_contact_segments(effort: Effort) -> Iterator[Observation]:
    yield Evidence("Contact segments are counted.")
    for series in count_all("Contact segments", effort):
        yield series
        if (most := max(point.ratio for point in series.points)) > 1:
            yield f"the number is {most:.2g} times 2mn"


def edges(pair: SweepPair) -> int:
    return len(no_fit_polygon(*pair[::-1]).exterior)


def convolution(pair: SweepPair) -> int:
    """Count the contact segments of the trajectory and G."""
    scale, path = no_fit_polygon(*pair[::-1]).exterior.lattice()
    moving = [(scale * x, scale * y) for x, y in pair.generatrix]
    return len(find_contact_segments([path], [moving]))


def sum_by_parts(pair: SweepPair) -> int:
    """Count the operations of summing the trajectory and G by convex parts, without pruning."""
    chains = count_chains(pair)
    path = make_counted(kernel.find_trajectory(pair.chains))
    return count_operations(kernel.merge_sub_trajectories, Chains(inverse(chains.bottom), [], path))


def sweep_by_parts(pair: SweepPair) -> int:
    return count_operations(kernel.sweep_outer_cm, *count_chains(pair))


def count_convolution(effort: Effort) -> Iterator[Observation]:
    yield Evidence("Operations and contact segments are counted.")
    summed, swept, *_ = growth = list(count_all("Minkowski sum algorithms", effort))
    yield from growth
    chains = SweepPair(*cm_hard(32, 32)).chains
    found, expected = kernel.find_outer(chains), kernel.sweep_outer_cm(*chains)
    yield functions.describe_difference("the sum of T and G", found, expected)
    last, other = summed.points[-1], swept.points[-1]
    yield Counterexample(
        f"for m = n = {last.m}, summing T and G by convex parts takes {last.count:,} operations, "
        f"SweepO_CM {other.count:,}: both {summed.verdict} with mn",
        "deep teeth, at the largest counted size",
    )


_Angles = dict[Vertex, Cones]


def find_contacts(d: LatticeShape, h: LatticeShape) -> tuple[list[Edge], set[Vertex]]:
    """Find segments and points that contain all positions of contact without overlap.

    Cost: O((m + n) log(m + n)) for m and n edges, and O(1) per segment.
    """
    # A segment is the sum of a vertex of D or of H = -G and an edge of the other shape. It is
    # dropped if an angle at the vertex reaches to the right of the edge: D and G + t overlap there.
    # Two vertices meet at an end of a remaining segment: if two angles have no common direction,
    # one of them lies beyond a side of the other. Where rings touch, a vertex has several angles;
    # these positions need not lie on a segment, and are returned as points.
    shapes = split_where_touching(d), split_where_touching(h)
    one, other = map(find_cones_of, shapes)
    segments = [*_list_sums(one, shapes[1]), *_list_sums(other, shapes[0])]
    pinched_d, pinched_h = ([(p, c) for p, c in of.items() if len(c) > 1] for of in (one, other))
    points = {
        _add(p, q)
        for (p, cones), (q, others) in chain(
            product(pinched_d, other.items()), product(one.items(), pinched_h)
        )
        if not find_common_direction(
            cones, [Cone(_negate(c.start), _negate(c.end)) for c in others]
        )
    }
    return segments, points


def _list_sums(angles: _Angles, walls: LatticeShape) -> Iterator[Edge]:
    """Yield the sums of a vertex and an edge with no angle that reaches to the edge's right."""
    directions = sorted((by_turn(subtract(b, a)), (a, b)) for a, b in list_edges(walls))
    keys = [key for key, _ in directions]
    for v, (cone, *others) in angles.items():
        if not cone.is_wide:
            start, end = by_turn(_negate(cone.end)), by_turn(cone.start)
            k, j = bisect_left(keys, start), bisect_right(keys, end)
            for _, (a, b) in directions[k:j] if start <= end else directions[k:] + directions[:j]:
                right = [Cone(subtract(a, b), subtract(b, a))] if others else []
                if not find_common_direction(others, right):
                    yield _add(v, a), _add(v, b)


def _negate(p: Vertex) -> Vertex:
    return -p[0], -p[1]


def _add(p: Vertex, q: Vertex) -> Vertex:
    return p[0] + q[0], p[1] + q[1]
