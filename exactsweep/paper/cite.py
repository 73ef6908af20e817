"""How to cite the paper and this software."""

from __future__ import annotations

from importlib.resources import files


def citation() -> str:
    """The citation data: CITATION.cff, and BibTeX for the paper and the works that correct it.

    >>> citation().count("@article{")
    3
    """
    folder = files("exactsweep.paper")
    texts = (
        folder.joinpath(name).read_text(encoding="utf-8")
        for name in ("CITATION.cff", "references.bib")
    )
    return "\n".join(texts)


def bibtex() -> str:
    """The BibTeX entries alone."""
    return files("exactsweep.paper").joinpath("references.bib").read_text(encoding="utf-8")
