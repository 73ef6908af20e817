"""Answers that the checker of certificates proves, in the place of a second computation."""

from typing import Any, NamedTuple

from exactsweep import Point, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.check import verify

Loop = tuple[Point, ...]
Fits = tuple[tuple[Point, Point], ...]


class ReferenceNoFit(NamedTuple):
    exterior: Loop
    holes: tuple[Loop, ...]
    exact_fits: Fits


class ReferenceInnerFit(NamedTuple):
    regions: tuple[tuple[Loop, tuple[Loop, ...]], ...]
    exact_fits: Fits


class ReferenceSwept(NamedTuple):
    outer: Loop
    inner: Loop
    unswept: tuple[Loop, ...]


def reference_no_fit(d: Any, g: Any) -> ReferenceNoFit:
    n = no_fit_polygon(d, g)
    _require_proof(n)
    holes = tuple(hole.vertices for hole in n.holes)
    return ReferenceNoFit(n.exterior.vertices, holes, n.exact_fits)


def reference_inner_fit(container: Any, part: Any) -> ReferenceInnerFit:
    f = inner_fit_polygon(container, part)
    _require_proof(f)
    regions = tuple((r.exterior.vertices, tuple(h.vertices for h in r.holes)) for r in f.regions)
    return ReferenceInnerFit(regions, f.exact_fits)


def reference_swept(d: Any, g: Any) -> ReferenceSwept:
    s = sweep(g, d)
    _require_proof(s)
    unswept = tuple(loop.vertices for loop in s.unswept)
    return ReferenceSwept(s.outer.vertices, s.inner.vertices, unswept)


def _require_proof(answer: Any) -> None:
    verdict = verify(answer.certificate())
    assert verdict.proved, verdict
