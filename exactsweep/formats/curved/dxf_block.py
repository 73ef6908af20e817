"""DXF blocks, placed by INSERTs."""

from collections.abc import Iterator
from typing import NamedTuple

from exactsweep.formats.curved.affine import Affine, make_scaling, make_shift
from exactsweep.formats.curved.arc import make_rotation
from exactsweep.formats.curved.dxf_entity import FROZEN, Drawing, Entity
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import MAX_COPIES, Reading
from exactsweep.numbers.error import quote

MAX_DEPTH = 32  # of nested blocks
# Entities that draw no outline.
_ANNOTATIONS = {
    "TEXT",
    "MTEXT",
    "ATTDEF",
    "ATTRIB",
    "DIMENSION",
    "LEADER",
    "MULTILEADER",
    "TOLERANCE",
}
_ANNOTATIONS |= {"POINT", "VIEWPORT", "IMAGE", "WIPEOUT"}


class PlacedEntity(NamedTuple):
    entity: Entity
    image: Affine  # the map from the entity to the drawing
    layer: str  # "0" inside a block is replaced by the layer of the INSERT
    around: str = ""  # the locations of the INSERTs that draw it, for messages
    fault: str = ""  # why an INSERT cannot be drawn

    @property
    def place(self) -> str:
        return f"{self.around}{self.entity.place}"


class Blocks:
    def __init__(self, drawing: Drawing, reading: Reading) -> None:
        self.drawing, self.blocks, self.reading = drawing, drawing.blocks, reading
        # Cached maps of each INSERT, by line.
        self._maps: dict[int, list[Affine]] = {}

    def place(self, entity: Entity, image: Affine) -> Iterator[PlacedEntity]:
        """Yield an entity, or the entities that an INSERT draws; count hidden ones."""
        return self._place(PlacedEntity(entity, image, entity.layer), ())

    def _is_hidden(self, placed: PlacedEntity) -> bool:
        layer = placed.layer.upper()
        reason = self.drawing.hidden.get(layer, "")
        # If the layer of the INSERT is off, entities on other layers are still visible.
        if placed.entity.kind == "INSERT" and reason != FROZEN:
            reason = ""
        if layer in self.drawing.unplotted and placed.entity.kind != "INSERT":
            self.reading.notes[f"the layer {quote(placed.layer)} does not plot, but is read"] = None
        on_layer = reason and f"on the layer {quote(placed.layer)}, which is {reason}"
        what = placed.entity.hidden or on_layer
        return bool(what) and self.reading.skip_hidden(f"{placed.entity.kind} {what}")

    def _place(self, placed: PlacedEntity, around: tuple[str, ...]) -> Iterator[PlacedEntity]:
        if around:
            self.reading.allow_copies(1, placed.entity.size, "blocks expand to", "entities")
        if placed.entity.kind in _ANNOTATIONS or self._is_hidden(placed):
            return
        if placed.entity.kind != "INSERT":
            yield placed
            return
        try:
            name = placed.entity.name.upper()
            images = self._images(placed, name, around)
        except ValueError as error:
            yield placed._replace(fault=str(error))
            return
        _, *members = self.blocks[name]
        for image in images:
            for entity in members:
                layer = placed.layer if entity.layer == "0" else entity.layer
                inner = PlacedEntity(entity, image, layer, f"{placed.place}: ")
                yield from self._place(inner, (*around, name))

    def _images(self, placed: PlacedEntity, name: str, around: tuple[str, ...]) -> list[Affine]:
        """Return the maps of a block, one for each row and column."""
        insert = placed.entity
        if name not in self.blocks:
            raise FormatError(f"there is no block {quote(insert.name)}")
        if name in around:
            raise FormatError(f"block {quote(insert.name)} contains itself")
        if len(around) == MAX_DEPTH:
            raise FormatError(f"nested in more than {MAX_DEPTH} blocks")
        if insert.line not in self._maps:
            self._maps[insert.line] = self._own_maps(insert, self.blocks[name])
        return [placed.image @ own for own in self._maps[insert.line]]

    def _own_maps(self, insert: Entity, block: list[Entity]) -> list[Affine]:
        columns, rows = (max(1, int(insert.number(code, "1"))) for code in (70, 71))
        # Count copies of an empty block, too.
        drawn = len(block) - 1 or 1
        if columns * rows * drawn > MAX_COPIES:
            raise FormatError(f"expands to more than {MAX_COPIES:,} entities")
        turn = make_rotation(insert.number(50, "0"))
        position, base = insert.point(10), block[0].point(10)
        scale = make_scaling(insert.number(41, "1"), insert.number(42, "1"))
        outer = insert.plane @ make_shift(*position) @ turn
        own = scale @ make_shift(-base.x, -base.y)
        step = insert.number(44, "0"), insert.number(45, "0")
        return [
            outer @ make_shift(i * step[0], j * step[1]) @ own
            for j in range(rows)
            for i in range(columns)
        ]
