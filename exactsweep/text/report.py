"""Text reports of sweeps, no-fit polygons and inner fits."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping, Sequence
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from fractions import Fraction
from io import StringIO
from math import isqrt
from types import MappingProxyType
from typing import TYPE_CHECKING

from exactsweep.evidence.no_fit import NoFitAnswer, RegionAnswer
from exactsweep.evidence.sweep import SweepAnswer
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.digits import abridge, find_magnitude, format_fraction
from exactsweep.numbers.number import Fit, find_root
from exactsweep.words import CLASSES, write_pair

# rich is slow to import.
if TYPE_CHECKING:
    from rich.table import Table

NO_FILES: Mapping[str, str] = MappingProxyType({})
_SHOWN = 6  # significant digits of rounded numbers
_ANY_EXPONENT = Context(prec=99, Emax=MAX_EMAX, Emin=MIN_EMIN)
_NO_WRAPPING = 10**9  # rich always wraps, so this exceeds the length of any line


def report(
    sweep: SweepAnswer,
    terminal_width: int | None = None,
    *,
    everything: bool = False,
    files: Mapping[str, str] = NO_FILES,
) -> str:
    """Describe a sweep: class, direction, undercuts, exact fits, sizes, areas, loops.

    Areas are exact, with a decimal approximation if that differs. Long loops are truncated unless
    `everything` is set. `terminal_width` is None for plain text; `files` maps roles of polygons,
    such as "moves" and "stays", to file names.

    >>> from exactsweep import sweep
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> print(report(sweep(square, [(0, 0), (1, 0), (0, "1/3")])), end="")
    class       CC, convex generatrix and convex directrix
    direction   (1,0)
    reference   (0,0)
    undercuts   0
    exact fits  0
    <BLANKLINE>
                vertices  approx. area  exact area
    generatrix         4                1
    directrix          3  0.166667      1/6
    trajectory         5  2.5           5/2
    inner loop         3  0.166667      1/6
    outer loop         5  6.83333       41/6
    swept area            6.66667       20/3
    <BLANKLINE>
    trajectory  (-1,-1) (1,-1) (1,0) (0,1/3) (-1,1/3)
    inner loop  (0,0) (1,0) (0,1/3)
    outer loop  (-1,-1) (2,-1) (2,1) (1,4/3) (-1,4/3)
    """
    loops = {
        "trajectory": sweep.trajectory,
        "inner loop": sweep.inner,
        "outer loop": sweep.outer,
        **{f"unswept {k}": loop for k, loop in enumerate(sweep.unswept)},
    }
    facts = {
        **files,
        "class": CLASSES[sweep.kind],
        "direction": "none" if sweep.direction is None else write_pair(sweep.direction),
        "reference": write_pair(sweep.reference),
        "undercuts": str(len(sweep.undercuts)),
        "exact fits": str(len(sweep.exact_fits)),
    }
    given = {"generatrix": sweep.generatrix, "directrix": sweep.directrix}
    return _format_report(
        facts, given, loops, "swept area", sweep.area, (), terminal_width, everything
    )


def report_no_fit(
    n: NoFitAnswer,
    terminal_width: int | None = None,
    *,
    everything: bool = False,
    files: Mapping[str, str] = NO_FILES,
) -> str:
    loops = {"exterior": n.exterior, **{f"hole {k}": hole for k, hole in enumerate(n.holes)}}
    facts = {
        **files,
        "class": CLASSES[n.kind],
        "reference": write_pair(n.reference),
        "holes": str(len(n.holes)),
        "exact fits": str(len(n.exact_fits)),
    }
    given = {"stationary": n.stationary, "orbiting": n.orbiting}
    return _format_report(
        facts, given, loops, "no fit", n.area, n.exact_fits, terminal_width, everything
    )


def report_regions(
    f: RegionAnswer,
    terminal_width: int | None = None,
    *,
    everything: bool = False,
    files: Mapping[str, str] = NO_FILES,
) -> str:
    exact = "fits exactly" if f.exact_fits else "does not fit"
    given = {name: getattr(f, name) for name in f.asked if name != "reference"}
    facts = {
        **files,
        **({"the part": "fits" if f.regions else exact} if "part" in given else {}),
        **{name: str(len(v)) for name, v in given.items() if isinstance(v, tuple) and v},
        "reference": write_pair(f.reference),
        "regions": str(len(f.regions)),
        "exact fits": str(len(f.exact_fits)),
    }
    loops = {
        f"region {k}{f', hole {j - 1}' if j else ''}": ring
        for k, region in enumerate(f.regions)
        for j, ring in enumerate((region.exterior, *region.holes))
    }
    single = {name: shape for name, shape in given.items() if isinstance(shape, Region)}
    fits, name = f.exact_fits, "positions" if "part" in given else "no fit"
    return _format_report(facts, single, loops, name, f.area, fits, terminal_width, everything)


def _format_report(
    facts: Mapping[str, str],
    given: Mapping[str, AnyPolygon],
    loops: Mapping[str, Polygon],
    name: str,
    area: Fraction,
    fits: Sequence[Fit],
    terminal_width: int | None,
    everything: bool,
) -> str:
    ends = {f"exact fit {k}": tuple(dict.fromkeys(fit)) for k, fit in enumerate(fits)}
    shapes: dict[str, AnyPolygon] = {**given, **loops}
    # rich breaks lines at blanks, so vertices must not contain any.
    texts = {called: str(loop).replace(", ", ",") for called, loop in loops.items()}
    texts |= {called: " ".join(map(write_pair, points)) for called, points in ends.items()}
    width = max(map(len, [*facts, *shapes, name, *texts]))
    sizes = make_table(("", "vertices", "approx. area", "exact area"), {"vertices"}, width)
    for called, shape in shapes.items():
        sizes.add_row(called, str(len(shape)), *write_area(shape.area))
    sizes.add_row(name, "", *write_area(area))
    tables = [list_facts(facts, width), sizes]
    if everything:
        # Tables are slow with long numbers.
        lines = {n: loop.vertices for n, loop in loops.items()} | ends
        points = {
            n: (f"({format_fraction(p.x)},{format_fraction(p.y)})" for p in line)
            for n, line in lines.items()
        }
        shown = (f"{n:<{width}}  {' '.join(line)}\n" for n, line in points.items())
        return lay_out(tables, terminal_width) + "\n" * bool(lines) + "".join(shown)
    return lay_out([*tables, *([list_facts(texts, width)] if texts else [])], terminal_width)


def lay_out(tables: Iterable[Table], terminal_width: int | None) -> str:
    """Format tables as text, separated by blank lines; the width is as for `report`."""
    from rich.console import Console

    text = StringIO()
    console = Console(
        file=text,
        width=terminal_width or _NO_WRAPPING,
        force_terminal=terminal_width is not None,
        highlight=False,
        markup=False,
    )
    for k, table in enumerate(tables):
        if k:
            console.print()
        console.print(table)
    # rich pads every row with blanks.
    return "".join(f"{line.rstrip()}\n" for line in text.getvalue().splitlines())


def make_table(heads: Iterable[str], numbers: Container[str] = (), width: int = 0) -> Table:
    """Make a borderless table; columns whose heads are in `numbers` are right-aligned."""
    from rich.table import Table

    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0))
    for k, head in enumerate(heads):
        table.add_column(
            head,
            style="" if k else "bold",
            justify="right" if head in numbers else "left",
            overflow="fold",
            min_width=0 if k else width,
            # On narrow terminals, rich would crop other columns if it could not keep min_width.
            no_wrap=bool(width) and not k,
        )
    return table


def list_facts(texts: Mapping[str, str], width: int) -> Table:
    from rich.table import Table

    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column(min_width=width, style="bold")
    table.add_column(overflow="fold")
    for name, text in texts.items():
        table.add_row(name, text)
    return table


def write_area(area: Fraction) -> tuple[str, str]:
    """Format an area rounded, or "" if that is exact, and also exactly."""
    exact, rounded = abridge(area), approximate(area)
    return "" if rounded == exact else rounded, exact


def approximate(value: Fraction, *, up: bool = False, more: int = 0) -> str:
    """Format a number with 6 + `more` significant digits, rounded to nearest or up.

    >>> approximate(Fraction(-20, 3)), approximate(Fraction(30)), approximate(Fraction(2**99))
    ('-6.66667', '30', '6.33825e+29')
    >>> approximate(Fraction(1, 3), up=True), approximate(Fraction(1, 4), up=True)
    ('0.333334', '0.25')
    >>> [approximate(Fraction(10) ** k) for k in (-7, -6, 12, 13)]
    ['1e-7', '0.000001', '1000000000000', '1e+13']
    """
    n, d = value.as_integer_ratio()
    exponent = find_magnitude(abs(value)) - _SHOWN - more + 1 if n else 0
    n, d = n * 10 ** max(0, -exponent), d * 10 ** max(0, exponent)
    # Ties go to even.
    whole, rest = divmod(2 * n + d, 2 * d)
    whole = -(-n // d) if up else whole - (whole % 2 if not rest else 0)
    rounded = Decimal(whole).scaleb(exponent, _ANY_EXPONENT).normalize(_ANY_EXPONENT)
    return f"{rounded:f}" if -6 <= rounded.adjusted() <= 12 else str(rounded).lower()


def take_root(square: Fraction) -> Fraction:
    """Return the square root, exact if rational, else rounded up to about 60 bits.

    >>> take_root(Fraction(1, 4)), float(take_root(Fraction(2)))
    (Fraction(1, 2), 1.4142135623730951)
    """
    exact = find_root(square)
    if exact is not None:
        return exact
    n, d = square.as_integer_ratio()
    bits = max(0, 120 + d.bit_length() - n.bit_length())
    return Fraction(isqrt((n << 2 * bits) // d) + 1, 1 << bits)
