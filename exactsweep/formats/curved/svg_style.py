"""The style of SVG elements: their attributes, their `style`, and the rules of style sheets."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element

SPACE = "{http://www.w3.org/2000/svg}"
"""The namespace of SVG."""

# A comment, or a rule of its own kind, such as @media, with the rules in it; possessive throughout.
_PASSED = re.compile(
    r"/\*.*?(?:\*/|\Z)|<!--|-->|@[^{};]*+(?:;|\{(?:[^{}]*+\{[^{}]*+\})*+[^{}]*+\}|\{?)", re.DOTALL
)
_SIMPLE = re.compile(r"[.#]?[^\s.#:>+~\[\]*()]+|\*")
# The properties that are read.
_DRAWING = {"display", "visibility", "fill-rule", "transform"}


class Style:
    """The style sheets of a document, as far as their selectors are a name, a class or an id.

    Args:
        root: the document.

    Attributes:
        ignored: the other selectors, where their rules could change what is drawn.
    """

    def __init__(self, root: Element) -> None:
        self.ignored: list[str] = []
        self.rules: dict[str, dict[str, str]] = {}
        for sheet in root.iter():
            if name_kind(sheet) == "style":
                for rule in _PASSED.sub("", "".join(sheet.itertext())).split("}"):
                    selectors, _, body = rule.partition("{")
                    declared = dict(_declarations(body))
                    for selector in map(str.strip, selectors.split(",")):
                        if _SIMPLE.fullmatch(selector):
                            self.rules.setdefault(selector, {}).update(declared)
                        elif not _DRAWING.isdisjoint(declared):
                            self.ignored.append(selector)

    def find(self, element: Element, name: str) -> str | None:
        """Find a property of an element; None if it is not given."""
        attributes = element.attrib
        if not self.rules and "style" not in attributes:
            return attributes.get(name)
        for own, value in _declarations(attributes.get("style", "")):
            if own == name:
                return value
        classes = reversed(attributes.get("class", "").split())
        selectors = f"#{attributes.get('id')}", *(f".{one}" for one in classes), name_kind(element)
        for selector in (*selectors, "*") if self.rules else ():
            if name in self.rules.get(selector, ()):
                return self.rules[selector][name]
        return attributes.get(name)


def _declarations(text: str) -> Iterator[tuple[str, str]]:
    for declaration in text.split(";"):
        name, _, value = declaration.partition(":")
        yield name.strip(), value.strip().removesuffix("!important").rstrip()


def name_kind(element: Element) -> str:
    """Return the name of an element of SVG."""
    # Comments and processing instructions have a function for a tag.
    return element.tag.removeprefix(SPACE) if isinstance(element.tag, str) else ""


def find_link(element: Element) -> str:
    """Return the reference of an element, such as "#part"; "" if it has none."""
    return element.get("href", element.get("{http://www.w3.org/1999/xlink}href", ""))
