"""The steps that checks of certificates take."""

from math import ceil
from typing import Any
from unittest.mock import patch

from exactsweep.check import verify
from exactsweep.check.standalone import Work


def count_steps(certificate: Any) -> list[int]:
    """Verify a certificate; return the steps from each budget, in the order of the checks."""
    begin, budgets = Work.__init__, list[tuple[Work, float]]()

    def remember(work: Work, steps: float) -> None:
        begin(work, steps)
        budgets.append((work, steps))

    with patch.object(Work, "__init__", remember):
        verify(certificate)
    return [ceil(steps - work.left) for work, steps in budgets]
