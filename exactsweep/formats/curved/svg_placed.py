"""SVG elements with styles and inherited transforms, viewports, units, layers and fill rules."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import cached_property
from itertools import count
from xml.etree.ElementTree import Element

from exactsweep.formats.curved.affine import IDENTITY, Affine, scale_axes, translate
from exactsweep.formats.curved.svg_transform import compose, read_transform
from exactsweep.formats.curved.xml import line
from exactsweep.formats.decimals import read_decimal, read_decimals
from exactsweep.formats.error import FormatError
from exactsweep.formats.filling import Rule
from exactsweep.formats.reading import UNITS, Reading
from exactsweep.numbers.error import prefix_errors, quote

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
_INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"
_VIEWS = {"svg", "symbol"}
# Style properties that move an element, and the only supported transform origin.
_STYLED = "transform", "rotate", "scale", "translate"
_ORIGIN = re.compile(r"(?:\s*0(?:px)?\b){2,3}\s*")
_BOXES = None, "view-box"
# Pixels per unit; percentages are resolved for each attribute.
_PX = {unit: UNITS[unit] / UNITS["px"] for unit in ("mm", "cm", "in", "pt", "pc", "px")}
_PX |= {"": Fraction(1), "%": Fraction(1)}


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


class PlacedElement:
    """An element with its ancestors; `used` is the `use` that draws it and sets its size."""

    def __init__(
        self,
        element: Element,
        parent: PlacedElement | None,
        reading: Reading,
        used: PlacedElement | None = None,
        style: Style | None = None,
    ) -> None:
        self.element, self.parent, self.reading, self.used = element, parent, reading, used
        self._inherited: dict[str, str] = {}
        self._style: Style | None = style or (parent._style if parent else None)

    @cached_property
    def styled(self) -> dict[str, str]:
        return self._style.read(self.element) if self._style else {}

    def style(self, name: str) -> str | None:
        return self.styled.get(name, self.element.get(name))

    def inherited(self, name: str, initial: str) -> str:
        """Return an inherited property, and cache it for all ancestors."""
        asked: list[PlacedElement] = []
        placed: PlacedElement | None = self
        while placed is not None and name not in placed._inherited:
            asked.append(placed)
            placed = placed.parent
        value = placed._inherited[name] if placed else initial
        for placed in reversed(asked):
            own = placed.style(name)
            value = placed._inherited[name] = own if own and own != "inherit" else value
        return value

    @cached_property
    def place(self) -> str:
        name = f" {quote(self.element.attrib['id'])}" if "id" in self.element.attrib else ""
        return f"line {line(self.element)}: {name_kind(self.element)}{name}"

    @property
    def transform(self) -> str:
        """The transform attribute; raises FormatError if a style also moves the element."""
        found: str = self.element.get("transform", "")
        if any(map(self.styled.get, _STYLED)):
            raise FormatError("transformations in a style are not supported")
        center, box = self.style("transform-origin"), self.style("transform-box")
        if found and not (_ORIGIN.fullmatch(center or "0 0") and box in _BOXES):
            raise FormatError("transform-origin is not supported")
        return found

    @cached_property
    def matrix(self) -> Affine:
        outer = IDENTITY if self.parent is None else self.parent.matrix
        with prefix_errors(self.place, FormatError):
            product = compose(outer, read_transform(self.transform))
            if self.parent is None:
                return compose(scale_axes(self.unit, self.unit), product)
            if name_kind(self.element) == "use":
                return compose(product, translate(self.length("x"), self.length("y")))
            return compose(product, self._view()) if name_kind(self.element) in _VIEWS else product

    @cached_property
    def layer(self) -> str | None:
        attributes = self.element.attrib
        if attributes.get(f"{_INKSCAPE}groupmode") == "layer":
            return attributes.get(f"{_INKSCAPE}label", attributes.get("id"))
        return None if self.parent is None else self.parent.layer

    @cached_property
    def groups(self) -> tuple[str, ...]:
        around = self.parent.groups if self.parent else ()
        own = self.element.get("id") if name_kind(self.element) == "g" else None
        return (*around, own) if own else around

    @property
    def rule(self) -> Rule:
        """The inherited fill rule; unknown ones are nonzero, as in browsers."""
        return "evenodd" if self.inherited("fill-rule", "nonzero") == "evenodd" else "nonzero"

    def length(self, name: str, default: str | None = "0") -> Fraction:
        """Return a length attribute in user units, at 96 px per inch."""
        text = self.element.get(name, default)
        if text is None:
            raise FormatError(f"{name} is missing")
        if self.parent and self.styled.get(name):
            raise FormatError(f"{name} in a style is not supported")
        text = text.strip()
        unit = next((unit for unit in _PX if unit and text.endswith(unit)), "")
        number = text.removesuffix(unit).rstrip()
        with prefix_errors(name, FormatError):
            return read_decimal(number) * (self._whole(name) / 100 if unit == "%" else _PX[unit])

    def _whole(self, name: str) -> Fraction:
        """Return the side of the viewport that a percentage refers to."""
        width, height = self.parent.viewport if self.parent else (None, None)
        across = name in ("x", "x1", "x2", "cx", "rx", "width")
        found = width if across or width == height else None if name == "r" else height
        if found is None:
            raise FormatError("percentage of an unknown or irrational length")
        return found

    @cached_property
    def viewport(self) -> tuple[Fraction | None, Fraction | None]:
        if name_kind(self.element) not in _VIEWS:
            return self.parent.viewport if self.parent else (None, None)
        if "viewBox" in self.element.attrib:
            return self._box()[2], self._box()[3]
        return self._known("width"), self._known("height")

    def _known(self, name: str) -> Fraction | None:
        try:
            return self._extent(name)
        except FormatError:
            return None

    def size(self, name: str, default: str | None = None) -> Fraction:
        found = self.length(name, default)
        if found < 0:
            raise FormatError(f"{name} is negative")
        return found

    @cached_property
    def unit(self) -> Fraction:
        attributes = self.element.attrib
        unit = None
        text = attributes.get("width", "").strip()
        try:
            if "viewBox" not in attributes:
                unit = UNITS["px"]
            elif text and not text.endswith("%"):
                unit = self._measure_unit() * UNITS["px"]
        except FormatError:
            if self.reading.unit is not None:
                raise
        return self.reading.scale(unit or None)

    def _box(self) -> list[Fraction]:
        box = read_decimals(self.element.get("viewBox", ""))
        if len(box) != 4 or box[2] <= 0 or box[3] <= 0:
            raise FormatError("viewBox must be x, y and two positive sizes")
        return box

    def _view(self) -> Affine:
        """Return the map from the inside of a nested svg or a symbol to the outside."""
        attributes = self.element.attrib
        x, y = (self.length(axis) if name_kind(self.element) == "svg" else 0 for axis in "xy")
        at = translate(x, y)
        if "viewBox" not in attributes:
            return at
        left, top, width, height = self._box()
        sizes = [self._extent("width"), self._extent("height")]
        scales = [size / own for size, own in zip(sizes, (width, height), strict=True) if size]
        if len(scales) < 2:
            raise FormatError("no width or height, so nothing is drawn")
        fitted, shares = self._fit(scales)
        rests = [
            share * (scale - own_scale) * own
            for share, scale, own_scale, own in zip(
                shares, scales, fitted, (width, height), strict=True
            )
        ]
        return at @ translate(*rests) @ scale_axes(*fitted) @ translate(-left, -top)

    def _fit(self, scales: list[Fraction]) -> tuple[list[Fraction], list[Fraction]]:
        """Return the scales by preserveAspectRatio, and the share of spare space before each."""
        ratio = self.element.get("preserveAspectRatio", "xMidYMid")
        fit, _, how = ratio.strip().partition(" ")
        if fit == "none":
            return scales, [Fraction(0), Fraction(0)]
        if (fit[:1], fit[4:5]) != ("x", "Y") or not {fit[1:4], fit[5:]} <= _SHARES.keys():
            raise FormatError(f"unknown preserveAspectRatio {quote(fit)}")
        scale = max(scales) if how == "slice" else min(scales)
        return [scale, scale], [_SHARES[fit[1:4]], _SHARES[fit[5:]]]

    def _measure_unit(self) -> Fraction:
        """Return the px per unit of the root's viewBox."""
        _, _, width, height = self._box()
        across = down = self.size("width") / width
        text = self.element.get("height", "%").strip()
        if not text.endswith("%"):
            down = self.size("height") / height
        fitted, _ = self._fit([across, down])
        if fitted[0] != fitted[1]:
            raise FormatError("the horizontal and vertical units differ")
        return fitted[0]

    def _extent(self, name: str) -> Fraction:
        """Return the size of a view from its `use`, its own attribute, or 100%."""
        used = self.used if self.used and name in self.used.element.attrib else self
        return used.size(name, "100%")


# Alignment as the share of the spare space before a view.
_SHARES = {"Min": Fraction(0), "Mid": Fraction(1, 2), "Max": Fraction(1)}
