"""Makes the pages of the API reference: `python -m exactsweep.cli.reference [FOLDER]`."""

import inspect
import sys
from importlib import import_module
from pathlib import Path
from typing import get_type_hints

import pdoc

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
    "exactsweep.text",
    "exactsweep.formats",
    "exactsweep.batch",
    "exactsweep.draw",
    "exactsweep.view",
    "exactsweep.corpus",
    "exactsweep.conform",
    "exactsweep.conform.adapters",
    "exactsweep.paper",
)


def main(output: str = "reference") -> None:
    """Write a page for each of the MODULES, with the README.md beside it, and a search index."""
    for name in MODULES:
        module = import_module(name)
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


if __name__ == "__main__":
    main(*sys.argv[1:])
