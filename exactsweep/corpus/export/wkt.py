"""Cases as WKT, in a table of comma-separated values.

WKT has decimals only. Where a coordinate is not a finite decimal, such as 1/3, the row has no
geometry, and says why: a rounded polygon would be another one.
"""

import csv
from collections.abc import Iterable, Iterator
from io import StringIO

from exactsweep.corpus.case import Case
from exactsweep.corpus.export.geojson import Figure, figures
from exactsweep.formats.decimals import format_decimal
from exactsweep.formats.error import FormatError


def cases_to_wkt(cases: Iterable[Case]) -> Iterator[str]:
    """Write cases as a table, a ring or segment a row.

    Args:
        cases: the cases.

    Returns:
        An iterator of lines: the names of the columns, then for each figure the case's id, the
        figure's name, POLYGON or LINESTRING, and why that is missing.

    Cost: linear in the length of the result, times that of dividing numbers of its length.

    Example:
        >>> from exactsweep.corpus import find_case
        >>> print(*list(cases_to_wkt([find_case("fits-square")]))[4:6], sep="", end="")
        fits-square,inner,"POLYGON ((0 0, 3 0, 3 3, 0 3, 0 0))",
        fits-square,outer,"POLYGON ((-1 -1, 4 -1, 4 4, -1 4, -1 -1))",
    """
    yield _row("case", "figure", "wkt", "missing because")
    for case in cases:
        for figure in figures(case):
            try:
                yield _row(case.id, figure.name, _geometry(figure), "")
            except FormatError as error:
                yield _row(case.id, figure.name, "", str(error))


def _geometry(figure: Figure) -> str:
    points = [" ".join(map(format_decimal, point)) for point in figure.points]
    if figure.closed:
        return f"POLYGON (({', '.join([*points, points[0]])}))"
    return f"LINESTRING ({', '.join(points)})"


def _row(*fields: str) -> str:
    text = StringIO()
    csv.writer(text, lineterminator="\n").writerow(fields)
    return text.getvalue()
