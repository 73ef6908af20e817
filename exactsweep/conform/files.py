"""A case and an answer, from files."""

from __future__ import annotations

from pathlib import Path

from exactsweep.corpus import Case, case_from_json, find_case
from exactsweep.formats import FormatError, file_name, read_text
from exactsweep.formats.exact_json import described, parse_certificate, parse_json, read_vertices


def read_case(name: str) -> Case:
    """Read a case.

    Args:
        name: the path of a file, "-" for standard input, or the id of a case of the corpus or of
            a generated one. The file holds a case as `case_from_json` reads it; or just a pair, an
            object with "directrix" and "generatrix" and, if wanted, "reference", such as
            `exactsweep sweep --json` writes.

    Returns:
        The Case; of a pair without "id", the name of the file is the id.

    Raises:
        ValueError: none of these; the message names the file.
    """
    if name != "-" and not Path(name).exists():
        return find_case(name)
    try:
        text = read_text(name)
        document = parse_json(text)
        if not isinstance(document, dict):
            raise FormatError(f"$ is {described(document)}, not an object")
        if "expected" in document:
            return case_from_json(parse_certificate(text))
        return _pair(document, name)
    except ValueError as error:
        raise FormatError(f"{file_name(name)}: {error}") from None


def read_result(path: str) -> object:
    """Read an answer: JSON, in which integers are ints and other numbers binary64.

    Args:
        path: of a file, or "-" for standard input.

    Returns:
        What `compare` takes, whatever it may be.

    Raises:
        FormatError: not to be read, or not JSON.
    """
    try:
        return parse_certificate(read_text(path))
    except ValueError as error:
        raise FormatError(f"{file_name(path)}: {error}") from None


def _pair(document: dict[str, object], name: str) -> Case:
    for part in ("directrix", "generatrix"):
        if part not in document:
            raise FormatError(f'$ has neither "expected", as a case has, nor "{part}"')
    (reference,) = read_vertices([document.get("reference", ["0", "0"])], "$.reference")
    return Case.of(
        str(document.get("id", file_name(name))),
        "",
        read_vertices(document["directrix"], "$.directrix"),
        read_vertices(document["generatrix"], "$.generatrix"),
        reference,
    )
