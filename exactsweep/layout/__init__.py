"""Exact judging of layouts: parts placed in a container."""

from exactsweep.layout.fault import Fault
from exactsweep.layout.judge import Judgement, judge_layout
from exactsweep.layout.layout import Layout, LayoutPart, Placement
from exactsweep.layout.reading import LayoutError

__all__ = [
    "Fault",
    "Judgement",
    "Layout",
    "LayoutError",
    "LayoutPart",
    "Placement",
    "judge_layout",
]
