"""Every public function rejects a wrong value of each argument in one sentence.

Functions and arguments are read from signatures; VALID has values for arguments without a default.
"""

import importlib
import inspect
from collections.abc import Callable, Iterator
from fractions import Fraction
from functools import partial
from itertools import product
from pathlib import Path
from typing import Any, ClassVar

import matplotlib as mpl
import numpy as np
import pytest
import shapely
from command import EXAMPLE
from tiers import mostly_long

import exactsweep
from exactsweep import (
    ExactSweepError,
    Point,
    Polygon,
    PolygonError,
    Polyline,
    inner_fit_polygon,
    limits,
    no_fit_polygon,
    no_fit_union,
    overlap,
)
from exactsweep.batch import take_all_pairs
from exactsweep.canvas.style import Look
from exactsweep.cli.pair import GENERATRIX
from exactsweep.corpus import Case, case_to_json, find_case, layout_cases
from exactsweep.draw import Picture, Scale, make_figure
from exactsweep.formats import NamedPolygon, NamedRegion, to_sympy
from exactsweep.geometry.region import Region
from exactsweep.layout import Layout, LayoutPart, Placement
from exactsweep.numbers.limits import get_limits

PACKAGES = ("batch", "check", "conform", "corpus", "draw", "formats", "layout", "lessons", "view")
UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
TEXT = "[[0, 0], [1, 0], [0, 1]]"
PART = NamedRegion(Region(GENERATRIX), "a")
PARTS = [NamedPolygon(GENERATRIX)]
CASE = find_case("directions-y")
ORIGIN = Point(Fraction(0), Fraction(0))
# Files exist before a function is called.
FILES = {"p.json": TEXT, "pairs.jsonl": f'{{"generatrix": {TEXT}, "directrix": {TEXT}}}\n'}


class Hostile:
    """An object with a false, long repr that contains control characters."""

    def __repr__(self) -> str:
        return "\n\x1b[2J" * 10**4

    __str__ = __repr__

    def __iter__(self) -> Iterator[object]:
        return iter((self, self))


class Unspeakable:
    def __repr__(self) -> str:
        raise RuntimeError

    __str__ = __repr__


class Lying:
    """Claim a length of 10**9, and contain nothing."""

    def __len__(self) -> int:
        return 10**9

    def __iter__(self) -> Iterator[object]:
        return iter(())


class Telling:
    """An object whose `__geo_interface__` has no valid ring."""

    __geo_interface__: ClassVar = {"type": "Polygon", "coordinates": [None, [5]]}


NESTED: list[Any] = []
for _ in range(10**4):
    NESTED = [NESTED]
CYCLE: list[Any] = []
CYCLE += [CYCLE, CYCLE, CYCLE]

# shapes, which all functions read in the same way
NO_SHAPES: list[Any] = [
    *(NESTED, CYCLE, Lying(), Telling(), b"ab", (1, 2, 3), int, [UNIT, UNIT], {(0, 0): 1}),
    *([(0, 0), (1, 1), (2, 2)], [(0, 0), (2, 2), (2, 0), (0, 2)], [(0, 0), (1, 0), (0, "1/0")]),
]
HOSTILE: list[Any] = [
    *(None, "a", "", b"a", 1.5, float("nan"), float("inf"), True, -1, 10**30, 1j, Fraction(1, 3)),
    *([], (), {}, set(), [None], [[]], {"a": 1}, [1, 2], object(), Hostile(), Unspeakable()),
]

FIGURE = make_figure()
PICTURE = Picture(FIGURE.axes[0], Scale.of(EXAMPLE.outer.vertices))
# Valid values of parameters without a default, by their names.
BY_NAME: dict[str, Any] = {
    **dict.fromkeys(("generatrix", "directrix", "stationary", "orbiting"), UNIT),
    **dict.fromkeys(("container", "part", "a", "b"), UNIT),
    **dict.fromkeys(("t", "point", "position"), (0, 0)),
    **dict.fromkeys(("polygon", "shape"), GENERATRIX),
    **dict.fromkeys(("generatrices", "directrices", "polygons"), PARTS),
    "placed": [],
    "path": "p.json",
    "text": TEXT,
    "output": "o.jsonl",
    "form": "wkt",
    "name": "tour",
    "case": CASE,
    "cases": [CASE],
    "result": {},
    "function": lambda case: {},
    "certificate": EXAMPLE.certificate(),
    "notebook": {"cells": []},
    "id": "directions-y",
    "family": "notched",
    "seed": 1,
    "s": EXAMPLE,
    "found": no_fit_polygon(UNIT, UNIT),
    "picture": PICTURE,
    "figure": FIGURE,
    "positions": [ORIGIN],
    "chains": [UNIT],
    "undercuts": EXAMPLE.undercuts,
    "look": Look("red"),
    "fits": [(ORIGIN, ORIGIN)],
    "loops": [EXAMPLE.trajectory],
    "array": np.array(UNIT),
    "geometry": shapely.box(0, 0, 1, 1),
    "places": 2,
    "region": PART.region,
    "regions": [PART],
    "layout": next(iter(layout_cases())).layout,
    "job": take_all_pairs(PARTS, PARTS),
    "side_of": lambda part: "closest",
    "geometries": [shapely.box(0, 0, 1, 1)],
    "data": case_to_json(CASE),
}
# Where the name is ambiguous, or a default would be slow or trivial.
VALID: dict[str, dict[str, Any]] = {
    "batch.run": {"workers": 1},
    "batch.take_listed_pairs": {"path": "pairs.jsonl"},
    "check.verify": {"max_steps": 10**8},
    "conform.conform": {"name": "a", "loops": ("trajectory",), "made_smaller": 0},
    "conform.shrink": {"judge": lambda case: "", "tries": 3, "seconds": 1.0},
    "corpus.cases": {"prefix": "directions"},
    "corpus.find_layout_case": {"id": next(iter(layout_cases())).id},
    "corpus.find_path_case": {"id": "paths-slot"},
    "draw.draw_chains": {"chains": {"a": UNIT}},
    "draw.place_generatrix": {"position": ORIGIN},
    "draw.read_suffix": {"path": "a.svg"},
    "draw.save": {"path": "a.svg"},
    "formats.from_wkt": {"text": "POLYGON ((0 0, 1 0, 0 1, 0 0))"},
    "formats.from_sympy": {"polygon": to_sympy(GENERATRIX)},
    "formats.round_region": {"side": "closest"},
    "formats.to_numpy": {"dtype": "object"},
    "no_fit_union": {"stationary": [UNIT], "orbiting": [UNIT]},
    "view.make_page": {"names": ("a", "b"), "tell": str},
}
# Connecting to an address takes long; progress and restarts are not checked.
UNTRIED = {"scheduler", "progress", "restart"}
# Functions that are slow for any argument; only some arguments are tried.
LONG = {
    "batch.run": ("job", "output", "workers"),
    "view.make_page": ("s", "names"),
    "draw.plot_sweep": ("s",),
    "draw.plot_positions": ("found",),
    "draw.save": ("figure",),
}


def public() -> dict[str, Callable[..., Any]]:
    found: dict[str, Callable[..., Any]] = {}
    for package in ("", *PACKAGES):
        module = importlib.import_module(f"exactsweep.{package}" if package else "exactsweep")
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isfunction(value):
                found[f"{package}.{name}" if package else name] = value
    return found


PUBLIC = public()

HOLED = Region([(0, 0), (5, 0), (5, 5), (0, 5)], [[(1, 1), (2, 1), (1, 2)]])
OF_SHAPES: dict[str, dict[str, Any]] = {
    "contains": {"point": (0, 0), "strictly": False},
    "edge_index": {"k": 0},
    "mirrored": {"along": (0, 1), "center": (0, 0)},
    "plot": {"axes": None},
    "reflected": {"center": (0, 0)},
    "rotated": {"by": 90, "center": (0, 0)},
    "scaled": {"by": 2, "center": (0, 0)},
    "translated": {"by": (1, 1)},
    "vertex_index": {"k": 0},
}
OF_POSITIONS: dict[str, dict[str, Any]] = {
    "locate": {"position": (0, 0)},
    "plot": {"y_down": False},
}
PLOTTED = {"axes": None, "positions": [(0, 0)], "y_down": False}
METHODS: list[tuple[object, dict[str, dict[str, Any]]]] = [
    (GENERATRIX, OF_SHAPES),
    (HOLED, OF_SHAPES),
    (
        EXAMPLE,
        {
            "contacts_along": {"loops": [EXAMPLE.trajectory.vertices]},
            "contacts_at": {"position": (0, 0)},
            "plot": PLOTTED,
            "view": {"height": 600},
        },
    ),
    (no_fit_polygon(UNIT, UNIT), OF_POSITIONS),
    (inner_fit_polygon(HOLED, UNIT), OF_POSITIONS),
    (no_fit_union([HOLED, UNIT], [UNIT]), {"locate": {"position": (0, 0)}}),
    (overlap(HOLED, UNIT), {}),
    (Polyline(UNIT), {}),
]


LAYOUT = next(iter(layout_cases())).layout
READERS: dict[type, tuple[Callable[..., Any], dict[str, Any]]] = {
    Case: (
        Case.of,
        {"id": "a", "title": "", "directrix": UNIT, "generatrix": UNIT, "reference": (0, 0)},
    ),
    Layout: (Layout.from_json, {"data": LAYOUT.to_json()}),
    LayoutPart: (
        partial(LayoutPart.from_json, path="$"),
        {"data": LAYOUT.to_json()["parts"][0]},
    ),
    Placement: (
        partial(Placement.from_json, path="$"),
        {"data": LAYOUT.to_json()["placements"][0]},
    ),
}


def arguments_of(name: str) -> dict[str, Any]:
    """Valid arguments for a public function: those in VALID, by name, and defaults."""
    parameters = inspect.signature(PUBLIC[name]).parameters.values()
    plain = {p.name: p for p in parameters if p.kind is not p.VAR_KEYWORD}
    good = BY_NAME | {key: p.default for key, p in plain.items() if p.default is not p.empty}
    good |= VALID.get(name, {})
    return {key: good[key] for key in plain if key not in UNTRIED}


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize(
    "package", mostly_long(["", *PACKAGES], ["", "corpus", "formats", "layout"])
)
def test_wrong_arguments_of_functions_are_rejected(
    package: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    mpl.use("Agg")
    for name, text in FILES.items():
        Path(name).write_text(text)
    tried = refused = 0
    for name in PUBLIC:
        if name.rpartition(".")[0] != package:
            continue
        arguments = arguments_of(name)
        assert call(PUBLIC[name], arguments) is None, name
        for argument in LONG.get(name, arguments):
            for hostile in HOSTILE:
                tried += 1
                said = call(PUBLIC[name], {**arguments, argument: hostile})
                refused += said is not None
                assert said is None or said.isprintable(), (name, argument)
                assert said is None or 0 < len(said) < 300, (name, argument)
    # Many arguments are names and flags, not polygons, numbers or options.
    assert refused > tried / 3


def test_every_public_method_is_tried() -> None:
    kinds = {kind for kind in vars(exactsweep).values() if isinstance(kind, type)}
    tried = {type(one): methods for one, methods in METHODS}
    plain = {kind for kind in kinds if issubclass(kind, Exception | Point)}
    assert tried.keys() == kinds - plain
    for kind, methods in tried.items():
        public = {name for name in dir(kind) if not name.startswith("_")}
        with_arguments = {
            name
            for name in public
            if inspect.isfunction(of := getattr(kind, name)) or inspect.ismethod(of)
            if inspect.signature(getattr(kind, name)).parameters.keys() - {"self"}
        }
        # Methods of a Sequence behave like those of a tuple.
        assert with_arguments - {"index", "count"} == methods.keys(), kind


def test_every_class_that_reads_data_is_tried() -> None:
    modules = [importlib.import_module(f"exactsweep.{package}") for package in PACKAGES]
    kinds = {
        kind
        for package in modules
        for name in package.__all__
        if isinstance(kind := getattr(package, name), type)
    }
    assert {kind for kind in kinds if {"from_json", "of"} & vars(kind).keys()} - {
        Scale
    } == READERS.keys()


def enter_limits(**values: Any) -> None:
    with limits(**values):
        pass


@pytest.mark.long
@pytest.mark.filterwarnings("ignore")
def test_wrong_arguments_of_methods_and_shapes_are_rejected() -> None:
    mpl.use("Agg")
    calls: list[tuple[Callable[..., Any], dict[str, Any]]] = [
        (Polygon, {"vertices": UNIT}),
        (Region, {"exterior": UNIT, "holes": ()}),
        (enter_limits, get_limits()._asdict()),
        *READERS.values(),
        *((getattr(one, name), given) for one, of in METHODS for name, given in of.items()),
    ]
    tried = refused = 0
    for function, arguments in calls:
        assert call(function, arguments) is None, function
        more = NO_SHAPES if function in (Polygon, Region) else []
        for argument, hostile in product(arguments, HOSTILE + more):
            tried += 1
            said = call(function, {**arguments, argument: hostile})
            refused += said is not None
            assert said is None or said.isprintable(), (function, argument)
            assert said is None or 0 < len(said) < 300, (function, argument)
    assert refused > tried / 2


def test_missing_vertices_and_edges_are_rejected() -> None:
    with pytest.raises(PolygonError, match=r"^there is no vertex 4; the last one is 3$"):
        Polygon(UNIT).vertex_index(4)
    with pytest.raises(PolygonError, match=r"^there is no edge -8; the last one is 6$"):
        HOLED.edge_index(-8)
    with pytest.raises(PolygonError, match=r"^there is no edge 'a'; the last one is 3$"):
        Polygon(UNIT).edge_index("a")  # type: ignore[arg-type]
    # As in a list, -1 is the last one, a vertex of the hole.
    assert HOLED.vertex_index(-1) == HOLED.vertex_index(6)
    assert HOLED.edge_index(-7) == HOLED.edge_index(0)


def call(function: Callable[..., Any], arguments: dict[str, Any]) -> str | None:
    """Call a function; return the refusal."""
    try:
        found = function(**arguments)
        if isinstance(found, Iterator):
            next(found, None)
    except ExactSweepError as error:
        return str(error)
    return None
