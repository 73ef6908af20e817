"""Conformance tests of other implementations against exact answers."""

from exactsweep.conform.judge.compare import compare
from exactsweep.conform.judge.verdict import Comparison, PartComparison, Verdict, Witness
from exactsweep.conform.run.outcome import Outcome
from exactsweep.conform.run.run import Run
from exactsweep.conform.run.runner import conform
from exactsweep.conform.run.shrink import shrink

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
