"""The area between loops: nothing is reduced, and no common divisor is looked for."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction

from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import Node

_Quotient = tuple[int, int]


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
    terms = [*_doubled(outer, 1), *(term for loop in inside for term in _doubled(loop, -1))]
    # In pairs, so that factors are of equal length.
    while len(terms) > 1:
        odd = terms[len(terms) & ~1 :]
        pairs = zip(terms[::2], terms[1::2], strict=False)
        terms = [(a * d + c * b, b * d) for (a, b), (c, d) in pairs] + odd
    doubled, over = terms[0]
    if doubled * area.denominator != area.numerator * 2 * unit * over:
        raise CertificateError("area: it is not that of the outer loop minus those inside it")


def _doubled(nodes: Sequence[Node], sign: int) -> Iterator[_Quotient]:
    """Terms of twice the area of a loop, numerators and denominators."""
    for (px, py, pw), (qx, qy, qw) in zip(nodes, [*nodes[1:], nodes[0]], strict=True):
        yield sign * (px * qy - qx * py), pw * qw
