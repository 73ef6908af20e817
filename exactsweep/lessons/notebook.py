"""Notebooks without Jupyter: reading, running and writing."""

import ast
import io
import json
from collections.abc import Iterable, Iterator
from contextlib import redirect_stdout
from pathlib import Path
from typing import Any

from exactsweep.draw import save_svg
from exactsweep.numbers.error import ExactSweepError, explain_type_errors, quote
from exactsweep.words import suggest

Notebook = dict[str, Any]
FOLDER = Path(__file__).parent
_NAMES = ("gallery", "tour", "sweeps", "paper", "judging", "layouts")
# Longer outputs, such as the interactive page, are not stored.
_MAX_STORED = 60_000


@explain_type_errors
def list_titles() -> dict[str, str]:
    """Return the titles of the lessons by name.

    >>> list_titles()["judging"]
    'Judging your own program'
    """
    return {name: _source(read_notebook(name)["cells"][0]).split("\n")[0][2:] for name in _NAMES}


@explain_type_errors
def read_notebook(name: str) -> Notebook:
    """Return a lesson, one of `list_titles`, as a notebook document.

    >>> read_notebook("tour")["cells"][0]["cell_type"]
    'markdown'
    """
    if name not in _NAMES:
        near = suggest(str(name), _NAMES) or f"; the lessons are {', '.join(_NAMES)}"
        raise ExactSweepError(f"no lesson {quote(name)}{near}")
    found: Notebook = json.loads((FOLDER / f"{name}.ipynb").read_text(encoding="utf-8"))
    return found


def write_notebook(path: Path, notebook: Notebook) -> None:
    text = json.dumps(notebook, indent=1, ensure_ascii=False)
    path.write_text(f"{text}\n", encoding="utf-8", newline="\n")


@explain_type_errors
def run_notebook(notebook: Notebook) -> Notebook:
    """Run the cells of a notebook in order, like Jupyter.

    Returns:
        The notebook with the output of each cell: printed text, the last value as text, HTML or
        SVG, and pyplot figures as SVG.

    Raises:
        Exception: a cell raised it.

    Example:
        >>> cell = {"cell_type": "code", "source": ["6 * 7"]}
        >>> run_notebook({"cells": [cell]})["cells"][0]["outputs"][0]["data"]
        {'text/plain': ['42']}
    """
    if "cells" not in notebook:
        raise ExactSweepError("the notebook has no cells")
    names: dict[str, Any] = {"__name__": "__main__"}
    cells = []
    number = 0
    for cell in notebook["cells"]:
        if cell["cell_type"] == "code":
            number += 1
            outputs = list(_run(_source(cell), names, number))
            cell = cell | {"execution_count": number, "outputs": outputs}
        cells.append(cell)
    return notebook | {"cells": cells}


def _source(cell: dict[str, Any]) -> str:
    return "".join(cell["source"])


def _run(source: str, names: dict[str, Any], number: int) -> Iterator[dict[str, Any]]:
    tree = ast.parse(source)
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    value = None
    before = _open_figures()
    with redirect_stdout(io.StringIO()) as printed:
        exec(compile(tree, f"cell {number}", "exec"), names)
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), f"cell {number}", "eval"), names)
    if printed.getvalue():
        yield {"name": "stdout", "output_type": "stream", "text": _lines(printed.getvalue())}
    if value is not None:
        yield {
            "data": {kind: _lines(text) for kind, text in _show(value).items()},
            "execution_count": number,
            "metadata": {},
            "output_type": "execute_result",
        }
    for picture in _draw_figures(_open_figures() - before):
        data = {"image/svg+xml": _lines(picture), "text/plain": ["<Figure>"]}
        yield {"data": data, "metadata": {}, "output_type": "display_data"}


def _show(value: object) -> dict[str, str]:
    from matplotlib.figure import Figure

    if isinstance(value, Figure):
        return {"image/svg+xml": save_svg(value), "text/plain": "<Figure>"}
    found = {}
    for kind, method in (("text/html", "_repr_html_"), ("image/svg+xml", "_repr_svg_")):
        text = getattr(value, method, lambda: None)()
        if text is not None and len(text) <= _MAX_STORED:
            found[kind] = text
    return found | {"text/plain": repr(value)}


def _open_figures() -> set[int]:
    from matplotlib import pyplot

    return set(pyplot.get_fignums())


def _draw_figures(figures: Iterable[int]) -> Iterator[str]:
    from matplotlib import pyplot

    for number in sorted(figures):
        yield save_svg(pyplot.figure(number))
        pyplot.close(number)


def _lines(text: str) -> list[str]:
    return text.splitlines(keepends=True)
