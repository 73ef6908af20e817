"""Makes the pages of the API reference: `python -m exactsweep.cli.reference [FOLDER]`."""

import inspect
import sys
from importlib import import_module
from pathlib import Path
from typing import get_type_hints

import pdoc

MODULES = (
    "exactsweep",
    "exactsweep.procedures.cc",
    "exactsweep.procedures.cm",
    "exactsweep.procedures.mm",
    "exactsweep.procedures.envelope",
    "exactsweep.evidence.steps",
    "exactsweep.check",
    "exactsweep.formats",
    "exactsweep.batch",
    "exactsweep.draw",
    "exactsweep.view",
    "exactsweep.corpus",
    "exactsweep.conform",
)


def main(folder: str = "reference") -> None:
    """Write a page for each of the MODULES, and a search index."""
    for name in MODULES:
        for value in vars(import_module(name)).values():
            if inspect.isclass(value) and issubclass(value, tuple) and hasattr(value, "_fields"):
                # The constructor of a named tuple does not know the module of its annotations.
                value.__new__.__annotations__ = get_type_hints(value)
    pdoc.render.configure(docformat="google", show_source=False)
    pdoc.pdoc(*MODULES, output_directory=Path(folder))


if __name__ == "__main__":
    main(*sys.argv[1:])
