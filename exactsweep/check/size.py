"""Certificates too large to be checked: refused before the work begins, not in its midst."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from math import lcm

from exactsweep.check.certificate import MAX_BITS, CertificateError
from exactsweep.check.chain import Node
from exactsweep.geometry.point import Point


def common_scale(points: Iterable[Point]) -> int:
    """The least common denominator; raise CertificateError if it is enormous."""
    scale = 1
    for x, y in points:
        scale = lcm(scale, x.denominator, y.denominator)
        if scale.bit_length() > MAX_BITS:
            raise CertificateError(f"too large: a common denominator has more than {MAX_BITS} bits")
    return scale


def check_size(loops: Collection[Sequence[Node]], steps: int, max_steps: int) -> None:
    """Raise CertificateError if so many steps, and the loops themselves, are more than allowed."""
    bits = max(number.bit_length() for nodes in loops for node in nodes for number in node)
    work = (steps + sum(map(len, loops))) * _weight(bits)
    # The area comes over the product of all denominators.
    work += max(_weight(2 * sum(w.bit_length() for _, _, w in nodes)) for nodes in loops)
    if work > max_steps:
        raise CertificateError(f"too large: to check it would take more than {max_steps} steps")


def _weight(bits: int) -> int:
    """The cost of a step on numbers of so many bits, in steps on small ones."""
    words = 1 + bits // 64
    return words + words * words // 1000
