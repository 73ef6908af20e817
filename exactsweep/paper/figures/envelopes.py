"""Figure 6: a CM sweep composed of the CC sweeps along the convex parts of D."""

from exactsweep.paper.checks.section4 import lowest
from exactsweep.paper.figures.figure import (
    PaperFigure,
    shift,
    take_half,
    write_list,
)
from exactsweep.paper.functions import keep_corners, take_bottom
from exactsweep.paper.kernel import (
    find_convex_parts,
    sweep_outer_cc,
    sweep_outer_cm,
    trajectory_cc,
    trajectory_cm,
)
from exactsweep.procedures.chain import split
from exactsweep.sweep import sweep

GENERATRIX = [(0, 0), (1, -2), (4, -1), (5, 0), (3, 3), (1, 2)]
DIRECTRIX = [(0, 5), (2, 1), (5, 0), (8, 4), (10, 0), (14, 1), (16, 5), (12, 7), (4, 7)]


def compute() -> PaperFigure:
    s = sweep(GENERATRIX, DIRECTRIX, reference=(2, 0))
    half = take_half(s)
    chain = half.directrix
    parts = find_convex_parts(chain)
    paths = [shift(trajectory_cc(half.top, part), s.reference) for part in parts]
    outers = [sweep_outer_cc(half.top, half.bottom, part) for part in parts]
    path = shift(trajectory_cm(half.top, chain), s.reference)
    outer = list(sweep_outer_cm(half.top, half.bottom, chain))
    meeting = s.undercuts[0].positions[:1]
    return PaperFigure(
        facts=[
            ("convex parts of D_b", len(parts)),
            ("their edges", write_list(len(part) - 1 for part in parts)),
            ("edges of the sub-trajectories", write_list(len(p) - 1 for p in paths)),
            ("edges of the trajectory", len(path) - 1),
            ("edges of the sub-outer chains", write_list(len(p) - 1 for p in outers)),
            ("edges of the outer boundary", len(outer) - 1),
            ("undercuts", len(s.undercuts)),
        ],
        laws=[
            ("trajectory", keep_corners(path), take_bottom(s.trajectory.vertices)),
            ("outer boundary", keep_corners(outer), take_bottom(s.outer.vertices)),
            ("lowest sub-trajectories", lowest("sub-trajectory", paths, path), ""),
            ("lowest sub-outer chains", lowest("sub-outer chain", outers, outer), ""),
            ("the sub-trajectories meet on the trajectory", meeting[0] in path, True),
        ],
        shapes={"top": split(s.directrix.vertices)[1], "bottom": chain, "parts": parts}
        | {"paths": paths, "outers": outers, "path": path, "lower": outer}
        | {"detached": shift(s.generatrix.vertices, (-5, 0)), "meeting": meeting}
        | {"ends": [(x, 0) for x, _ in (outer[0], outer[-1])]}
        | {"below": (chain[3][0] - 2, min(y for _, y in outer))},
        sweeps=[(s, meeting)],
    )
