"""Proving a certificate from the definition alone.

A certificate with the key `claim` is for polygons of any shape: `claim` describes it, and
`claim` proves it. The others are sweeps of monotone polygons, and the rest is about them.

With P = D + I(G), the Minkowski sum, a certificate says where three loops run:

    trajectory   the boundary of P
    outer loop   the boundary of P + G
    inner loop   the boundary of P eroded by I(G): of the points p with p + I(G) in P

All these regions are weakly monotone to the shared direction: lines perpendicular to it meet them
in one piece. The checks below, in this order, prove them, and what goes with them.

1. All loops are canonical, simple and monotone.
2. Trajectory. Its edges are drawn by contacts, features of D and of I(G), so it lies in P; lines
   perpendicular to the direction meet P in one piece, so its region is in P. And P is in its
   region, by the lemma of `sums`.
3. Outer loop. The same with P and G in place of D and I(G).
4. Inner loop, with its region Q. That Q + I(G) is in P, again by the lemma, says that Q is in the
   eroded region E. Its edges are drawn by G on the trajectory, through points t + g with t on the
   boundary of P. Such a point is never inside E, or t would be inside P. So the inside of E, which
   the inner loop does not enter, is all in Q. (It is in one piece: perpendiculars lead from
   anywhere in it to the inside of D.)
5. The exact fits are those of the definition; the area is that between the loops.

That the loops are nested follows: D is in E, for D + I(G) = P; E is in P + G, for p + I(G) in P.

Two steps more. G sweeps P + G less the inside of E along the boundary T of P: a point p is in T + G
if the connected set p + I(G) meets T, that is, if it meets P and is not inside P. Perpendiculars
meet P, P + G and E in one interval each: sums have sums of intervals as sections, and E, which all
P - g have in common for g in I(G), has intersections of intervals.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from exactsweep.check.area import check_area
from exactsweep.check.certificate import Certificate, CertificateError, read
from exactsweep.check.claim import prove_claim
from exactsweep.check.contacts import check_contacts
from exactsweep.check.cover import check_drawings
from exactsweep.check.fits import count_pairs, find_places, list_exact_fits
from exactsweep.check.loop import MonotoneLoop, NodeFrame
from exactsweep.check.size import check_reading, check_size, find_common_scale
from exactsweep.check.standalone import Refused, Ring, check_given, node, prove
from exactsweep.check.sums import check_sum_within, count_steps
from exactsweep.numbers.arguments import tells_arguments
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import to_fraction
from exactsweep.numbers.point import ORIGIN, Fit, Point

# About a microsecond each.
_MAX_STEPS = 10**8
_PLAIN = (str, int, float, bool, type(None), dict, list)


class Verification(NamedTuple):
    """The verdict on a certificate: proved, or the first thing that is wrong with it.

    The witness, if there is one, is a point of the loop or edge that the reason speaks of, or in
    its way. For the trajectory, contacts and exact fits it is a translation of G, without regard to
    the reference point; so it is where the reason has G moved into the inner loop.
    """

    proved: bool
    reason: str
    witness: Point | None


@tells_arguments
def verify(
    certificate: Any,
    *,
    generatrix: Any = None,
    directrix: Any = None,
    part: Any = None,
    container: Any = None,
    max_steps: int = _MAX_STEPS,
) -> Verification:
    """Decide whether a certificate proves its answer, from the definition alone.

    Args:
        certificate: as `json.loads` gives it, from any source. With a `proof`, the checker that
            stands alone has to prove it, too; layouts are proved by that alone.
        generatrix: the polygon G that the certificate should be about: a Polygon, its vertices or a
            Region. If left out, the certificate may be about any.
        directrix: D, likewise.
        part: that of an inner fit, likewise.
        container: likewise.
        max_steps: the most work to do, in steps of about a microsecond. A certificate that needs
            more is not proved. `verify` refuses it before the work begins or, if it is about
            polygons of any shape and too many pieces meet, after that many steps.

    Returns:
        Verification. The reason is "proved", or says which loop, edge or list is wrong. No
        certificate makes `verify` raise an exception.

    Raises:
        ExactSweepError: a polygon that is none, or `max_steps` that is no int above 0.

    Cost: with m and n edges, a look-up for each edge and corner that may touch, and each pair of
    convex corners that have a slope in common, O(m + n) for convex polygons and O(mn) for others;
    k (m + n) steps for k concave corners of the trajectory, k (t + n) for k of the outer loop
    around a trajectory of t edges (of m and t those only that are over G). For polygons of any
    shape that of `reference_no_fit` and its like, by pieces that meet.
    Source: Definitions 1.1 to 1.3, Theorems 2.1 and 2.2, Lemma 5.3 as far as it holds.

    >>> verify({"format": "exactsweep certificate"})
    Verification(proved=False, reason="the key 'version' is missing", witness=None)
    """
    if type(max_steps) is not int or max_steps < 1:
        raise ExactSweepError("max_steps must be an int, at least 1")
    given = {
        name: _read_given(shape)
        for name, shape in (
            ("generatrix", generatrix),
            ("directrix", directrix),
            ("part", part),
            ("container", container),
        )
        if shape is not None
    }
    try:
        _verify(certificate, max_steps)
        for name, rings in given.items():
            check_given(certificate, name, rings)
    except CertificateError as flaw:
        return Verification(False, str(flaw), flaw.witness)
    except Refused as refused:
        return Verification(False, str(refused), None)
    return Verification(True, "proved", None)


def _verify(certificate: Any, max_steps: int) -> None:
    _check_types(certificate)
    check_reading(certificate, max_steps)
    if type(certificate) is dict and "layout" in certificate:
        prove(certificate, max_steps)
        return
    if type(certificate) is not dict:
        raise CertificateError(f"a certificate is an object, not a {type(certificate).__name__}")
    claim = {key: item for key, item in certificate.items() if key != "proof"}
    if "claim" in claim:
        prove_claim(claim, max_steps)
    else:
        _prove(read(claim), max_steps)
    if len(claim) < len(certificate):
        prove(certificate, max_steps)


def _check_types(certificate: Any) -> None:
    """Refuse types that `json.loads` does not return: their methods could do anything."""
    left, seen = [certificate], set()
    while left:
        item = left.pop()
        if type(item) in (dict, list) and id(item) not in seen:
            seen.add(id(item))  # a list may hold itself
            left += [*item, *item.values()] if type(item) is dict else item
        elif type(item) not in _PLAIN:
            raise CertificateError(f"a {type(item).__name__} is not JSON")


def _read_given(shape: Any) -> list[Ring]:
    rings = (shape.exterior, *shape.holes) if hasattr(shape, "holes") else (shape,)
    try:
        return [
            [node(*map(to_fraction, p)) for p in getattr(points, "vertices", points)]
            for points in rings
        ]
    except TypeError:
        raise ExactSweepError(f"a {type(shape).__name__} is no polygon and no Region") from None


def _prove(c: Certificate, max_steps: int) -> None:
    frame = NodeFrame(c.direction, find_common_scale(c.generatrix + c.directrix))
    placed = {
        "generatrix": frame.enter(c.generatrix, ORIGIN),
        "directrix": frame.enter(c.directrix, ORIGIN),
        "trajectory": frame.enter(c.trajectory, c.reference),
        "inner": frame.enter(c.inner, ORIGIN),
        "outer": frame.enter(c.outer, ORIGIN),
    }
    check_size(placed.values(), 0, max_steps)
    g, d, trajectory, inner, outer = (
        MonotoneLoop(nodes, name, frame) for name, nodes in placed.items()
    )
    inverse = g.turn_half()
    sums = [(trajectory, d, inverse), (outer, trajectory, g), (trajectory, inner, inverse)]
    steps = sum(count_steps(*loops) for loops in sums) + count_pairs(d, inverse)
    check_size(placed.values(), steps, max_steps)
    places = find_places(d, inverse)
    check_size(placed.values(), steps + len(places) * (len(g.nodes) + len(d.nodes)), max_steps)

    kind = "MM" if not g.is_convex else "CC" if d.is_convex else "CM"
    if c.kind != kind:
        raise CertificateError(f"kind: it is {kind}, not {c.kind}")

    check_contacts(trajectory, d, inverse, c.contacts, frame)
    check_sum_within(
        *(trajectory, d, inverse, frame),
        "trajectory: the contact of directrix vertex {} and generatrix vertex {} is outside",
        "trajectory: G overlaps D at vertex {} or beside it",
    )
    _check_fits(list_exact_fits(places, frame), c)

    check_drawings("outer_drawn", outer, trajectory, g, c.outer_drawn, frame)
    check_sum_within(
        *(outer, trajectory, g, frame),
        "outer: with G at trajectory vertex {} its vertex {} is outside",
        "outer: vertex {}, or the boundary beside it, is inside the area swept",
    )

    check_drawings("inner_drawn", inner, trajectory, g, c.inner_drawn, frame)
    check_sum_within(
        *(trajectory, inner, inverse, frame),
        "inner: at vertex {} generatrix vertex {} can be put, and G is free of D",
        "inner: at trajectory vertex {}, or beside it, G cuts into the region inside",
    )
    check_area(c.area, outer.nodes, [inner.nodes], frame.unit_area)


def _check_fits(found: list[Fit], c: Certificate) -> None:
    x0, y0 = c.reference
    listed = [
        (Point(ax - x0, ay - y0), Point(bx - x0, by - y0)) for (ax, ay), (bx, by) in c.exact_fits
    ]
    true, claimed = set(found), set(listed)
    for k, fit in enumerate(listed):
        if fit not in true:
            raise CertificateError(f"exact_fits[{k}]: not an exact fit, from end to end", fit[1])
    for fit in found:
        if fit not in claimed:
            raise CertificateError("exact_fits: one is missing", fit[1])
    if listed != found:
        raise CertificateError("exact_fits: not sorted, or one is listed twice")
