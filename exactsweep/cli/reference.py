"""The command that makes the API reference: `python -m exactsweep.cli.reference [FOLDER]`."""

import inspect
import re
import sys
from importlib import import_module
from os.path import relpath
from pathlib import Path
from typing import get_type_hints

import pdoc
from jinja2 import Environment

from exactsweep.lessons import list_titles, read_notebook

_PARTS = """
geometry procedures procedures.cc procedures.cm procedures.mm procedures.ss
procedures.lower_envelope evidence evidence.steps check layout text formats batch draw
view lessons corpus conform paper
"""
MODULES = ("exactsweep", *(f"exactsweep.{name}" for name in _PARTS.split()))
"""The modules that have a page, in the order of the first page."""


def read_page(path: Path, module: str) -> str:
    """Read a Markdown file for the page of a module, with links to pages instead of files.

    Links to files without a page become plain text.
    """

    def link(match: re.Match[str]) -> str:
        name, target = match.groups()
        parts = (path.parent / target).resolve().parts
        if "exactsweep" not in parts or parts[-1] != "README.md":
            return name
        inside = parts[len(parts) - parts[::-1].index("exactsweep") - 1 : -1]
        if ".".join(inside) not in MODULES:
            return name
        page = Path(*inside).with_suffix(".html").as_posix()
        # pdoc itself makes links of names of modules in code.
        return f"[{name.replace('`', '')}]({relpath(page, Path(*module.split('.')).parent)})"

    return re.sub(r"\[([^\]]+)\]\((?!https?:)([^)\s]+)\)", link, path.read_text(encoding="utf-8"))


def front() -> str:
    """Return the text of the first page: a line on every module, the lessons, the project."""
    lines = ["", "", "# Modules", ""]
    for name in MODULES[1:]:
        summary = (import_module(name).__doc__ or "").strip().partition("\n")[0]
        lines.append(f"- `{name}`: {summary}")
    lines += ["", "# Lessons", ""]
    lines += [
        f"- [{title}](exactsweep/lessons/{name}.html)" for name, title in list_titles().items()
    ]
    project = Path(__file__).parents[1] / "PROJECT.md"
    return "\n".join([*lines, "", read_page(project, "exactsweep")])


def write_lessons(folder: Path) -> None:
    """Write a page for each lesson, with the output of its cells."""
    folder.mkdir(parents=True, exist_ok=True)
    source = Path(__file__).with_name("lesson.html.j2").read_text(encoding="utf-8")
    template = Environment(autoescape=True).from_string(source)
    for name, title in list_titles().items():
        cells = read_notebook(name)["cells"]
        text = template.render(title=title, cells=cells, to_html=pdoc.render_helpers.to_html)
        (folder / f"{name}.html").write_text(text, encoding="utf-8")


def main(output: str = "reference") -> None:
    """Write a page for each of the MODULES and of the lessons, and a search index.

    The page of a package includes its README.md. The first page has links to all others.
    """
    overview = front()
    for name in MODULES:
        module = import_module(name)
        if name == "exactsweep":
            module.__doc__ = f"{module.__doc__}{overview}"
        for folder in getattr(module, "__path__", ()):
            if (readme := Path(folder, "README.md")).exists():
                module.__doc__ = f"{module.__doc__}\n\n{read_page(readme, name)}"
        for value in vars(module).values():
            if inspect.isclass(value) and issubclass(value, tuple) and hasattr(value, "_fields"):
                # The constructor of a named tuple cannot resolve names in its annotations.
                value.__new__.__annotations__ = get_type_hints(value)
                # Docstrings that Python generates say nothing.
                for generated in (value.__new__, *(vars(value)[field] for field in value._fields)):
                    if generated.__doc__.startswith(("Create new", "Alias for")):
                        generated.__doc__ = ""
    pdoc.render.configure(
        docformat="google", show_source=False, template_directory=Path(__file__).parent
    )
    # Without the second pattern, a package without exports would add all of its modules.
    specs = (spec for name in MODULES for spec in (name, rf"!{name}\."))
    pdoc.pdoc(*specs, output_directory=Path(output))
    write_lessons(Path(output, "exactsweep", "lessons"))


if __name__ == "__main__":
    main(*sys.argv[1:])
