"""Other implementations, judged by the exact answers."""

from exactsweep.conform.compare import compare
from exactsweep.conform.outcome import Outcome
from exactsweep.conform.run import Run
from exactsweep.conform.runner import conform
from exactsweep.conform.shrink import shrink
from exactsweep.conform.verdict import Comparison, PartComparison, Verdict, Witness

__all__ = [
    "Comparison",
    "Outcome",
    "PartComparison",
    "Run",
    "Verdict",
    "Witness",
    "compare",
    "conform",
    "shrink",
]
