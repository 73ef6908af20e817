"""Limits on untrusted input: digits per number, bytes per text.

Numbers in strings and Decimals are limited, because a few characters such as `1e999999999` must not
allocate gigabytes. Yet the package must be able to read every answer that it writes.

(1) A number may have D = `max_digits` digits in its numerator and in its denominator.
(2) A number written out digit by digit may have 32 D + 7 digits. By (3) to (5), no vertex of a loop
    computed from numbers of D digits has more. Certificates have no limit, because their checker
    counts steps; ints, Fractions and floats have none, because they are already in memory.

Let |n|, d < 10^D for all coordinates n/d of two polygons.

(3) A line through d1 - g and d2 - g, for vertices d1, d2 of one polygon and g of the other, is A x
    + B y = C with ints |A|, |B| < 2 * 10^6D and |C| < 8 * 10^6D: multiply by the denominators of
    d1, d2 and g.
(4) Two such lines cross at a vertex t of a trajectory or a hole, or at the end of an exact fit,
    with the denominator A B' - A' B < 8 * 10^12D and numerators below 32 * 10^12D; a reference
    point adds D digits.
(5) Such lines moved by a vertex of G bound the swept area, with |A|, |B| < 2 * 10^8D. So do edges
    of G moved by t: over its denominator, |A|, |B| < 16 * 10^16D and |C| < 256 * 10^16D. Two of
    these cross with a denominator below 512 * 10^32D and numerators below 8192 * 10^32D.

Reading takes up to 130 bytes of memory per byte of text, so the size of text is limited, too.

(6) Text is charged its number of bytes, but at least 16 bytes for each vertex, 32 for each SVG
    element and 64 for each DXF entity, each time it is drawn; the limit is `max_mib` MiB.
(7) If an answer exceeds that limit, its writer reports the limit needed to read it.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import NamedTuple

from exactsweep.numbers.error import ExactSweepError

# Python's own limit for printing an int (`sys.int_info.default_max_str_digits`).
DEFAULT_DIGITS = 4300
DEFAULT_MIB = 16

_MOST_MIB = 2**20


class Limits(NamedTuple):
    """The maximum number of digits (D in (1)), and the maximum size of text in MiB."""

    max_digits: int = DEFAULT_DIGITS
    max_mib: float = DEFAULT_MIB

    @property
    def answer_digits(self) -> int:
        """The maximum number of digits of a number written out digit by digit, by (2)."""
        return 32 * self.max_digits + 7

    @property
    def max_bytes(self) -> int:
        """The limit on the size of text in bytes."""
        return int(self.max_mib * 2**20)


_current = ContextVar("limits", default=Limits())  # noqa: B039


def get_limits() -> Limits:
    """Return the limits of the current thread or task."""
    return _current.get()


def set_limits(held: Limits) -> None:
    """Set the limits of a new process."""
    _current.set(held)


class LimitError(ExactSweepError):
    """A value that cannot be a limit."""


@contextmanager
def limits(*, max_digits: int | None = None, max_mib: float | None = None) -> Iterator[None]:
    """Change the limits on input inside a `with` block.

    The limit on digits applies to the number, not to its spelling. Results computed from numbers
    within the limit can be written in any format and read again. The limits apply to the current
    thread or asyncio task; a new thread starts with the defaults.

    Args:
        max_digits: the maximum number of digits of the numerator and of the denominator of a number
            in a string or `Decimal`, in lowest terms; 4300 by default. A number written out digit
            by digit may have 32 times as many, plus 7. None keeps the limit.
        max_mib: the maximum size in MiB of a file, or of a line of a file of pairs, with at least
            16 bytes for each vertex; 16 MiB by default. None keeps the limit.

    Raises:
        LimitError: `max_digits` is not an int of at least 1, or `max_mib` is not a number above 0.

    Example:
        >>> from exactsweep import Polygon
        >>> with limits(max_digits=10_000):
        ...     print(Polygon([(0, 0), (1, 0), (0, "1e5000")]).area * 2 == 10**5000)
        True
    """
    if max_digits is not None and (type(max_digits) is not int or max_digits < 1):
        raise LimitError("max_digits must be an int, at least 1")
    if max_mib is not None and not (type(max_mib) in (int, float) and 0 < max_mib <= _MOST_MIB):
        raise LimitError(f"max_mib must be a number above 0, at most {_MOST_MIB}")
    held = get_limits()
    token = _current.set(Limits(max_digits or held.max_digits, max_mib or held.max_mib))
    try:
        yield
    finally:
        _current.reset(token)
