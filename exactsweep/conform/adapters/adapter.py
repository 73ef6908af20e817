"""What an adapter is, and what all of them need."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from exactsweep.conform.run.protocol import Hello, Numbers
from exactsweep.geometry.canonical import doubled_area
from exactsweep.geometry.error import ExactSweepError
from exactsweep.geometry.number import to_fraction
from exactsweep.geometry.point import Point

Number = Any
Ring = list[tuple[Number, Number]]


class MissingError(ExactSweepError):
    """A program that is not installed here; the message says how to get it."""


def _nothing() -> None:
    """Do nothing."""


class Adapter(NamedTuple):
    """A program that can be judged.

    Attributes:
        hello: its name and version, and what it can do.
        rings: of D and of G turned by half a turn, two rings: the rings of their Minkowski sum.
            Numbers are of the type that the hello asks for.
        close: ends what runs for the adapter, if anything does.
    """

    hello: Hello
    rings: Callable[[Ring, Ring], Sequence[Sequence[Sequence[Number]]]]
    close: Callable[[], object] = _nothing

    def answer(self, directrix: Ring, generatrix: Ring, reference: object) -> dict[str, Any]:
        """Answer a case whose reference point is the origin, as `CallablePeer` asks.

        Args:
            directrix: D, a list of pairs.
            generatrix: G, likewise.
            reference: not looked at: the hello says that it is the origin.

        Returns:
            The rings, as "trajectory".

        Raises:
            NotImplementedError: the program does not take such numbers.
        """
        inverse = [(-x, -y) for x, y in generatrix]
        return {"trajectory": self.rings(prepared(directrix), prepared(inverse))}


def peer_hello(name: str, numbers: Numbers) -> Hello:
    """Return the hello of a program that computes Minkowski sums."""
    return Hello(name, ("trajectory",), numbers, "origin")


def prepared(ring: Ring) -> Ring:
    """Return a ring counter-clockwise and without repeated vertices.

    Example:
        >>> prepared([(0, 0), (0, 2), (0, 2), (1, 1), (2, 0), (0, 0)])
        [(0, 0), (2, 0), (1, 1), (0, 2)]
    """
    distinct = [p for k, p in enumerate(ring) if p != ring[k - 1]]
    # Floats are made exact: their products would be rounded.
    points = [Point(to_fraction(x), to_fraction(y)) for x, y in distinct]
    return distinct if doubled_area(points) > 0 else distinct[::-1]


def fillings(rings: Sequence[Ring], directrix: Ring, inverse: Ring) -> list[Ring]:
    """Return what fills the sum of two boundaries, if a ring of it touches itself, else nothing.

    A point of the sum of two polygons that is not in the sum of their boundaries has all of the
    one, moved to it, inside the other, or the other way round: so it is in D moved by a vertex of
    -G, or in -G moved by a vertex of D. Holes of their own are easily left out; holes that touch
    the outer ring may be part of it.
    """
    if all(len(set(ring)) == len(ring) for ring in rings):
        return []
    return [_moved(directrix, inverse[0]), _moved(inverse, directrix[0])]


def _moved(ring: Ring, by: tuple[Number, Number]) -> Ring:
    """Return a ring moved by a vector."""
    return [(x + by[0], y + by[1]) for x, y in ring]


def require_range(first: Ring, second: Ring, most: int) -> None:
    """Refuse rings of ints whose sum may have coordinates beyond a limit.

    Raises:
        NotImplementedError: it may; an unsupported case.
    """
    reach = sum(max(abs(c) for point in ring for c in point) for ring in (first, second))
    if reach > most:
        raise NotImplementedError(f"coordinates beyond {most}")
