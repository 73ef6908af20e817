"""Loops of a certificate, in a frame whose x-axis is the shared direction, as pairs of chains."""

from __future__ import annotations

from collections.abc import Sequence
from copy import copy
from fractions import Fraction
from math import gcd, lcm

from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import Line, LowerChain, Node, turn, walk_heights
from exactsweep.numbers.number import split_ratios
from exactsweep.numbers.point import ORIGIN, Point


class NodeFrame:
    """The integer map [u; u_perp], and back. Scale: units of the lattice in one unit of length."""

    def __init__(self, direction: tuple[int, int], scale: int) -> None:
        self._p, self._q = direction
        self._scale = scale

    @property
    def unit_area(self) -> int:
        """The area in the frame of one unit of area."""
        return (self._p**2 + self._q**2) * self._scale**2

    def enter(self, points: Sequence[Point], origin: Point) -> list[Node]:
        """Nodes of points, taken from an origin."""
        if origin != ORIGIN:
            points = [Point(x - origin.x, y - origin.y) for x, y in points]
        (us, ws), (vs, zs) = (split_ratios([point[axis] for point in points]) for axis in (0, 1))
        nodes = []
        for u, v, w, z in zip(us, vs, ws, zs, strict=True):
            if w != 1 or z != 1:
                common = lcm(w, z)
                u, v, w = u * (common // w), v * (common // z), common
            u, v = u * self._scale, v * self._scale
            if w != 1:
                common = gcd(w, u, v)  # w first: it is small, as a rule, and then the rest is quick
                u, v, w = u // common, v // common, w // common
            nodes.append((self._p * u + self._q * v, self._p * v - self._q * u, w))
        return nodes

    def leave(self, node: Node) -> Point:
        """The point, or translation, of a node."""
        x, y, w = node
        w *= (self._p**2 + self._q**2) * self._scale
        return Point(Fraction(self._p * x - self._q * y, w), Fraction(self._q * x + self._p * y, w))


class MonotoneLoop:
    """A simple polygon, weakly monotone to x.

    Attributes:
        nodes: list of Node, counter-clockwise.
        lines: list of Line; line k is that of the edge from node k to the next one.
        halves: the lower chain, and the upper one turned by half a turn about the origin, which
            makes it a lower chain, too. Of the polygon turned so, the halves change places.
    """

    def __init__(self, nodes: list[Node], name: str, frame: NodeFrame) -> None:
        """Raise CertificateError if the nodes are not those of a canonical loop, monotone to x.

        Cost: O(n).
        """
        self.nodes = nodes
        self.lines = [line_through(p, q) for p, q in zip(nodes, nodes[1:] + nodes[:1], strict=True)]

        def flaw(what: str, k: int) -> CertificateError:
            return CertificateError(f"{name}: {what} vertex {k}", frame.leave(nodes[k]))

        if (0, 0, 0) in self.lines:
            raise flaw("not canonical, the next vertex repeats", self.lines.index((0, 0, 0)))
        turns = [turn(self.lines[k - 1], line) for k, line in enumerate(self.lines)]
        if 0 in turns:
            raise flaw("not canonical, the boundary does not turn at", turns.index(0))
        self.is_convex = min(turns) > 0
        steps = [(k, line[1] > 0) for k, line in enumerate(self.lines) if line[1]]
        turning = [k for m, (k, ahead) in enumerate(steps) if ahead != steps[m - 1][1]]
        if len(turning) != 2:
            raise flaw("not monotone to the direction, it turns back again at", turning[-1])
        start, end = turning if self.lines[turning[0]][1] > 0 else turning[::-1]
        self.halves = (
            self._chain(nodes, self.lines, start, end),
            self._chain(*_turn_half(nodes, self.lines), end, start),
        )
        # Where all turns are to the left, the direction goes round once, for x turns back twice:
        # then it is a convex polygon.
        if not self.is_convex and not _is_below(*self.halves):
            raise CertificateError(f"{name}: not simple and counter-clockwise")

    def turn_half(self) -> MonotoneLoop:
        """The loop turned by half a turn about the origin, its nodes numbered as they are here."""
        turned = copy(self)
        turned.nodes, turned.lines = _turn_half(self.nodes, self.lines)
        turned.halves = self.halves[1], self.halves[0]
        return turned

    def _chain(self, nodes: list[Node], lines: list[Line], start: int, end: int) -> LowerChain:
        """The chain from node `start` to the end of the last edge that does not go back."""
        n = len(nodes)
        last = (end - start) % n
        while lines[(start + last - 1) % n][1] == 0:
            last -= 1
        numbers = [(start + k) % n for k in range(last + 1)]
        return LowerChain([(k, nodes[k]) for k in numbers], [lines[k] for k in numbers[:-1]])


def _turn_half(nodes: Sequence[Node], lines: Sequence[Line]) -> tuple[list[Node], list[Line]]:
    return [(-x, -y, w) for x, y, w in nodes], [(-a, -b, c) for a, b, c in lines]


def line_through(p: Node, q: Node) -> Line:
    """The line through two points; (0, 0, 0) if they are one."""
    (px, py, pw), (qx, qy, qw) = p, q
    return reduce_line(py * qw - qy * pw, qx * pw - px * qw, px * qy - qx * py)


def reduce_line(a: int, b: int, c: int) -> Line:
    """The line of three numbers that may have a common divisor."""
    common = gcd(a, b, c) or 1
    return a // common, b // common, c // common


def _is_below(lower: LowerChain, turned_upper: LowerChain) -> bool:
    """Decide whether a lower chain is below an upper one, common ends excepted."""
    # Without jumps the limits from both sides are the same.
    for side in (-1, 1) if lower.jumps or turned_upper.jumps else (1,):
        first, *inside, last = (
            gap for gap, _ in walk_heights(lower, turned_upper, (0, 0, 1), side)
        )
        if max(first, last) > 0 or max(inside, default=-1) >= 0:
            return False
    return True
