"""Selection of cases, from the corpus or a file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any, BinaryIO

from exactsweep.corpus.case import KINDS, Case
from exactsweep.corpus.case_json import case_from_json
from exactsweep.corpus.shipped import to_names
from exactsweep.formats import FormatError, show_path
from exactsweep.formats.exact_json import parse_certificate
from exactsweep.formats.files import open_bytes, split_lines
from exactsweep.formats.size import require_size
from exactsweep.numbers.error import ExactSweepError, name_refusals, quote

_FILTERS = {"id": "prefix", "flag": "flags", "class": "kind", "size": "max_size"}


class SelectionError(ExactSweepError):
    """A filter that does not exist, or cases with equal ids."""


def read_filters(filters: Iterable[str]) -> dict[str, Any]:
    """Read filters: id=PREFIX, flag=FLAG, class=CC, size=MOST.

    A case has one of the prefixes and of the classes, if there are several, and all of the flags.

    Returns:
        The arguments of `cases` and of `select`.

    Raises:
        SelectionError: anything else.

    Example:
        >>> read_filters(["flag=exact-fit", "size=20"])
        {'flags': ['exact-fit'], 'max_size': 20}
    """
    found: dict[str, Any] = {}
    for text in filters:
        name, equals, value = text.partition("=")
        if name not in _FILTERS or not equals:
            raise SelectionError(f"{quote(text)} is not id=..., flag=..., class=... or size=...")
        argument = _FILTERS[name]
        if name == "size" and argument in found:
            raise SelectionError("more than one filter size=...")
        found.setdefault(argument, []).append(value)
    if "max_size" in found:
        (size,) = found["max_size"]
        try:
            found["max_size"] = int(size)
        except ValueError:
            raise SelectionError(f"{quote(size)} is not a number of vertices") from None
    return found


def select(
    cases: Iterable[Case],
    *,
    prefix: str | Iterable[str] = "",
    flags: Iterable[str] = (),
    kind: str | Iterable[str] | None = None,
    max_size: int | None = None,
) -> Iterator[Case]:
    """Yield those of some cases that `cases` of the corpus would yield for these arguments."""
    prefixes, kinds, wanted = to_names(prefix), to_names(KINDS if kind is None else kind), {*flags}
    for case in cases:
        if (
            case.id.startswith(prefixes)
            and wanted <= set(case.flags)
            and case.kind in kinds
            and (max_size is None or case.size <= max_size)
        ):
            yield case


def require_distinct(cases: Iterable[Case]) -> Iterator[Case]:
    """Yield cases as long as no id comes twice.

    Raises:
        SelectionError: one does.
    """
    seen = set()
    for case in cases:
        if case.id in seen:
            raise SelectionError(f"two cases have the id {quote(case.id)}")
        seen.add(case.id)
        yield case


def read_cases(path: str) -> Iterator[Case]:
    """Read cases from a file of JSON lines, or from standard input, one by one.

    Args:
        path: a path, or "-" for standard input.

    Returns:
        An iterator of Case.

    Raises:
        FormatError: not to be read, or a line that is no case; the message names the file and line.
    """
    with open_bytes(path) as file:
        yield from read_lines(
            file, path, lambda number, line: case_from_json(parse_certificate(line))
        )


def read_lines(file: BinaryIO, path: str, read: Callable[[int, str], Case]) -> Iterator[Case]:
    """Read a case of each line that is not empty.

    Args:
        file: of lines.
        path: its name, for messages.
        read: a function of a line and its number.

    Raises:
        FormatError: a line that is no case; the message names the file and line.
    """
    for number, line in enumerate(split_lines(file), 1):
        if line.isspace():
            continue
        with name_refusals(f"{show_path(path)}, line {number}", FormatError):
            require_size(len(line))
            yield read(number, line.decode("utf-8-sig").strip())
