"""The entities of a DXF text, their values being text still."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from io import StringIO
from typing import TYPE_CHECKING

from exactsweep.formats.decimals import read_decimal
from exactsweep.formats.error import FormatError, needs
from exactsweep.geometry.number import quoted
from exactsweep.geometry.point import Point

if TYPE_CHECKING:
    from ezdxf.lldxf.types import DXFTag

_LAYER, _FLAGS, _PAPER = 8, 70, 67
_EXTRUSION = {210: 0, 220: 0, 230: 1}
# Heights above the plane: of a point, of the other end of a line, of a polyline.
_HEIGHTS = (30, 31, 38)


class _Text(str):
    """A value and the line of the file on which it is."""

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
        shown = self.kind if self.kind.isidentifier() else quoted(self.kind)
        self.place = f"line {self.line}: {shown}"
        self.vertices: list[Entity] = []

    def number(self, code: int, default: int | None = None) -> Fraction:
        """Return the number with a group code; refuse where there is none, and no default."""
        text = self._text(code, None if default is None else str(default))
        try:
            return read_decimal(text)
        except ValueError as error:
            raise FormatError(f"group {code}: {error}") from None

    def point(self, code: int) -> Point:
        """Return the point whose x has a group code, and its y that code plus ten."""
        return Point(self.number(code), self.number(code + 10))

    def flags(self) -> int:
        """Return the bits of group 70."""
        return int(self.number(_FLAGS, 0))

    @property
    def is_on_paper(self) -> bool:
        """Whether it is on the paper around the model."""
        return self._text(_PAPER, "0").strip() == "1"

    def require_flat(self) -> None:
        """Refuse what does not lie in the plane of x and y, seen from above."""
        if any(self.number(code, value) != value for code, value in _EXTRUSION.items()):
            raise FormatError("drawn in a plane of its own (groups 210 to 230)")
        if any(self.number(code, 0) for code in _HEIGHTS):
            raise FormatError("above or below the plane: a third coordinate is not 0")

    def corners(self) -> list[tuple[Point, Fraction]]:
        """Return the vertices of an LWPOLYLINE, each with the bulge of the edge that follows."""
        starts = [k for k, tag in enumerate(self.tags) if tag.code == 10]
        parts = [self.tags[i:j] for i, j in zip(starts, [*starts[1:], None], strict=True)]
        return [_corner(Entity([self.tags[0], *part])) for part in parts]

    def vertex_corners(self) -> list[tuple[Point, Fraction]]:
        """Return the same of a POLYLINE, from the VERTEX entities that follow it."""
        found = []
        for vertex in self.vertices:
            try:
                vertex.require_flat()
                found.append(_corner(vertex))
            except ValueError as error:
                raise FormatError(f"{vertex.place}: {error}") from None
        return found

    def _text(self, code: int, default: str | None) -> str:
        for tag in self.tags[1:]:
            if tag.code == code:
                return str(tag.value).strip()
        if default is None:
            raise FormatError(f"group {code} is missing")
        return default


def read_entities(text: str) -> list[Entity]:
    """Read the entities that are drawn.

    Args:
        text: an ASCII DXF file.

    Returns:
        list of Entity, in order; the vertices of a POLYLINE in its `vertices`.

    Raises:
        FormatError: not DXF.
    """
    with needs("ezdxf", "dxf", "DXF"):
        from ezdxf.lldxf.const import DXFError
        from ezdxf.lldxf.loader import load_dxf_structure

    try:
        sections = load_dxf_structure(_tags(text))
    except DXFError as error:
        reason = str(error).removeprefix("DXFStructureError: ")[:80]
        raise FormatError(f"not DXF: {ascii(reason)[1:-1]}") from None
    found: list[Entity] = []
    polyline: Entity | None = None
    for tags in sections.get("ENTITIES", [])[1:]:
        entity = Entity(tags)
        if entity.kind == "VERTEX" and polyline is not None:
            polyline.vertices.append(entity)
            continue
        polyline = entity if entity.kind == "POLYLINE" else None
        if entity.kind != "SEQEND":
            found.append(entity)
    return found


def _tags(text: str) -> Iterator[DXFTag]:
    from ezdxf.lldxf.tagger import ascii_tags_loader
    from ezdxf.lldxf.types import DXFTag

    lines = StringIO(text, newline=None)
    opens_section = seen = False
    for k, tag in enumerate(ascii_tags_loader(lines, skip_comments=False)):
        if tag.code == 999:
            continue
        value = _Text(tag.value)
        value.line = 2 * k + 2
        if opens_section and value == "ENTITIES":
            # ezdxf takes the last one.
            if seen:
                raise FormatError(f"not DXF: line {value.line}: a second section of entities")
            seen = True
        opens_section = (tag.code, value) == (0, "SECTION")
        yield DXFTag(tag.code, value)


def _corner(vertex: Entity) -> tuple[Point, Fraction]:
    return vertex.point(10), vertex.number(42, 0)
