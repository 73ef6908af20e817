"""Limits on untrusted input: digits per number, bytes per text.

There is one limit on numbers, for those in texts and Decimals: some characters, `1e999999999`, must
not ask for gigabytes, and what is answered must be readable again.

1. A number may have `max_digits` D in its numerator and in its denominator, however it is spelled.
2. One that is written out may have as many as it is written with, up to 32 D + 7: no vertex of a
   loop that is computed from numbers of D digits has more, by 3 to 5. Certificates, whose cost is
   counted in steps, have no limit; nor do ints, Fractions and floats, which are numbers already.

Let |n|, d < 10^D for all coordinates n/d of two polygons.

3. A line through d1 - g and d2 - g, for vertices d1, d2 of one and g of the other, is A x + B y = C
   with ints |A|, |B| < 2 * 10^6D and |C| < 8 * 10^6D: A and B are over the denominators of d1 and
   d2, which cancel that of d1 in C, and C is over those of g.
4. Two such lines cross, at a vertex t of a trajectory or a hole or at the end of an exact fit, over
   A B' - A' B < 8 * 10^12D, with numerators below 32 * 10^12D; a reference point adds D digits.
5. What is swept is bounded by such lines moved by a vertex of G, with |A|, |B| < 2 * 10^8D, and by
   edges of G moved by t: over its denominator, |A|, |B| < 16 * 10^16D and |C| < 256 * 10^16D. Two
   of these cross over less than 512 * 10^32D, with numerators below 8192 * 10^32D.

And one on texts, since reading takes memory in proportion to them, up to 130 bytes for a byte:

6. A text may count for `max_mib` MiB. It counts for as many bytes as it has, and for no less than
   16 bytes for each vertex, 32 for each element of SVG and 64 for each entity of DXF; what a file
   draws again and again counts each time.
7. An answer may have more vertices than fit into that, whatever the limit. So whoever writes one
   says, where it does, which limit reads it, by the same count.

What is computed from an answer, and from answers to that, can pass any limit: both can be raised.
"""

from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from contextvars import ContextVar
from typing import TypedDict

from exactsweep.numbers.error import ExactSweepError

# What Python itself is ready to print of an int (`sys.int_info.default_max_str_digits`).
DEFAULT_DIGITS = 4300
DEFAULT_MIB = 16

_MOST_MIB = 2**20

_max_digits: ContextVar[int | None] = ContextVar("max_digits", default=None)
_max_mib: ContextVar[float | None] = ContextVar("max_mib", default=None)


class LimitError(ExactSweepError):
    """A limit that is none."""


@contextmanager
def limits(*, max_digits: int | None = None, max_mib: float | None = None) -> Iterator[None]:
    """Change, inside a `with` block, how large what is read may be.

    What is computed from numbers read under the limit on digits can be written in any format and
    read again; the limit is on the number, not on how it is spelled.

    Args:
        max_digits: the most digits of the numerator and of the denominator of a number in a string
            or `Decimal`, in lowest terms; 4300 unless changed. A number that is written out may
            have 32 times as many, and 7 more. None to leave it.
        max_mib: for how many MiB a file, or a line of a file of pairs, may count: for what it has,
            and no less than 16 bytes for each vertex; 16 MiB unless changed. None to leave it.

    Raises:
        LimitError: digits that are no int from one on; MiB that are no number above 0.

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
    with ExitStack() as stack:
        if max_digits is not None:
            stack.callback(_max_digits.reset, _max_digits.set(max_digits))
        if max_mib is not None:
            stack.callback(_max_mib.reset, _max_mib.set(max_mib))
        yield


class Limits(TypedDict):
    """The arguments of `limits`."""

    max_digits: int | None
    max_mib: float | None


def list_limits() -> Limits:
    """List the limits as they were changed, as arguments of `limits`, for another process.

    Example:
        >>> with limits(max_mib=2):
        ...     list_limits()
        {'max_digits': None, 'max_mib': 2}
    """
    return {"max_digits": _max_digits.get(), "max_mib": _max_mib.get()}


def get_max_digits() -> int:
    """Return the most digits of a number, by 1."""
    return _max_digits.get() or DEFAULT_DIGITS


def answer_digits() -> int:
    """Return the most digits of a number that is written out: by 5, of any vertex of an answer."""
    return 32 * get_max_digits() + 7


def get_max_mib() -> float:
    """Return for how many MiB a text may count."""
    return _max_mib.get() or DEFAULT_MIB


def get_max_bytes() -> int:
    """Return for how many bytes a text may count."""
    return int(get_max_mib() * 2**20)
