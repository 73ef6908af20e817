"""The procedures of the paper, section by section, and the solvers built on them.

The paper's ten procedures have their own names: `trajectory_cc`, `sweep_inner_cc` and
`sweep_outer_cc` (Section 3), `trajectory_cm`, `sweep_inner_cm` and `sweep_outer_cm` (Section 4),
`trajectory_mm` and `sweep_mm` (Section 5), `lower_envelope_cm` (Appendix) and `lower_envelope_mm`
(Section 5.1). They take and return a `Chain` or a `Graph`.
"""

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
