"""Proving that a no-fit polygon, an inner fit or the area of a sweep is right, and complete.

1. Input. D and G are polygons with holes: rings are simple, touch at most in points, holes lie
   inside the exterior and apart from each other, and the interior is connected.
2. Loops. Each claimed loop is simple and canonical.
3. Nothing is invented. All loops and fits run along the boundary of the overlap O, as `no_fit`
   proves it to be: the free parts of all contact segments. Where one does not, G overlaps D, or
   is apart from it, and that position is the witness.
4. Nothing is missed. All of that boundary is on claimed loops and fits. A hole that was left out
   would have its boundary there, and an exact fit, a single position, too, is boundary itself;
   the witness is a position of contact without overlap that is in none of the lists.
5. Nothing is mistaken for another. Where the claim is drawn along the true boundary, each edge
   has O on one side or on both, so it is known whether it bounds a hole or is an exact fit. Since
   O is connected, loops touch like the rings of a cactus, and the boundary is made of simple loops
   in one way only; where O is not connected, regions are the components of free space, and their
   boundary is cut where it would visit a point twice. So loops, fits, their ends and the order of
   the lists are those of `no_fit`. Two loops written as one, a hole written as a ring of fits, a
   fit written in two parts: each is refused, with a position on it.
6. Area swept. The loops are those of T + G, with T the exterior proved before: steps 3 to 5 with
   T in the place of D. The inner loop is the one around D; the area lies between the loops.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import lcm

from exactsweep.check.area import check_area
from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import Node
from exactsweep.check.claim import ClaimedShape, InnerFitClaim, NoFitClaim, ShapeClaim, SweepClaim
from exactsweep.check.claimed_shape import check_loop, check_shape
from exactsweep.check.classify import classify
from exactsweep.check.difference import LoopOrFit, compare
from exactsweep.check.monotone import has_shared_direction
from exactsweep.check.no_fit import find_inner_fit, find_no_fit, find_swept
from exactsweep.check.shape import list_rings
from exactsweep.check.size import Budget, measure_size
from exactsweep.geometry.polygon import Polygon
from exactsweep.numbers.point import Fit, Loop, Point

# Steps to see that a loop is simple at a vertex, and where its edge is.
_VERTEX = 100


def prove_claim(claim: ShapeClaim, max_steps: int) -> None:
    """Prove a claim by steps 1 to 6.

    Raises:
        CertificateError: the first thing that is wrong, with a witness.

    Cost: that of `reference_no_fit`, `reference_inner_fit` and `reference_swept`.
    """
    budget = Budget(max_steps)
    if isinstance(claim, NoFitClaim):
        _prove_no_fit(claim, budget)
    elif isinstance(claim, InnerFitClaim):
        _prove_inner_fit(claim, budget)
    else:
        _prove_sweep(claim, budget)


def _prove_no_fit(c: NoFitClaim, budget: Budget) -> None:
    claimed = _parts_of_no_fit(c.exterior, c.holes, c.exact_fits)
    _check_size(c.directrix, c.generatrix, claimed, budget)
    check_shape(c.directrix, "directrix")
    check_shape(c.generatrix, "generatrix")
    _check_loops(claimed)
    true = _parts_of_no_fit(*find_no_fit(list_rings(c.directrix), list_rings(c.generatrix), budget))

    def say(t: Point) -> str:
        verdict = classify(c.directrix, c.generatrix, t).verdict
        return "G overlaps D" if verdict == "OVERLAP" else "G does not touch D"

    compare(claimed, true, say, budget)


def _prove_inner_fit(c: InnerFitClaim, budget: Budget) -> None:
    claimed = _parts_of_inner_fit(c.regions, c.exact_fits)
    _check_size(c.container, c.part, claimed, budget)
    check_shape(c.container, "container")
    check_shape(c.part, "part")
    _check_loops(claimed)
    found = find_inner_fit(list_rings(c.container), list_rings(c.part), budget)
    regions = [ClaimedShape(*region) for region in found.regions]
    compare(
        claimed,
        _parts_of_inner_fit(regions, found.exact_fits),
        lambda _: "the part is not inside the container, or does not touch it",
        budget,
    )
    for k, (region, right) in enumerate(zip(c.regions, regions, strict=True)):
        if region != right:
            raise CertificateError(f"regions[{k}]: not sorted, or a hole is in the wrong region")


def _prove_sweep(c: SweepClaim, budget: Budget) -> None:
    d, g = c.no_fit.directrix, c.no_fit.generatrix
    claimed = _parts_of_sweep(c.outer, c.inner, c.unswept)
    _check_size(ClaimedShape(c.no_fit.exterior, ()), g, claimed, budget)
    _prove_no_fit(c.no_fit, budget)
    if not d.holes and not g.holes and has_shared_direction([d.exterior, g.exterior]):
        raise CertificateError("kind: there is a shared direction, so it is not SS")
    _check_loops(claimed)
    exterior = Polygon(c.no_fit.exterior)
    true = _parts_of_sweep(*find_swept(list_rings(d), list_rings(g), exterior, budget))
    compare(claimed, true, lambda _: "it is not on the boundary of the area swept", budget)
    check_area(c.area, _nodes(c.outer), [*map(_nodes, (c.inner, *c.unswept))])


# --- Size and form -------------------------------------------------------------------------------


def _check_size(
    d: ClaimedShape, g: ClaimedShape, parts: Sequence[LoopOrFit], budget: Budget
) -> None:
    """Refuse at once what would take too long in any case: all loops, and all pairs of edges."""
    rings = [d.exterior, *d.holes, g.exterior, *g.holes]
    loops = [_nodes(points) for points in (*rings, *(part.points for part in parts))]
    m, n = (len(s.exterior) + sum(map(len, s.holes)) for s in (d, g))
    listed = sum(map(len, loops))
    budget.take(measure_size(loops, _VERTEX * listed + 3 * m * n + m * m + n * n))


def _nodes(points: Iterable[Point]) -> list[Node]:
    nodes = []
    for x, y in points:
        w = lcm(x.denominator, y.denominator)
        nodes.append((int(x * w), int(y * w), w))
    return nodes


def _check_loops(parts: Iterable[LoopOrFit]) -> None:
    for part in parts:
        if part.is_loop:
            check_loop(part.points, part.name)


def _parts_of_no_fit(exterior: Loop, holes: Sequence[Loop], fits: Sequence[Fit]) -> list[LoopOrFit]:
    return [
        LoopOrFit("exterior", "exterior", exterior, True),
        *_loops_of("holes", holes),
        *_fits_of(fits),
    ]


def _parts_of_inner_fit(regions: Sequence[ClaimedShape], fits: Sequence[Fit]) -> list[LoopOrFit]:
    parts = []
    for k, (exterior, holes) in enumerate(regions):
        parts.append(LoopOrFit("regions", f"regions[{k}].exterior", exterior, True))
        parts += _loops_of(f"regions[{k}].holes", holes, "holes of regions")
    return parts + _fits_of(fits)


def _parts_of_sweep(outer: Loop, inner: Loop, unswept: Sequence[Loop]) -> list[LoopOrFit]:
    named = ("outer", outer), ("inner", inner)
    parts = [LoopOrFit(name, name, points, True) for name, points in named]
    return parts + _loops_of("unswept", unswept)


def _loops_of(name: str, loops: Sequence[Loop], group: str = "") -> list[LoopOrFit]:
    return [LoopOrFit(group or name, f"{name}[{k}]", p, True) for k, p in enumerate(loops)]


def _fits_of(fits: Sequence[Fit]) -> list[LoopOrFit]:
    return [LoopOrFit("exact_fits", f"exact_fits[{k}]", fit, False) for k, fit in enumerate(fits)]
