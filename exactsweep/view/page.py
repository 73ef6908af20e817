"""The page: one HTML file that contains style, scripts and data."""

import json
import re
from base64 import b64encode
from collections.abc import Callable
from hashlib import sha256
from html import escape
from importlib.resources import files

from exactsweep.canvas.style import write_style_sheet
from exactsweep.evidence.no_fit import InnerFitAnswer, NoFitAnswer
from exactsweep.evidence.sweep import SweepAnswer
from exactsweep.numbers.error import explain_type_errors
from exactsweep.view.data import gather_page_data, gather_positions

# d3-zoom and its dependencies, in dependency order; see vendor/README.md.
_LIBRARIES = (
    *("color", "dispatch", "ease", "timer", "selection"),
    *("interpolate", "drag", "transition", "zoom"),
)
_SCRIPTS = tuple(
    f"{name}.js"
    for name in ("rational", "shapes", "scene", "grid", "contacts", "page", "pointing", "controls")
)
_FIELD = re.compile(r"\{\{(\w+)\}\}")


@explain_type_errors
def make_page(
    s: SweepAnswer | NoFitAnswer | InnerFitAnswer,
    *,
    names: tuple[str, str] | None = None,
    y_down: bool = False,
    progress: Callable[[str], object] = str,
) -> str:
    """Return an interactive HTML page on which G moves around D, or inside a container.

    Args:
        s: a Sweep, a NoFitPolygon or an InnerFit.
        names: the names of G and D, such as their file names.
        y_down: whether Y points down, as in SVG viewers.
        progress: a callback that receives the name of each long step.

    Returns:
        A self-contained HTML document, whose content security policy permits only its own scripts
        and no network access.

    Cost: linear in the length of the result, plus the cost of loops, contacts and undercuts.

    Example:
        >>> from exactsweep import sweep
        >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
        >>> make_page(sweep(square, square)).startswith("<!doctype html>")
        True
    """
    if isinstance(s, SweepAnswer):
        data = gather_page_data(s, names=names, y_down=y_down, progress=progress)
    else:
        progress("all positions")
        data = gather_positions(s, names=names, y_down=y_down)
    library = "\n".join(_text(f"vendor/d3-{name}.min.js") for name in _LIBRARIES)
    notice = _text("vendor/LICENSE").strip()
    script = "\n".join(map(_text, _SCRIPTS))
    scripts = [f"/*\n{notice}\n*/\n{library}", f'"use strict";\n(() => {{\n{script}}})();\n']
    hashes = " ".join(f"'sha256-{_digest(text)}'" for text in scripts)
    fields = {
        "policy": f"default-src 'none'; script-src {hashes}; style-src 'unsafe-inline'; "
        "img-src data:",
        "title": escape(data["title"]),
        "style": write_style_sheet() + _text("page.css"),
        "data": embed_json(data),
        "library": scripts[0],
        "script": scripts[1],
    }
    return _FIELD.sub(lambda field: fields[field[1]], _text("page.html"))


def _text(name: str) -> str:
    return files("exactsweep.view").joinpath(name).read_text(encoding="utf-8")


def embed_json(data: object) -> str:
    """Write JSON that cannot close the script element around it."""
    text = json.dumps(data, separators=(",", ":"))
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _digest(text: str) -> str:
    return b64encode(sha256(text.encode()).digest()).decode()


class InlinePage:
    """The page of a Sweep in a notebook, in a frame of a given height in pixels.

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
