"""Operations that a procedure needs, counted on families of pairs whose sizes double."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, Protocol

from exactsweep.paper.counting import counted, counting
from exactsweep.paper.growth import Growth, grow
from exactsweep.paper.pairs import Chains, Pair, Ring


class Family(Protocol):
    """A named function of m and n that returns a generatrix and a directrix."""

    __name__: str

    def __call__(self, m: int, n: int) -> tuple[Ring, Ring]:
        """Return the pair."""


def operations(run: Callable[[Chains], Iterable[Any]], chains: Chains) -> int:
    """Multiplications and comparisons of coordinates, and vertices that come out.

    >>> from exactsweep.paper.pairs import Chains
    >>> operations(lambda chains: chains.directrix, Chains([(1, 1)], [(0, 0)], [(0, 0), (1, 0)]))
    2
    """
    fed = Chains(*(counted(chain) for chain in chains))  # type: ignore[arg-type]
    with counting() as tally:
        out = sum(1 for _ in run(fed))
    return tally.total + out


def operations_grow(
    procedure: str,
    run: Callable[[Chains], Iterable[Any]],
    family: Family,
    bound: tuple[str, Callable[[int, int], float]],
    sizes: Iterable[tuple[int, int]],
) -> Growth:
    """Count the operations of a procedure beside a bound in m and n."""
    what = f"operations of {procedure}"
    return _grow(what, lambda chains: operations(run, chains), family, bound, sizes)


def vertices_grow(
    what: str,
    run: Callable[[Chains], Iterable[Any]],
    family: Family,
    bound: tuple[str, Callable[[int, int], float]],
    sizes: Iterable[tuple[int, int]],
) -> Growth:
    """Count the vertices that come out beside a bound in m and n."""
    return _grow(f"vertices of {what}", lambda c: sum(1 for _ in run(c)), family, bound, sizes)


def _grow(
    what: str,
    count: Callable[[Chains], int],
    family: Family,
    bound: tuple[str, Callable[[int, int], float]],
    sizes: Iterable[tuple[int, int]],
) -> Growth:
    def beside(m: int, n: int) -> tuple[int, float]:
        return count(Pair(*family(m, n)).chains), bound[1](m, n)

    return grow(what, family.__name__, bound[0], sizes, beside)
