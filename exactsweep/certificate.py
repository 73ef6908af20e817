"""Certificates: a sweep with the reasons for every edge of its loops, as plain JSON data.

All numbers are strings, reduced rationals; all indices count the vertices as the certificate lists
them, edge k running from vertex k to the next.  The trajectory and the exact fits are positions of
the reference point.  What each list claims, and what has to be checked so that the claims together
prove the sweep, is said in `exactsweep.check.verify`, which shares no code with this side.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from exactsweep.contact import edges_of
from exactsweep.number import format_fraction
from exactsweep.polygon import ORIGIN, Point, Polygon

if TYPE_CHECKING:
    from exactsweep.sweep import Sweep

FORMAT = "exactsweep certificate"
VERSION = 1


def certificate(s: Sweep) -> dict[str, Any]:
    """Write the certificate of a sweep.

    Returns:
        A dict ready for `json.dump`: the input (`generatrix`, `directrix`, `reference`,
        `direction`), the answer (`kind`, `trajectory`, `inner`, `outer`, `area`, `exact_fits`) and
        its reasons: `contacts`, for each edge of the trajectory its contacts as [event, feature of
        G, feature of D]; `inner_drawn` and `outer_drawn`, for each edge of the loop what draws it
        as [[where on the trajectory], [feature of G]].

    Cost: O(m n + s) look-ups for s edges of all loops, besides the sweep itself.

    Example:
        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> proof = certificate(sweep(square, square))
        >>> proof["contacts"][0], proof["outer_drawn"][0]
        ([['EE', 2, 0]], [[['edge', 0], ['edge', 0]]])
    """
    return {
        "format": FORMAT,
        "version": VERSION,
        "generatrix": _points(s.generatrix.vertices),
        "directrix": _points(s.directrix.vertices),
        "kind": s.kind,
        "direction": list(s.direction),
        "reference": _point(s.reference),
        "trajectory": _points(s.trajectory.vertices),
        "inner": _points(s.inner.vertices),
        "outer": _points(s.outer.vertices),
        "area": format_fraction(s.area),
        "exact_fits": [_points(fit) for fit in s.exact_fits],
        "contacts": [[list(c) for c in found] for found in s._numbered_contacts],
        "inner_drawn": _drawn(s, s.inner),
        "outer_drawn": _drawn(s, s.outer),
    }


def _drawn(s: Sweep, loop: Polygon) -> list[list[list[list[str | int]]]]:
    edges = edges_of(s._frame.raised(loop.vertices, ORIGIN))
    return [[[list(p), list(f)] for p, f in s._tracer.trace(edge)] for edge in edges]


def _points(points: Sequence[Point]) -> list[list[str]]:
    return [_point(point) for point in points]


def _point(point: Iterable[Any]) -> list[str]:
    return [format_fraction(c) for c in point]
