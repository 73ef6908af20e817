"""Size limits for input text; see 6 in `exactsweep.numbers.limits`."""

from math import ceil

from exactsweep.formats.error import FormatError
from exactsweep.numbers.limits import DEFAULT_MIB, get_limits

# Bytes charged per vertex, SVG element, DXF entity and rejected element.
VERTEX, ELEMENT, ENTITY, FAULT = 16, 32, 64, 1600
_NUMBER = 4  # bytes charged per number; lists have about as many numbers as commas


def measure_text(text: str, vertices: int) -> int:
    """Return the size of text in bytes, or the charge for its content if greater."""
    return weigh(_count_bytes(text), vertices, text.count(","))


def weigh(size: int, vertices: int, numbers: int) -> int:
    return max(size, VERTEX * vertices, _NUMBER * numbers)


def require_text(text: str, vertices: int) -> None:
    require_size(_count_bytes(text))
    require_count(vertices, VERTEX, "vertices")
    require_count(text.count(","), _NUMBER, "numbers")


def require_size(size: int, what: str = "") -> None:
    if size > get_limits().max_bytes:
        raise FormatError(f"{what}more than {get_limits().max_mib:g} MiB (max_mib)")


def require_count(count: int, each: int, what: str) -> None:
    if count * each > get_limits().max_bytes:
        raise FormatError(f"more than {get_limits().max_bytes // each:,} {what} (max_mib)")


def find_needed_mib(size: int) -> int | None:
    """Return the limit in MiB for a size in bytes; None if the default suffices."""
    return ceil(size / 2**20) if size > DEFAULT_MIB * 2**20 else None


def _count_bytes(text: str) -> int:
    return len(text) if text.isascii() else len(text.encode(errors="surrogatepass"))
