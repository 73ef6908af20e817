"""The interactive page in a notebook."""

from __future__ import annotations

from html import escape
from typing import TYPE_CHECKING

from exactsweep.view.page import make_page

if TYPE_CHECKING:
    from exactsweep.evidence.sweep import SweepAnswer


class InlinePage:
    """The page of a Sweep as the value of a notebook cell.

    Args:
        s: the Sweep.
        height: the height of the frame in pixels.

    Attributes:
        html: the page as `make_page` returns it.

    Example:
        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> sweep(generatrix=square, directrix=square).view()
        <InlinePage: Sweep of 4 around 4 vertices>
    """

    def __init__(self, s: SweepAnswer, height: int = 600) -> None:
        self.html = make_page(s)
        self._height = height
        self._title = f"Sweep of {len(s.generatrix)} around {len(s.directrix)} vertices"

    def __repr__(self) -> str:
        return f"<InlinePage: {self._title}>"

    def _repr_html_(self) -> str:
        # Scripts in a sandboxed frame cannot access the notebook.
        return (
            f'<iframe title="{escape(self._title)}" sandbox="allow-scripts" '
            f'srcdoc="{escape(self.html)}" '
            f'style="width:100%;height:{self._height}px;border:0"></iframe>'
        )
