"""The number of examples: few in the plain run, many or all in the long run."""

from collections.abc import Collection

import pytest
from hypothesis import settings

few_or_all = pytest.mark.parametrize(
    "step", [24, pytest.param(1, marks=pytest.mark.long)], ids=["few", "all"]
)
"""Every `step`-th item of a list."""


def examples(many: int) -> settings:
    """Set the number of examples in the long run; plain tests draw a quarter of them."""
    return settings(max_examples=-(-many * settings().max_examples // 100))


def mostly_long(names: Collection[object], plain: Collection[object]) -> list[object]:
    """Mark all parameters except some for the long run."""
    assert {*plain} <= {*names}
    return [name if name in plain else pytest.param(name, marks=pytest.mark.long) for name in names]
