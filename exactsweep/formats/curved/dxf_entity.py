"""DXF entities, with unparsed values."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from itertools import compress, pairwise
from typing import NamedTuple, cast

from exactsweep.formats.curved.affine import IDENTITY, Affine
from exactsweep.formats.decimals import read_decimal
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import INSUNITS, Reading
from exactsweep.formats.size import ENTITY, require_count, require_size
from exactsweep.numbers.error import prefix_errors, quote
from exactsweep.numbers.number import Point

_LAYER, _FLAGS, _PAPER, _NAME, _INVISIBLE, _COLOR, _PLOT = 8, 70, 67, 2, 60, 62, 290
_BULGE, _COMMENT = 42, 999
_FROZEN = 1
# The groups of the extrusion direction, and their defaults.
_NORMAL = {210: "0", 220: "0", 230: "1"}
_MIRRORED = Affine(*map(Fraction, (-1, 0, 0, 1, 0, 0)))
_FRAME = 16
_LONG = 40  # longer kinds are quoted
_GROUP = 4  # minimum bytes of a group code and two line ends
FROZEN = "frozen"  # the state of a layer that also hides blocks inserted on it


class Entity:
    """An entity: its group codes and texts, its line, and the VERTEX entities of a POLYLINE."""

    __slots__ = ("codes", "kind", "line", "texts", "vertices")

    def __init__(self, codes: Sequence[int], texts: Sequence[str], line: int) -> None:
        self.codes, self.texts, self.line = codes, texts, line
        self.kind = texts[0].strip()
        self.vertices: Sequence[Entity] = ()

    @property
    def place(self) -> str:
        is_word = self.kind.isidentifier() and len(self.kind) < _LONG
        return f"line {self.line}: {self.kind if is_word else quote(self.kind)}"

    @property
    def layer(self) -> str:
        return self._text(_LAYER, "0")

    @property
    def size(self) -> int:
        """The bytes charged for the entity and its vertices."""
        own = ENTITY + sum(len(text) + _GROUP for text in self.texts)
        return own + sum(vertex.size for vertex in self.vertices)

    def number(self, code: int, default: str | None = None) -> Fraction:
        text = self._text(code, default)
        with prefix_errors(f"group {code}", FormatError):
            return read_decimal(text)

    def point(self, code: int) -> Point:
        """Return the point with x at a group code and y at that code plus 10."""
        return Point(*self.values(code, code + 10))

    def flags(self) -> int:
        return int(self.number(_FLAGS, "0"))

    @property
    def hidden(self) -> str:
        """Why the entity is hidden regardless of its layer, or ""."""
        if self._text(_PAPER, "0") == "1":
            return "in paper space"
        return "marked invisible" if self._text(_INVISIBLE, "0") == "1" else ""

    def numbers(self, code: int) -> list[Fraction]:
        return _read_group(code, [*compress(self.texts, map(code.__eq__, self.codes))])

    def points(self, code: int) -> list[Point]:
        xs, ys = self.numbers(code), self.numbers(code + 10)
        if len(xs) != len(ys):
            raise FormatError(f"{len(xs)} numbers of group {code}, {len(ys)} of group {code + 10}")
        return [*map(Point, xs, ys)]

    def values(self, *codes: int, default: str | None = None) -> list[Fraction]:
        return [self.number(code, default) for code in codes]

    @property
    def plane(self) -> Affine:
        """The map from the entity's plane to the XY plane."""
        normal = [self.number(code, default) for code, default in _NORMAL.items()]
        if normal[:2] == [0, 0] and normal[2]:
            return IDENTITY if normal[2] > 0 else _MIRRORED
        raise FormatError("not drawn in the XY plane (groups 210 to 230)")

    @property
    def name(self) -> str:
        return self._text(_NAME, None)

    def corners(self) -> tuple[list[Point], list[Fraction]]:
        """Return the vertices of an LWPOLYLINE, and the bulge after each."""
        points = self.points(10)
        # The extra entry receives a bulge before the first point.
        bulges = [Fraction(0)] * (len(points) + 1)
        place = -1
        for code, text in zip(self.codes, self.texts, strict=True):
            place += code == 10
            if code == _BULGE:
                (bulges[place],) = _read_group(_BULGE, [text])
        return points, bulges[:-1]

    def vertex_corners(self, reading: Reading) -> tuple[list[Point], list[Fraction]]:
        points, bulges, heights = [], [], []
        for vertex in self.vertices:
            with prefix_errors(vertex.place):
                # The control frame of a fitted curve is not drawn.
                if not vertex.flags() & _FRAME:
                    points.append(vertex.point(10))
                    heights.append(vertex.number(30, "0"))
                    bulges.append(vertex.number(_BULGE, "0"))
        reading.require_planar(heights)
        return points, bulges

    def _text(self, code: int, default: str | None) -> str:
        text = self.texts[self.codes.index(code)] if code in self.codes else default
        if text is None:
            raise FormatError(f"group {code} is missing")
        return text.strip()


class Drawing(NamedTuple):
    entities: list[Entity]
    blocks: dict[str, list[Entity]]  # each begins with its BLOCK entity, which has the base point
    unit: Fraction | None
    hidden: dict[str, str]  # hidden layers, in upper case, with reasons
    unplotted: set[str]


def read_drawing(text: str) -> Drawing:
    sections = _read_sections(text)
    blocks: dict[str, list[Entity]] = {}
    current: list[Entity] = []
    for entity in _attach_vertices(sections.get("BLOCKS", [])[1:]):
        if entity.kind == "BLOCK":
            current = blocks[entity.name.upper()] = []
        if entity.kind != "ENDBLK":
            current.append(entity)
    entities = _attach_vertices(sections.get("ENTITIES", [])[1:])
    return Drawing(entities, blocks, _unit(sections), *_layers(sections.get("TABLES", [])[1:]))


def _read_sections(text: str) -> dict[str, list[Entity]]:
    """Find the entities of each section; the SECTION entity, with the header, comes first."""
    require_size(len(text))
    sections: dict[str, list[Entity]] = {}
    section: list[Entity] | None = None
    for entity in _divide(text):
        if entity.kind == "SECTION":
            if section is not None:
                break
            name = entity._text(_NAME, "")
            if not name or name in sections:
                which = f"a second section {quote(name)}" if name else "a section without a name"
                raise FormatError(f"not DXF: line {entity.line}: {which}")
            sections[name] = section = [entity]
        elif entity.kind == "ENDSEC":
            section = None
        elif entity.kind == "EOF":
            break
        elif section is not None:
            section.append(entity)
    else:
        raise FormatError("not DXF: missing EOF tag")
    if section is not None:
        raise FormatError("not DXF: missing ENDSEC tag")
    return sections


def _divide(text: str) -> Iterator[Entity]:
    """Split text into entities; lines alternate between group codes and values."""
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    words, values = lines[::2], lines[1::2]
    known: dict[str, int] = {}
    for word in {*words}:
        with suppress(ValueError):
            known[word] = int(word)
    found = [*map(known.get, words[: len(values)])]
    # Text after EOF may lack group codes.
    codes = cast(list[int], found[: found.index(None)] if None in found else found)
    starts = [k for k, code in enumerate(codes) if code == 0]
    require_count(len(starts), ENTITY, "entities")
    # Equal tuples of codes share one object, to save memory.
    same: dict[tuple[int, ...], tuple[int, ...]] = {}
    for start, end in pairwise([*starts, len(codes)]):
        own = tuple(codes[start:end])
        entity = Entity(same.setdefault(own, own), values[start:end], 2 * start + 2)
        if end == len(codes) < len(values) and entity.kind != "EOF":
            place = f"line {2 * end + 1}: {quote(words[end])}"
            raise FormatError(f"not DXF: {place} is not a group code")
        yield entity


def _layers(found: Iterable[Entity]) -> tuple[dict[str, str], set[str]]:
    hidden = {"DEFPOINTS": "for dimension points"}
    unplotted = set()
    for layer in found:
        if layer.kind != "LAYER":
            continue
        name = layer.name.upper()
        if layer.flags() & _FROZEN:
            hidden[name] = FROZEN
        elif layer.number(_COLOR, "7") < 0:
            hidden[name] = "off"
        elif name not in hidden and not layer.number(_PLOT, "1"):
            unplotted.add(name)
    return hidden, unplotted


def _attach_vertices(found: Iterable[Entity]) -> list[Entity]:
    entities: list[Entity] = []
    vertices: list[Entity] | None = None
    for entity in found:
        if entity.kind == "VERTEX" and vertices is not None:
            vertices.append(entity)
            continue
        vertices = None
        if entity.kind == "POLYLINE":
            entity.vertices = vertices = []
        if entity.kind not in ("SEQEND", "ATTRIB"):
            entities.append(entity)
    return entities


def _unit(sections: Mapping[str, Sequence[Entity]]) -> Fraction | None:
    tags = [
        tag
        for entity in sections.get("HEADER", [])[:1]
        for tag in zip(entity.codes, entity.texts, strict=True)
        if tag[0] != _COMMENT
    ]
    for (code, name), (_, value) in pairwise(tags):
        if code == 9 and name.strip() == "$INSUNITS":
            text = value.strip()
            return INSUNITS.get(int(text)) if text.isascii() and text.isdigit() else None
    return None


def _read_group(code: int, texts: Sequence[str]) -> list[Fraction]:
    with prefix_errors(f"group {code}", FormatError):
        return [read_decimal(text.strip()) for text in texts]
