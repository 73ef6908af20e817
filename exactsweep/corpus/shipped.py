"""The cases that come with the package, a file a theme, read when they are asked for."""

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
from exactsweep.numbers.error import tells_arguments


@tells_arguments
def themes() -> dict[str, str]:
    """Return the themes, in order, each with its title.

    Every case's id starts with the name of its theme and a hyphen.

    Example:
        >>> themes()["fits"]
        'Slots that the generatrix fits exactly, and nearly'
    """
    return {name: _theme(name)["title"] for name in _names()}


@tells_arguments
def cases(
    *,
    prefix: str | Iterable[str] = "",
    flags: Iterable[str] = (),
    kind: str | Iterable[str] | None = None,
    max_size: int | None = None,
) -> Iterator[Case]:
    """Yield the shipped cases, in the order of themes, reading them one by one.

    Args:
        prefix: how the id starts, or several such beginnings; the name of a theme and a hyphen
            give that theme.
        flags: flags that the case must all have.
        kind: "CC", "CM", "MM" or "SS", or several of these.
        max_size: the most vertices of D and G together.

    Returns:
        An iterator of Case.

    Raises:
        UnknownNameError: no such flag or class.

    Cost: linear in the size of the themes that are read.

    Example:
        >>> [case.kind for case in cases(prefix="figures-10-")][0]
        'MM'
    """
    return map(case_from_json, _match(prefix, flags, kind, max_size))


class Summary(NamedTuple):
    """A case in a line: its id, class, number of vertices of D and G together, and title."""

    id: str
    kind: str
    size: int
    title: str


def list_summaries(**filters: Any) -> Iterator[Summary]:
    """Yield the summaries of cases, without reading the polygons; filters are those of `cases`.

    Example:
        >>> next(list_summaries(prefix="fits-")).title
        'A square into a slot as wide'
    """
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
        raise TypeError  # here, and not where the first case is asked for
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
    """Return one name, or several, as a tuple; raise TypeError if one is no str.

    >>> to_names("CC"), to_names(["CC", "CM"])
    (('CC',), ('CC', 'CM'))
    """
    names = (given,) if isinstance(given, str) else tuple(given)
    if not all(isinstance(name, str) for name in names):
        raise TypeError
    return names


def _size(data: dict[str, Any]) -> int:
    holes = [*data.get("directrix_holes", ()), *data.get("generatrix_holes", ())]
    return sum(map(len, (data["directrix"], data["generatrix"], *holes)))


def find_shipped_case(id: str) -> Case:
    """Return the shipped case of this id.

    Raises:
        UnknownNameError: no case has this id.

    Example:
        >>> find_shipped_case("figures-10-2-4-6").title
        'Figure 10: one tooth, two peaks and a tip of four flat edges'
    """
    require_known(id, list_ids(), "case")
    return case_from_json(next(data for data in _entries((id,)) if data["id"] == id))


def list_ids() -> list[str]:
    """Return the ids of the shipped cases, in their order."""
    return [data["id"] for data in _entries(("",))]


def read_schema() -> str:
    """Return the JSON Schema (2020-12) of a case; its "theme" in "$defs" is that of a file."""
    return files("exactsweep.corpus").joinpath("schema.json").read_text(encoding="utf-8")


def require_start(name: str, *others: str) -> str:
    """Return the beginning of ids of shipped cases.

    Args:
        name: the beginning.
        others: further words that may be meant.

    Raises:
        UnknownNameError: no id begins so; the message suggests a theme or an id.
    """
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
    """Read the file of a theme: NAME.json, or NAME.json.xz where it would be large."""
    plain = folder.joinpath(f"{name}.json")
    if plain.is_file():
        return plain.read_text(encoding="utf-8")
    return lzma.decompress(folder.joinpath(f"{name}.json.xz").read_bytes()).decode("utf-8")


@tells_arguments
def find_case(id: str) -> Case:
    """Return the case of this id: a shipped one, or a generated one, made again.

    Raises:
        UnknownNameError: no case has this id; the message suggests a similar id.

    Example:
        >>> find_case("gen-convex-1-0").kind
        'CC'
    """
    return generate_case(id) if id.startswith("gen-") else find_shipped_case(id)


class Note(NamedTuple):
    """The meaning of a flag of a case, and the kind of bug that such cases catch."""

    meaning: str
    catches: str


@cache
def notes() -> dict[str, Note]:
    """Return the note on each flag there is, by name.

    Example:
        >>> notes()["rounded-answer"].meaning
        'At the integer scale, some coordinate of the answer is not an integer.'
    """
    text = files("exactsweep.corpus").joinpath("notes.json").read_text(encoding="utf-8")
    return {flag: Note(**note) for flag, note in json.loads(text).items()}
