"""Values that a function's annotation admits, and messages for all others."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import Any, Literal, NewType, Optional, Protocol, TypeVar, Union

import pytest

from exactsweep.numbers.error import ArgumentError, ExactSweepError, explain_type_errors

T = TypeVar("T")
Metres = NewType("Metres", int)


class Walks(Protocol):
    def walk(self) -> None: ...
    def halt(self) -> None: ...


class Walker:
    def __init__(self) -> None:
        self.walk = self.halt = None


class Standing:
    def __init__(self) -> None:
        self.halt = None


class Bare:
    """A class without its own name."""


class Array(Bare):
    """A type that only type checkers import, for annotations here."""


class Long(Array):
    """A subclass."""


class OwnError(Exception):
    pass


NAN = float("nan")


def tell(value: object, hint: object) -> str | None:
    """Return the error message of a function on a value; None for an allowed failure."""

    def fail(argument: Any) -> None:
        raise OwnError

    fail.__annotations__ = {"argument": hint}
    try:
        explain_type_errors(fail)(value)
    except ArgumentError as error:
        return str(error)
    except OwnError:
        return None
    raise AssertionError


@pytest.mark.parametrize(
    ("hint", "name", "admitted", "refused"),
    [
        (int, "int", [0, -3], ["a", True, 1.0, None]),
        (float, "float", [1, 1.5], [NAN, False, "1", Fraction(1)]),
        (bool, "bool", [True], [1, None]),
        (str, "str", ["", "a"], [b"a", 1]),
        (Fraction, "Fraction", [Fraction(1, 2)], [1]),
        (Bare, "Bare", [Bare(), Long()], [1, Standing()]),
        (None, "None", [None], [0, False]),
        (int | None, "int or None", [1, None], [True, "a", 0.0]),
        (Union[int, str], "int or str", [1, "a"], [None, 0.5]),  # noqa: UP007
        (Optional[str], "str or None", ["a", None], [1]),  # noqa: UP045
        (Literal["ab", "cd", 1], "Literal['ab', 'cd', 1]", ["ab", "cd", 1], ["a", True, 1.0]),
        (Any, "Any", [1, None], []),
        (T, "T", [1, None], []),
        (object, "object", [1, None, "a"], []),
        (Metres, "Metres", [1, "a"], []),
        (list, "list", [[], [1, "a"]], [(), "a"]),
        (list[int], "list[int]", [[], [1, 2]], [["a"], [1, "a"], [None, 1], (1, 2), {1: 2}, "12"]),
        (Sequence[int], "Sequence[int]", [[1], (1, 2)], ["12", b"12", "", [1, "a"], 5, {1: 2}]),
        (Sequence[str], "Sequence[str]", [["a"], "ab", ()], [b"ab", [b"ab"], ["a", 1], 5]),
        (Iterable[int], "Iterable[int]", [{1, 2}, iter("ab"), [1]], [{"a"}, "1", {1: 2}, 5]),
        (Iterator[int], "Iterator[int]", [iter("ab")], [[1], "ab"]),
        (Iterable[str | int], "Iterable[str | int]", [["a", 1], (1,)], [[1, None], 5, "ab"]),
        (Sequence[int] | None, "Sequence[int] | None", [[1], None], [["a"], 5, "a"]),
        (tuple[int, str], "tuple[int, str]", [(1, "a")], [(1,), (1, 2), (1, "a", 2), [1, "a"]]),
        (tuple[int, ...], "tuple[int, ...]", [(), (1,), (1, 2, 3)], [(1, "a"), ("a", 1), [1]]),
        (Sequence[tuple[int, int]], "Sequence[tuple[int, int]]", [[(1, 2)]], [[(1, 2), (3,)]]),
        (Mapping[str, int], "Mapping[str, int]", [{}, {"a": 1}], [{1: 1}, {"a": "b"}, [], "a"]),
        (dict[str, list[int]], "dict[str, list[int]]", [{"a": [1]}], [{"a": 1}, {"a": ["b"]}]),
        (Callable[[int], int], "Callable[[int], int]", [abs], [5]),
        (Walks, "Walks", [Walker()], [Standing(), Bare(), 5]),
        ("int | None", "int or None", [5, None], ["a"]),
        ("Sequence[Fraction]", "Sequence[Fraction]", [[Fraction(1)]], [[1], 5]),
        ("unseen.Array", "Array", [Array(), Long()], [Bare(), 5]),
        ("unseen.Array[int] | None", "Array or None", [Array(), None], [Bare(), 5]),
        ("Sequence[unseen.Array]", "Sequence[Array]", [[Array()]], [[5]]),
    ],
)
def test_annotations_match_their_values(
    hint: object, name: str, admitted: list[object], refused: list[object]
) -> None:
    for value in admitted:
        assert tell(value, hint) is None, value
    for value in refused:
        found = tell(value, hint)
        assert found is not None, value
        assert found.startswith("argument is ")
        assert found.endswith(f", not {name}"), found


def test_only_the_first_items_are_examined() -> None:
    assert tell([0] * 99 + ["a"], list[int]) is not None
    assert tell([0] * 100 + ["a"], list[int]) is None


def test_the_first_of_several_errors_is_reported() -> None:
    @explain_type_errors
    def join(first: int, *many: int, last: int = 0, **named: int) -> int:
        return first.bit_length() + sum(many) + last + sum(named.values())

    assert join(4, 1, last=2, other=3) == 9
    with pytest.raises(ArgumentError, match=r"^first is 'a', not int$"):
        join("a", last="b")  # type: ignore[arg-type]
    with pytest.raises(ArgumentError, match=r"^last is 'b', not int$"):
        join(1, 2, last="b", other=3)  # type: ignore[arg-type]
    for others in ({"other": "a"}, {"first": 1}):
        with pytest.raises(TypeError):
            join(1, **others)


def test_error_messages_are_unchanged() -> None:
    @explain_type_errors
    def refuse(argument: int) -> None:
        raise ExactSweepError(f"no {argument}")

    with pytest.raises(ExactSweepError, match=r"^no a$"):
        refuse("a")  # type: ignore[arg-type]
