"""Style of SVG elements: attributes, `style`, and rules of style sheets."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

SPACE = "{http://www.w3.org/2000/svg}"
"""The namespace of SVG."""

# A comment, or an at-rule such as @media with the rules in it; possessive throughout.
_PASSED = re.compile(
    r"/\*.*?(?:\*/|\Z)|<!--|-->|@[^{};]*+(?:;|\{(?:[^{}]*+\{[^{}]*+\})*+[^{}]*+\}|\{?)", re.DOTALL
)
_SIMPLE = re.compile(r"[.#]?[^\s.#:>+~\[\]*()]+|\*")
_COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)", re.DOTALL)
# Properties that show, rotate or move a shape; and all that are read, with sizes and colors.
_DRAWING = {"display", "visibility", "fill-rule", "transform", "transform-origin", "transform-box"}
_DRAWING |= {"rotate", "scale", "translate"}
_READ = {*_DRAWING, "fill", "stroke", "x", "y", "width", "height", "cx", "cy", "r", "rx", "ry"}

_Declared = tuple[bool, int, int, str]
"""A declaration: its importance, the rank of its selector, its number, its value."""

_RANKS = {"*": 0, ".": 2, "#": 3}
_NAME_RANK, _STYLE_RANK = 1, 4


class Style:
    """Style sheets, with selectors by name, class or id; others are in `ignored`."""

    def __init__(self, root: Element) -> None:
        self.ignored: list[str] = []
        self._rules: dict[str, dict[str, _Declared]] = {}
        self._number = 0
        for sheet in root.iter():
            if name_kind(sheet) == "style":
                for rule in _PASSED.sub("", "".join(sheet.itertext())).split("}"):
                    selectors, _, body = rule.partition("{")
                    self._add(selectors, body)

    def _add(self, selectors: str, body: str) -> None:
        declared: dict[str, _Declared] = {}
        for name, value, important in _declarations(body):
            if name in _READ:
                self._number += 1
                _declare(declared, name, (important, 0, self._number, value))
        for selector in map(str.strip, selectors.split(",")) if declared else ():
            if _SIMPLE.fullmatch(selector):
                rules = self._rules.setdefault(selector, {})
                rank = _RANKS.get(selector[0], _NAME_RANK)
                for name, (important, _, number, value) in declared.items():
                    _declare(rules, name, (important, rank, number, value))
            elif not _DRAWING.isdisjoint(declared):
                self.ignored.append(selector)

    def read(self, element: Element) -> dict[str, str]:
        """Return the properties that styles give an element, by the cascade of CSS."""
        attributes = element.attrib
        found: dict[str, _Declared] = {}
        if self._rules:
            classes = (f".{one}" for one in attributes.get("class", "").split())
            for selector in ("*", name_kind(element), *classes, f"#{attributes.get('id')}"):
                for name, declared in self._rules.get(selector, {}).items():
                    _declare(found, name, declared)
        if "style" in attributes:
            for k, (name, value, important) in enumerate(_declarations(attributes["style"])):
                _declare(found, name, (important, _STYLE_RANK, k, value))
        return {name: value for name, (*_, value) in found.items()}


def _declare(found: dict[str, _Declared], name: str, declared: _Declared) -> None:
    """Add a declaration unless the present one has precedence."""
    found[name] = max(declared, found.get(name, declared))


def _declarations(text: str) -> Iterator[tuple[str, str, bool]]:
    """Yield the name of each declared property, its value, and whether it is important."""
    for declaration in _COMMENT.sub("", text).split(";"):
        name, _, value = declaration.partition(":")
        value, important, _ = value.lower().partition("!important")
        yield name.strip().lower(), value.strip(), bool(important)


def name_kind(element: Element) -> str:
    """Return the name of an element of SVG."""
    # The tag of a comment or processing instruction is a function.
    return element.tag.removeprefix(SPACE) if isinstance(element.tag, str) else ""


def find_link(element: Element) -> str:
    """Return the reference of an element, such as "#part"; "" for none."""
    return element.get("href", element.get("{http://www.w3.org/1999/xlink}href", ""))
