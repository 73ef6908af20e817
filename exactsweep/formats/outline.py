"""The polygons of a file before they are read: which there are, and which one is meant."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple, NoReturn, Self, TypeVar

from exactsweep.formats.error import FormatError
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.number import NumberError, quoted
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.words import suggestion

_SHOWN = 4
_Shape = TypeVar("_Shape", Polygon, Region)


class NamedPolygon(NamedTuple):
    """A polygon of a file that holds several.

    Attributes:
        polygon: the Polygon.
        name: its id, or None.
        layer: the layer of a DXF file that it is on, else None.
    """

    polygon: Polygon
    name: str | None = None
    layer: str | None = None


class NamedRegion(NamedTuple):
    """A polygon with its holes, of a file that holds several.

    Attributes:
        region: the Region.
        name: its id, or None.
        layer: the layer of a DXF file that it is on, else None.
    """

    region: Region
    name: str | None = None
    layer: str | None = None


class Outline(NamedTuple):
    """A polygon of a file, to be read when it is wanted, so that its faults concern no other.

    Attributes:
        place: where it is in the file, for messages; "" if the refusals of `vertices` say so.
        vertices: reads them, or raises FormatError.
        name: its id, or None.
        layer: its layer, or None.
        holes: finds its inner rings, in order, or raises FormatError; read when they are wanted.
    """

    place: str
    vertices: Callable[[], Sequence[Point]]
    name: str | None = None
    layer: str | None = None
    holes: Callable[[], Sequence[Outline]] = tuple

    @classmethod
    def refused(cls, reason: str, name: str | None = None, layer: str | None = None) -> Self:
        """Make an outline that raises FormatError, for what is drawn but is no polygon."""

        def vertices() -> NoReturn:
            raise FormatError(reason)

        return cls("", vertices, name, layer)

    def polygon(self) -> Polygon:
        """Read the polygon; raises FormatError, or PolygonError if it is not simple."""
        for hole in self.holes():
            raise FormatError(f"{hole.place}: an inner ring: with it, this is a Region, no Polygon")
        return self._read(lambda: Polygon(self.vertices()))

    def region(self) -> Region:
        """Read the polygon with its holes; refuses as `polygon` does, but no hole for being one."""
        holes = self.holes()
        if not holes:
            return Region(self.polygon())
        return self._read(lambda: Region(self.vertices(), [hole.vertices() for hole in holes]))

    def shape(self) -> Polygon | Region:
        """Read it as the Region that it is if there are holes, else as a Polygon."""
        return self.region() if self.holes() else self.polygon()

    def _read(self, shape: Callable[[], _Shape]) -> _Shape:
        try:
            return shape()
        except PolygonError as error:
            raise PolygonError(f"{self.place}: {error}" if self.place else str(error)) from None
        except NumberError as error:
            raise FormatError(f"{self.place}: {error}" if self.place else str(error)) from None

    def named_polygon(self) -> NamedPolygon:
        """Read the polygon, as `polygon` does, with its name and layer."""
        return NamedPolygon(self.polygon(), self.name, self.layer)

    def named_region(self) -> NamedRegion:
        """Read the region, as `region` does, with its name and layer."""
        return NamedRegion(self.region(), self.name, self.layer)


def choose(outlines: Sequence[Outline], choice: str | None) -> Outline:
    """Find the outline that is meant.

    Args:
        outlines: those of a file, in order.
        choice: a name, an index from 0 or a layer, tried in this order; None for the only one.

    Returns:
        The outline.

    Raises:
        FormatError: none, or several that could be meant.
    """
    if choice is None:
        if not outlines:
            raise FormatError("holds no polygon")
        if len(outlines) > 1:
            raise FormatError(
                f"holds {len(outlines)} polygons; choose one by name, index or layer, as in "
                f"FILE#0: {_listed(outlines, range(len(outlines)))}"
            )
        return outlines[0]
    named = [i for i, outline in enumerate(outlines) if outline.name == choice]
    # A name may look like an index, and so may a layer: DXF's first one is "0".
    index = int(choice) if choice.isascii() and choice.isdigit() and len(choice) < 10 else -1
    if len(named) != 1 and 0 <= index < len(outlines):
        return outlines[index]
    layered = [i for i, outline in enumerate(outlines) if outline.layer == choice]
    for kind, found in (("name", named), ("layer", layered)):
        if len(found) > 1:
            raise FormatError(
                f"{len(found)} polygons have the {kind} {quoted(choice)}; choose one by index: "
                f"{', '.join(f'#{i}' for i in found[:_SHOWN])}{' ...' * (len(found) > _SHOWN)}"
            )
        if found:
            return outlines[found[0]]
    near = suggestion(choice, [n for o in outlines for n in (o.name, o.layer) if n])
    raise FormatError(
        f"no polygon has the name, index or layer {quoted(choice)}"
        f"{near or f'; there are {len(outlines)}'}"
    )


def _listed(outlines: Sequence[Outline], indices: Sequence[int]) -> str:
    shown = [f"#{i}" + _called(outlines[i]) for i in indices[:_SHOWN]]
    return ", ".join(shown) + " ..." * (len(indices) > _SHOWN)


def _called(outline: Outline) -> str:
    name = outline.name or outline.layer
    return f" {quoted(name)}" if name else ""
