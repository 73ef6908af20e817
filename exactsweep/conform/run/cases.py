"""Selection of the cases for an implementation, from the corpus or a stream."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from typing import BinaryIO, Self

from exactsweep.conform.run.protocol import read_object
from exactsweep.corpus import Case, case_from_json, cases
from exactsweep.formats import FormatError, show_path
from exactsweep.formats.files import open_bytes, split_lines
from exactsweep.formats.size import require_size
from exactsweep.numbers.error import ExactSweepError, name_refusals, quote


class SelectionError(ExactSweepError):
    """A filter that does not exist, or cases with equal ids."""


@dataclass(frozen=True)
class Selection:
    """Conditions that a case must meet; the default is any case.

    Attributes:
        prefix: how its id starts.
        flags: flags that it must all have.
        kind: its class, or None.
        max_size: the most vertices of D and G together, or None.
    """

    prefix: str = ""
    flags: tuple[str, ...] = ()
    kind: str | None = None
    max_size: int | None = None

    @classmethod
    def of(cls, filters: Iterable[str]) -> Self:
        """Read filters: id=PREFIX, flag=FLAG, class=CC, size=MOST; flags may be several.

        Raises:
            SelectionError: anything else.

        Example:
            >>> Selection.of(["flag=exact-fit", "size=20"])
            Selection(prefix='', flags=('exact-fit',), kind=None, max_size=20)
        """
        found: dict[str, list[str]] = {"id": [], "flag": [], "class": [], "size": []}
        for text in filters:
            name, equals, value = text.partition("=")
            if name not in found or not equals:
                raise SelectionError(
                    f"{quote(text)} is not id=..., flag=..., class=... or size=..."
                )
            found[name].append(value)
        for name in ("id", "class", "size"):
            if len(found[name]) > 1:
                raise SelectionError(f"more than one filter {name}=...")
        try:
            sizes = [int(size) for size in found["size"]]
        except ValueError:
            raise SelectionError(f"{quote(found['size'][0])} is not a number of vertices") from None
        kind, most = next(iter(found["class"]), None), next(iter(sizes), None)
        return cls("".join(found["id"]), tuple(found["flag"]), kind, most)

    def shipped(self) -> Iterator[Case]:
        """Yield the cases of the corpus that fit.

        Raises:
            UnknownNameError: there is no such flag or class.
        """
        return cases(prefix=self.prefix, flags=self.flags, kind=self.kind, max_size=self.max_size)

    def among(self, cases: Iterable[Case]) -> Iterator[Case]:
        """Yield those of some cases that fit."""
        wanted = set(self.flags)
        for case in cases:
            if (
                case.id.startswith(self.prefix)
                and wanted <= set(case.flags)
                and self.kind in (None, case.kind)
                and (self.max_size is None or case.size <= self.max_size)
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
        yield from read_lines(file, path, lambda number, line: case_from_json(read_object(line)))


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
