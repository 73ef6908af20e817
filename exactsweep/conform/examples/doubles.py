"""No-fit polygons and Minkowski sums of any shapes with holes, in doubles, for small cases.

Put your own code in place of `no_fit`; or of `minkowski_sum`, if it computes a + b.
"""

import json
import sys
from itertools import pairwise
from math import atan2, hypot, pi
from typing import Any

HELLO = {
    "hello": "doubles.py",
    "questions": ["no_fit", "minkowski_sum"],
    "shapes": "any",
    "numbers": "binary64",
    "reference": "given",
}
MOST = 2500
"""Pairs of edges; the sum takes time proportional to their square."""

XY = tuple[float, float]
Contour = list[XY]
Contours = list[Contour]
"""A polygon: its exterior, then its holes, in either orientation."""


def no_fit(d: Contours, g: Contours, reference: XY) -> Contours:
    """Return the rings around the positions of the reference point at which g overlaps d."""
    rings = minkowski_sum(d, scale(g, -1))
    return [[(x + reference[0], y + reference[1]) for x, y in ring] for ring in rings]


def scale(shape: Contours, k: float) -> Contours:
    """Multiply all coordinates."""
    return [[(k * x, k * y) for x, y in ring] for ring in shape]


def minkowski_sum(a: Contours, b: Contours) -> Contours:
    """Return the rings of a + b: edges of each at convex corners of the other, cut and filtered."""
    size = max(abs(c) for ring in (*a, *b) for p in ring for c in p)
    if not 1e-70 < size < 1e70:
        # Products would overflow or underflow; scaling by a power of two is exact.
        k = 2.0**-200 if size > 1 else 2.0**200
        return scale(minkowski_sum(scale(a, k), scale(b, k)), 1 / k)
    a, b = orient(a), orient(b)
    lines = [*place_edges(a, b), *place_edges(b, a)]
    near = 1e-13 * max(abs(c) for line in lines for p in line for c in p)
    nodes: Contour = []

    def find_node(p: XY) -> XY:
        for q in nodes:
            if abs(p[0] - q[0]) < near and abs(p[1] - q[1]) < near:
                return q
        nodes.append(p)
        return p

    lines = [(find_node(p), find_node(q)) for p, q in lines]
    lines = [(p, q) for p, q in lines if p != q]
    pieces = set()
    for p, q in lines:
        cuts = sorted({0.0, 1.0, *(t for r, s in lines for t in find_cuts(p, q, r, s, near))})
        places = [(p[0] + t * (q[0] - p[0]), p[1] + t * (q[1] - p[1])) for t in cuts]
        for (x1, y1), (x2, y2) in pairwise(places):
            length = hypot(x2 - x1, y2 - y1)
            if length > near:
                # The interior is left of each piece; the exterior is right of boundary pieces.
                # At the midpoint, two corners might be opposite each other.
                x = x1 + 0.4372 * (x2 - x1) + near * (y2 - y1) / length
                y = y1 + 0.4372 * (y2 - y1) - near * (x2 - x1) / length
                if not is_inside(x, y, a, b):
                    pieces.add((find_node((x1, y1)), find_node((x2, y2))))
    return join(pieces)


def orient(shape: Contours) -> Contours:
    """Orient rings with the interior on the left; drop repeated vertices."""
    found = []
    for k, given in enumerate(shape):
        ring = [p for j, p in enumerate(given) if p != given[j - 1]]
        x, y = ring[0]
        area = sum((p[0] - x) * (q[1] - y) - (q[0] - x) * (p[1] - y) for p, q in pairwise(ring))
        found.append(ring if (area > 0) == (k == 0) else ring[::-1])
    return found


def place_edges(edges: Contours, corners: Contours) -> list[tuple[XY, XY]]:
    """Translate each edge to the corners of the other shape whose edges enclose its direction."""
    lines = []
    for ring in corners:
        for k, (x, y) in enumerate(ring):
            (bx, by), (ax, ay) = ring[k - 1], ring[(k + 1) % len(ring)]
            for other in edges:
                for j, (qx, qy) in enumerate(other):
                    px, py = other[j - 1]
                    before = (x - bx) * (qy - py) - (y - by) * (qx - px)
                    after = (qx - px) * (ay - y) - (qy - py) * (ax - x)
                    if before >= 0 and after >= 0:
                        lines.append(((px + x, py + y), (qx + x, qy + y)))
    return lines


def find_cuts(p: XY, q: XY, r: XY, s: XY, near: float) -> list[float]:
    """Find the parameters on pq, from 0 to 1, where rs crosses it or ends on it."""
    dx, dy, ex, ey = q[0] - p[0], q[1] - p[1], s[0] - r[0], s[1] - r[1]
    if min(r[0], s[0]) > max(p[0], q[0]) + near or max(r[0], s[0]) < min(p[0], q[0]) - near:
        return []
    if min(r[1], s[1]) > max(p[1], q[1]) + near or max(r[1], s[1]) < min(p[1], q[1]) - near:
        return []
    length, found = hypot(dx, dy), []
    offs = []
    for x, y in (r, s):
        off = (dx * (y - p[1]) - dy * (x - p[0])) / length
        offs.append(off)
        if abs(off) < near:
            found.append((dx * (x - p[0]) + dy * (y - p[1])) / length**2)
    if not found and (offs[0] > 0) != (offs[1] > 0):
        u = offs[0] / (offs[0] - offs[1])
        found.append((dx * (r[0] + u * ex - p[0]) + dy * (r[1] + u * ey - p[1])) / length**2)
    return [t for t in found if 0 < t < 1]


def is_inside(x: float, y: float, a: Contours, b: Contours) -> bool:
    """Decide whether (x, y) is inside a + b: whether a meets (x, y) - b."""
    c = [[(x - u, y - v) for u, v in ring] for ring in b]
    edges = [(ring[k - 1], p) for ring in c for k, p in enumerate(ring)]
    for ring in a:
        for k, q in enumerate(ring):
            p = ring[k - 1]
            for r, s in edges:
                if turn(p, q, r) * turn(p, q, s) < 0 and turn(r, s, p) * turn(r, s, q) < 0:
                    return True
    return holds(a, c[0][0]) or holds(c, a[0][0])


def turn(p: XY, q: XY, r: XY) -> float:
    """Return a number that is positive if r is on the left of pq."""
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def holds(shape: Contours, p: XY) -> bool:
    """Decide whether a point is inside a shape, by the parity of crossings of a ray."""
    inside = False
    for ring in shape:
        for k, b in enumerate(ring):
            a = ring[k - 1]
            if (a[1] > p[1]) != (b[1] > p[1]):
                inside ^= (turn(a, b, p) > 0) == (b[1] > a[1])
    return inside


def join(pieces: set[tuple[XY, XY]]) -> Contours:
    """Join pieces to rings; at a branch, take the rightmost piece."""
    rings = []
    while pieces:
        start, p = piece = min(pieces)
        pieces.remove(piece)
        ring, before = [start], start
        while p != start:
            ring.append(p)
            back = atan2(before[1] - p[1], before[0] - p[0])
            going = [piece for piece in pieces if piece[0] == p]
            piece = max(
                going,
                key=lambda s: (atan2(s[1][1] - s[0][1], s[1][0] - s[0][0]) - back) % (2 * pi),
            )
            pieces.remove(piece)
            before, p = piece
        rings.append(ring)
    return rings


def answer(case: dict[str, Any]) -> dict[str, Any]:
    """Answer all questions of a case."""

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
