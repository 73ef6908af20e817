"""Selection of cases, from the corpus or a file."""

from collections.abc import Callable, Iterable, Iterator
from typing import Any, BinaryIO

from exactsweep.corpus.case import KINDS, Case
from exactsweep.corpus.case_json import case_from_json
from exactsweep.corpus.shipped import to_names
from exactsweep.formats import FormatError, show_path
from exactsweep.formats.exact_json import parse_certificate
from exactsweep.formats.files import open_bytes, split_lines
from exactsweep.formats.size import require_size
from exactsweep.numbers.error import ExactSweepError, prefix_errors, quote

_FILTERS = {"id": "prefix", "flag": "flags", "class": "kind", "size": "max_size"}


class SelectionError(ExactSweepError):
    """An unknown filter, or cases with equal ids."""


def read_filters(filters: Iterable[str]) -> dict[str, Any]:
    """Read filters id=PREFIX, flag=FLAG, class=CC, size=MAX as arguments of `cases` and `select`.

    A case must match one of the prefixes, one of the classes, and all flags.

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
            raise SelectionError("more than one size=... filter")
        found.setdefault(argument, []).append(value)
    if "max_size" in found:
        (size,) = found["max_size"]
        try:
            found["max_size"] = int(size)
        except ValueError:
            raise SelectionError(f"{quote(size)} is not an integer number of vertices") from None
    return found


def select(
    cases: Iterable[Case],
    *,
    prefix: str | Iterable[str] = "",
    flags: Iterable[str] = (),
    kind: str | Iterable[str] | None = None,
    max_size: int | None = None,
) -> Iterator[Case]:
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
    seen = set()
    for case in cases:
        if case.id in seen:
            raise SelectionError(f"duplicate case id {quote(case.id)}")
        seen.add(case.id)
        yield case


def read_cases(path: str) -> Iterator[Case]:
    with open_bytes(path) as file:
        yield from read_lines(
            file, path, lambda number, line: case_from_json(parse_certificate(line))
        )


def read_lines(file: BinaryIO, path: str, read: Callable[[int, str], Case]) -> Iterator[Case]:
    """Yield a case for each line that is not blank; `read` takes its number and text."""
    for number, line in enumerate(split_lines(file), 1):
        if line.isspace():
            continue
        with prefix_errors(f"{show_path(path)}, line {number}", FormatError):
            require_size(len(line))
            yield read(number, line.decode("utf-8-sig").strip())
