"""No-fit polygons and Minkowski sums of shapes with holes, in doubles, for small cases.

Put your own code in place of `no_fit`; or of `minkowski_sum`, if it computes a + b.
"""

import json
import sys
from cmath import phase
from itertools import pairwise
from math import pi
from typing import Any

HELLO = {
    "hello": "doubles.py",
    "questions": ["no_fit", "minkowski_sum"],
    "shapes": "any",
    "numbers": "binary64",
    "reference": "given",
}
MOST = 800
"""Maximum number of pairs of edges; the time grows with its square."""

Contour = list[tuple[float, float]]
Contours = list[Contour]
"""A polygon: its exterior, then its holes, in either orientation."""
ComplexLine = tuple[complex, complex]
ComplexRings = list[list[complex]]
"""Rings of complex numbers, with the interior on the left."""


def no_fit(d: Contours, g: Contours, reference: tuple[float, float]) -> Contours:
    """Return the rings around the positions of the reference point at which g overlaps d."""
    return scale(minkowski_sum(d, scale(g, -1)), 1, *reference)


def scale(shape: Contours, k: float, x: float = 0, y: float = 0) -> Contours:
    """Scale a shape by k, and translate it by (x, y)."""
    return [[(k * u + x, k * v + y) for u, v in ring] for ring in shape]


def minkowski_sum(a: Contours, b: Contours) -> Contours:
    """Return the rings of a + b: edges of each at convex corners of the other, cut and filtered."""
    size = max(abs(c) for ring in (*a, *b) for p in ring for c in p)
    if not 1e-70 < size < 1e70:
        # Products would overflow or underflow; scaling by a power of two is exact.
        k = 2.0**-200 if size > 1 else 2.0**200
        return scale(minkowski_sum(scale(a, k), scale(b, k)), 1 / k)
    (x, y), (u, v) = a[0][0], b[0][0]
    if abs(x) + abs(y) + abs(u) + abs(v) > 0:
        # Coordinates near the origin have more digits.
        return scale(minkowski_sum(scale(a, 1, -x, -y), scale(b, 1, -u, -v)), 1, x + u, y + v)
    first, second = orient(a), orient(b)
    lines = [*place_edges(first, second), *place_edges(second, first)]
    near = 1e-13 * max(abs(p) for line in lines for p in line)
    nodes: list[complex] = []

    def find_node(p: complex) -> complex:
        known = next((q for q in nodes if abs(p - q) < near), None)
        if known is None:
            nodes.append(p)
        return p if known is None else known

    lines = [(find_node(p), find_node(q)) for p, q in lines]
    lines = [(p, q) for p, q in lines if p != q]
    pieces = set()
    for p, q in lines:
        cuts = sorted({0.0, 1.0, *(t for other in lines for t in find_cuts((p, q), other, near))})
        for r, s in pairwise(p + t * (q - p) for t in cuts):
            if (length := abs(s - r)) > near:
                # The interior is left of each piece; the exterior is right of boundary pieces.
                # At the midpoint, two corners might be opposite each other.
                outer = r + (0.4372 - 1j * near / length) * (s - r)
                if not is_inside(outer, first, second):
                    pieces.add((find_node(r), find_node(s)))
    return join(pieces)


def cross(u: complex, v: complex) -> float:
    """Return the cross product of two vectors, positive if v is on the left of u."""
    return u.real * v.imag - u.imag * v.real


def list_edges(shape: ComplexRings) -> list[ComplexLine]:
    return [(ring[k - 1], p) for ring in shape for k, p in enumerate(ring)]


def orient(shape: Contours) -> ComplexRings:
    """Orient rings with the interior on the left; drop repeated vertices."""
    found = []
    for k, given in enumerate(shape):
        ring = [complex(*p) for j, p in enumerate(given) if p != given[j - 1]]
        area = sum(cross(p - ring[0], q - ring[0]) for p, q in pairwise(ring))
        found.append(ring if (area > 0) == (k == 0) else ring[::-1])
    return found


def place_edges(edges: ComplexRings, corners: ComplexRings) -> list[ComplexLine]:
    """Translate each edge to the corners of the other shape whose edges enclose its direction."""
    return [
        (q + p, r + p)
        for ring in corners
        for k, p in enumerate(ring)
        for q, r in list_edges(edges)
        if cross(p - ring[k - 1], r - q) >= 0 and cross(r - q, ring[(k + 1) % len(ring)] - p) >= 0
    ]


def find_cuts(line: ComplexLine, other: ComplexLine, near: float) -> list[float]:
    """Find the parameters on a line, from 0 to 1, where another line crosses it or ends on it."""
    (p, q), (r, s) = line, other
    if min(r.real, s.real) > max(p.real, q.real) + near or (
        max(r.real, s.real) < min(p.real, q.real) - near
    ):
        return []
    length = abs(q - p)
    one, two = (cross(q - p, end - p) / length for end in other)
    found = [end for end, off in ((r, one), (s, two)) if abs(off) < near]
    if not found and (one > 0) != (two > 0):
        found = [r + one / (one - two) * (s - r)]
    cuts = (((end - p) * (q - p).conjugate()).real / length**2 for end in found)
    return [t for t in cuts if 0 < t < 1]


def is_inside(p: complex, a: ComplexRings, b: ComplexRings) -> bool:
    """Decide whether a point is inside a + b: whether a meets the point minus b."""
    c = [[p - q for q in ring] for ring in b]
    others = list_edges(c)
    crossings = (
        cross(r - q, s - q) * cross(r - q, t - q) < 0
        and cross(t - s, q - s) * cross(t - s, r - s) < 0
        for q, r in list_edges(a)
        for s, t in others
    )
    return any(crossings) or holds(a, c[0][0]) or holds(c, a[0][0])


def holds(shape: ComplexRings, p: complex) -> bool:
    """Decide whether a point is inside a shape, by the parity of crossings of a ray."""
    crossed = (
        (a.imag > p.imag) != (b.imag > p.imag) and (cross(b - a, p - a) > 0) == (b.imag > a.imag)
        for a, b in list_edges(shape)
    )
    return sum(crossed) % 2 == 1


def join(pieces: set[ComplexLine]) -> Contours:
    """Join pieces to rings; at a branch, take the rightmost piece."""
    rings = []
    while pieces:
        start, p = pieces.pop()
        before, ring = start, [start]
        while p != start:
            ring.append(p)
            back = phase(before - p)
            going = (piece for piece in pieces if piece[0] == p)
            piece = max(going, key=lambda piece: (phase(piece[1] - piece[0]) - back) % (2 * pi))
            pieces.remove(piece)
            before, p = piece
        rings.append([(q.real, q.imag) for q in ring])
    return rings


def answer(case: dict[str, Any]) -> dict[str, Any]:
    def read(name: str) -> Contours:
        rings = [case[name], *case.get(f"{name}_holes", [])]
        return [[(float(x), float(y)) for x, y in ring] for ring in rings]

    d, g, a, b = map(read, ("directrix", "generatrix", "a", "b"))
    if sum(map(len, a)) * sum(map(len, b)) > MOST:
        return {"unsupported": "too large for an example"}
    x, y = map(float, case["reference"])
    answers = {"no_fit": lambda: no_fit(d, g, (x, y)), "minkowski_sum": lambda: minkowski_sum(a, b)}
    return {part: answers[part]() for part in case["ask"]}


if __name__ == "__main__":
    print(json.dumps(HELLO), flush=True)
    for line in sys.stdin:
        case = json.loads(line)
        if "bye" in case:
            break
        print(json.dumps({"id": case["id"], **answer(case)}), flush=True)
