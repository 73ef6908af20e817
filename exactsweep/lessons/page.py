"""Lessons as HTML pages, with their code and stored output."""

from exactsweep.lessons.notebook import read_notebook
from exactsweep.numbers.error import explain_type_errors

_KINDS = ("text/html", "image/svg+xml", "text/plain")


@explain_type_errors
def render_lesson(name: str) -> str:
    """Render a lesson, one of `list_titles`, as an HTML page, without running it.

    The page follows the light or dark mode of the browser.

    >>> "<h1>The gallery</h1>" in render_lesson("gallery")
    True
    """
    from jinja2 import Environment, PackageLoader
    from markdown_it import MarkdownIt

    environment = Environment(loader=PackageLoader("exactsweep.lessons", "."), autoescape=True)
    environment.filters["markdown"] = MarkdownIt().render
    cells = [
        {
            "kind": cell["cell_type"],
            "source": "".join(cell["source"]),
            "outputs": [_choose(output) for output in cell.get("outputs", ())],
        }
        for cell in read_notebook(name)["cells"]
    ]
    return environment.get_template("page.html").render(title=cells[0]["source"], cells=cells)


def _choose(output: dict[str, object]) -> tuple[str, str]:
    """Return the richest representation of an output, with its media type."""
    data = output.get("data", {"text/plain": output.get("text", ())})
    assert isinstance(data, dict)
    kind = next(kind for kind in _KINDS if kind in data)
    return kind, "".join(data[kind])
