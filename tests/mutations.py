"""Break the kernel on purpose, and see which rows of the ledger turn red.

Run `python -m tests.mutations` for all of them.

Each mutation puts a wrong procedure in the place of a right one, in every module of the package
that has it by name. The rows that depend on the procedure have to turn red. Some faults show in
seconds alone; these are timed, in a full run of their rows, and are no part of the test suite.
"""

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from fractions import Fraction
from functools import reduce
from pkgutil import resolve_name
from typing import Any, NamedTuple

import click
from rich.console import Console
from rich.table import Table

from exactsweep.evidence import contact, exact_fit, undercut
from exactsweep.paper import costs, literal
from exactsweep.paper.claim import Effort, reproduce
from exactsweep.paper.ledger import CHECKS, CLAIMS, FIGURES, find, read_rows
from exactsweep.procedures import cc, chain, cm, lower_envelope, mm, mm_inner, part_pairs
from exactsweep.procedures.envelope import Envelope, precedes

Procedure = Callable[..., Any]

# A module that is loaded while the kernel is broken would keep what is wrong.
MODULES = [costs] + [
    resolve_name(f"{folder}.{name.split('.')[0]}")
    for row in read_rows()
    for folder, names in (
        (CHECKS, [*row.get("laws", ()), *([row["check"]] if "check" in row else [])]),
        (FIGURES, [row["figure"]] if "figure" in row else []),
    )
    for name in names
]


class Mutation(NamedTuple):
    """A procedure, what takes its place, and rows that must notice; by the clock, if timed."""

    fault: str
    procedure: Procedure
    wrong: Callable[[Procedure], Procedure]
    rows: tuple[str, ...]
    timed: bool = False


def lay_end_to_end(right: Procedure) -> Procedure:
    def trajectory_cc(generatrix: Any, directrix: Any) -> Any:
        laid = list(directrix)
        path = chain.inverse(generatrix)
        (x, y), (dx, dy) = laid[-1], path[0]
        return [(a + dx, b + dy) for a, b in laid] + [(x + a, y + b) for a, b in path[1:]]

    return trajectory_cc


def compare_all_edges(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any) -> Any:
        for x, _ in first:
            for other, _ in second:
                x < other  # noqa: B015
        return right(first, second)

    return merge_by_slope


def straighten(right: Procedure) -> Procedure:
    return lambda generatrix, directrix: [directrix[0], directrix[-1]]


def forget_bottom(right: Procedure) -> Procedure:
    return lambda top, bottom, directrix: cc.trajectory_cc(top, directrix)


def take_first_part(right: Procedure) -> Procedure:
    return lambda edges, parts, first_source=0: right(edges, list(parts)[:1], first_source)


def leave_undercuts_open(right: Procedure) -> Procedure:
    return lambda generatrix, directrix, trajectory=None: chain.corners(directrix)


def forget_bottom_cm(right: Procedure) -> Procedure:
    return lambda top, bottom, directrix: cm.trajectory_cm(top, directrix)


def take_first_chain(right: Procedure) -> Procedure:
    return lambda chains, *more, **options: right(chains[:1], *more, **options)


def mirror_instead(right: Procedure) -> Procedure:
    def outer_mm(bottom: Any, trajectory: Any) -> Any:
        mirrored = [(-x, y) for x, y in bottom]
        return mm.trajectory_mm(mirrored[::-1], trajectory)

    return outer_mm


def return_directrix(right: Procedure) -> Procedure:
    return lambda top, trajectory, directrix: chain.corners(directrix)


def always_take_over(right: Procedure) -> Procedure:
    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        k = partial.edge_before(piece.breaks[0]) if len(partial.pieces) > 1 else 0
        cut = Envelope(
            [*partial.breaks[: k + 1], piece.breaks[0]],
            partial.pieces[: k + 1],
        )
        cut.pieces += piece.pieces
        cut.breaks += piece.breaks[1:]
        return cut

    return lower_envelope_cm


def walk_as_a_whole(right: Procedure) -> Procedure:
    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        for at in partial.breaks:
            precedes(at, piece.breaks[0])
        return right(partial, piece)

    return lower_envelope_cm


def never_split(right: Procedure) -> Procedure:
    return lambda points: [[p for part in right(points) for p in part]]


def leave_out_last(right: Procedure) -> Procedure:
    return lambda envelopes: right(list(envelopes)[:-1] or envelopes)


def mirror_in_an_axis(right: Procedure) -> Procedure:
    return lambda points: [(-x, y) for x, y in points]


def leave_as_it_is(right: Procedure) -> Procedure:
    return lambda points: list(points)


def lose_parallel(right: Procedure) -> Procedure:
    def edge_contacts(*arguments: Any) -> Any:
        return [[c for c in found if c.event != "EE"] for found in right(*arguments)]

    return edge_contacts


def lose_first(right: Procedure) -> Procedure:
    return lambda *arguments: list(right(*arguments))[1:]


def find_none(right: Procedure) -> Procedure:
    return lambda *arguments: []


def copy_each_time(right: Procedure) -> Procedure:
    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        whole = Envelope(partial.breaks[:], partial.pieces[:])
        return right(whole, piece)

    return lower_envelope_cm


def merge_instead(right: Procedure) -> Procedure:
    return lambda partial, piece: lower_envelope.lower_envelope_mm([partial, piece])


def keep_each(right: Procedure) -> Procedure:
    kept: list[Any] = []

    def lower_envelope_cm(partial: Any, piece: Any) -> Any:
        kept.append((partial.breaks[:], partial.pieces[:]))
        return right(partial, piece)

    return lower_envelope_cm


def concatenate(right: Procedure) -> Procedure:
    def merge_by_slope(first: Any, second: Any) -> Any:
        chain: list[Any] = []
        for point in right(first, second):
            chain = [*chain, point]
        return chain

    return merge_by_slope


def compare_squared(right: Procedure) -> Procedure:
    def trajectory_cm(generatrix: Any, directrix: Any) -> Any:
        for points in (list(generatrix), list(directrix)):
            for x, _ in points:
                for other, _ in points:
                    x < other  # noqa: B015
        return right(generatrix, directrix)

    return trajectory_cm


def run_log_times(right: Procedure) -> Procedure:
    def trajectory_mm(generatrix: Any, directrix: Any) -> Any:
        for _ in range(len(generatrix).bit_length() - 1):
            right(generatrix, directrix)
        return right(generatrix, directrix)

    return trajectory_mm


def keep_first(right: Procedure) -> Procedure:
    return lambda *arguments: list(right(*arguments))[:1]


def halve_fits(right: Procedure) -> Procedure:
    def exact_fits(*arguments: Any) -> Any:
        return [
            (start, tuple((a + b) / Fraction(2) for a, b in zip(start, end, strict=True)))
            for start, end in right(*arguments)
        ]

    return exact_fits


def merge_by_turns(right: Procedure) -> Procedure:
    return lambda envelopes: reduce(lower_envelope.merge, envelopes)


def sweep_all_again(right: Procedure) -> Procedure:
    def inner_mm(top: Any, trajectory: Any, directrix: Any) -> Any:
        literal.trajectory_mm(top, chain.inverse(chain.complement(list(trajectory))))
        return right(top, trajectory, directrix)

    return inner_mm


def draw_straight(right: Procedure) -> Procedure:
    def sweep_inner_cm(generatrix: Any, directrix: Any, trajectory: Any = None) -> Any:
        inner = right(generatrix, directrix, trajectory)
        known = set(directrix)
        return chain.corners([p for k, p in enumerate(inner) if p in known or k % 2])

    return sweep_inner_cm


MUTATIONS = (
    Mutation(
        "Trajectory_CC: edges laid end to end, not merged",
        cc.trajectory_cc,
        lay_end_to_end,
        ("Trajectory_CC", "Lemma 3.1", "Corollary 3.3"),
    ),
    Mutation(
        "Trajectory_CC: right, but in quadratic time",
        cc.merge_by_slope,
        compare_all_edges,
        ("Corollary 3.4",),
    ),
    Mutation(
        "SweepI_CC: D_b cut short by a straight edge",
        cc.sweep_inner_cc,
        straighten,
        ("SweepI_CC", "Lemma 3.2", "Definition 1.2"),
    ),
    Mutation(
        "SweepO_CC: the edges of G_b forgotten",
        cc.sweep_outer_cc,
        forget_bottom,
        ("SweepO_CC", "Lemma 3.2", "Corollary A.4"),
    ),
    Mutation(
        "Trajectory_CM, step 2: only the first convex part of D_b",
        cm.sweep_parts,
        take_first_part,
        ("Trajectory_CM", "SweepO_CM", "Lemma 4.2", "Corollary 4.3"),
    ),
    Mutation(
        "SweepI_CM: undercuts left open",
        cm.sweep_inner_cm,
        leave_undercuts_open,
        ("SweepI_CM", "Monotone inner boundary", "Number of undercuts", "Corollary 4.4"),
    ),
    Mutation(
        "SweepO_CM: the edges of G_b forgotten",
        cm.sweep_outer_cm,
        forget_bottom_cm,
        ("SweepO_CM", "Lemma 4.2", "Corollary 4.3"),
    ),
    Mutation(
        "Trajectory_MM, steps 2 and 3: only the first convex part of G_t",
        part_pairs.sweep_pairs,
        take_first_chain,
        ("Trajectory_MM", "Lemma 5.3", "Lemma 5.2", "Corollary 5.4", "Definition 1.1"),
    ),
    Mutation(
        "Sweep_MM, outer loop: G mirrored in an axis instead of inverted",
        mm.outer_mm,
        mirror_instead,
        ("Sweep_MM", "Corollary 5.4", "Lemma 5.6", "Figure 10's count"),
    ),
    Mutation(
        "Sweep_MM, inner loop: D_b returned",
        mm_inner.inner_mm,
        return_directrix,
        ("Sweep_MM", "Corollary 5.4", "Lemma 5.5", "Definition 2.1"),
    ),
    Mutation(
        "LowerEnvelope_CM: the new piece always taken from its start",
        lower_envelope.lower_envelope_cm,
        always_take_over,
        ("LowerEnvelope_CM", "Lemma A.3", "Trajectory_CM"),
    ),
    Mutation(
        "LowerEnvelope_CM: right, but all of the partial trajectory is walked each time",
        lower_envelope.lower_envelope_cm,
        walk_as_a_whole,
        ("LowerEnvelope_CM", "Corollary 4.5"),
    ),
    Mutation(
        "LowerEnvelope_CM: right, but all of the partial trajectory is copied each time",
        lower_envelope.lower_envelope_cm,
        copy_each_time,
        ("Corollary 4.5",),
        timed=True,
    ),
    Mutation(
        "LowerEnvelope_CM: replaced by LowerEnvelope_MM",
        lower_envelope.lower_envelope_cm,
        merge_instead,
        ("Corollary 4.5",),
    ),
    Mutation(
        "LowerEnvelope_CM: right, but every partial trajectory is kept",
        lower_envelope.lower_envelope_cm,
        keep_each,
        ("Corollary 4.5",),
    ),
    Mutation(
        "Trajectory_CC: right, but the list is copied for each edge",
        cc.merge_by_slope,
        concatenate,
        ("Corollary 3.4",),
        timed=True,
    ),
    Mutation(
        "Trajectory_CM: right, but with m² + n² comparisons more",
        cm.trajectory_cm,
        compare_squared,
        ("Corollary 4.5",),
    ),
    Mutation(
        "SweepI_CM: every other corner of a bottom chain left out",
        cm.sweep_inner_cm,
        draw_straight,
        ("SweepI_CM", "Monotone inner boundary", "Corollary 4.4"),
    ),
    Mutation(
        "Trajectory_MM: right, but run log n times",
        mm.trajectory_mm,
        run_log_times,
        ("Corollary 5.7",),
    ),
    Mutation(
        "LowerEnvelope_MM: right, but one chain after the other",
        lower_envelope.lower_envelope_mm,
        merge_by_turns,
        ("Levels of divide and conquer",),
    ),
    Mutation(
        "Sweep_MM, inner loop: right, but all of T's inside is swept",
        mm_inner.inner_mm,
        sweep_all_again,
        ("A faster inner loop",),
    ),
    Mutation(
        "undercuts: all forgotten but the first of each half",
        undercut.find_pockets,
        keep_first,
        ("Number of undercuts, MM", "Lemma 5.5"),
    ),
    Mutation(
        "exact fits: cut in half",
        exact_fit.find_exact_fits,
        halve_fits,
        ("Definition 1.1",),
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
        leave_out_last,
        ("LowerEnvelope_MM", "Two chains in linear time", "Trajectory_MM"),
    ),
    Mutation(
        "inverse: mirrored in the Y axis, not in a point",
        chain.inverse,
        mirror_in_an_axis,
        ("Definition 3.1", "Definition 5.1", "Trajectory_CC", "Theorem 2.1"),
    ),
    Mutation(
        "complement: walked the same way",
        chain.complement,
        leave_as_it_is,
        ("Definition 5.2", "Sweep_MM", "A faster inner loop"),
    ),
    Mutation(
        "contacts: EE contacts lost",
        contact.find_edge_contacts,
        lose_parallel,
        ("Every edge of D is touched", "Table 1", "Lemma A.1", "Labels of events"),
    ),
    Mutation(
        "undercuts: the first one forgotten",
        undercut.find_pockets,
        lose_first,
        ("Two forms of a bottom chain",),
    ),
    Mutation(
        "exact fits: none found",
        exact_fit.find_exact_fits,
        find_none,
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
@click.option("--timed", "only_timed", is_flag=True, help="Only what shows in seconds alone.")
def main(seed: int, only_timed: bool) -> None:
    """Show, for each mutation, the rows that turn red; exit code 1 if one that must does not.

    Only a tenth of the pairs is tried. What shows in seconds alone is left out unless it is asked
    for; then the rows that must notice are run in full, and no others.
    """
    table = Table("mutation", "red rows", "missed", show_lines=True)
    missed_any = False
    for mutation in MUTATIONS:
        if mutation.timed != only_timed:
            continue
        names = mutation.rows if only_timed else ()
        red = red_rows(mutation, Effort(seed, quick=not only_timed), names)
        missed = [name for name in mutation.rows if name not in red]
        missed_any = missed_any or bool(missed)
        table.add_row(mutation.fault, f"{len(red)}: {', '.join(red)}", ", ".join(missed))
    Console().print(table)
    sys.exit(missed_any)


if __name__ == "__main__":
    main()
