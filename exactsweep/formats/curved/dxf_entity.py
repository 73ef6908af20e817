"""The entities of a DXF text, their values being text still."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property
from io import StringIO
from itertools import pairwise
from typing import TYPE_CHECKING, NamedTuple

from exactsweep.formats.curved.affine import IDENTITY, Affine
from exactsweep.formats.decimals import read_decimal
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import INSUNITS, Reading
from exactsweep.formats.size import ENTITY, require_count, require_size
from exactsweep.numbers.error import require_imports
from exactsweep.numbers.number import quote
from exactsweep.numbers.point import Point

if TYPE_CHECKING:
    from ezdxf.lldxf.types import DXFTag

_LAYER, _FLAGS, _PAPER, _NAME, _INVISIBLE, _COLOR, _PLOT = 8, 70, 67, 2, 60, 62, 290
_FROZEN = 1
# Where the normal of an entity's own plane is, and what it is in the plane of x and y.
_NORMAL = {210: 0, 220: 0, 230: 1}
_MIRRORED = Affine(*map(Fraction, (-1, 0, 0, 1, 0, 0)))
_FRAME = 16
# The shown letters of an unknown kind.
_LONG = 40
# A group code and two ends of lines, at least.
_GROUP = 4
FROZEN = "frozen"
"""Why a layer does not show, and no block that is put on it."""


def require_level(reading: Reading, heights: Iterable[Fraction]) -> None:
    """Refuse points at different heights above the plane."""
    if not reading.is_level(heights):
        allowed = "" if reading.join else " (--join allows a distance)"
        raise FormatError(f"not level: its points are at different heights{allowed}")


class _Text(str):
    """A value and the line of the file on which it is."""

    __slots__ = ("line",)
    line: int


class Entity:
    """An entity: its kind, and its values by group code.

    Attributes:
        kind: "LINE", for instance.
        line: the line of the file on which its kind is named.
        place: both, for messages.
        layer: the name of its layer.
        vertices: the entities that follow it and belong to it.
    """

    def __init__(self, tags: Iterable[DXFTag]) -> None:
        self.tags = list(tags)
        kind = self.tags[0].value
        self.kind, self.line = str(kind).strip(), kind.line
        self.layer = self._text(_LAYER, "0")
        is_word = self.kind.isidentifier() and len(self.kind) < _LONG
        shown = self.kind if is_word else quote(self.kind)
        self.place = f"line {self.line}: {shown}"
        self.vertices: list[Entity] = []

    @cached_property
    def size(self) -> int:
        """For how many bytes it counts: for those of its values, and as an entity."""
        own = ENTITY + sum(len(str(tag.value)) + _GROUP for tag in self.tags)
        return own + sum(vertex.size for vertex in self.vertices)

    def number(self, code: int, default: int | None = None) -> Fraction:
        """Return the number with a group code; refuse if it is missing without a default."""
        return _read_group(code, self._text(code, None if default is None else str(default)))

    def point(self, code: int) -> Point:
        """Return the point whose x has a group code, and its y that code plus ten."""
        return Point(self.number(code), self.number(code + 10))

    def flags(self) -> int:
        """Return the bits of group 70."""
        return int(self.number(_FLAGS, 0))

    @property
    def hidden(self) -> str:
        """The reason why it is hidden, whatever its layer: "" for none."""
        if self._text(_PAPER, "0") == "1":
            return "in paper space"
        return "made invisible" if self._text(_INVISIBLE, "0") == "1" else ""

    def numbers(self, code: int) -> list[Fraction]:
        """Return all numbers with a group code."""
        return [read_decimal(str(tag.value).strip()) for tag in self.tags if tag.code == code]

    def points(self, code: int) -> list[Point]:
        """Return all points whose x has a group code."""
        pairs = zip(self.numbers(code), self.numbers(code + 10), strict=True)
        return [Point(*found) for found in pairs]

    def require_level(self, reading: Reading, *codes: int) -> None:
        """Refuse points at different heights above the plane; one that is not there is 0."""
        require_level(reading, [z for code in codes for z in self.numbers(code) or [Fraction(0)]])

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

    def corners(self) -> list[tuple[Point, Fraction]]:
        """Return the vertices of an LWPOLYLINE, each with the bulge of the edge that follows."""
        parts: list[dict[int, str]] = []
        for tag in self.tags:
            if tag.code == 10:
                parts.append({})
            if parts:
                parts[-1].setdefault(tag.code, str(tag.value).strip())
        return [
            (
                Point(_read_group(10, part[10]), _read_group(20, part.get(20))),
                _read_group(42, part.get(42, "0")),
            )
            for part in parts
        ]

    def vertex_corners(self, reading: Reading) -> list[tuple[Point, Fraction]]:
        """Return the same of a POLYLINE, from the VERTEX entities that follow it."""
        found, heights = [], []
        for vertex in self.vertices:
            try:
                # The frame of a fitted curve is not drawn.
                if not vertex.flags() & _FRAME:
                    found.append(_corner(vertex))
                    heights.append(vertex.number(30, 0))
            except ValueError as error:
                raise FormatError(f"{vertex.place}: {error}") from None
        require_level(reading, heights)
        return found

    def _text(self, code: int, default: str | None) -> str:
        for tag in self.tags[1:]:
            if tag.code == code:
                return str(tag.value).strip()
        if default is None:
            raise FormatError(f"group {code} is missing")
        return default


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
    with require_imports("ezdxf", "dxf", "DXF", FormatError):
        from ezdxf.lldxf.const import DXFError
        from ezdxf.lldxf.loader import load_dxf_structure

    require_size(len(text))
    try:
        sections = load_dxf_structure(_tags(text))
    except DXFError as error:
        reason = str(error).removeprefix("DXFStructureError: ")[:80]
        raise FormatError(f"not DXF: {ascii(reason)[1:-1]}") from None
    blocks: dict[str, list[Entity]] = {}
    current: list[Entity] = []
    for entity in _gather(sections.get("BLOCKS", [])[1:]):
        if entity.kind == "BLOCK":
            current = blocks[entity.name.upper()] = []
        if entity.kind != "ENDBLK":
            current.append(entity)
    entities = _gather(sections.get("ENTITIES", [])[1:])
    return Drawing(entities, blocks, _unit(sections), *_layers(sections.get("TABLES", [])[1:]))


def _layers(found: Iterable[Iterable[DXFTag]]) -> tuple[dict[str, str], set[str]]:
    """Find the layers that do not show, and those that do not plot."""
    hidden = {"DEFPOINTS": "for the points of dimensions"}
    unplotted = set()
    for layer in map(Entity, found):
        if layer.kind != "LAYER":
            continue
        name = layer.name.upper()
        if layer.flags() & _FROZEN:
            hidden[name] = FROZEN
        elif layer.number(_COLOR, 7) < 0:
            hidden[name] = "off"
        elif name not in hidden and not layer.number(_PLOT, 1):
            unplotted.add(name)
    return hidden, unplotted


def _gather(found: Iterable[Iterable[DXFTag]]) -> list[Entity]:
    """Make entities, and give a POLYLINE the vertices that follow it."""
    entities: list[Entity] = []
    polyline: Entity | None = None
    for tags in found:
        entity = Entity(tags)
        if entity.kind == "VERTEX" and polyline is not None:
            polyline.vertices.append(entity)
            continue
        polyline = entity if entity.kind == "POLYLINE" else None
        if entity.kind not in ("SEQEND", "ATTRIB"):
            entities.append(entity)
    return entities


def _unit(sections: Mapping[str, Sequence[Iterable[DXFTag]]]) -> Fraction | None:
    tags = [tag for entity in sections.get("HEADER", [])[:1] for tag in entity]
    for name, value in pairwise(tags):
        if name.code == 9 and str(name.value).strip() == "$INSUNITS":
            text = str(value.value).strip()
            return INSUNITS.get(int(text)) if text.isascii() and text.isdigit() else None
    return None


def _tags(text: str) -> Iterator[DXFTag]:
    from ezdxf.lldxf.tagger import ascii_tags_loader
    from ezdxf.lldxf.types import DXFTag

    lines = StringIO(text, newline=None)
    opens_section = seen = False
    count = 0
    for k, tag in enumerate(ascii_tags_loader(lines, skip_comments=False)):
        if tag.code == 999:
            continue
        if tag.code not in (0, _NAME):
            yield DXFTag(tag.code, tag.value)
            continue
        count += tag.code == 0
        # Vertices of old polylines among them, each of some 3 kB.
        require_count(count, ENTITY, "entities")
        # Kinds and names keep their lines for messages.
        value = _Text(tag.value)
        value.line = 2 * k + 2
        if opens_section and value == "ENTITIES":
            # ezdxf takes the last one.
            if seen:
                raise FormatError(f"not DXF: line {value.line}: a second section of entities")
            seen = True
        opens_section = (tag.code, value) == (0, "SECTION")
        yield DXFTag(tag.code, value)


def _read_group(code: int, text: str | None) -> Fraction:
    if text is None:
        raise FormatError(f"group {code} is missing")
    try:
        return read_decimal(text)
    except ValueError as error:
        raise FormatError(f"group {code}: {error}") from None


def _corner(vertex: Entity) -> tuple[Point, Fraction]:
    return vertex.point(10), vertex.number(42, 0)
