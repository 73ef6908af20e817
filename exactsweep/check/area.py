"""The area between loops: nothing is reduced, and no common divisor is looked for.

The term of the edge from p to q is over pw * qw, so that two edges that follow each other have a
divisor in common that is known. A sum of terms from p to q is kept as a / (pw * m * qw), and

    a / (pw * m * qw) + b / (qw * n * rw) = (a * n * rw + b * pw * m) / (pw * (m * qw * n) * rw).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from fractions import Fraction
from typing import TypeVar

from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import Node

_Quotient = tuple[int, int]
_SharedTerm = tuple[int, int, int, int]
_Addend = TypeVar("_Addend")


def check_area(
    area: Fraction, outer: Sequence[Node], inside: Iterable[Sequence[Node]], unit: int = 1
) -> None:
    """Raise CertificateError if an area is not that of a loop without those inside it.

    Args:
        area: in the plane.
        outer: the nodes of the outer loop, counter-clockwise like the others.
        inside: those of the others.
        unit: the area in the frame of the nodes that is one in the plane.

    Cost: a product of as many digits as all nodes have, and of half as many twice, and so on.
    """
    loops = [_double_area(outer), *((-n, d) for n, d in map(_double_area, inside))]
    doubled, over = _add_in_pairs(loops, lambda p, q: (p[0] * q[1] + q[0] * p[1], p[1] * q[1]))
    if doubled * area.denominator != area.numerator * 2 * unit * over:
        raise CertificateError("area: it is not that of the outer loop minus those inside it")


def _double_area(nodes: Sequence[Node]) -> _Quotient:
    """Twice the area of a loop."""
    terms = [
        (px * qy - qx * py, pw, 1, qw)
        for (px, py, pw), (qx, qy, qw) in zip(nodes, [*nodes[1:], nodes[0]], strict=True)
    ]
    total, first, others, last = _add_in_pairs(terms, _join_terms)
    return total, first * others * last


def _join_terms(one: _SharedTerm, other: _SharedTerm) -> _SharedTerm:
    (a, p, m, q), (b, _, n, r) = one, other
    return a * n * r + b * p * m, p, m * q * n, r


def _add_in_pairs(terms: list[_Addend], add: Callable[[_Addend, _Addend], _Addend]) -> _Addend:
    """Add neighbours, and then their sums, so that factors are of equal length."""
    while len(terms) > 1:
        odd = terms[len(terms) & ~1 :]
        terms = [add(p, q) for p, q in zip(terms[::2], terms[1::2], strict=False)] + odd
    return terms[0]
