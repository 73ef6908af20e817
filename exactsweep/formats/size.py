"""Size limits for input text; see 6 in `exactsweep.numbers.limits`."""

from math import ceil

from exactsweep.formats.error import FormatError
from exactsweep.numbers.limits import DEFAULT_MIB, get_max_bytes, get_max_mib

VERTEX, ELEMENT, ENTITY, FAULT = 16, 32, 64, 1600
"""Bytes charged per vertex, SVG element, DXF entity and rejected element."""

# Bytes charged per number; lists have about as many numbers as commas.
_NUMBER = 4


def measure_text(text: str, vertices: int) -> int:
    """Return the size of text in bytes, or the charge for its content if that is greater."""
    return weigh(_count_bytes(text), vertices, text.count(","))


def weigh(size: int, vertices: int, numbers: int) -> int:
    """Return the maximum of a size in bytes and the charge for vertices and numbers."""
    return max(size, VERTEX * vertices, _NUMBER * numbers)


def require_text(text: str, vertices: int) -> None:
    """Reject text beyond the size limit."""
    require_size(_count_bytes(text))
    require_count(vertices, VERTEX, "vertices")
    require_count(text.count(","), _NUMBER, "numbers")


def require_size(size: int, what: str = "") -> None:
    """Reject a size in bytes beyond the limit; `what` begins the message."""
    if size > get_max_bytes():
        raise FormatError(f"{what}more than {get_max_mib():g} MiB (max_mib)")


def require_count(count: int, each: int, what: str) -> None:
    """Reject too many items, charged `each` bytes."""
    if count * each > get_max_bytes():
        raise FormatError(f"more than {get_max_bytes() // each:,} {what} (max_mib)")


def find_needed_mib(size: int) -> int | None:
    """Return the limit in MiB that a size in bytes needs; None if the default suffices."""
    return ceil(size / 2**20) if size > DEFAULT_MIB * 2**20 else None


def _count_bytes(text: str) -> int:
    return len(text) if text.isascii() else len(text.encode(errors="surrogatepass"))
