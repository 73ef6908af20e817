"""The procedures of the paper, under their own names, and the solvers built on them."""

from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import Chain
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm
from exactsweep.procedures.graph import Graph, lower_envelope_cm, lower_envelope_mm
from exactsweep.procedures.mm import sweep_mm, trajectory_mm

__all__ = [
    "Chain",
    "Graph",
    "lower_envelope_cm",
    "lower_envelope_mm",
    "sweep_inner_cc",
    "sweep_inner_cm",
    "sweep_mm",
    "sweep_outer_cc",
    "sweep_outer_cm",
    "trajectory_cc",
    "trajectory_cm",
    "trajectory_mm",
]
