"""One layout as each nesting program writes it: an L and its half turn fill a box of 4 by 3.

The L is at the origin of the box. Its copy is rotated by 180 degrees about the origin of the part
and translated to the opposite corner.
"""

from fractions import Fraction
from pathlib import Path

Corners = set[tuple[Fraction, Fraction]]
L: Corners = {
    (Fraction(x), Fraction(y)) for x, y in zip((0, 3, 3, 1, 1, 0), (0, 0, 1, 1, 3, 3), strict=True)
}
# The box is 4 wide, with a 2 by 1 gap between the arms.
BOX: Corners = {(Fraction(x), Fraction(y)) for x in (0, 4) for y in (0, 3)}

_FOLDER = Path(__file__).with_name("nest_files")


def _read(name: str) -> str | None:
    file = _FOLDER / name
    return file.read_text(encoding="utf-8") if file.exists() else None


FILES = {
    name: ((_FOLDER / name).read_text(encoding="utf-8"), _read(f"{name}.instance"))
    for name in sorted(file.name for file in _FOLDER.iterdir() if file.suffix != ".instance")
}
"""By name: the text of a file, and that of its instance, if it needs one."""
