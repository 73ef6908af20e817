"""Which contacts stop G: those through which it cannot move on, however little, without overlap.

Near a contact both polygons are cones, a half-plane at the inside of an edge.  Moved by a short
step, G overlaps D there exactly when the step lies in the sum of D's open cone and of G's turned
by half a turn.  A step along an edge in contact is on the boundary of that sum, and so allowed.
"""

from __future__ import annotations

from collections.abc import Sequence

from exactsweep.chain import Rational, Vertex
from exactsweep.contact import Contact, minus


def blocks(
    contact: Contact, step: Vertex, generatrix: Sequence[Vertex], directrix: Sequence[Vertex]
) -> bool:
    """Whether G overlaps D at a contact after any short enough move.

    Args:
        contact: of G, where it is now, with D; they do not overlap.
        step: the direction of the move, a vector.
        generatrix: loop of G, counter-clockwise, by which its features are numbered.
        directrix: loop of D, likewise.

    Cost: O(1).

    Example:
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> on_top = Contact("EE", 0, 2)
        >>> [blocks(on_top, step, square, square) for step in [(1, 0), (1, 1), (1, -1)]]
        [False, False, True]
    """
    event, i, j = contact
    if event == "EV":
        _, forward = _rays(generatrix, i)
        return _cross(forward, step) < 0
    if event != "VV":
        _, forward = _rays(directrix, j)
        return _cross(forward, step) > 0
    g_back, g_forward = _rays(generatrix, i)
    d_back, d_forward = _rays(directrix, j)
    back = minus((0, 0), step)
    # In a reflex corner, the other polygon can only move as its free cone, convex, allows.
    if _cross(d_forward, d_back) < 0:
        return _cross(d_back, step) < 0 or _cross(step, d_forward) < 0
    if _cross(g_forward, g_back) < 0:
        return _cross(g_back, back) < 0 or _cross(back, g_forward) < 0
    # Two convex cones without overlap: their sum is convex, at most a half-plane.
    rays = [d_forward, d_back, minus((0, 0), g_forward), minus((0, 0), g_back)]
    first = next(r for r in rays if all(_cross(r, other) >= 0 for other in rays))
    last = next(r for r in rays if all(_cross(r, other) <= 0 for other in rays))
    return _cross(first, step) > 0 and _cross(step, last) > 0


def _rays(loop: Sequence[Vertex], k: int) -> tuple[Vertex, Vertex]:
    """From vertex k, the ways to the previous and to the next vertex."""
    here = loop[k]
    return minus(loop[k - 1], here), minus(loop[(k + 1) % len(loop)], here)


def _cross(p: Vertex, q: Vertex) -> Rational:
    return p[0] * q[1] - p[1] * q[0]
