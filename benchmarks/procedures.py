"""The paper's procedures as they are measured: claimed bound, families, and how to call each.

A `Task` is made for one pair, outside the clock and the count; calling it runs the procedure alone
and returns how much came out.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import log2
from typing import NamedTuple

from exactsweep.geometry.point import Vertex
from exactsweep.paper.pairs import Chains
from exactsweep.procedures.cc import sweep_inner_cc, sweep_outer_cc, trajectory_cc
from exactsweep.procedures.chain import convex_parts, inverse
from exactsweep.procedures.cm import sweep_inner_cm, sweep_outer_cm, trajectory_cm
from exactsweep.procedures.envelope import Envelope
from exactsweep.procedures.lower_envelope import lower_envelope_cm, lower_envelope_mm
from exactsweep.procedures.mm import outer_mm, trajectory_mm
from exactsweep.procedures.mm_inner import inner_mm


class Outcome(NamedTuple):
    """Vertices that came out; the bound, where it depends on more than m and n."""

    output: int
    bound: float | None = None


Task = Callable[[], Outcome]


class Procedure(NamedTuple):
    """A procedure of the paper with its claimed cost; see `scaling.RUNS` for what it is run on."""

    name: str
    claim: str
    bound: Callable[[int, int], float]
    task: Callable[[Chains], Task]


def _read(run: Callable[[Chains], Sequence[Vertex] | Envelope]) -> Callable[[Chains], Task]:
    """A task that runs a procedure and reads every vertex of what it returns."""
    return lambda chains: lambda: Outcome(len(list(run(chains))))


def _inner_mm(chains: Chains) -> Task:
    trajectory = trajectory_mm(chains.top, chains.directrix)
    return lambda: Outcome(len(inner_mm(chains.top, trajectory, chains.directrix)))


def _outer_mm(chains: Chains) -> Task:
    trajectory = trajectory_mm(chains.top, chains.directrix)
    return lambda: Outcome(len(list(outer_mm(chains.bottom, trajectory))))


def _envelope_cm(chains: Chains) -> Task:
    """All sub-trajectories are made beforehand; the bound is what is handed in and trimmed off."""
    pieces = [
        Envelope.of(trajectory_cc(chains.top, part), source)
        for source, part in enumerate(convex_parts(chains.directrix))
    ]

    def run() -> Outcome:
        partial = Envelope(pieces[0].breaks[:], pieces[0].edges[:], pieces[0].sources[:])
        handed_in = len(partial.edges)
        for piece in pieces[1:]:
            handed_in += len(piece.edges)
            lower_envelope_cm(partial, piece)
        return Outcome(len(partial.edges), handed_in + (handed_in - len(partial.edges)))

    return run


def _envelope_mm(chains: Chains) -> Task:
    """One trajectory for each convex part of G_t; the bound is N log2 k for their total size."""
    envelopes = [
        trajectory_cm(inverse(part), chains.directrix) for part in convex_parts(inverse(chains.top))
    ]
    size, count = sum(len(envelope.edges) for envelope in envelopes), len(envelopes)

    def run() -> Outcome:
        return Outcome(len(lower_envelope_mm(envelopes).edges), size * max(1.0, log2(count)))

    return run


def _sum(m: int, n: int) -> float:
    return m + n


def _product(m: int, n: int) -> float:
    return m * n


TRAJECTORY_CC = Procedure(
    "Trajectory_CC", "m + n", _sum, _read(lambda c: trajectory_cc(c.top, c.directrix))
)
SWEEP_INNER_CC = Procedure(
    "SweepI_CC", "m + n", _sum, _read(lambda c: sweep_inner_cc(c.top, c.directrix))
)
SWEEP_OUTER_CC = Procedure(
    "SweepO_CC", "m + n", _sum, _read(lambda c: sweep_outer_cc(c.top, c.bottom, c.directrix))
)
TRAJECTORY_CM = Procedure(
    "Trajectory_CM", "mn", _product, _read(lambda c: trajectory_cm(c.top, c.directrix))
)
SWEEP_INNER_CM = Procedure(
    "SweepI_CM", "mn", _product, _read(lambda c: sweep_inner_cm(c.top, c.directrix))
)
SWEEP_OUTER_CM = Procedure(
    "SweepO_CM", "mn", _product, _read(lambda c: sweep_outer_cm(c.top, c.bottom, c.directrix))
)
LOWER_ENVELOPE_CM = Procedure("LowerEnvelope_CM", "in + trimmed", _product, _envelope_cm)
LOWER_ENVELOPE_MM = Procedure("LowerEnvelope_MM", "N log k", _product, _envelope_mm)
TRAJECTORY_MM = Procedure(
    "Trajectory_MM",
    "mn log n",
    lambda m, n: m * n * log2(n),
    _read(lambda c: trajectory_mm(c.top, c.directrix)),
)
SWEEP_INNER_MM = Procedure(
    "Sweep_MM, inner", "mn² log n", lambda m, n: m * n * n * log2(n), _inner_mm
)
SWEEP_OUTER_MM = Procedure(
    "Sweep_MM, outer", "mn² log n", lambda m, n: m * n * n * log2(n), _outer_mm
)
