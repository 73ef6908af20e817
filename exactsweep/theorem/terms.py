"""Terms for Coq, in its syntax and as plain numbers.

A term is a Fraction (a rational), an int (an integer), a `Number`, a bool, a list, a tuple, a dict
(a record of Statements.v, with its fields in order) or a `Constructor`.
"""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from typing import Any, NamedTuple

from exactsweep.numbers.error import ExactSweepError


class TheoremError(ExactSweepError):
    """A certificate whose claim the checker in Coq does not cover."""


class Number(NamedTuple):
    """A natural number, in the scope of its type: nat or N."""

    value: int
    scope: str = "nat"


class Constructor(NamedTuple):
    """A constructor: its number in driver.ml, its Coq name, and its arguments."""

    number: int
    name: str
    arguments: tuple[Any, ...] = ()


def option(value: Any) -> Constructor:
    """Return an optional value, which may be None."""
    return Constructor(0, "None") if value is None else Constructor(1, "Some", (value,))


def write_words(term: Any) -> Iterator[str]:
    """Yield the numbers of a term."""
    match term:
        case Constructor(number, _, arguments):
            yield str(number)
            yield from write_words(arguments)
        case Number(value):
            yield str(value)
        case list():
            yield str(len(term))
            yield from write_words((*term,))
        case tuple():
            for value in term:
                yield from write_words(value)
        case dict():
            yield from write_words((*term.values(),))
        case Fraction():
            yield f"{term.numerator}/{term.denominator}"
        case _:
            yield str(int(term))


def write_coq(term: Any) -> str:
    """Write a term in Coq syntax, with rationals in the open scope."""
    match term:
        case Constructor(_, name, arguments):
            return f"({' '.join([name, *map(write_coq, arguments)])})" if arguments else name
        case Number(value, scope):
            return f"{value}%{scope}"
        case list():
            return f"[{'; '.join(map(write_coq, term))}]"
        case tuple():
            return f"({', '.join(map(write_coq, term))})"
        case dict():
            fields = (f"Statements.{key} := {write_coq(value)}" for key, value in term.items())
            return "{| " + ";\n   ".join(fields) + " |}"
        case bool():
            return str(term).lower()
        case Fraction(denominator=1):
            return str(term) if term >= 0 else f"({term})"
        case Fraction(numerator=n, denominator=d):
            return f"({n} # {d})"
        case _:
            return f"({term})%Z"
