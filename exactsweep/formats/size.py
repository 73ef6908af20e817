"""For how much a text counts, by 6 of `exactsweep.numbers.limits`."""

from math import ceil

from exactsweep.formats.error import FormatError
from exactsweep.numbers.limits import DEFAULT_MIB, get_max_bytes, get_max_mib

VERTEX, ELEMENT, ENTITY, FAULT = 16, 32, 64, 1600
"""For how many bytes a vertex counts, an element of SVG, an entity of DXF, and what is no polygon,
of which a reason is kept."""

# Of lists without vertices there are as many numbers as commas.
_NUMBER = 4


def measure_text(text: str, vertices: int) -> int:
    """Count the bytes of a text, or those that its vertices and numbers count for, if more.

    Args:
        text: in a format with commas between numbers or vertices.
        vertices: how many there are.

    Returns:
        A number of bytes.

    Example:
        >>> measure_text("POLYGON ((0 0, 1 0, 0 1, 0 0))", 4), measure_text("é", 0)
        (64, 2)
    """
    return weigh(_count_bytes(text), vertices, text.count(","))


def weigh(size: int, vertices: int, numbers: int) -> int:
    """For how much so many bytes count, of which so many vertices or other numbers are read.

    Example:
        >>> weigh(70, 4, 6)
        70
    """
    return max(size, VERTEX * vertices, _NUMBER * numbers)


def require_text(text: str, vertices: int) -> None:
    """Refuse, with a FormatError, a text that counts for more than is read."""
    require_size(_count_bytes(text))
    require_count(vertices, VERTEX, "vertices")
    require_count(text.count(","), _NUMBER, "numbers")


def require_size(size: int, what: str = "") -> None:
    """Refuse more bytes than are read; the message begins with what they are.

    Example:
        >>> require_size(2**24 + 1)
        Traceback (most recent call last):
        exactsweep.formats.error.FormatError: more than 16 MiB (max_mib)
    """
    if size > get_max_bytes():
        raise FormatError(f"{what}more than {get_max_mib():g} MiB (max_mib)")


def require_count(count: int, each: int, what: str) -> None:
    """Refuse more things than are read.

    Args:
        count: how many there are.
        each: for how many bytes one of them counts.
        what: what they are.

    Raises:
        FormatError: they are too many.

    Example:
        >>> require_count(2**21, VERTEX, "vertices")
        Traceback (most recent call last):
        exactsweep.formats.error.FormatError: more than 1,048,576 vertices (max_mib)
    """
    if count * each > get_max_bytes():
        raise FormatError(f"more than {get_max_bytes() // each:,} {what} (max_mib)")


def find_needed_mib(size: int) -> int | None:
    """Find the limit, in MiB, under which that many bytes are read; None if they are unasked.

    Example:
        >>> find_needed_mib(2**24), find_needed_mib(2**24 + 1)
        (None, 17)
    """
    return ceil(size / 2**20) if size > DEFAULT_MIB * 2**20 else None


def _count_bytes(text: str) -> int:
    return len(text) if text.isascii() else len(text.encode(errors="surrogatepass"))
