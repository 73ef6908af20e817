"""Files and standard input, as text."""

import re
import sys
from codecs import BOM_UTF16_BE, BOM_UTF16_LE
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import BinaryIO

from exactsweep.formats.error import FormatError
from exactsweep.formats.size import require_size
from exactsweep.numbers.error import ExactSweepError, explain_type_errors, quote
from exactsweep.numbers.limits import get_limits

# The start of a DXF text; possessive, to match blank lines and comments in linear time.
DXF_SIGN = re.compile(r"(?:\s*+999[^\S\n]*+\n[^\n]*+\n)*+\s*+0[^\S\n]*+\n\s*+SECTION\b")
_MOST_SHOWN = 400
_XML_ENCODING = re.compile(
    rb"\s*<\?xml\b[^>]*\bencoding\s*=\s*[\"'](iso-8859-\d+|windows-125\d)", re.IGNORECASE
)


@explain_type_errors
def read_text(path: str) -> str:
    """Read a whole file, or standard input for "-", without a byte order mark.

    Raises:
        FormatError: unreadable, too large, or in an unknown encoding.
    """
    if not isinstance(path, str):
        # `open` would interpret an int as a file descriptor.
        raise FormatError(f"{quote(path)} is not a path")
    try:
        with _open(path) as file:
            # Read one byte past the limit, to detect larger files and endless devices.
            data = file.read(get_limits().max_bytes + 1)
    except OSError as error:
        raise FormatError(error.strerror or str(error)) from None
    require_size(len(data))
    if data.startswith(b"AutoCAD Binary DXF"):
        raise FormatError("a binary DXF file; save it as ASCII DXF")
    if data.startswith(b"\x1f\x8b"):
        raise FormatError("a gzip file; decompress it first")
    try:
        return decode_text(data)
    except FormatError:
        from exactsweep.formats.plain import reject_unsupported

        reject_unsupported(data[:80].decode("latin-1"))
        if declared := _XML_ENCODING.match(data):
            with suppress(ValueError, LookupError):
                return data.decode(declared[1].decode())
        # The code page of older DXF affects only layer names.
        latin = data.decode("latin-1")
        if DXF_SIGN.match(latin):
            return latin
        raise


def decode_text(data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        if data.startswith((BOM_UTF16_LE, BOM_UTF16_BE)):
            raise FormatError("UTF-16 text; save it as UTF-8") from None
        raise FormatError(f"not UTF-8 text: {error.reason} at byte {error.start}") from None


@explain_type_errors
def show_path(path: str) -> str:
    r"""Format a path for a message, on one line, abbreviated if very long.

    >>> show_path("-"), show_path("two\nlines") == ascii("two\nlines")
    ('standard input', True)
    """
    if path == "-":
        return "standard input"
    if len(path) > _MOST_SHOWN:
        path = f"{path[: _MOST_SHOWN // 2]}...{path[-_MOST_SHOWN // 2 :]}"
    return path if path and path.isprintable() else ascii(path)


@contextmanager
def _open(path: str) -> Iterator[BinaryIO]:
    if path != "-":
        with open(path, "rb") as file:
            yield file
    elif sys.stdin is None:
        raise OSError("closed")
    else:
        yield sys.stdin.buffer


@contextmanager
def open_bytes(path: str) -> Iterator[BinaryIO]:
    with prefix_os_errors(path), _open(path) as file:
        yield file


@contextmanager
def prefix_os_errors(path: str, error_type: type[ExactSweepError] = FormatError) -> Iterator[None]:
    """Convert an OSError to an error that names the file."""
    try:
        yield
    except OSError as error:
        raise error_type(f"{show_path(path)}: {error.strerror or error}") from None


def split_lines(file: BinaryIO) -> Iterator[bytes]:
    """Yield the lines of a file; truncate a line to one byte more than the limit."""
    most = get_limits().max_bytes
    while line := file.readline(most + 1):
        yield line
        while len(line) > most and not line.endswith(b"\n"):
            line = file.readline(most + 1)
