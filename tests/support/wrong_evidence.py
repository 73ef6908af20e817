"""Sabotages of the evidence: contacts, undercuts, exact fits and steps."""

from fractions import Fraction
from typing import Any

from sabotage import Procedure, sabotage

from exactsweep.evidence import contact, steps, undercut
from exactsweep.procedures import exact_fit, pockets


@sabotage(
    "undercuts: all forgotten but the first of each half",
    pockets.find_pockets,
    "Number of undercuts, MM",
    "Lemma 5.5",
)
def keep_first(right: Procedure) -> Procedure:
    return lambda *arguments: list(right(*arguments))[:1]


@sabotage("exact fits: cut in half", exact_fit.find_exact_fits, "Definition 1.1")
def halve_fits(right: Procedure) -> Procedure:
    def exact_fits(*arguments: Any) -> Any:
        return [
            (start, tuple((a + b) / Fraction(2) for a, b in zip(start, end, strict=True)))
            for start, end in right(*arguments)
        ]

    return exact_fits


@sabotage(
    "contacts: EE contacts lost",
    contact.find_edge_contacts,
    "Every edge of D is touched",
    "Table 1",
    "Lemma A.1",
    "Labels of events",
)
def lose_parallel(right: Procedure) -> Procedure:
    def edge_contacts(*arguments: Any) -> Any:
        return [[c for c in found if c.event != "EE"] for found in right(*arguments)]

    return edge_contacts


@sabotage("undercuts: the first one forgotten", pockets.find_pockets, "Two forms of a bottom chain")
def lose_first(right: Procedure) -> Procedure:
    return lambda *arguments: list(right(*arguments))[1:]


@sabotage("exact fits: none found", exact_fit.find_exact_fits, "Definition 1.1")
def find_none(right: Procedure) -> Procedure:
    return lambda *arguments: []


@sabotage(
    "undercuts: only one of the positions that close them",
    undercut.find_closing_positions,
    "Two forms of a bottom chain",
)
def close_once(right: Procedure) -> Procedure:
    def closing_positions(*arguments: Any) -> Any:
        intersection, positions = right(*arguments)
        return intersection, positions[:1]

    return closing_positions


@sabotage("steps: the last contact of each forgotten", steps.explain, "Table 1", "Lemma A.1")
def forget_last_touch(right: Procedure) -> Procedure:
    return lambda s: [step._replace(touches=step.touches[:-1]) for step in right(s)]


@sabotage(
    "exact fits: all but the first of each half are lost",
    exact_fit.find_exact_fits,
    "Definition 1.1",
)
def keep_first_fit(right: Procedure) -> Procedure:
    return lambda *arguments: list(right(*arguments))[:1]


@sabotage(
    "contacts: the third and later ones at a vertex are lost",
    contact.find_contacts,
    "Table 1",
    "Labels of events",
    "Lemma A.1",
    "Lemma A.2",
    "Theorem 2.1",
)
def keep_two_contacts(right: Procedure) -> Procedure:
    return lambda *arguments: right(*arguments)[:2]


@sabotage(
    "undercuts: one of several closing positions",
    undercut.find_closing_positions,
    "Number of undercuts, MM",
)
def close_at_first(right: Procedure) -> Procedure:
    def closing_positions(*arguments: Any) -> Any:
        intersection, positions = right(*arguments)
        return intersection, positions if intersection == "segment" else positions[:1]

    return closing_positions
