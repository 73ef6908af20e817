"""All answers for a pair compared with the definition."""

from collections.abc import Callable, Iterator, Sequence
from itertools import product
from math import lcm
from random import Random
from typing import Any

from small_pairs import Shape, SmallPair, shares_direction

import exactsweep
from exactsweep import DirectionError, Point, Region
from exactsweep.check import classify, point_in_polygon, verify
from exactsweep.evidence.certificate import claim_inner_fit, claim_no_fit, claim_sweep
from exactsweep.evidence.proof import add_proof
from exactsweep.numbers.number import Vertex
from exactsweep.paper.definition import reference_exact_fits, reference_loops

Fit = tuple[Point, Point]
DIRECTIONS = [(1, 0), (0, 1), (1, 1), (1, -1), (3, 4), (1, -2), (3, -1)]


def find_failure(pair: SmallPair, *, deep: bool = False, kernel: Any = exactsweep) -> str:
    """Describe a difference from the definition: of loops, if deep of all answers; "" if none."""
    checks: list[Callable[[SmallPair, Any], Iterator[str]]] = [_loops]
    if deep:
        checks += [_inner_fit, _reasons, _certificates, _classification]
    try:
        s = kernel.sweep(*_shapes(pair, kernel))
        return next((failure for check in checks for failure in check(pair, (kernel, s))), "")
    except Exception as error:
        return f"{type(error).__name__}: {error}"


def _is_proved(claim: dict[str, Any]) -> bool:
    return verify(add_proof(claim)).proved


def _claim_no_fit(pair: SmallPair, exterior: Any, holes: Any, fits: Any) -> dict[str, Any]:
    g, d = map(Region, _shapes(pair))
    return claim_no_fit(d, g, exterior, holes, fits)


def _loops(pair: SmallPair, answered: Any) -> Iterator[str]:
    kernel, s = answered
    g, d = _shapes(pair)
    if shares_direction(pair) != (s.kind != "SS"):
        yield f"kind {s.kind}"
    if s.kind == "SS":
        n = kernel.no_fit_polygon(*reversed(_shapes(pair, kernel)))
        if not _is_proved(_claim_no_fit(pair, n.exterior, n.holes, n.exact_fits)):
            yield "no-fit polygon"
        return
    for name, loop in reference_loops(g, d, s.direction)._asdict().items():
        if getattr(s, name).vertices != loop:
            yield f"{name}, swept in direction {s.direction}"
    if s.exact_fits != reference_exact_fits(g, d, s.direction):
        yield f"exact fits, swept in direction {s.direction}"


def _inner_fit(pair: SmallPair, answered: Any) -> Iterator[str]:
    kernel, s = answered
    g, d = map(Region, _shapes(pair))
    f = kernel.inner_fit_polygon(*reversed(_shapes(pair, kernel)))
    if not _is_proved(claim_inner_fit(d, g, f.regions, f.exact_fits)):
        yield "inner fit"
    no_fit = _claim_no_fit(pair, s.trajectory, s.no_fit_holes, s.exact_fits)
    if not _is_proved(claim_sweep(no_fit, s.inner, s.outer, s.unswept, s.area)):
        yield "swept area"


def _reasons(pair: SmallPair, answered: Any) -> Iterator[str]:
    kernel, s = answered
    g, d = _shapes(pair)
    if not all(s.contacts):
        yield "an edge of the trajectory without contact"
    # Features are numbered as they are given here.
    touching = kernel.sweep(*(_shape(_rings(shape), kernel) for shape in (g, d)))
    for t in (*s.trajectory.vertices, *(end for fit in s.exact_fits for end in fit)):
        if {*touching.contacts_at(t)} != find_contacts(_rings(g), _rings(d), t):
            yield f"contacts at {t}"
    for fit in s.exact_fits:
        if not is_exact_fit(g, d, fit):
            yield f"{fit} is not an exact fit"
    if s.kind == "SS":
        return
    if sum(u.polygon.area for u in s.undercuts) + d.area != s.inner.area:
        yield "areas of the undercuts"
    for undercut in s.undercuts:
        if classify(d, undercut.polygon, (0, 0)).verdict != "CONTACT":
            yield f"{undercut.polygon} is not an undercut of D"
        for extreme in undercut.extremes:
            if point_in_polygon(extreme, d) or point_in_polygon(extreme, s.inner):
                yield f"{extreme} is not an extreme contact point"
        for position in undercut.positions:
            if point_in_polygon(position, s.trajectory):
                yield f"{position} closes an undercut but is not on the trajectory"
    for direction in DIRECTIONS:
        try:
            other = kernel.sweep(*_shapes(pair, kernel), direction=direction)
        except DirectionError:
            continue
        for name in ("trajectory", "inner", "outer", "exact_fits"):
            if getattr(other, name) != getattr(s, name):
                yield f"{name}, swept in direction {direction}"


def _certificates(pair: SmallPair, answered: Any) -> Iterator[str]:
    """Require a proved certificate for every answer."""
    kernel, s = answered
    g, d = _shapes(pair, kernel)
    for answer in (s, kernel.inner_fit_polygon(d, g), kernel.no_fit_polygon(d, g)):
        if not (result := verify(answer.certificate())).proved:
            yield f"certificate: {result.reason}"


def _classification(pair: SmallPair, answered: Any) -> Iterator[str]:
    """Compare the answer with `classify` at positions on and between the loops."""
    kernel, _ = answered
    g, d = _shapes(pair)
    n = kernel.no_fit_polygon(*reversed(_shapes(pair, kernel)))
    rng = Random(repr(pair))
    points = [p for loop in (n.exterior, *n.holes) for p in loop.vertices]
    points += [p for fit in n.exact_fits for p in fit]
    for _ in range(10):
        p, q = rng.choice(points), rng.choice(points)
        t = Point((p.x + q.x) / 2, (p.y + q.y) / 2)
        if (found := classify(d, g, t).verdict.lower()) != n.locate(t):
            yield f"classify says {found} at {t}, not {n.locate(t)}"


def is_exact_fit(generatrix: Any, directrix: Any, fit: Fit) -> bool:
    """Decide whether a segment is in contact, with overlap on both sides, at three points."""
    (ax, ay), (bx, by) = fit
    x, y = (ax + bx) / 2, (ay + by) / 2
    dx, dy = (by - ay) / 10**40, (ax - bx) / 10**40
    touching = all(classify(directrix, generatrix, t).verdict == "CONTACT" for t in (*fit, (x, y)))
    if (ax, ay) == (bx, by):
        return touching
    aside = ((x + dx, y + dy), (x - dx, y - dy))
    return touching and all(classify(directrix, generatrix, t).verdict == "OVERLAP" for t in aside)


def find_contacts(
    generatrix: Sequence[Sequence[Vertex]], directrix: Sequence[Sequence[Vertex]], t: Vertex
) -> set[tuple[str, int, int]]:
    """List the contacts of G + t with D by trying all pairs of features.

    Vertices are numbered ring by ring, and edge i runs from vertex i.
    """
    unit = lcm(*(c.denominator for ring in (*generatrix, *directrix, [t]) for p in ring for c in p))
    corners, sides = _features(generatrix, t, unit)
    others, walls = _features(directrix, (0, 0), unit)
    found = {("VV", i, j) for (i, v), (j, w) in product(corners, others) if v == w}
    found |= {("EV", i, j) for (i, e), (j, w) in product(sides, others) if _is_inside(w, e)}
    found |= {("VE", i, j) for (i, v), (j, f) in product(corners, walls) if _is_inside(v, f)}
    found |= {("EE", i, j) for (i, e), (j, f) in product(sides, walls) if _run_along(e, f)}
    return found


Edge = tuple[Vertex, Vertex]


def _features(
    rings: Sequence[Sequence[Vertex]], by: Vertex, unit: int
) -> tuple[list[tuple[int, Vertex]], list[tuple[int, Edge]]]:
    """List the numbered vertices and edges of moved rings, in ints."""
    plain = [[(int((x + by[0]) * unit), int((y + by[1]) * unit)) for x, y in r] for r in rings]
    edges = [e for ring in plain for e in zip(ring, ring[1:] + ring[:1], strict=True)]
    return list(enumerate(v for ring in plain for v in ring)), list(enumerate(edges))


def _cross(a: Vertex, b: Vertex, c: Vertex) -> Any:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _is_inside(p: Vertex, edge: Edge) -> bool:
    return min(edge) < p < max(edge) and _cross(*edge, p) == 0


def _run_along(e: Edge, f: Edge) -> bool:
    in_line = _cross(*e, f[0]) == _cross(*e, f[1]) == 0
    return in_line and max(min(e), min(f)) < min(max(e), max(f))


def _rings(shape: Any) -> list[list[Vertex]]:
    rings = (shape.exterior, *shape.holes) if hasattr(shape, "holes") else (shape,)
    return [[*ring.vertices] for ring in rings]


def _shapes(pair: SmallPair, kernel: Any = exactsweep) -> tuple[Any, Any]:
    return _shape(pair.generatrix, kernel), _shape(pair.directrix, kernel)


def _shape(shape: Shape | list[list[Vertex]], kernel: Any) -> Any:
    return kernel.Region(shape[0], shape[1:]) if shape[1:] else kernel.Polygon(shape[0])
