"""Matplotlib figures in the project's style, and reproducible files."""

from __future__ import annotations

from io import StringIO
from pathlib import Path
from typing import TYPE_CHECKING, Any

from exactsweep.canvas.style import use_style
from exactsweep.canvas.window import DrawError
from exactsweep.numbers.error import explain_type_errors, quote, require_imports

if TYPE_CHECKING:
    from matplotlib.figure import Figure

SUFFIXES = (".svg", ".pdf", ".png")

_MAX_AXES = 400
# Without the time and the version of the program, so that files are reproducible.
_METADATA: dict[str, dict[str, Any]] = {
    ".svg": {"Date": None, "Creator": "exactsweep"},
    ".pdf": {"CreationDate": None, "Creator": "exactsweep", "Producer": None},
    ".png": {"Software": None},
}


def require_matplotlib() -> None:
    """Raise DrawError if matplotlib is missing or fails to load."""
    with require_imports("matplotlib", "a picture", DrawError):
        import matplotlib  # noqa: F401


@explain_type_errors
def make_figure(rows: int = 1, columns: int = 1, size: tuple[float, float] | None = None) -> Figure:
    """Make a Figure with empty Axes, row by row, without opening a window.

    Args:
        rows: the number of rows of Axes.
        columns: the number of columns of Axes.
        size: width and height in inches, by default 7.2 and 4.8. Saved files are cropped.

    Raises:
        DrawError: matplotlib is not installed.
    """
    require_matplotlib()
    from matplotlib.figure import Figure

    if not 1 <= rows * columns <= _MAX_AXES or rows < 1:
        raise DrawError(f"{quote(rows)} by {quote(columns)} Axes; use 1 to {_MAX_AXES} in all")
    with use_style():
        figure = Figure(layout="compressed", figsize=size)
        figure.subplots(rows, columns)
        return figure


@explain_type_errors
def read_suffix(path: str) -> str:
    """Return the suffix of a picture file in lower case; raises DrawError for other files.

    >>> read_suffix("fig/block.SVG")
    '.svg'
    """
    suffix = Path(path).suffix.lower()
    if suffix not in SUFFIXES:
        fault = f"unknown suffix {suffix!a}" if suffix else "the suffix is missing"
        raise DrawError(f"{fault}; use one of {', '.join(SUFFIXES)}")
    return suffix


@explain_type_errors
def save(figure: Figure, path: str) -> None:
    """Save a figure in the format of the suffix; files depend only on the matplotlib version."""
    suffix = read_suffix(path)
    with use_style():
        figure.savefig(path, format=suffix[1:], metadata=_METADATA[suffix], bbox_inches="tight")


@explain_type_errors
def save_svg(figure: Figure) -> str:
    """Return a figure as an SVG document, as `save` writes it."""
    text = StringIO()
    with use_style():
        figure.savefig(text, format="svg", metadata=_METADATA[".svg"], bbox_inches="tight")
    return text.getvalue()
