"""Refusals as transcripts: calls, each with the error that it raises indented below it.

Dots stand for any text.
"""

import re
from decimal import Decimal
from pathlib import Path
from typing import Any

import pytest

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
    # Monotone to all directions near the X axis, and near the Y axis.
    "STANDING": [(0, 0), (3, 0), (3, 2), (0, 2), (2, 1)],
    "LYING": [(0, 0), (0, 3), (2, 3), (2, 0), (1, 2)],
}


def list_refusals(file: str) -> list[tuple[str, str]]:
    """List the calls in refusals.txt beside a file, with their errors."""
    text = Path(file).with_name("refusals.txt").read_text(encoding="utf-8")
    return re.findall(r"^(\S.*)\n    (.*)$", text, re.M)


def require_refused(call: str, said: str, **names: Any) -> None:
    """Require that a call raises the error that stands below it."""
    with pytest.raises(ExactSweepError) as caught:
        eval(call, NAMES | names)
    assert isinstance(caught.value, ValueError)
    pattern = re.escape(said).replace(re.escape("..."), ".*")
    assert re.fullmatch(pattern, f"{type(caught.value).__name__}: {caught.value}")
