"""The text report of a sweep, for people to read."""

from collections.abc import Iterable
from decimal import MAX_EMAX, MIN_EMIN, Context, Decimal
from fractions import Fraction
from io import StringIO

from rich.console import Console
from rich.table import Table

from exactsweep.evidence.swept import Swept
from exactsweep.geometry.number import format_fraction
from exactsweep.geometry.polygon import Polygon
from exactsweep.words import CLASSES, pair

_APPROXIMATE = Context(prec=6, Emax=MAX_EMAX, Emin=MIN_EMIN)
# Far beyond any line: rich wraps to a width, always.
_NO_WRAPPING = 10**9


def report(sweep: Swept, terminal_width: int | None = None) -> str:
    """Describe a sweep: class, direction, undercuts, exact fits, sizes, areas, loops.

    Areas are exact, with a decimal approximation beside them where that is another number; of a
    long loop the first vertices are shown, and how many more there are.

    Args:
        sweep: a Sweep.
        terminal_width: columns of the terminal to be filled; None for plain text, whose lines are
            as long as they need to be.

    Returns:
        Lines of text, of ASCII characters only; for a terminal also its control sequences.

    Example:
        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> print(report(sweep(square, [(0, 0), (1, 0), (0, "1/3")])), end="")
        class       CC, convex generatrix and convex directrix
        direction   (1,0)
        reference   (0,0)
        undercuts   0
        exact fits  0
        <BLANKLINE>
                    vertices  area about  area exactly
        generatrix         4              1
        directrix          3  0.166667    1/6
        trajectory         5  2.5         5/2
        inner loop         3  0.166667    1/6
        outer loop         5  6.83333     41/6
        swept area            6.66667     20/3
        <BLANKLINE>
        trajectory  (-1,-1) (1,-1) (1,0) (0,1/3) (-1,1/3)
        inner loop  (0,0) (1,0) (0,1/3)
        outer loop  (-1,-1) (2,-1) (2,1) (1,4/3) (-1,4/3)
    """
    loops = {
        "trajectory": sweep.trajectory,
        "inner loop": sweep.inner,
        "outer loop": sweep.outer,
    }
    return laid_out([_facts(sweep), _sizes(sweep, loops), _loops(loops)], terminal_width)


def laid_out(tables: Iterable[Table], terminal_width: int | None) -> str:
    """Write tables as text, an empty line between them.

    Args:
        tables: the tables.
        terminal_width: columns of the terminal to be filled; None for plain text, whose lines are
            as long as they need to be.

    Returns:
        Lines of text; for a terminal also its control sequences.
    """
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
    # rich fills every row up with blanks.
    return "".join(f"{line.rstrip()}\n" for line in text.getvalue().splitlines())


def _facts(sweep: Swept) -> Table:
    table = _named_rows()
    table.add_row("class", CLASSES[sweep.kind])
    table.add_row("direction", pair(sweep.direction))
    table.add_row("reference", pair(sweep.reference))
    table.add_row("undercuts", str(len(sweep.undercuts)))
    table.add_row("exact fits", str(len(sweep.exact_fits)))
    return table


def _sizes(sweep: Swept, loops: dict[str, Polygon]) -> Table:
    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0))
    table.add_column(min_width=10, style="bold")
    table.add_column("vertices", justify="right")
    table.add_column("area about", overflow="fold")
    table.add_column("area exactly", overflow="fold")
    polygons = {"generatrix": sweep.generatrix, "directrix": sweep.directrix, **loops}
    for name, polygon in polygons.items():
        table.add_row(name, str(len(polygon)), *_area(polygon.area))
    table.add_row("swept area", "", *_area(sweep.area))
    return table


def _area(area: Fraction) -> tuple[str, str]:
    exact, rounded = format_fraction(area), approximation(area)
    return "" if rounded == exact else rounded, exact


def _loops(loops: dict[str, Polygon]) -> Table:
    table = _named_rows()
    for name, loop in loops.items():
        # Lines are broken at blanks, and a vertex must not be.
        table.add_row(name, str(loop).replace(", ", ","))
    return table


def _named_rows() -> Table:
    table = Table.grid(padding=(0, 2, 0, 0))
    table.add_column(min_width=10, style="bold")
    table.add_column(overflow="fold")
    return table


def approximation(value: Fraction) -> str:
    """Round to six significant digits, to give an idea of a number.

    >>> approximation(Fraction(-20, 3)), approximation(Fraction(30)), approximation(Fraction(2**99))
    ('-6.66667', '30', '6.33825E+29')
    """
    rounded = _APPROXIMATE.divide(Decimal(value.numerator), Decimal(value.denominator))
    rounded = rounded.normalize(_APPROXIMATE)
    return f"{rounded:f}" if -6 <= rounded.adjusted() <= 12 else str(rounded)
