"""Settings and state of a reader."""

from collections import Counter
from collections.abc import Sequence
from copy import copy
from fractions import Fraction
from typing import Self, TypedDict, cast

from exactsweep.formats.decimals import show_number
from exactsweep.formats.error import FormatError
from exactsweep.formats.size import VERTEX, require_count, require_size
from exactsweep.numbers.error import prefix_errors, quote
from exactsweep.numbers.limits import get_limits
from exactsweep.numbers.number import to_fraction

MAX_LINES = 20_000  # chords per curve
MAX_COPIES = 20_000  # elements drawn by blocks or uses, since small files can draw many

# Units in millimeters; an inch has 96 px, as in CSS.
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
# DXF units in millimeters, by the value of $INSUNITS: inch, foot, mile, mm, cm, m, km,
# microinch, mil, yard, angstrom, nm, um, dm, dam, hm, Gm.
_INSUNITS = "25.4 304.8 1609344 1 10 1e3 1e6 254e-7 254e-4 914.4 1e-7 1e-6 1e-3 100 1e4 1e5 1e12"
INSUNITS = dict(enumerate(map(Fraction, _INSUNITS.split()), 1))


class Options(TypedDict, total=False):
    """Options of the file readers, besides the tolerance for curves.

    Attributes:
        nested: whether outlines inside others are holes, outlines inside holes are polygons, and so
            on; see `exactsweep.formats.depth`. By default only in layouts.
        layers: the DXF or Inkscape layers to read, ignoring case; by default all.
        ignored_layers: the layers to skip.
        join: the maximum gap to close between line ends, in SVG and DXF. By default, equal ends are
            joined, and curve ends within a quarter of the tolerance.
        unit: the unit of the result, one of UNITS. Files with a known unit are scaled exactly,
            others are rejected. By default, numbers remain unchanged.
        hidden: whether to read hidden geometry: invisible DXF entities, layers that are off or
            frozen, paper space; invisible SVG elements and unused `defs`.
        y_down: whether Y points down in the file; by default only in SVG.
        clean: the minimum area of a polygon; smaller ones are skipped.
    """

    nested: bool | None
    layers: Sequence[str]
    ignored_layers: Sequence[str]
    join: object
    unit: str | None
    hidden: bool
    y_down: bool | None
    clean: object


class Reading:
    """The settings and the state of one reading; arguments as in `Options`."""

    def __init__(
        self,
        tolerance: object = None,
        *,
        nested: bool | None = None,
        layers: Sequence[str] = (),
        ignored_layers: Sequence[str] = (),
        join: object = None,
        unit: str | None = None,
        hidden: bool = False,
        y_down: bool | None = None,
        clean: object = None,
    ) -> None:
        if unit is not None and not (isinstance(unit, str) and unit in UNITS):
            raise FormatError(f"the unit {quote(unit)} is not one of {', '.join(UNITS)}")
        # `joining` is four times the maximum gap at curve ends; None derives it from the drawing.
        self.tolerance = self.joining = read_positive(tolerance, "the tolerance")
        self.join = read_positive(join, "the join distance")
        self.clean = read_positive(clean, "the minimum area") or Fraction(0)
        self.nested, self.unit, self.hidden, self.y_down = nested, unit, hidden, y_down
        self.layers = read_names(layers, "layers")
        self.ignored_layers = read_names(ignored_layers, "ignored_layers")
        self.is_svg = False
        self.found_unit: Fraction | None = None
        self.skipped: Counter[str] = Counter()
        self.notes: dict[str, None] = {}
        self.lines = self.vertices = self.copies = self.copied = 0
        # Whether zero-length strokes with round caps are discs, as in layouts.
        self.dots = False
        # Whether unfilled paths are separate outlines, to be nested with all others.
        self.separate = bool(nested)

    def without_nesting(self) -> Self:
        found = copy(self)
        found.nested = False
        found.skipped, found.notes = Counter(), {}
        found.lines = found.vertices = found.copies = found.copied = 0
        return found

    @property
    def options(self) -> Options:
        given = {name: getattr(self, name) for name in Options.__annotations__}
        return cast(Options, given | {"clean": self.clean or None})

    def with_tolerance(self, tolerance: Fraction) -> Self:
        found = self.without_nesting()
        found.tolerance, found.nested = tolerance, self.nested
        return found

    def charge_chords(self, count: int) -> None:
        if count > MAX_LINES:
            shown = f"{count:,}" if count <= 10**12 else "more than 10**12"
            raise FormatError(
                f"a curve needs {shown} chords at this tolerance; the maximum is {MAX_LINES:,}"
            )
        self.lines += count
        if self.lines * VERTEX > get_limits().max_bytes:
            raise FormatError(
                f"the curves in the file need {self.lines:,} chords at this tolerance; "
                f"the maximum is {get_limits().max_bytes // VERTEX:,} (max_mib)"
            )

    def charge_vertices(self, count: int) -> None:
        self.vertices += count
        require_count(self.vertices, VERTEX, "drawn vertices")

    def charge_copies(self, count: int, size: int, draw: str, things: str) -> None:
        self.copies, self.copied = self.copies + count, self.copied + size
        if self.copies > MAX_COPIES:
            raise FormatError(f"{draw} more than {MAX_COPIES:,} {things}")
        require_size(self.copied, f"{draw} ")

    def scale(self, unit: Fraction | None) -> Fraction:
        """Return the scale factor for a file, given its unit in millimeters."""
        self.found_unit = unit
        if self.unit is None:
            return Fraction(1)
        if unit is None:
            raise FormatError("has no unit, so --unit cannot scale it")
        self.found_unit = UNITS[self.unit]
        return unit / self.found_unit

    def skip_hidden(self, reason: str) -> bool:
        """Return whether to skip an element for a reason ("" if it is visible), and count it."""
        if not reason or self.hidden:
            return False
        self.skipped[reason] += 1
        return True

    def list_hidden(self) -> list[str]:
        return [f"hidden: {many} {what} (--hidden)" for what, many in self.skipped.items()]

    def require_planar(self, heights: Sequence[Fraction]) -> None:
        if all(height is heights[0] for height in heights):
            return
        if max(heights) - min(heights) > (self.join or 0):
            hint = "" if self.join else "; --join DISTANCE allows small differences"
            raise FormatError(f"not planar: the heights differ{hint}")


def read_positive(value: object, name: str) -> Fraction | None:
    if value is None:
        return None
    with prefix_errors(name, FormatError):
        number = to_fraction(value)
    if number <= 0:
        raise FormatError(f"{name} must be positive, not {show_number(number)}")
    return number


def read_names(value: object, name: str) -> tuple[str, ...]:
    if not isinstance(value, list | tuple) or not all(isinstance(one, str) for one in value):
        raise FormatError(f"{name} is {quote(value)}, not a list of strings")
    return tuple(value)
