"""Integers that count what is done with them, so that nothing in the kernel has to.

The kernel takes any exact rationals.  Fed with these, it multiplies, divides and compares
coordinates as always, and the counts are the same on every run and every machine.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any


@dataclass
class Tally:
    """Operations on coordinates and on numbers derived from them."""

    multiplications: int = 0
    comparisons: int = 0

    @property
    def total(self) -> int:
        """Both together."""
        return self.multiplications + self.comparisons


_tally = Tally()


class Counted(int):
    """An int whose results are counted ints again, through Fractions too.

    Divisions count as multiplications; additions, which come with them, are not counted.
    """

    __slots__ = ()
    __hash__ = int.__hash__

    # Fraction takes these, and so goes on in counted ints.
    @property
    def numerator(self) -> Counted:
        """The int itself."""
        return self

    @property
    def denominator(self) -> Counted:  # type: ignore[override]
        """One."""
        return Counted(1)


def _free(name: str) -> Callable[..., Any]:
    plain = getattr(int, name)

    def method(*operands: int) -> Any:
        result = plain(*operands)
        return result if result is NotImplemented else Counted(result)

    return method


def _multiplication(name: str) -> Callable[..., Any]:
    plain = getattr(int, name)

    def method(*operands: int) -> Any:
        result = plain(*operands)
        if result is NotImplemented:
            return result
        _tally.multiplications += 1
        return Counted(result)

    return method


def _comparison(name: str) -> Callable[..., Any]:
    plain = getattr(int, name)

    def method(*operands: int) -> Any:
        result = plain(*operands)
        if result is not NotImplemented:
            _tally.comparisons += 1
        return result

    return method


for _make, _names in (
    (_free, "add radd sub rsub neg pos abs"),
    (_multiplication, "mul rmul floordiv rfloordiv mod rmod"),
    (_comparison, "lt le gt ge eq ne bool"),
):
    for _name in _names.split():
        setattr(Counted, f"__{_name}__", _make(f"__{_name}__"))


def counted(chain: Sequence[tuple[int, int]]) -> list[tuple[int, int]]:
    """The same points in counted ints.

    >>> with counting() as tally:
    ...     (x, y), = counted([(3, 4)])
    ...     x * y < 13 * x, tally
    (True, Tally(multiplications=2, comparisons=1))
    """
    return [(Counted(x), Counted(y)) for x, y in chain]


@contextmanager
def counting() -> Iterator[Tally]:
    """Count from zero inside a `with` block."""
    global _tally
    outer, _tally = _tally, Tally()
    try:
        yield _tally
    finally:
        _tally = outer
