"""Settings of reading: the options of a caller, and the most lines that curves may become."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from fractions import Fraction
from typing import TypedDict

from exactsweep.formats.error import FormatError
from exactsweep.formats.size import VERTEX, require_count, require_size
from exactsweep.numbers.limits import get_max_bytes
from exactsweep.numbers.number import NumberError, abridge, quote, to_fraction

MAX_LINES = 20_000
"""The most lines that one curve becomes."""

UNITS = {
    "mm": Fraction(1),
    "cm": Fraction(10),
    "m": Fraction(1000),
    "dm": Fraction(100),
    "um": Fraction(1, 1000),
    "in": Fraction(127, 5),
    "ft": Fraction(1524, 5),
    "pt": Fraction(127, 360),
    "pc": Fraction(127, 30),
    "px": Fraction(127, 480),
}
"""How many millimetres a unit is; 96 px are an inch, as in CSS."""

# Inch, foot, mile, mm, cm, m, km, microinch, mil, yard, angstrom, nm, um, dm, dam, hm, Gm.
_INSUNITS = "25.4 304.8 1609344 1 10 1e3 1e6 254e-7 254e-4 914.4 1e-7 1e-6 1e-3 100 1e4 1e5 1e12"
INSUNITS = dict(enumerate(map(Fraction, _INSUNITS.split()), 1))
"""How many millimetres the unit of a DXF is, by the value of $INSUNITS."""


class Options(TypedDict, total=False):
    """The options of a reader of files, besides the tolerance for curves.

    Attributes:
        nested: whether closed outlines of one layer that lie inside others are their holes, and
            those inside a hole polygons again, and so on; all are on one layer where there are no
            layers, as there are in DXF and Inkscape's SVG. "all" takes all layers for one, and
            names of layers between commas take these for one, "OUTER,INNER".
        join: how far ends of lines of SVG and DXF may be apart that are to be one, a positive
            number; if left out, only equal ends are joined, and those of curves within a fourth of
            the tolerance.
        unit: one of UNITS, in which the result is wanted; SVG and DXF that say theirs are scaled,
            exactly, and all others refused. Numbers are taken as they stand if left out.
        hidden: whether hidden geometry is read, too: invisible entities of DXF, its layers that are
            off or frozen, and its paper space; elements of SVG without display or visibility, or in
            `defs`.
        y_down: whether Y points down in the file; if left out, it does in SVG only.
    """

    nested: bool | str
    join: object
    unit: str | None
    hidden: bool
    y_down: bool | None


class Reading:
    """The state of reading one text.

    Args:
        tolerance: how far lines may be from the curves that they replace, a positive number as
            `to_fraction` reads it; None to refuse curves.
        nested, join, unit, hidden, y_down: as for `Options`.

    Attributes:
        tolerance, join: Fractions, or None.
        nested, unit, hidden, y_down: as given.
        found_unit: how many millimetres the numbers of the file count; None if it does not say.
        passed: how many things are passed over for each reason.
        notes: what else there is to say.
        lines: how many lines curves have become.
        vertices: how many vertices have been drawn, and
        copied: how many bytes, beside those of the file, by what draws something again.

    Raises:
        FormatError: a number that is not positive, no such unit.
    """

    def __init__(
        self,
        tolerance: object = None,
        *,
        nested: bool | str = False,
        join: object = None,
        unit: str | None = None,
        hidden: bool = False,
        y_down: bool | None = None,
    ) -> None:
        if unit is not None and not (isinstance(unit, str) and unit in UNITS):
            raise FormatError(f"the unit {quote(unit)} is none of {', '.join(UNITS)}")
        self.tolerance = read_positive(tolerance, "the tolerance")
        self.join = read_positive(join, "the distance of ends that are joined")
        self.nested, self.unit, self.hidden, self.y_down = nested, unit, hidden, y_down
        self.found_unit: Fraction | None = None
        self.passed: Counter[str] = Counter()
        self.notes: dict[str, None] = {}
        self.lines = self.vertices = self.copied = 0

    def allow_curve(self, count: int = 0) -> Fraction:
        """Allow a curve to become so many lines, before it does.

        Args:
            count: how many lines.

        Returns:
            The tolerance.

        Raises:
            FormatError: there is no tolerance, or these are too many lines for one curve or, with
                those before, for one file.
        """
        if self.tolerance is None:
            raise FormatError(
                "a curve, which is read only with a tolerance for its lines (--flatten)"
            )
        if count > MAX_LINES:
            shown = f"{count:,}" if count < 10**12 else "more than 10**12"
            raise FormatError(
                f"a curve would become {shown} lines at this tolerance, more than {MAX_LINES:,}"
            )
        self.lines += count
        if self.lines * VERTEX > get_max_bytes():
            raise FormatError(
                f"with this one, the curves of the file would become {self.lines:,} lines at this "
                f"tolerance, more than {get_max_bytes() // VERTEX:,} (max_mib)"
            )
        return self.tolerance

    def allow_vertices(self, count: int) -> None:
        """Count vertices that are drawn; raises FormatError if all are more than are read."""
        self.vertices += count
        require_count(self.vertices, VERTEX, "vertices are drawn")

    def allow_copy(self, size: int, what: str) -> None:
        """Count bytes that something draws again; raises FormatError if they are too many."""
        self.copied += size
        require_size(self.copied, f"{what} draw ")

    def allow_angle(self, degrees: Fraction) -> Fraction:
        """Allow a rotation that is irrational, and return how far off its matrix may be."""
        if self.tolerance is None:
            raise FormatError(
                f"an angle of {abridge(degrees)} degrees, which is irrational and read only with "
                "a tolerance (--flatten)"
            )
        return min(self.tolerance, Fraction(1)) / 10**30

    def scale(self, unit: Fraction | None) -> Fraction:
        """Return the factor by which the numbers of a file are multiplied.

        Args:
            unit: what its numbers count, in millimetres; None if it does not say.
        """
        self.found_unit = unit
        if self.unit is None:
            return Fraction(1)
        if unit is None:
            raise FormatError("does not say in which unit its numbers are (--unit)")
        self.found_unit = UNITS[self.unit]
        return unit / self.found_unit

    def hides(self, reason: str) -> bool:
        """Tell whether something is passed over for a reason, and count it if so.

        Args:
            reason: what hides it; "" for nothing.
        """
        if not reason or self.hidden:
            return False
        self.passed[reason] += 1
        return True

    def is_level(self, heights: Iterable[Fraction]) -> bool:
        """Tell whether heights are the same, or no farther apart than ends that are joined."""
        found = [*heights]
        return not found or max(found) - min(found) <= (self.join or 0)


def read_positive(value: object, name: str) -> Fraction | None:
    """Read a positive number of a caller, as `to_fraction` does; None if there is none."""
    if value is None:
        return None
    try:
        number = to_fraction(value)
    except NumberError as error:
        raise FormatError(f"{name}: {error}") from None
    if number <= 0:
        raise FormatError(f"{name}, {abridge(number)}, is not positive")
    return number
