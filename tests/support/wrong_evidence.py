"""Sabotages of the evidence: contacts, undercuts, exact fits and steps."""

from collections.abc import Callable
from fractions import Fraction
from typing import Any

from sabotage import Procedure, sabotage

from exactsweep.evidence import contact, steps, undercut
from exactsweep.procedures import exact_fit, undercuts


@sabotage(
    "undercuts: all forgotten but the first",
    undercuts.find_undercuts,
    "Number of undercuts, MM",
    "Undercuts under ceilings",
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


@sabotage(
    "undercuts: the first one forgotten", undercuts.find_undercuts, "Two forms of a bottom chain"
)
def lose_first(right: Procedure) -> Procedure:
    return lambda *arguments: list(right(*arguments))[1:]


@sabotage(
    "undercuts: an edge of a bottom chain in two", undercut.Undercut, "Two forms of a bottom chain"
)
def add_corner(right: Procedure) -> Procedure:
    def make(polygon: Any, extremes: Any, bottom: Any, form: str, positions: Any) -> Any:
        (x, y), (u, v), *_ = bottom
        middle = type(bottom[0])((x + u) / 2, (y + v) / 2)
        corners = (bottom[0], middle, *bottom[1:]) if form == "point" else bottom
        return right(polygon, extremes, corners, form, positions)

    return make


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


def change_fits(change: Callable[[Any, Any], Any]) -> Callable[[Procedure], Procedure]:
    """Change the far end of each exact fit; drop the fit if the new end is None."""

    def wrong(right: Procedure) -> Procedure:
        def exact_fits(*arguments: Any) -> Any:
            changed = [(start, change(start, end)) for start, end in right(*arguments)]
            return [fit for fit in changed if fit[1] is not None]

        return exact_fits

    return wrong


for fault, change in (
    ("cut off where they are deeper than six", lambda p, q: (q[0], min(q[1], p[1] + 6))),
    ("lost where they are no deeper than one", lambda p, q: q if q[1] - p[1] > 1 else None),
):
    sabotage(f"exact fits: {fault}", exact_fit.find_exact_fits, "Definition 1.1")(
        change_fits(change)
    )


@sabotage(
    "contacts: of several EE contacts of one edge of G only the first",
    contact.find_edge_contacts,
    "Table 1",
    "Lemma A.1",
)
def keep_one_parallel(right: Procedure) -> Procedure:
    def edge_contacts(*arguments: Any) -> Any:
        firsts = [
            {c.generatrix: c for c in at[::-1] if c.event == "EE"} for at in right(*arguments)
        ]
        return [
            [c for c in at if c.event != "EE" or first[c.generatrix] is c]
            for at, first in zip(right(*arguments), firsts, strict=True)
        ]

    return edge_contacts


@sabotage(
    "contacts: where two vertices touch, EV contacts are lost",
    contact.find_contacts,
    "Table 1",
    "Theorem 2.1",
)
def hide_near_vertices(right: Procedure) -> Procedure:
    def find_contacts(*arguments: Any) -> Any:
        found = right(*arguments)
        events = {c.event for c in found}
        return [c for c in found if c.event != "EV" or "VV" not in events]

    return find_contacts


@sabotage(
    "undercuts: the narrowest of more than three is lost",
    undercuts.find_undercuts,
    "Number of undercuts, MM",
)
def lose_narrowest(right: Procedure) -> Procedure:
    def find_undercuts(*arguments: Any) -> Any:
        found = list(right(*arguments))
        widths = [bottom[-1][0] - bottom[0][0] for bottom, _ in found]
        return [p for p, w in zip(found, widths, strict=True) if len(found) < 4 or w > min(widths)]

    return find_undercuts


@sabotage("steps: all end at a corner", steps.explain, "Lemma A.1")
def end_at_corners(right: Procedure) -> Procedure:
    return lambda s: [step._replace(ending="corner") for step in right(s)]


@sabotage("steps: contacts last to the end of their step", steps.explain, "Table 1", "Lemma A.1")
def last_too_long(right: Procedure) -> Procedure:
    return lambda s: [
        step._replace(touches=tuple(t._replace(end=step.end) for t in step.touches))
        for step in right(s)
    ]
