"""Arguments that are not what a function asks for: refused by name, whatever they are."""

from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest

from exactsweep import (
    Polygon,
    Region,
    inner_fit_polygon,
    no_fit_polygon,
    sweep,
)
from exactsweep.check import classify, reference_loops, reference_no_fit, verify
from exactsweep.formats import parse_polygons, read_polygon, read_polygons
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import to_fraction

UNIT = [(0, 0), (1, 0), (1, 1), (0, 1)]
NESTED: list[Any] = []
for _ in range(10**4):
    NESTED = [NESTED]
CYCLE: list[Any] = []
CYCLE += [CYCLE, CYCLE, CYCLE]


class Lying:
    """Says that it is long, and has nothing."""

    def __len__(self) -> int:
        return 10**9

    def __iter__(self) -> Any:
        return iter(())

    def __repr__(self) -> str:
        return "\n" * 10**6


NUMBERS = [
    *(
        None,
        True,
        1j,
        float("nan"),
        float("inf"),
        "",
        " 1",
        "1 ",
        "+1",
        "01",
        "1_0",
        "0x1",
        "½",
        "٣",
    ),
    *("1e", "1e9999999", "1e-9999999", "1/0", "-", "1/-2", "1//2", "NaN", "1\n", "\x00", "\ud800"),
    *(Decimal("nan"), Decimal("inf"), Decimal("1e99999"), b"1", [1], {1}, object(), int, Lying()),
    *("9" * 10**6, "0." + "0" * 10**6, "1/" + "3" * 10**6, "e" * 10**6, "1e" + "9" * 10**6),
]
POINTS = [None, 7, "ab", b"ab", (), (1,), (1, 2, 3), [[1], [2]], {}, {1: 2}, Lying(), NESTED, CYCLE]
SHAPES = [
    *(None, 7, "polygon", b"", (), [(0, 0)], [(0, 0), (1, 1)], [(0, 0), (1, 1), (2, 2)], [UNIT]),
    *([(0, 0), (1, 0), (0, 0), (0, 1)], [(0, 0), (2, 2), (2, 0), (0, 2)], {0: 1}, Lying(), NESTED),
    *(CYCLE, [(0, 0), (1, 0), (None, 1)], [(0, 0), (1, 0), (0, "x")], [UNIT, UNIT], object(), int),
]


class Telling:
    """Has a `__geo_interface__`, of whatever kind."""

    def __init__(self, told: object) -> None:
        self.__geo_interface__ = told


RINGS: list[Any] = [None, 5, "ab", [], [5], [[]], [None, UNIT], [[5]], [UNIT, 5], {}]
TOLD: list[Any] = [
    *(
        5,
        {},
        "Polygon",
        {"type": ["Polygon"], "coordinates": []},
        {"type": "Feature", "geometry": 5},
    ),
    *({"type": kind} for kind in ("Polygon", "LinearRing", "Point", None)),
    *(
        {"type": kind, "coordinates": coordinates}
        for kind in ("Polygon", "LinearRing", "MultiPolygon")
        for coordinates in RINGS
    ),
]
TEXTS: list[Any] = [
    None,
    5,
    b"[[0, 0], [1, 0], [0, 1]]",
    [],
    True,
    "\x00",
    "a\x00b",
    "\ud800",
    "\ufeff",
    Lying(),
]
DIRECTIONS = [
    *POINTS[1:],
    "12",
    {1: 2, 3: 4},
    (0, 0),
    (0, 1j),
    ("x", 1),
    (1, float("nan")),
    (True, 1),
]
CERTIFICATES = [*SHAPES, *POINTS, *NUMBERS, {"claim": []}, {"claim": "sweep"}, {"format": 1}]

REFUSING: dict[str, tuple[Callable[[Any], object], list[Any]]] = {
    "`to_fraction`": (to_fraction, NUMBERS),
    "coordinates of a `Polygon`": (lambda c: Polygon([(0, 0), (1, 0), (0, c)]), NUMBERS),
    "`Polygon`": (Polygon, SHAPES),
    "exterior of a `Region`": (Region, SHAPES),
    "holes of a `Region`": (lambda hole: Region(UNIT, [hole]), SHAPES),
    "generatrix of a `sweep`": (lambda g: sweep(g, UNIT), SHAPES),
    "directrix of a `sweep`": (lambda d: sweep(UNIT, d), SHAPES),
    "`__geo_interface__`": (lambda told: Polygon(Telling(told)), TOLD),  # type: ignore[arg-type]
    "`__geo_interface__` of a `Region`": (lambda told: Region(Telling(told)), TOLD),  # type: ignore[arg-type]
    "`parse_polygons`": (parse_polygons, TEXTS),
    "`read_polygons`": (read_polygons, TEXTS),
    "`direction`": (lambda u: sweep(UNIT, UNIT, direction=u), DIRECTIONS),
    "`reference`": (lambda r: sweep(UNIT, UNIT, reference=r), POINTS),
    "`no_fit_polygon`": (lambda d: no_fit_polygon(d, UNIT), SHAPES),
    "`inner_fit_polygon`": (lambda d: inner_fit_polygon(d, UNIT), SHAPES),
    "position of `classify`": (lambda t: classify(UNIT, UNIT, t), POINTS),
    "shapes of `classify`": (lambda d: classify(d, UNIT, (0, 0)), SHAPES),
    "`reference_loops`": (lambda d: reference_loops(d, UNIT), SHAPES),
    "`reference_no_fit`": (lambda d: reference_no_fit(d, UNIT), SHAPES),
}


@pytest.mark.parametrize("entry", REFUSING)
def test_what_is_no_argument_is_refused(entry: str) -> None:
    call, arguments = REFUSING[entry]
    for argument in arguments:
        with pytest.raises(ExactSweepError) as caught:
            call(argument)
        message = str(caught.value)
        assert message.isprintable()
        assert 0 < len(message) < 300


def test_no_argument_makes_verify_raise() -> None:
    for argument in CERTIFICATES:
        result = verify(argument)
        assert not result.proved
        assert result.reason.isprintable()


def test_exact_numbers_of_any_kind_come_in() -> None:
    """What looks hostile and is not."""
    for value in (10**9999, Fraction(1, 10**9999), -0.0, 5e-324, "-0", "0e0", Decimal("-0")):
        assert Polygon([(0, 0), (1, 0), (0, 1 + to_fraction(value))])


def test_paths_may_be_objects(tmp_path: Path) -> None:
    """Once one that could not be read ended in Python's own words."""
    path = tmp_path / "unit.json"
    with pytest.raises(ExactSweepError, match=r"unit\.json: No such file"):
        read_polygon(path)
    path.write_text("[[0, 0], [1, 0], [0, 1]]")
    assert read_polygon(path).area == Fraction(1, 2)
