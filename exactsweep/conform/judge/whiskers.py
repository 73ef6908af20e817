"""Exact fits that are traced as whiskers: a ring that goes along a fit and straight back.

Programs that orbit, moving G along D from contact to contact, go into a slot that fits exactly and
come back the same way. The ring that they leave has a spike for each fit.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from exactsweep.numbers.point import Fit, Loop, Point


def strip_whiskers(
    rings: Sequence[Loop], fits: Sequence[Fit]
) -> tuple[tuple[Loop, ...], list[Fit]]:
    """Take spikes that lie on exact fits from rings.

    Args:
        rings: as answered.
        fits: the exact fits.

    Returns:
        The rings without these spikes, and the spikes, each as a segment. Other spikes stay.

    Cost: O(n^2) for rings of n vertices with as many spikes, else O(n f) for f fits.

    Example:
        >>> from fractions import Fraction
        >>> ring = [(0, 0), (4, 0), (4, 4), (2, 4), (2, 1), (2, 4), (0, 4)]
        >>> points = tuple(Point(Fraction(x), Fraction(y)) for x, y in ring)
        >>> (left,), whiskers = strip_whiskers([points], [(points[3], points[4])])
        >>> len(points), len(left), len(whiskers)
        (7, 5, 1)
    """
    whiskers: list[Fit] = []
    return tuple(_strip(ring, fits, whiskers) for ring in rings), whiskers


def _strip(ring: Loop, fits: Sequence[Fit], whiskers: list[Fit]) -> Loop:
    points = [p for k, p in enumerate(ring) if p != ring[k - 1]]
    k = 0
    while k < len(points) and len(points) > 2:
        before, tip, after = points[k - 1], points[k], points[(k + 1) % len(points)]
        if not _is_spike(before, tip, after):
            k += 1
            continue
        base = before if is_on(before, (tip, after)) else after
        if not any(is_on(tip, fit) and is_on(base, fit) for fit in fits):
            k += 1
            continue
        whiskers.append((base, tip))
        del points[k]
        points = [p for j, p in enumerate(points) if p != points[j - 1]]
        # What was before the tip may be a tip now.
        k = max(0, k - 2)
    return tuple(points)


def trace_whiskers(rings: Sequence[Loop], fits: Iterable[Fit]) -> tuple[Loop, ...]:
    """Return rings with each fit that hangs on one of them traced as a whisker of it. Cost: O(nf).

    A fit hangs on a ring by its first end.
    """
    grown = [list(ring) for ring in rings]
    for hanging, inside in fits:
        for ring in grown:
            k = next((k for k, b in enumerate(ring) if is_on(hanging, (ring[k - 1], b))), None)
            if k is not None:
                ring[k:k] = [hanging, inside, hanging]
                break
    return tuple(map(tuple, grown))


def is_on(point: Point, segment: Fit) -> bool:
    """Whether a point is on a segment, ends included."""
    (ax, ay), (bx, by) = segment
    x, y = point
    return (
        (bx - ax) * (y - ay) == (by - ay) * (x - ax)
        and min(ax, bx) <= x <= max(ax, bx)
        and min(ay, by) <= y <= max(ay, by)
    )


def _is_spike(before: Point, tip: Point, after: Point) -> bool:
    ux, uy, vx, vy = tip.x - before.x, tip.y - before.y, after.x - tip.x, after.y - tip.y
    return ux * vy == uy * vx and ux * vx + uy * vy < 0
