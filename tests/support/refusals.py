"""Errors as transcripts: calls, each with its error indented below.

Dots stand for any text. `python -m tests.goldens` rewrites the errors.
"""

import re
from collections.abc import Mapping
from decimal import Decimal
from pathlib import Path
from typing import Any

import exactsweep
from exactsweep import ExactSweepError
from exactsweep.check import classify
from exactsweep.numbers.number import to_fraction

NAMES: dict[str, Any] = {
    **vars(exactsweep),
    "classify": classify,
    "to_fraction": to_fraction,
    "Decimal": Decimal,
    "SQUARE": [(0, 0), (9, 0), (9, 9), (0, 9)],
    "SMALL": [(1, 1), (3, 1), (3, 3), (1, 3)],
    # Monotone in all directions near the X axis, and near the Y axis.
    "STANDING": [(0, 0), (3, 0), (3, 2), (0, 2), (2, 1)],
    "LYING": [(0, 0), (0, 3), (2, 3), (2, 0), (1, 2)],
}


_REFUSAL = re.compile(r"^(\S.*)\n    (.*)$", re.M)


def list_refusals(file: str) -> list[tuple[str, str]]:
    """List the calls and errors of refusals.txt in the folder of a file."""
    text = Path(file).with_name("refusals.txt").read_text(encoding="utf-8")
    return _REFUSAL.findall(text)


def find_refusal(call: str, message: str, names: Mapping[str, Any]) -> str:
    """Return the error of a call, or the given pattern if it matches."""
    found = "no error"
    try:
        eval(call, {**NAMES, **names})
    except ExactSweepError as error:
        found = f"{type(error).__name__}: {error}"
    pattern = re.escape(message).replace(re.escape("..."), ".*")
    return message if re.fullmatch(pattern, found) else found


def require_refused(call: str, message: str, **names: Any) -> None:
    """Require the listed error of a call."""
    assert find_refusal(call, message, names) == message


def renew_errors(path: Path, names: Mapping[str, Any]) -> str:
    """Return the current text of a refusals.txt."""

    def replace(match: re.Match[str]) -> str:
        return f"{match[1]}\n    {find_refusal(match[1], match[2], names)}"

    return _REFUSAL.sub(replace, path.read_text(encoding="utf-8"))
