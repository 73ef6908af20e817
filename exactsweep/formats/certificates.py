"""Certificates from files."""

from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import parse_certificate
from exactsweep.formats.files import file_name, read_text


def read_certificate(path: str) -> object:
    """Read a certificate from a file, or from standard input, as `parse_certificate` does.

    Args:
        path: a path, or "-" for standard input.

    Returns:
        What `exactsweep.check.verify` takes; what is in it is not looked at.

    Raises:
        FormatError: not to be read, or not JSON; the message names the file.
    """
    try:
        return parse_certificate(read_text(path))
    except ValueError as error:
        raise FormatError(f"{file_name(path)}: {error}") from None
