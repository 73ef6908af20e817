"""Certificates too large to be checked: refused before the work begins, not in its midst."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from math import lcm
from typing import Any

from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import Node
from exactsweep.check.length import reading_steps
from exactsweep.geometry.point import Point


def common_scale(points: Collection[Point], max_steps: int) -> int:
    """The least common denominator; raise CertificateError if it alone makes too many steps."""
    scale = 1
    for x, y in points:
        scale = lcm(scale, x.denominator, y.denominator)
        _allow(len(points) * _weight(scale.bit_length()), max_steps)
    return scale


def check_size(loops: Collection[Sequence[Node]], steps: int, max_steps: int) -> None:
    """Raise CertificateError if so many steps, and the loops themselves, are more than allowed."""
    columns = [column for nodes in loops for column in zip(*nodes, strict=True)]
    bits = max(n.bit_length() for column in columns for n in (min(column), max(column)))
    work = (steps + sum(map(len, loops))) * _weight(bits)
    # The area comes over the product of all denominators.
    work += max(_weight(2 * sum(w.bit_length() for _, _, w in nodes)) for nodes in loops)
    _allow(work, max_steps)


def check_reading(certificate: Any, max_steps: int) -> None:
    """Raise CertificateError if to read its numbers takes more steps than are allowed."""
    _allow(reading_steps(certificate), max_steps)


def _allow(steps: int, max_steps: int) -> None:
    if steps > max_steps:
        raise CertificateError(f"too large: to check it would take more than {max_steps} steps")


def _weight(bits: int) -> int:
    """The cost of a step on numbers of so many bits, in steps on small ones."""
    words = 1 + bits // 64
    return words + words * words // 1000
