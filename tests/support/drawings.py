"""Part files as CAD and drawing programs write them, with their areas, from drawings.toml."""

import io
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache, cached_property
from operator import attrgetter
from pathlib import Path
from typing import Any

import ezdxf.filemanagement as files

ROOT = 'width="100mm" height="100mm" viewBox="0 0 100 100"'
SPACES = {
    "": "http://www.w3.org/2000/svg",
    ":xlink": "http://www.w3.org/1999/xlink",
    ":inkscape": "http://www.inkscape.org/namespaces/inkscape",
    ":sodipodi": "http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd",
}


@dataclass(frozen=True)
class Drawing:
    """A file.

    Attributes:
        name: with its ending.
        areas: of its regions, in order; () if it is rejected.
        options: at most two, with their values.
        reason: the reason for the rejection, or the report of omissions.
        content: describes the text.
    """

    name: str
    areas: tuple[float, ...]
    options: tuple[str, ...]
    reason: str
    content: Mapping[str, Any]

    @cached_property
    def text(self) -> str:
        match self.content:
            case {"text": str(text)}:
                return text
            case {"svg": body, **more}:
                return _svg(body, more.get("root", ROOT))
            case {"tags": tags}:
                around = [(0, "SECTION"), (2, "ENTITIES"), *tags, (0, "ENDSEC"), (0, "EOF")]
                return "".join(f"{code:>3}\r\n{value}\r\n" for code, value in around)
        return _dxf(**self.content)


@cache
def every_drawing() -> tuple[Drawing, ...]:
    """Return all drawings."""
    described = tomllib.loads(Path(__file__).with_suffix(".toml").read_text(encoding="utf-8"))
    return tuple(_describe(**drawing) for drawing in described["drawings"])


def _describe(
    name: str, areas: list[float], options: Iterable[str] = (), reason: str = "", **content: Any
) -> Drawing:
    return Drawing(name, tuple(areas), tuple(options), reason, content)


def _svg(body: str, attributes: str) -> str:
    spaces = " ".join(f'xmlns{prefix}="{space}"' for prefix, space in SPACES.items())
    head = '<?xml version="1.0" encoding="UTF-8" standalone="no"?>\n'
    return f'{head}<svg {attributes} version="1.1" {spaces}>\n{body}\n</svg>\n'


def _dxf(
    version: str,
    entities: list[dict[str, Any]],
    unit: int = 0,
    blocks: Iterable[dict[str, Any]] = (),
) -> str:
    document = files.new(version)
    document.units = unit
    for block in blocks:
        base = block.get("base_point", (0, 0))
        _draw(document.blocks.new(block["name"], base_point=base), block["entities"])
    _draw(document.modelspace(), entities)
    text = io.StringIO()
    document.write(text)
    return text.getvalue()


def _draw(space: Any, entities: list[dict[str, Any]]) -> None:
    for described in entities:
        add = getattr(space, f"add_{described['add']}")
        entity = add(*described.get("given", ()), **described.get("named", {}))
        for name, value in described.get("set", {}).items():
            setattr(entity, name, value)
        for name, given, named in described.get("then", ()):
            attrgetter(name)(entity)(*given, **named)
