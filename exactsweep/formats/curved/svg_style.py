"""Styles of SVG elements: `style` attributes and style sheets."""

import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from itertools import count
from xml.etree.ElementTree import Element

SPACE = "{http://www.w3.org/2000/svg}"
# A comment, or an at-rule such as @media with its rules; possessive, to run in linear time.
_PASSED = re.compile(
    r"/\*.*?(?:\*/|\Z)|<!--|-->|@[^{};]*+(?:;|\{(?:[^{}]*+\{[^{}]*+\})*+[^{}]*+\}|\{?)", re.DOTALL
)
_SIMPLE = re.compile(r"[.#]?[^\s.#:>+~\[\]*()]+|\*")
_COMMENT = re.compile(r"/\*.*?(?:\*/|\Z)", re.DOTALL)
# Properties that show or move a shape, and all properties that are read.
_DRAWING = {"display", "visibility", "fill-rule", "transform", "transform-origin", "transform-box"}
_DRAWING |= {"rotate", "scale", "translate"}
_READ = {*_DRAWING, "fill", "stroke", "x", "y", "width", "height", "cx", "cy", "r", "rx", "ry"}

_Declared = tuple[bool, int, str, str]  # importance, order, name and value


class Style:
    """Style sheets with selectors by name, class or id; `ignored` lists other selectors."""

    def __init__(self, root: Element) -> None:
        self.ignored: list[str] = []
        self._rules: defaultdict[str, list[_Declared]] = defaultdict(list)
        numbers = count()
        for sheet in root.iter():
            if name_kind(sheet) == "style":
                for rule in _PASSED.sub("", "".join(sheet.itertext())).split("}"):
                    selectors, _, body = rule.partition("{")
                    declared = [one for one in _list_declared(body, numbers) if one[2] in _READ]
                    self._add(selectors, declared)

    def _add(self, selectors: str, declared: Sequence[_Declared]) -> None:
        for selector in map(str.strip, selectors.split(",")) if declared else ():
            if _SIMPLE.fullmatch(selector):
                self._rules[selector] += declared
            elif any(name in _DRAWING for _, _, name, _ in declared):
                self.ignored.append(selector)

    def read(self, element: Element) -> dict[str, str]:
        attributes = element.attrib
        classes = (f".{one}" for one in attributes.get("class", "").split())
        if not self._rules and "style" not in attributes:
            return {}
        known = (("*",), (name_kind(element),), classes, (f"#{attributes.get('id')}",))
        found = [
            (important, rank, number, name, value)
            for rank, selectors in enumerate(known)
            for selector in selectors
            for important, number, name, value in self._rules.get(selector, ())
        ]
        own = _list_declared(attributes.get("style", ""), count())
        found += [
            (important, len(known), number, name, value) for important, number, name, value in own
        ]
        return {name: value for *_, name, value in sorted(found)}


def _list_declared(text: str, numbers: Iterator[int]) -> Iterator[_Declared]:
    for declaration in _COMMENT.sub("", text).split(";"):
        name, _, value = declaration.partition(":")
        value, important, _ = value.lower().partition("!important")
        yield bool(important), next(numbers), name.strip().lower(), value.strip()


def name_kind(element: Element) -> str:
    # The tag of a comment or processing instruction is a function.
    return element.tag.removeprefix(SPACE) if isinstance(element.tag, str) else ""


def find_link(element: Element) -> str:
    return element.get("href", element.get("{http://www.w3.org/1999/xlink}href", ""))
