"""The shipped cases, one file per theme, read on demand."""

import json
import lzma
from collections.abc import Iterable, Iterator
from functools import cache
from importlib.resources import files
from importlib.resources.abc import Traversable
from typing import Any, NamedTuple

from exactsweep.corpus.case import KINDS, Case
from exactsweep.corpus.case_json import case_from_json
from exactsweep.corpus.generator import generate_case
from exactsweep.corpus.names import require_known
from exactsweep.numbers.error import explain_type_errors


@explain_type_errors
def themes() -> dict[str, str]:
    """Return the titles of the themes by name.

    The id of a case starts with the name of its theme and a hyphen.

    >>> themes()["fits"]
    'Slots that the generatrix fits exactly, and nearly'
    """
    return {name: _theme(name)["title"] for name in _names()}


@explain_type_errors
def cases(
    *,
    prefix: str | Iterable[str] = "",
    flags: Iterable[str] = (),
    kind: str | Iterable[str] | None = None,
    max_size: int | None = None,
) -> Iterator[Case]:
    """Yield the shipped cases, theme by theme.

    Args:
        prefix: an id prefix, such as the name of a theme and a hyphen, or several prefixes.
        flags: the required flags.
        kind: "CC", "CM", "MM" or "SS", or several of them.
        max_size: the maximum number of vertices of D and G.

    Raises:
        UnknownNameError: a flag or class does not exist.

    Example:
        >>> [case.kind for case in cases(prefix="figures-10-")][0]
        'MM'
    """
    return map(case_from_json, _match(prefix, flags, kind, max_size))


class Summary(NamedTuple):
    id: str
    kind: str
    size: int  # the number of vertices of D and G
    title: str


def list_summaries(**filters: Any) -> Iterator[Summary]:
    for data in _match(**filters):
        yield Summary(data["id"], data["class"], _size(data), data["title"])


def _match(
    prefix: str | Iterable[str] = "",
    flags: Iterable[str] = (),
    kind: str | Iterable[str] | None = None,
    max_size: int | None = None,
) -> Iterator[dict[str, Any]]:
    prefixes, kinds = to_names(prefix), to_names(KINDS if kind is None else kind)
    if not isinstance(max_size, int | None):
        raise TypeError
    wanted = {require_known(flag, notes(), "flag") for flag in flags}
    for one in kinds:
        require_known(one, KINDS, "class")
    return (
        data
        for data in _entries(prefixes)
        if wanted <= set(data["flags"])
        and data["class"] in kinds
        and (max_size is None or _size(data) <= max_size)
    )


def to_names(given: str | Iterable[str]) -> tuple[str, ...]:
    names = (given,) if isinstance(given, str) else tuple(given)
    if not all(isinstance(name, str) for name in names):
        raise TypeError
    return names


def _size(data: dict[str, Any]) -> int:
    holes = [*data.get("directrix_holes", ()), *data.get("generatrix_holes", ())]
    return sum(map(len, (data["directrix"], data["generatrix"], *holes)))


def list_ids() -> list[str]:
    return [data["id"] for data in _entries(("",))]


def read_schema() -> str:
    """Return the JSON Schema (2020-12) of a case; "theme" in "$defs" describes a file."""
    return files("exactsweep.corpus").joinpath("schema.json").read_text(encoding="utf-8")


def require_prefix(name: str, *others: str) -> str:
    """Require that some id has a prefix; otherwise suggest a similar one."""
    ids = list_ids()
    if not any(id.startswith(name) for id in ids):
        require_known(name, [*others, *themes(), *ids], "theme or case")
    return name


def _entries(prefixes: tuple[str, ...]) -> Iterator[dict[str, Any]]:
    for name in _names():
        start = f"{name}-"
        if any(start.startswith(prefix) or prefix.startswith(start) for prefix in prefixes):
            yield from (data for data in _theme(name)["cases"] if data["id"].startswith(prefixes))


@cache
def _names() -> tuple[str, ...]:
    listed = (file.name for file in files("exactsweep.corpus").joinpath("data").iterdir())
    return tuple(sorted(name.partition(".json")[0] for name in listed if ".json" in name))


@cache
def _theme(name: str) -> Any:
    return json.loads(read_theme(files("exactsweep.corpus").joinpath("data"), name))


def read_theme(folder: Traversable, name: str) -> str:
    plain = folder.joinpath(f"{name}.json")
    if plain.is_file():
        return plain.read_text(encoding="utf-8")
    return lzma.decompress(folder.joinpath(f"{name}.json.xz").read_bytes()).decode("utf-8")


@explain_type_errors
def find_case(id: str) -> Case:
    """Find a shipped or generated case by its id; raise UnknownNameError if there is none.

    >>> find_case("gen-convex-1-0").kind
    'CC'
    """
    if id.startswith("gen-"):
        return generate_case(id)
    require_known(id, list_ids(), "case")
    return case_from_json(next(data for data in _entries((id,)) if data["id"] == id))


class Note(NamedTuple):
    """The meaning of a flag, and the bugs that its cases catch."""

    meaning: str
    catches: str


@cache
def notes() -> dict[str, Note]:
    """Read the notes on flags.

    >>> notes()["rounded-answer"].meaning
    'At the integer scale, some coordinate of the answer is not an integer.'
    """
    return {flag: Note(**note) for flag, note in read_shipped("notes").items()}


@cache
def read_shipped(name: str) -> Any:
    text = files("exactsweep.corpus").joinpath(f"{name}.json").read_text(encoding="utf-8")
    return json.loads(text)
