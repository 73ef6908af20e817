"""Files and standard input, as text."""

import sys

from exactsweep.formats.error import FormatError

MAX_BYTES = 16 * 2**20
"""The most bytes that are read from one file."""


def read_text(path: str) -> str:
    """Read a whole file, or standard input.

    Args:
        path: a path, or "-" for standard input.

    Returns:
        The text, without a byte order mark.

    Raises:
        FormatError: not readable, more than MAX_BYTES, not UTF-8.
    """
    try:
        data = _read_bytes(path)
    except OSError as error:
        raise FormatError(error.strerror or str(error)) from None
    if len(data) > MAX_BYTES:
        raise FormatError(f"more than {MAX_BYTES} bytes")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise FormatError(f"not UTF-8 text: {error.reason} at byte {error.start}") from None


def file_name(path: str) -> str:
    """Return a path as it is shown in a message: always on one line."""
    if path == "-":
        return "standard input"
    return path if path and path.isprintable() else ascii(path)


def _read_bytes(path: str) -> bytes:
    # One byte too many is enough to know, even of a device without end.
    if path != "-":
        with open(path, "rb") as file:
            return file.read(MAX_BYTES + 1)
    if sys.stdin is None:
        raise FormatError("closed")
    return sys.stdin.buffer.read(MAX_BYTES + 1)
