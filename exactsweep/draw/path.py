"""The data of an SVG path."""

from __future__ import annotations

from collections.abc import Iterable


def path_data(
    lines: Iterable[Iterable[tuple[float, float]]], *, closed: bool, digits: int = 2
) -> str:
    """Write lines as the data of one SVG path.

    Args:
        lines: of points, in pixels; empty ones are left out.
        closed: whether each line is a loop.
        digits: how many decimals there are.

    Cost: linear in the number of points.

    >>> path_data([[(0, 0), (1, 0.125)]], closed=True)
    'M0.00 0.00L1.00 0.12Z'
    """
    corners = ("L".join(f"{x:.{digits}f} {y:.{digits}f}" for x, y in line) for line in lines)
    return "".join(f"M{line}{'Z' * closed}" for line in corners if line)
