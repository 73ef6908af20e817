"""Integers that count their operations, so that counts do not depend on the machine.

The kernel accepts any exact rationals, so it runs on these unchanged.
"""

import gc
import tracemalloc
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from time import process_time
from typing import Any, Protocol, Self

from exactsweep.corpus.generator.shapes import Ring
from exactsweep.numbers.number import Vertex
from exactsweep.paper.growth import Bound, Growth, Size
from exactsweep.paper.pairs import Chains, SweepPair


@dataclass
class OperationCount:
    """Operations on coordinates and on derived numbers, and slots read in a CountedList."""

    multiplications: int = 0
    comparisons: int = 0
    additions: int = 0
    slots: int = 0

    @property
    def total(self) -> int:
        return self.multiplications + self.comparisons + self.additions + self.slots


_tally = OperationCount()


class Counted(int):
    """An int that counts operations and returns counted ints, even inside Fractions.

    A division counts as a multiplication, a subtraction as an addition; negation is free.
    """

    __slots__ = ()
    __hash__ = int.__hash__

    # Fraction uses these two, so its results are counted ints as well.
    @property
    def numerator(self) -> Self:
        return self

    @property
    def denominator(self) -> Self:  # type: ignore[override]
        return type(self)(1)


def _count_as(kind: str, make: Callable[[Any], Any], name: str) -> Callable[..., Any]:
    """Wrap an int method so that it counts the operation and returns Counted."""
    plain = getattr(int, name)

    def method(*operands: int) -> Any:
        result = plain(*operands)
        if result is NotImplemented:
            return result
        if kind:
            setattr(_tally, kind, getattr(_tally, kind) + 1)
        return make(result)

    return method


for _kind, _make, _names in (
    ("", Counted, "neg pos abs"),
    ("additions", Counted, "add radd sub rsub"),
    ("multiplications", Counted, "mul rmul floordiv rfloordiv mod rmod"),
    ("comparisons", bool, "lt le gt ge eq ne bool"),
):
    for _name in _names.split():
        setattr(Counted, f"__{_name}__", _count_as(_kind, _make, f"__{_name}__"))


def make_counted(chain: Iterable[Vertex]) -> list[tuple[Any, Any]]:
    return [(Counted(x), Counted(y)) for x, y in chain]


@contextmanager
def watch_operations() -> Iterator[OperationCount]:
    """Count operations in a `with` block, from zero."""
    global _tally
    outer, _tally = _tally, OperationCount()
    try:
        yield _tally
    finally:
        _tally = outer


class CountedList(list[Any]):
    """A list that counts the slots read from it.

    >>> with watch_operations() as tally:
    ...     CountedList([1, 2, 3])[:], tally.slots
    ([1, 2, 3], 3)
    """

    def __getitem__(self, key: Any) -> Any:
        found = super().__getitem__(key)
        _tally.slots += len(found) if isinstance(key, slice) else 1
        return found

    def __iter__(self) -> Iterator[Any]:
        _tally.slots += len(self)
        return super().__iter__()


class PairFamily(Protocol):
    """A named function of m and n that returns a generatrix and a directrix."""

    __name__: str

    def __call__(self, m: int, n: int) -> tuple[Ring, Ring]: ...


def count_chains(pair: SweepPair) -> Chains:
    return Chains(*map(make_counted, pair.chains))


def count_operations(run: Callable[..., Iterable[Any]], *arguments: Any) -> int:
    with watch_operations() as tally:
        out = sum(1 for _ in run(*arguments))
    return tally.total + out


def operations(run: Callable[[Chains], Iterable[Any]], chains: Chains) -> int:
    """Count the operations of a procedure and the vertices of its output."""
    return count_operations(run, Chains(*map(make_counted, chains)))


def vertices(run: Callable[[Chains], Iterable[Any]], chains: Chains) -> int:
    return sum(1 for _ in run(chains))


def seconds(run: Callable[[Chains], Any], chains: Chains) -> float:
    """Measure CPU seconds: the minimum of at least three runs that take 0.2 seconds in all."""
    times: list[float] = []
    while len(times) < 3 or (sum(times) < 0.2 and len(times) < 50):
        start = process_time()
        run(chains)
        times.append(process_time() - start)
    return min(times)


def peak(run: Callable[[Chains], Any], chains: Chains) -> float:
    """Measure peak memory in bytes, without the input."""
    # A full collection empties the lists of free objects, whose reuse is not traced. Freezing
    # excludes existing objects from it.
    gc.freeze()
    gc.collect()
    gc.unfreeze()
    tracemalloc.start()
    try:
        before = tracemalloc.get_traced_memory()[0]
        run(chains)
        return tracemalloc.get_traced_memory()[1] - before
    finally:
        tracemalloc.stop()


COUNTERS: dict[str, Callable[[Callable[[Chains], Any], Chains], float]] = {
    function.__name__: function for function in (operations, vertices, seconds)
} | {"bytes": peak}


def count_by(unit: str, run: Callable[[Chains], Iterable[Any]]) -> Callable[[SweepPair], float]:
    return lambda pair: COUNTERS[unit](run, pair.chains)


def grow(
    what: str,
    family: PairFamily,
    bound: Bound | str,
    sizes: Iterable[tuple[int, int]],
    count: Callable[[SweepPair], Any],
    limit: float = 1.08,
    side: str = "upper",
) -> Growth:
    """Count or measure a quantity on the pairs of a family, and compare it with a bound.

    For a bound that depends on more than m and n, pass its name; `count` then returns the count and
    the value of the bound. Each of the sizes (m, n) is about twice the one before. See `Growth` for
    `limit` and `side`.

    >>> from exactsweep.paper.growth import MN
    >>> def squares(m, n):
    ...     return [(0, 0)] * m**2, []
    >>> found = grow("points", squares, MN, [(2, 1), (4, 1)], lambda pair: len(pair[0]))
    >>> found.varied, found.exponent(), found.last_rise, found.is_flat
    ('m', 2.0, 2.0, False)
    """

    def measure(m: int, n: int) -> Size:
        found = count(SweepPair(*family(m, n)))
        return Size(m, n, *found) if isinstance(bound, str) else Size(m, n, found, bound[1](m, n))

    name = bound if isinstance(bound, str) else bound[0]
    points = tuple(measure(m, n) for m, n in sizes)
    return Growth(what, family.__name__, name, points, limit, side)
