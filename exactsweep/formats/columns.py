"""Column names of placement tables."""

import re
from collections.abc import Iterable, Sequence

from exactsweep.formats.error import FormatError
from exactsweep.numbers.error import quote

# Column names by meaning.
COLUMNS = {
    "x": ("x", "tx", "dx", "pos_x", "x_pos", "center_x", "x_center", "cx"),
    "y": ("y", "ty", "dy", "pos_y", "y_pos", "center_y", "y_center", "cy"),
    "angle": (
        *("angle", "deg", "degrees", "rotation", "rot", "theta", "turn", "orientation"),
        *("angle_deg", "angle_degrees", "rotation_deg", "rot_deg", "theta_deg"),
    ),
    "radians": ("rad", "radians", "angle_rad", "angle_radians", "rotation_rad", "theta_rad"),
    "radius": ("r", "radius"),
    "mirrored": ("mirrored", "mirror", "flipped", "flip"),
    "part": ("part", "part_id", "name", "item", "item_id", "shape", "piece"),
    "group": ("group", "layout", "sheet", "bin", "case", "puzzle", "board", "n"),
    "id": ("id",),
}
_MEANINGS = {name: meaning for meaning, names in COLUMNS.items() for name in names}
# With one of these, x and y are positions.
_PLACING = {"angle", "radians", "radius", "mirrored"}
_SIZES = {"diameter", "d", "rx", "ry"}
_OTHER = re.compile(r"[^a-z0-9]+")


def name_columns(head: Iterable[str]) -> dict[str, str]:
    """Map each meaning to its column; raise FormatError for two columns with one meaning."""
    found: dict[str, str] = {}
    for name in head:
        meaning = _MEANINGS.get(_simplify(name))
        if meaning is not None and meaning in found:
            raise FormatError(f"two columns for {meaning}: {quote(found[meaning])}, {quote(name)}")
        if meaning is not None:
            found[meaning] = name
    return found


def reject_placements(head: Sequence[str], place: str) -> None:
    meanings = [_MEANINGS.get(name, name) for name in map(_simplify, head)]
    placing = [k for k, meaning in enumerate(meanings) if meaning in _PLACING | _SIZES]
    if placing and {"x", "y"} <= {*meanings}:
        part = "" if "radius" in meanings else " --part OUTLINE"
        raise FormatError(
            f"{place}: a table of placements, because of the column "
            f"{quote(head[placing[0]].strip())}; 'exactsweep layout FILE{part}' judges it"
        )


def _simplify(name: str) -> str:
    return _OTHER.sub("_", name.lower()).strip("_")
