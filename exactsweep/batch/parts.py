"""Part lists, read and validated once for all pairs."""

from collections.abc import Sequence
from typing import NamedTuple, Unpack

from exactsweep.formats.folder import Listing, list_parts
from exactsweep.formats.part_list import Remarks
from exactsweep.formats.reading import Options
from exactsweep.geometry.region import AnyPolygon
from exactsweep.geometry.turn import read_turn
from exactsweep.numbers.error import explain_type_errors


class Part(NamedTuple):
    """A polygon in a part list, or its error."""

    name: str  # its id, else its index in the list
    polygon: AnyPolygon | str  # or an error message


@explain_type_errors
def read_parts(path: str, tolerance: object = None, **options: Unpack[Options]) -> tuple[Part, ...]:
    """Read a part list; an invalid polygon affects only its own pairs.

    Takes the arguments of `exactsweep.formats.read_regions`; the path may also be a folder or a
    pattern. Raises FormatError if no file can be read.

    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "parts.svg")
    ...     _ = file.write_text('<svg><rect id="plate" width="6" height="4"/></svg>')
    ...     print(*read_parts(str(file)))
    Part(name='plate', polygon=...)
    """
    return make_parts(list_parts([path], tolerance, **options))


def make_parts(listing: Listing) -> tuple[Part, ...]:
    found = []
    remarks = Remarks(listing.notes, listing.left_out)
    for name, _, candidate in listing.parts:
        try:
            found += [Part(name, piece.shape()) for piece in candidate.split(remarks)]
        except ValueError as error:
            found.append(Part(name, str(error)))
    return tuple(found)


def rotate_parts(parts: Sequence[Part], degrees: Sequence[int | str]) -> list[Part]:
    """Rotate each part about the origin by each angle in degrees, as `Turn.near` does.

    >>> from exactsweep import Polygon
    >>> (part,) = rotate_parts([Part("a", Polygon([(0, 0), (2, 0), (0, 1)]))], [90])
    >>> print(part.name, part.polygon)
    a@90 (-1, 0) (0, 0) (0, 2)
    """
    return [
        Part(f"{name}@{by}", shape if isinstance(shape, str) else shape.rotated(by))
        if read_turn(by).degrees
        else Part(name, shape)
        for name, shape in parts
        for by in degrees
    ]
