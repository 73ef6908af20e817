"""Makes the pages of the API reference: `python -m exactsweep.cli.reference [FOLDER]`."""

import inspect
import sys
from importlib import import_module
from pathlib import Path
from typing import get_type_hints

import pdoc
from jinja2 import Environment

from exactsweep.lessons import list_titles, read_notebook

MODULES = (
    "exactsweep",
    "exactsweep.geometry",
    "exactsweep.procedures",
    "exactsweep.procedures.cc",
    "exactsweep.procedures.cm",
    "exactsweep.procedures.mm",
    "exactsweep.procedures.ss",
    "exactsweep.procedures.lower_envelope",
    "exactsweep.evidence",
    "exactsweep.evidence.steps",
    "exactsweep.check",
    "exactsweep.layout",
    "exactsweep.text",
    "exactsweep.formats",
    "exactsweep.batch",
    "exactsweep.draw",
    "exactsweep.view",
    "exactsweep.lessons",
    "exactsweep.corpus",
    "exactsweep.conform",
    "exactsweep.conform.adapters",
    "exactsweep.paper",
)


def front() -> str:
    """Return what the first page says: every part with a line on it, the lessons, the project."""
    lines = ["", "", "## The parts", ""]
    for name in MODULES[1:]:
        summary = (import_module(name).__doc__ or "").strip().partition("\n")[0]
        lines.append(f"- [`{name}`]({name.replace('.', '/')}.html): {summary}")
    lines += ["", "## Lessons", ""]
    lines += [
        f"- [{title}](exactsweep/lessons/{name}.html)" for name, title in list_titles().items()
    ]
    return "\n".join([*lines, "", ".. include:: PROJECT.md", ""])


def write_lessons(folder: Path) -> None:
    """Write a page for each of the lessons, with what its cells show."""
    folder.mkdir(parents=True, exist_ok=True)
    source = Path(__file__).with_name("lesson.html.j2").read_text(encoding="utf-8")
    template = Environment(autoescape=True).from_string(source)
    for name, title in list_titles().items():
        cells = read_notebook(name)["cells"]
        text = template.render(title=title, cells=cells, to_html=pdoc.render_helpers.to_html)
        (folder / f"{name}.html").write_text(text, encoding="utf-8")


def main(output: str = "reference") -> None:
    """Write a page for each of the MODULES and of the lessons, and a search index.

    A README.md beside a module is on its page; the first page leads to all others.
    """
    overview = front()
    for name in MODULES:
        module = import_module(name)
        if name == "exactsweep":
            module.__doc__ = f"{module.__doc__}{overview}"
        if any(Path(folder, "README.md").exists() for folder in getattr(module, "__path__", ())):
            module.__doc__ = f"{module.__doc__}\n\n.. include:: README.md\n"
        for value in vars(module).values():
            if inspect.isclass(value) and issubclass(value, tuple) and hasattr(value, "_fields"):
                # The constructor of a named tuple does not know the module of its annotations.
                value.__new__.__annotations__ = get_type_hints(value)
    pdoc.render.configure(docformat="google", show_source=False)
    # A package that exports nothing would bring all of its modules: each name is one page.
    specs = (spec for name in MODULES for spec in (name, rf"!{name}\."))
    pdoc.pdoc(*specs, output_directory=Path(output))
    write_lessons(Path(output, "exactsweep", "lessons"))


if __name__ == "__main__":
    main(*sys.argv[1:])
