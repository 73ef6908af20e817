"""Certificates too large to be checked: refused before the work begins, not in its midst."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from math import isqrt, lcm
from typing import Any

from exactsweep.check.certificate import CertificateError
from exactsweep.check.chain import Node
from exactsweep.geometry.point import Point


def find_common_scale(points: Collection[Point], max_steps: int) -> int:
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


def reading_steps(certificate: Any) -> int:
    """What it takes to read all numbers, in steps of about a microsecond.

    Most of it is to see that long numbers are in lowest terms.
    """
    lengths = (len(text) for text in _strings(certificate))
    return sum(1 + n * isqrt(n) // 1000 + n * n // 400_000 for n in lengths)


def _strings(item: Any, depth: int = 7) -> Iterator[str]:
    """All strings of data as JSON has it; numbers are not nested more deeply."""
    if isinstance(item, str):
        yield item
    elif depth and isinstance(item, dict | list | tuple):
        for entry in item.values() if isinstance(item, dict) else item:
            yield from _strings(entry, depth - 1)


def _allow(steps: int, max_steps: int) -> None:
    if steps > max_steps:
        raise CertificateError(f"too large: to check it would take more than {max_steps} steps")


def _weight(bits: int) -> int:
    """The cost of a step on numbers of so many bits, in steps on small ones."""
    words = 1 + bits // 64
    return words + words * words // 1000
