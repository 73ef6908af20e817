"""The budget of steps for claims about polygons of any shape.

Work that is known to take too long is refused before it begins: to compare every edge with every
other one. The rest depends on the pieces that meet, and is counted while it is done.
"""

from __future__ import annotations

from collections.abc import Iterable

from exactsweep.check.standalone import Refused, weight
from exactsweep.numbers.point import Vertex


class Budget:
    """The work that may still be done, in steps of about a microsecond.

    Args:
        most: how many steps, or None for any number.

    Attributes:
        left: how many of them are left.
    """

    def __init__(self, most: int | None = None) -> None:
        self._most = self.left = most

    def take(self, steps: int, bits: int = 0) -> None:
        """Take steps on numbers of so many bits.

        Raises:
            Refused: that is more than is left.
        """
        if self.left is None:
            return
        self.left -= steps * weight(bits)
        if self.left < 0:
            raise Refused(f"too large: to check it would take more than {self._most} steps")


UNLIMITED = Budget()


def measure_bits(points: Iterable[Vertex]) -> int:
    """The bits of the longest coordinate, and 32 times as many for Fractions, which take longer."""
    ratios = [c.as_integer_ratio() for p in points for c in p]
    bits = max(max(n.bit_length(), d.bit_length()) for n, d in ratios)
    return bits if all(d == 1 for _, d in ratios) else 32 * bits
