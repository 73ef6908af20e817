"""The entities of a DXF text, their values being text still."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.formats.curved.affine import IDENTITY, Affine
from exactsweep.formats.decimals import read_decimal, read_each
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import INSUNITS, Reading
from exactsweep.formats.size import ENTITY, require_count, require_size
from exactsweep.numbers.error import name_refusals, quote
from exactsweep.numbers.number import Point, make_points

_LAYER, _FLAGS, _PAPER, _NAME, _INVISIBLE, _COLOR, _PLOT = 8, 70, 67, 2, 60, 62, 290
_BULGE, _COMMENT = 42, 999
_FROZEN = 1
# Where the normal of an entity's own plane is, and what it is in the plane of x and y.
_NORMAL = {210: "0", 220: "0", 230: "1"}
_MIRRORED = Affine(*map(Fraction, (-1, 0, 0, 1, 0, 0)))
_FRAME = 16
# The shown letters of an unknown kind.
_LONG = 40
# A group code and two ends of lines, at least.
_GROUP = 4
FROZEN = "frozen"
"""Why a layer does not show, and no block that is put on it."""


class KnownNumbers(dict[str | None, Fraction]):
    """The numbers of a text by how they are written, each of them read once."""

    @classmethod
    def of(cls, codes: Sequence[int], texts: Sequence[str]) -> KnownNumbers:
        """Read all coordinates at once, if they are numbers."""
        found = [*{text for code, text in zip(codes, texts, strict=False) if 10 <= code < 60}]
        try:
            return cls(zip(found, read_each(found), strict=True))
        except ValueError:
            return cls()

    def __missing__(self, text: str | None) -> Fraction:
        if text is None:
            raise FormatError("missing")
        number = self[text] = read_decimal(text.strip())
        return number


class Tags(NamedTuple):
    """The tags of a text: group codes, each with the text of its value, and the numbers in them."""

    codes: list[int]
    texts: list[str]
    numbers: KnownNumbers


class Entity:
    """An entity: its kind, and its values by group code.

    Args:
        tags: the tags of the whole text.
        start: the index of the tag that names the kind.
        end: the index after that of its last tag.

    Attributes:
        tags, start, end: as given.
        kind: "LINE", for instance.
        values: the first value of each group after the kind.
        vertices: the entities that follow it and belong to it.
    """

    __slots__ = ("end", "kind", "start", "tags", "values", "vertices")

    def __init__(self, tags: Tags, start: int, end: int) -> None:
        self.tags, self.start, self.end = tags, start, end
        codes, texts, _ = tags
        self.kind = texts[start].strip()
        last = end - 1
        self.values = dict(zip(codes[last:start:-1], texts[last:start:-1], strict=True))
        self.vertices: Sequence[Entity] = ()

    def list_tags(self) -> list[tuple[int, str]]:
        """List its group codes with the texts of their values, without comments."""
        own = slice(self.start, self.end)
        tags = zip(self.tags.codes[own], self.tags.texts[own], strict=True)
        return [tag for tag in tags if tag[0] != _COMMENT]

    @property
    def line(self) -> int:
        """The line of the file that names the kind."""
        return 2 * self.start + 2

    @property
    def place(self) -> str:
        """The kind and the line, for messages."""
        is_word = self.kind.isidentifier() and len(self.kind) < _LONG
        return f"line {self.line}: {self.kind if is_word else quote(self.kind)}"

    @property
    def layer(self) -> str:
        """The name of the entity's layer."""
        return self._text(_LAYER, "0")

    @property
    def size(self) -> int:
        """For how many bytes it counts: for those of its values, and as an entity."""
        own = ENTITY + sum(len(value) + _GROUP for _, value in self.list_tags())
        return own + sum(vertex.size for vertex in self.vertices)

    def number(self, code: int, default: str | None = None) -> Fraction:
        """Return the number with a group code; refuse if it is missing without a default."""
        if code not in self.values and default is None:
            raise FormatError(f"group {code} is missing")
        with name_refusals(f"group {code}", FormatError):
            return self.tags.numbers[self.values.get(code, default)]

    def point(self, code: int) -> Point:
        """Return the point whose x has a group code, and its y that code plus ten."""
        return Point(*self.take(code, code + 10))

    def flags(self) -> int:
        """Return the bits of group 70."""
        return int(self.number(_FLAGS, "0"))

    @property
    def hidden(self) -> str:
        """The reason why it is hidden, whatever its layer: "" for none."""
        if self._text(_PAPER, "0") == "1":
            return "in paper space"
        return "made invisible" if self._text(_INVISIBLE, "0") == "1" else ""

    def numbers(self, code: int) -> list[Fraction]:
        """Return all numbers with a group code."""
        with name_refusals(f"group {code}", FormatError):
            numbers = self.tags.numbers
            return [numbers[text] for own, text in self.list_tags() if own == code]

    def points(self, code: int) -> list[Point]:
        """Return all points whose x has a group code."""
        xs, ys = self.numbers(code), self.numbers(code + 10)
        if len(xs) != len(ys):
            raise FormatError(f"{len(xs)} numbers of group {code}, {len(ys)} of group {code + 10}")
        return make_points(xs, ys)

    def take(self, *codes: int, default: str | None = None) -> list[Fraction]:
        """Return the numbers with several group codes, as `number` does each."""
        numbers, values = self.tags.numbers, self.values
        try:
            return [numbers[values.get(code, default)] for code in codes]
        except ValueError:
            return [self.number(code, default) for code in codes]

    @property
    def plane(self) -> Affine:
        """The map of the entity's own plane to that of x and y, as seen from above."""
        normal = [self.number(code, default) for code, default in _NORMAL.items()]
        if normal == [0, 0, 1]:
            return IDENTITY
        if normal == [0, 0, -1]:
            return _MIRRORED
        raise FormatError("drawn in a plane of its own (groups 210 to 230)")

    @property
    def name(self) -> str:
        """The name in group 2."""
        return self._text(_NAME, None)

    def corners(self) -> tuple[list[Point], list[Fraction]]:
        """Return the vertices of an LWPOLYLINE, and the bulges of the edges that follow them."""
        points = self.points(10)
        # The last one is for a bulge before all points.
        bulges = [Fraction(0)] * (len(points) + 1)
        place = -1
        with name_refusals(f"group {_BULGE}", FormatError):
            for code, text in self.list_tags():
                place += code == 10
                if code == _BULGE:
                    bulges[place] = self.tags.numbers[text]
        return points, bulges[:-1]

    def vertex_corners(self, reading: Reading) -> tuple[list[Point], list[Fraction]]:
        """Return the same of a POLYLINE, from the VERTEX entities that follow it."""
        flags = _read_column(self.vertices, _FLAGS, "0")
        # The frame of a fitted curve is not drawn.
        drawn = [v for v, bits in zip(self.vertices, flags, strict=True) if not int(bits) & _FRAME]
        points = make_points(_read_column(drawn, 10), _read_column(drawn, 20))
        reading.require_level(_read_column(drawn, 30, "0"))
        return points, _read_column(drawn, _BULGE, "0")

    def _text(self, code: int, default: str | None) -> str:
        value = self.values.get(code, default)
        if value is None:
            raise FormatError(f"group {code} is missing")
        return value.strip()


class Drawing(NamedTuple):
    """The drawing of a DXF text.

    Attributes:
        entities: those that are drawn, in order; the vertices of a POLYLINE in its `vertices`.
        blocks: the entities of each block, after its own, which says where its base is.
        unit: how many millimetres its numbers count; None if it does not say.
        hidden: by the names of layers in upper case, why those do not show that do not; and
        unplotted: those that show and do not plot.
    """

    entities: list[Entity]
    blocks: dict[str, list[Entity]]
    unit: Fraction | None
    hidden: dict[str, str]
    unplotted: set[str]


def read_drawing(text: str) -> Drawing:
    """Read a DXF text.

    Args:
        text: an ASCII DXF file.

    Returns:
        A Drawing.

    Raises:
        FormatError: not DXF.

    Cost: linear.
    """
    sections = _read_sections(text)
    blocks: dict[str, list[Entity]] = {}
    current: list[Entity] = []
    for entity in _gather(sections.get("BLOCKS", [])[1:]):
        if entity.kind == "BLOCK":
            current = blocks[entity.name.upper()] = []
        if entity.kind != "ENDBLK":
            current.append(entity)
    entities = _gather(sections.get("ENTITIES", [])[1:])
    return Drawing(entities, blocks, _unit(sections), *_layers(sections.get("TABLES", [])[1:]))


def _read_sections(text: str) -> dict[str, list[Entity]]:
    """Find the entities of each section, after its own, which has the values of a header."""
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
    """Divide a text into entities; a line has a group code, the next one its value."""
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    words, texts = lines[::2], lines[1::2]
    codes: list[int] = []
    try:
        codes += map(int, words[: len(texts)])
    except ValueError:
        # The end of the file may come first.
        words = words[: len(codes) + 1]
    starts = [k for k, code in enumerate(codes) if code == 0]
    # Vertices of old polylines among them.
    require_count(len(starts), ENTITY, "entities")
    tags = Tags(codes, texts, KnownNumbers.of(codes, texts))
    for start, end in pairwise([*starts, len(codes)]):
        entity = Entity(tags, start, end)
        is_last = entity.kind == "EOF"
        if end == len(codes) < len(texts) and not is_last:
            place = f"line {2 * end + 1}: {quote(words[end])}"
            raise FormatError(f"not DXF: {place} is no group code")
        yield entity
        if is_last:
            break


def _layers(found: Iterable[Entity]) -> tuple[dict[str, str], set[str]]:
    """Find the layers that do not show, and those that do not plot."""
    hidden = {"DEFPOINTS": "for the points of dimensions"}
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


def _gather(found: Iterable[Entity]) -> list[Entity]:
    """List entities, and give a POLYLINE the vertices that follow it."""
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
    tags = [tag for entity in sections.get("HEADER", [])[:1] for tag in entity.list_tags()]
    for (code, name), (_, value) in pairwise(tags):
        if code == 9 and name.strip() == "$INSUNITS":
            text = value.strip()
            return INSUNITS.get(int(text)) if text.isascii() and text.isdigit() else None
    return None


def _read_column(
    entities: Sequence[Entity], code: int, default: str | None = None
) -> list[Fraction]:
    """Read the number with a group code of each entity; a refusal names the entity."""
    try:
        return [e.tags.numbers[e.values.get(code, default)] for e in entities]
    except ValueError:
        for entity in entities:
            with name_refusals(entity.place):
                entity.number(code, default)
        raise
