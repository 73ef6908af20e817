"""The adapters by name."""

from __future__ import annotations

from importlib import import_module

from benchmarks.peers.adapters.adapter import Adapter, MissingError
from exactsweep.numbers.error import quote

CGAL_STRATEGIES = (
    "reduced",
    "full",
    "bisectors",
    "optimal",
    "hertel-mehlhorn",
    "greene",
    "vertical",
    "triangulation",
)

NPM = ("clipper2-ts", "js-angusj-clipper", "polygon-clipping", "convex-minkowski-sum")

_MODULES = {
    "shapely": "shapely_union",
    "pyclipper": "clipper_sum",
    "clipper2": "clipper_sum",
    "klayout": "klayout_sum",
    "pysfcgal": "sfcgal_sum",
    **{f"cgal-{strategy}": "cgal_sum" for strategy in CGAL_STRATEGIES},
    **dict.fromkeys(NPM, "npm"),
    "libnfporb": "orbit",
    "libnfporb-rational": "orbit",
    "svgnest-orbit": "orbit",
    "svgnest-clipper": "nest",
    "deepnest-clipper": "nest",
}

NAMES = tuple(_MODULES)


def load(name: str) -> Adapter:
    """Load a program and return its Adapter.

    Raises:
        MissingError: there is no such adapter, or its program is not installed.

    Example:
        >>> load("abacus")
        Traceback (most recent call last):
        benchmarks.peers.adapters.adapter.MissingError: no adapter 'abacus'; choose from shapely, \
pyclipper, clipper2, klayout, pysfcgal, cgal-reduced, cgal-full, cgal-bisectors, cgal-optimal, \
cgal-hertel-mehlhorn, cgal-greene, cgal-vertical, cgal-triangulation, clipper2-ts, \
js-angusj-clipper, polygon-clipping, convex-minkowski-sum, libnfporb, libnfporb-rational, \
svgnest-orbit, svgnest-clipper, deepnest-clipper
    """
    if name not in _MODULES:
        raise MissingError(f"no adapter {quote(name)}; choose from {', '.join(NAMES)}")
    module = import_module(f"benchmarks.peers.adapters.{_MODULES[name]}")
    try:
        adapter: Adapter = module.adapter(name)
    except ImportError as error:
        raise MissingError(
            f"{name} is not installed ({error}): pip install 'exactsweep[peers]'"
        ) from None
    return adapter
