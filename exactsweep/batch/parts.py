"""Parts: polygons that many pairs share, each one read and validated once."""

from typing import NamedTuple, Unpack

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.polygons import read_candidates
from exactsweep.formats.reading import Options
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region


class Part(NamedTuple):
    """A polygon of a part list, or the reason why it is none.

    Attributes:
        name: its id, or else its index in the list.
        polygon: a Polygon, a Region if it has holes, or the message of its refusal.
    """

    name: str
    polygon: Polygon | Region | str


def read_parts(path: str, tolerance: object = None, **options: Unpack[Options]) -> tuple[Part, ...]:
    """Read a part list, each polygon once.

    Args:
        path: a file of polygons, or "-" for standard input.
        tolerance: as for `exactsweep.formats.parse_polygons`.

    Returns:
        tuple of Part; one that is no simple polygon is among them and concerns only its own pairs.

    Raises:
        FormatError: anything wrong with the file as a whole; the message names it.
    """
    return tuple(
        _read(outline, str(k))
        for k, outline in enumerate(read_candidates(path, tolerance, **options))
    )


def _read(outline: Candidate, index: str) -> Part:
    name = index if outline.name is None else outline.name
    try:
        return Part(name, outline.shape())
    except ValueError as error:
        return Part(name, str(error))
