"""Exact rotations of the plane, and rational approximations of arbitrary precision.

(1) The cosine and the sine of a rational number of degrees are both rational only for multiples of
    90 (Niven). Every other rational rotation is given by its cosine and sine.
(2) With t = tan(a/2), ((1 - t^2) / (1 + t^2), 2 t / (1 + t^2)) is the point of the unit circle at
    the angle a. Changing t by s moves this point by at most 2 s. So an interval for the tangent,
    found by interval arithmetic, bounds the error of a rational rotation.
(3) A rotation with error e on the unit circle moves a point at distance r from the origin to within
    e r of its true image.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property, lru_cache
from threading import Lock
from typing import NamedTuple

from exactsweep.geometry.reading import read_point
from exactsweep.numbers.digits import abridge, format_fraction
from exactsweep.numbers.error import NumberError
from exactsweep.numbers.number import Point, find_root, find_simplest_fraction, to_fraction

TURN_BITS = 64
"""The default precision: the error of a rational rotation is at most 2**-64."""

MAX_TURN_BITS = 100_000
"""The maximum precision of a rational rotation; the cost is quadratic."""

_ZERO, _ONE = Fraction(0), Fraction(1)
_QUARTERS = ((_ONE, _ZERO), (_ZERO, _ONE), (-_ONE, _ZERO), (_ZERO, -_ONE))

# mpmath caches constants globally and updates each in two steps, which is not thread-safe.
mpmath_lock = Lock()


class RationalTurn(NamedTuple):
    """A rational rotation with a bound on its error on the unit circle, 0 if exact."""

    cosine: Fraction
    sine: Fraction
    error: Fraction


@dataclass(frozen=True)
class Turn:
    """A counter-clockwise rotation about the origin, by degrees in [0, 360).

    `degrees` is None for a rotation given by its cosine and sine; `exact` is the pair (cosine,
    sine), or None if they are irrational.
    """

    degrees: Fraction | None
    exact: tuple[Fraction, Fraction] | None

    def near(self, bits: int = TURN_BITS) -> RationalTurn:
        """Return a rational rotation with an error of at most 2**-bits, exact if possible.

        Raises NumberError for bits below 1 or above MAX_TURN_BITS. Cost: O(bits^2); cached.

        >>> read_turn(180).near(1)
        RationalTurn(cosine=Fraction(-1, 1), sine=Fraction(0, 1), error=Fraction(0, 1))
        >>> print(*read_turn(45).near(8))
        697/985 696/985 1/256
        """
        if self.exact is not None:
            return RationalTurn(*self.exact, _ZERO)
        return find_rational_turn(self.degrees or _ZERO, bits)

    @cached_property
    def _hash(self) -> int:
        return hash(self.exact if self.degrees is None else self.degrees)

    def __hash__(self) -> int:
        return self._hash

    def __str__(self) -> str:
        if self.degrees is not None:
            return f"{abridge(self.degrees)} degrees"
        cosine, sine = map(abridge, self.near()[:2])
        return f"the turn with cosine {cosine} and sine {sine}"

    def to_json(self) -> str | list[str]:
        """Return the degrees as a string, or the cosine and the sine as a list of two."""
        if self.degrees is not None:
            return format_fraction(self.degrees)
        return [*map(format_fraction, self.near()[:2])]


def read_turn(by: object) -> Turn:
    """Read a rotation; equal rotations compare equal in any notation.

    Args:
        by: degrees; or a pair of numbers, the image of the X axis, a direction of rational length,
            such as (3, 4) or the equivalent ("3/5", "4/5").

    Raises:
        NumberError: a direction of irrational length, or not a number.

    >>> read_turn((0, 2)) == read_turn("-270"), read_turn((3, 4)).exact
    (True, (Fraction(3, 5), Fraction(4, 5)))
    """
    if not isinstance(by, Iterable) or isinstance(by, str):
        return _turn_by(to_fraction(by) % 360)
    x, y = read_point(by, "direction")
    length = find_root(x * x + y * y)
    if not length:
        raise NumberError(
            f"the direction ({abridge(x)}, {abridge(y)}) has no positive rational length, "
            "unlike (3, 4) and (5, 12)"
        )
    exact = x / length, y / length
    return Turn(Fraction(90 * _QUARTERS.index(exact)) if exact in _QUARTERS else None, exact)


@lru_cache(maxsize=1024)
def _turn_by(degrees: Fraction) -> Turn:
    quarters, rest = divmod(degrees, 90)
    return Turn(degrees, None if rest else _QUARTERS[quarters])


@lru_cache(maxsize=1024)
def find_rational_turn(degrees: Fraction, bits: int) -> RationalTurn:
    """Find a rational rotation with few digits and an error of at most 2**-bits, by (2)."""
    if not 1 <= bits <= MAX_TURN_BITS:
        raise NumberError(f"bits={bits}: not from 1 to {MAX_TURN_BITS}")
    quarter, rest = divmod(degrees, 90)
    off = Fraction(1, 2 ** (bits + 1))
    low, high = bound_half_tangent(rest, bits)
    # Any number strictly between these is within `off` of every number in [low, high].
    (a, b), (c, d) = (t.as_integer_ratio() for t in (max(high - off, _ZERO), low + off))
    q, p = find_simplest_fraction(a, b, c, d)
    return RationalTurn(*from_half_tangent(Fraction(p, q), quarter), 2 * off)


def from_half_tangent(t: Fraction, quarters: int = 0) -> Point:
    """Return the point on the unit circle with half-angle tangent t, rotated by quarter turns.

    >>> from_half_tangent(Fraction(1, 2), 1)
    Point(x=Fraction(-4, 5), y=Fraction(3, 5))
    """
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    for _ in range(quarters):
        c, s = -s, c
    return Point(c, s)


def bound_half_tangent(degrees: Fraction, bits: int) -> tuple[Fraction, Fraction]:
    """Bound the tangent of half an angle from 0 to 90 degrees within 2**-bits.

    >>> low, high = bound_half_tangent(Fraction(60), 9)
    >>> 3 * low**2 < 1 < 3 * high**2, high - low < Fraction(1, 512)
    (True, True)
    """
    from mpmath.ctx_iv import MPIntervalContext
    from mpmath.libmp import to_rational

    with mpmath_lock:
        # `mpmath.iv` has one precision for all threads.
        iv = MPIntervalContext()
        iv.prec = bits + 64
        angle = iv.pi * iv.mpf(degrees.numerator) / (180 * iv.mpf(degrees.denominator))
        low, high = (
            Fraction(*map(int, to_rational(end)))
            for end in (iv.sin(angle) / (1 + iv.cos(angle)))._mpi_
        )
    assert 2**bits * (high - low) < 1
    return low, high
