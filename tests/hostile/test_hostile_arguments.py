"""Arguments of the wrong type are named; internal errors keep their message."""

from fractions import Fraction
from pathlib import Path

import pytest

from exactsweep import ExactSweepError
from exactsweep.conform import shrink
from exactsweep.corpus import find_case
from exactsweep.formats import format_polygons, read_polygon, read_text
from exactsweep.numbers.error import ArgumentError, explain_type_errors


def test_errors_name_the_argument_and_its_type() -> None:
    with pytest.raises(ArgumentError, match=r"^polygons is None, not Iterable\[Polygon \| Region"):
        format_polygons(None, "wkt")  # type: ignore[arg-type]
    with pytest.raises(ArgumentError, match=r"^tries is 'a', not int$"):
        shrink(find_case("directions-y"), lambda case: "x", tries="a")  # type: ignore[arg-type]


def test_the_caller_is_not_blamed_for_internal_errors() -> None:
    """Errors on arguments of the right type are unchanged."""

    @explain_type_errors
    def fail(number: int, names: list[str], *, other: "Path | None" = None) -> None:
        raise TypeError("a fault")

    with pytest.raises(TypeError, match="a fault"):
        fail(1, ["a"])
    with pytest.raises(TypeError, match="missing 1 required"):
        fail(1)  # type: ignore[call-arg]
    with pytest.raises(ArgumentError, match=r"^names is \[1\], not list\[str\]$"):
        fail(1, [1])  # type: ignore[list-item]
    with pytest.raises(ArgumentError, match=r"^other is 5, not Path or None$"):
        fail(1, [], other=5)  # type: ignore[arg-type]


def test_a_path_may_be_an_object(tmp_path: Path) -> None:
    """Formerly, an unreadable one caused an internal Python error."""
    path = tmp_path / "unit.json"
    with pytest.raises(ExactSweepError, match=r"unit\.json: No such file"):
        read_polygon(path)
    path.write_text("[[0, 0], [1, 0], [0, 1]]")
    assert read_polygon(path).area == Fraction(1, 2)


def test_integers_are_not_file_descriptors() -> None:
    """Formerly, True was read as standard output, and closed it."""
    for number in (0, 1, True):
        with pytest.raises(ExactSweepError, match="is not a path"):
            read_text(number)  # type: ignore[arg-type]
