"""A failure as source code for a unit test in the language of the program."""

import re
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from exactsweep.conform.judge.rounding import BEYOND, to_double
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import PointRings


class _Language(NamedTuple):
    pattern: str
    line: str
    brackets: tuple[str, str]
    point: tuple[str, str]
    types: tuple[str, str, str] = ("", "", "")
    comment: str = "//"


_LANGUAGES = {
    "Python": _Language(
        r"\bpython|\.py\b", "{name} = {value}", ("[", "]"), ("(", ")"), comment="#"
    ),
    "JavaScript": _Language(
        r"\b(node|deno|bun)\b|\.[mc]?[jt]s\b", "const {name} = {value};", ("[", "]"), ("[", "]")
    ),
    "Rust": _Language(
        r"\bcargo\b|\.rs\b|target/(release|debug)",
        "let {name}: Vec<Vec<({type}, {type})>> = {value};",
        ("vec![", "]"),
        ("(", ")"),
        ("f64", "&str", "i64"),
    ),
    "C++": _Language(
        "",
        "const std::vector<std::vector<std::pair<{type}, {type}>>> {name} = {value};",
        ("{", "}"),
        ("{", "}"),
        ("double", "std::string", "long long"),
    ),
}


def guess_language(command: Sequence[str], name: str) -> str:
    """Guess the language of a program from its command and name; C++ by default."""
    said = " ".join([*command, name])
    return next(one for one, how in _LANGUAGES.items() if re.search(how.pattern, said))


def write_unit_test(
    shapes: Iterable[tuple[str, PointRings]], language: str, numbers: str, remark: str
) -> str:
    """Write rings as constants of a language.

    >>> from exactsweep import Point
    >>> ring = [Point(Fraction(0), Fraction(1)), Point(Fraction(1, 3), Fraction(2))]
    >>> print(write_unit_test([("exact", [ring])], "JavaScript", "binary64", "a"), end="")
    // a
    const exact = [[[0.0, 1.0], [0.3333333333333333, 2.0]]];
    // exact, exactly: (0,1) (1/3,2)
    """
    how = _LANGUAGES[language]
    is_double = numbers == "binary64"
    number, kind = {
        "binary64": (_write_double, how.types[0]),
        "rational": (lambda c: f'"{format_fraction(c)}"', how.types[1]),
    }.get(numbers, (format_fraction, how.types[2]))
    lines = [f"{how.comment} {remark}"]
    for name, rings in shapes:
        points = ([_surround(how.point, map(number, p)) for p in ring] for ring in rings)
        value = _surround(how.brackets, (_surround(how.brackets, ring) for ring in points))
        lines.append(how.line.format(name=name, value=value, type=kind))
        if is_double and any(to_double(c) != c for ring in rings for p in ring for c in p):
            exact = "; ".join(
                " ".join(f"({','.join(map(format_fraction, p))})" for p in ring) for ring in rings
            )
            lines.append(f"{how.comment} {name}, exactly: {exact}")
    return "".join(f"{line}\n" for line in lines)


def _surround(brackets: tuple[str, str], parts: Iterable[str]) -> str:
    return f"{brackets[0]}{', '.join(parts)}{brackets[1]}"


def _write_double(value: Fraction) -> str:
    return repr(float(value)) if abs(value) < BEYOND else format_fraction(value)
