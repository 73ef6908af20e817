"""Break the kernel on purpose, and see which rows of the ledger turn red.

Run `python -m tests.mutations` for all of them.

Each mutation puts a wrong procedure in the place of a right one, in every module of the package
that has it by name. The rows that depend on the procedure have to turn red.
"""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any, NamedTuple

import click
from rich.console import Console
from rich.table import Table

from exactsweep.evidence import contact, exact_fit, undercut
from exactsweep.paper.claim import Effort, reproduce
from exactsweep.paper.ledger import CLAIMS, find
from exactsweep.procedures import cc, chain, cm, lower_envelope, mm, mm_inner, part_pairs
from exactsweep.procedures.envelope import Envelope, precedes

Procedure = Callable[..., Any]


class Mutation(NamedTuple):
    """A procedure, what takes its place, and rows that must notice."""

    fault: str
    procedure: Procedure
    wrong: Callable[[Procedure], Procedure]
    rows: tuple[str, ...]


def unmerged(right: Procedure) -> Procedure:
    def trajectory_cc(generatrix: Any, directrix: Any) -> Any:
        laid = list(directrix)
        path = chain.inverse(generatrix)
        (x, y), (dx, dy) = laid[-1], path[0]
        return [(a + dx, b + dy) for a, b in laid] + [(x + a, y + b) for a, b in path[1:]]

    return trajectory_cc


def sorted_by_insertion(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any, *cuts: Any) -> Any:
        for x, _ in first:
            for other, _ in second:
                x < other  # noqa: B015
        return right(first, second, *cuts)

    return merge_by_slope


def straightened(right: Procedure) -> Procedure:
    return lambda generatrix, directrix: [directrix[0], directrix[-1]]


def without_bottom(right: Procedure) -> Procedure:
    return lambda top, bottom, directrix: cc.trajectory_cc(top, directrix)


def first_part_only(right: Procedure) -> Procedure:
    return lambda edges, parts, first_source=0: right(edges, list(parts)[:1], first_source)


def undercuts_left_open(right: Procedure) -> Procedure:
    return lambda generatrix, directrix, trajectory=None: chain.corners(directrix)


def without_bottom_cm(right: Procedure) -> Procedure:
    return lambda top, bottom, directrix: cm.trajectory_cm(top, directrix)


def first_chain_only(right: Procedure) -> Procedure:
    return lambda chains, *more, **options: right(chains[:1], *more, **options)


def not_inverted(right: Procedure) -> Procedure:
    def outer_mm(bottom: Any, trajectory: Any) -> Any:
        mirrored = [(-x, y) for x, y in bottom]
        return mm.trajectory_mm(mirrored[::-1], trajectory)

    return outer_mm


def directrix_itself(right: Procedure) -> Procedure:
    return lambda top, trajectory, directrix: chain.corners(directrix)


def always_taken_over(right: Procedure) -> Procedure:
    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        k = partial.edge_before(piece.breaks[0]) if len(partial.edges) > 1 else 0
        cut = Envelope(
            [*partial.breaks[: k + 1], piece.breaks[0]],
            partial.edges[: k + 1],
            partial.sources[: k + 1],
        )
        cut.edges += piece.edges
        cut.sources += piece.sources
        cut.breaks += piece.breaks[1:]
        return cut

    return lower_envelope_cm


def walked_as_a_whole(right: Procedure) -> Procedure:
    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        for at in partial.breaks:
            precedes(at, piece.breaks[0])
        return right(partial, piece)

    return lower_envelope_cm


def never_split(right: Procedure) -> Procedure:
    return lambda points: [[p for part in right(points) for p in part]]


def last_left_out(right: Procedure) -> Procedure:
    return lambda envelopes: right(list(envelopes)[:-1] or envelopes)


def mirrored_in_an_axis(right: Procedure) -> Procedure:
    return lambda points: [(-x, y) for x, y in points]


def left_as_it_is(right: Procedure) -> Procedure:
    return lambda points: list(points)


def without_parallel(right: Procedure) -> Procedure:
    def edge_contacts(*arguments: Any) -> Any:
        return [[c for c in found if c.event != "EE"] for found in right(*arguments)]

    return edge_contacts


def without_first(right: Procedure) -> Procedure:
    return lambda *arguments: list(right(*arguments))[1:]


def none_found(right: Procedure) -> Procedure:
    return lambda *arguments: []


MUTATIONS = (
    Mutation(
        "Trajectory_CC: edges laid end to end, not merged",
        cc.trajectory_cc,
        unmerged,
        ("Trajectory_CC", "Lemma 3.1", "Corollary 3.3"),
    ),
    Mutation(
        "Trajectory_CC: right, but in quadratic time",
        cc.merge_by_slope,
        sorted_by_insertion,
        ("Corollary 3.4",),
    ),
    Mutation(
        "SweepI_CC: D_b cut short by a straight edge",
        cc.sweep_inner_cc,
        straightened,
        ("SweepI_CC", "Lemma 3.2", "Definition 1.2"),
    ),
    Mutation(
        "SweepO_CC: the edges of G_b forgotten",
        cc.sweep_outer_cc,
        without_bottom,
        ("SweepO_CC", "Lemma 3.2", "Corollary A.4"),
    ),
    Mutation(
        "Trajectory_CM, step 2: only the first convex part of D_b",
        cm.sweep_parts,
        first_part_only,
        ("Trajectory_CM", "SweepO_CM", "Lemma 4.2", "Corollary 4.3"),
    ),
    Mutation(
        "SweepI_CM: undercuts left open",
        cm.sweep_inner_cm,
        undercuts_left_open,
        ("SweepI_CM", "Monotone inner boundary", "Number of undercuts", "Corollary 4.4"),
    ),
    Mutation(
        "SweepO_CM: the edges of G_b forgotten",
        cm.sweep_outer_cm,
        without_bottom_cm,
        ("SweepO_CM", "Lemma 4.2", "Corollary 4.3"),
    ),
    Mutation(
        "Trajectory_MM, steps 2 and 3: only the first convex part of G_t",
        part_pairs.sweep_pairs,
        first_chain_only,
        ("Trajectory_MM", "Lemma 5.3", "Lemma 5.2", "Corollary 5.4", "Definition 1.1"),
    ),
    Mutation(
        "Sweep_MM, outer loop: G mirrored in an axis instead of inverted",
        mm.outer_mm,
        not_inverted,
        ("Sweep_MM", "Corollary 5.4", "Lemma 5.6", "Figure 10's count"),
    ),
    Mutation(
        "Sweep_MM, inner loop: D_b returned",
        mm_inner.inner_mm,
        directrix_itself,
        ("Sweep_MM", "Corollary 5.4", "Lemma 5.5", "Definition 2.1"),
    ),
    Mutation(
        "LowerEnvelope_CM: the new piece always taken from its start",
        lower_envelope.lower_envelope_cm,
        always_taken_over,
        ("LowerEnvelope_CM", "Lemma A.3", "Trajectory_CM"),
    ),
    Mutation(
        "LowerEnvelope_CM: right, but all of the partial trajectory is walked each time",
        lower_envelope.lower_envelope_cm,
        walked_as_a_whole,
        ("LowerEnvelope_CM", "Corollary 4.5"),
    ),
    Mutation(
        "step 1: chains not split at reflex vertices",
        chain.convex_parts,
        never_split,
        ("Convex chain", "Lemma 4.1", "Lemma 5.1", "Trajectory_CM"),
    ),
    Mutation(
        "LowerEnvelope_MM: the last sub-trajectory left out",
        lower_envelope.lower_envelope_mm,
        last_left_out,
        ("LowerEnvelope_MM", "Two chains in linear time", "Trajectory_MM"),
    ),
    Mutation(
        "inverse: mirrored in the Y axis, not in a point",
        chain.inverse,
        mirrored_in_an_axis,
        ("Definition 3.1", "Definition 5.1", "Trajectory_CC", "Theorem 2.1"),
    ),
    Mutation(
        "complement: walked the same way",
        chain.complement,
        left_as_it_is,
        ("Definition 5.2", "Sweep_MM", "Lemma 5.3"),
    ),
    Mutation(
        "contacts: EE contacts lost",
        contact.edge_contacts,
        without_parallel,
        ("Every edge of D is touched", "Table 1", "Lemma A.1"),
    ),
    Mutation(
        "undercuts: the first one forgotten",
        undercut.pockets,
        without_first,
        ("Two forms of a bottom chain",),
    ),
    Mutation(
        "exact fits: none found",
        exact_fit.exact_fits,
        none_found,
        ("Definition 1.1",),
    ),
)


@contextmanager
def mutated(mutation: Mutation) -> Iterator[None]:
    """Break the kernel for a while."""
    right = mutation.procedure
    wrong = mutation.wrong(right)
    places = [
        (module, name)
        for key, module in list(sys.modules.items())
        if key.split(".")[0] == "exactsweep"
        for name, value in list(vars(module).items())
        if value is right
    ]
    for module, name in places:
        setattr(module, name, wrong)
    try:
        yield
    finally:
        for module, name in places:
            setattr(module, name, right)


def red_rows(mutation: Mutation, effort: Effort, names: tuple[str, ...] = ()) -> list[str]:
    """The rows, of all or of those named, whose evidence fails under a mutation."""
    claims = [find(name) for name in names] or CLAIMS
    with mutated(mutation):
        return [row.claim.name for row in reproduce(claims, effort) if row.disagreement]


@click.command()
@click.option("--seed", default=1, show_default=True)
@click.option("--full", is_flag=True, help="Not only a tenth of the pairs.")
def main(seed: int, full: bool) -> None:
    """Show, for each mutation, the rows that turn red; exit code 1 if one that must does not."""
    table = Table("mutation", "red rows", "missed", show_lines=True)
    missed_any = False
    for mutation in MUTATIONS:
        red = red_rows(mutation, Effort(seed, quick=not full))
        missed = [name for name in mutation.rows if name not in red]
        missed_any = missed_any or bool(missed)
        table.add_row(mutation.fault, f"{len(red)}: {', '.join(red)}", ", ".join(missed))
    Console().print(table)
    sys.exit(missed_any)


if __name__ == "__main__":
    main()
