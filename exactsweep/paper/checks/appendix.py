"""The appendix: lower envelopes for CM sweeps."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction
from functools import reduce
from itertools import pairwise

from exactsweep import Point, Sweep, sweep
from exactsweep.evidence.contact import Contact
from exactsweep.evidence.steps import Step, explain
from exactsweep.numbers.number import Vertex
from exactsweep.paper import functions
from exactsweep.paper.checks import section2
from exactsweep.paper.checks.section3 import slope
from exactsweep.paper.checks.section4 import lowest
from exactsweep.paper.claim import Effort, Evidence, Observation
from exactsweep.paper.counting import CountedList, count_chains, watch_operations
from exactsweep.paper.kernel import find_convex_parts, to_graph, trajectory_cc
from exactsweep.paper.laws import search_grid
from exactsweep.paper.pairs import SweepPair
from exactsweep.procedures.chain import split
from exactsweep.procedures.graph import Graph, lower_envelope_cm

# Reduced from a random pair.
AT_A_WALL = SweepPair([(0, 0), (1, 0), (1, 1)], [(0, 4), (1, 1), (1, 0), (3, 5)])


def list_lower_steps(s: Sweep) -> list[Step]:
    return [step for step in explain(s) if step.half == "lower"]


def one_edge_at_a_time(pair: SweepPair) -> Iterator[str]:
    """Simultaneous lasting contacts are EV or EE contacts of one edge of G."""
    s = sweep(*pair)
    yield from section2.contacts_are_correct(s)
    for step in list_lower_steps(s):
        yield from section2.touches_are_correct(s, step)
        for t in section2.list_moments(s, step.start, step.end):
            now = [
                touch.contact for touch in step.touches if section2.lasts(t, touch.start, touch.end)
            ]
            if not are_of_one_edge(now):
                yield f"after ({step.start.x}, {step.start.y}), simultaneous: {_name(now)}"


def are_of_one_edge(contacts: Sequence[Contact]) -> bool:
    """Decide whether several contacts are EV or EE contacts of the same edge of G."""
    events, edges = {c.event for c in contacts}, {c.generatrix for c in contacts}
    return len(contacts) < 2 or (len(edges) == 1 and "VE" not in events)


def _name(contacts: Sequence[Contact]) -> str:
    return ", ".join(f"{event} of {i} and {j}" for event, i, j in contacts)


def find_passing_events(effort: Effort) -> Iterator[Observation]:
    def touches_in_passing(pair: SweepPair) -> Iterator[str]:
        s = sweep(*pair)
        for step in list_lower_steps(s):
            contacts = [c for c in s.contacts_at(step.end) if c.event in ("EV", "VE", "EE")]
            if step.ending == "stop" and not are_of_one_edge(contacts):
                yield f"at ({step.end.x}, {step.end.y}), in passing: {_name(contacts)}"

    found = search_grid(2, 7, "convex", "any", touches_in_passing)
    yield replace(found, cases=())
    both = found.cases, search_grid(2, 7, "convex", "convex", _parallel_edges).cases
    for case, parallel in zip(*both, strict=False):
        yield case._replace(text=f"{case.text}; also, {parallel.text}")
    if not all(both):
        yield "no events in passing, or no parallel edges of a convex G"


def _parallel_edges(pair: SweepPair) -> Iterator[str]:
    ring = pair.generatrix
    if len({slope(edge) for edge in functions.list_edges(ring)}) < len(ring):
        yield f"the convex polygon {ring} has parallel edges"


def find_contact_extent(s: Sweep, t: Point, chain: Sequence[Vertex]) -> list[Fraction]:
    """List the abscissas of contacts of G + t with D_b, from G_t and D_b as functions of x."""
    top = [(x + t.x, y + t.y) for x, y in reversed(split(s.generatrix.vertices)[1])]
    return functions.find_common_points(top, chain)


def contact_moves_right(pair: SweepPair) -> Iterator[str]:
    """Both ends of the contact move right; points enter on the right and leave on the left."""
    s, (_, _, directrix) = sweep(*pair), pair.chains
    yield from section2.contacts_are_correct(s)
    positions: set[Point] = set()
    for step in list_lower_steps(s):
        # Include positions between changes of contact.
        positions |= {step.start, step.end, *section2.list_moments(s, step.start, step.end)}
    vertices = {x for x, _ in directrix}
    found = [(t, find_contact_extent(s, t, directrix)) for t in sorted(positions)]
    for (_, before), (t, now) in pairwise(found):
        if now[0] < before[0] or now[-1] < before[-1]:
            yield (
                f"at ({t.x}, {t.y}) the contact is from x = {now[0]} to {now[-1]}, "
                f"after {before[0]} to {before[-1]}"
            )
        passed = {x for x in now if before[0] <= x <= before[-1]}.difference(before)
        for x in passed & vertices:
            yield f"at ({t.x}, {t.y}) G touches D_b at the vertex x = {x}, which it had passed"


def find_contact_moving_left(effort: Effort) -> Iterator[Observation]:
    found = search_grid(2, 8, "bent", "any", contact_moves_right)
    yield replace(found, cases=())
    yield "" if found.cases else "no counterexample with a non-convex G"
    for case in found.cases:
        g, d = case.generatrix, case.directrix
        yield Evidence(f"The statement fails for the non-convex G = {g} and D = {d}.")


def describe_meeting(first: Sequence[Vertex], second: Sequence[Vertex]) -> tuple[str, bool]:
    """Describe how two chains share more than a point or segment; return whether they meet."""
    gaps = functions.list_gaps(first, second)
    zeros = [x for x, gap in gaps if gap == 0]
    zeros += [
        x + (y - x) * gap / (gap - other)
        for (x, gap), (y, other) in pairwise(gaps)
        if gap * other < 0
    ]
    if not zeros:
        return "", False
    start, end = min(zeros), max(zeros)
    if start == end:
        return "", True
    if any(gap != 0 for x, gap in gaps if start <= x <= end):
        return f"the chains meet at {start} and {end}, and separate in between", True
    if len(functions.clip(first, start, end)) > 2:
        return f"the chains share a bend between {start} and {end}", True
    return "", True


def partial_meets_once(pair: SweepPair, *, outer: bool, strict: bool) -> Iterator[str]:
    first, *chains = functions.list_sub_chains(pair)[outer]
    partial = to_graph(first)
    for chain in chains:
        if strict:
            failure, met = describe_meeting(list(partial), chain)
            yield failure or ("" if met else "the partial and the next trajectory do not meet")
        else:
            yield from crosses_once(list(partial), chain)
        partial = lower_envelope_cm(partial, to_graph(chain))
    expected = functions.look_up_bottom(pair, "outer" if outer else "trajectory")
    yield functions.describe_difference("the last envelope", partial, expected)


def crosses_once(first: Sequence[Vertex], second: Sequence[Vertex]) -> Iterator[str]:
    """The difference of two chains, which may have jumps, never changes from + to -."""
    xs = sorted({Fraction(x) for x, _ in (*first, *second)})
    above = False
    for left, right in pairwise(xs):
        for x in ((3 * left + right) / 4, (left + 3 * right) / 4):
            if functions.reaches(first, x) and functions.reaches(second, x):
                gap = functions.evaluate(first, x) - functions.evaluate(second, x)
                if above and gap < 0:
                    yield f"the partial trajectory is above the next one, then below it over {x}"
                above = above or gap > 0


def sub_trajectories_meet_once(pair: SweepPair) -> Iterator[str]:
    """The partial trajectory and the next sub-trajectory meet in one point or segment."""
    return partial_meets_once(pair, outer=False, strict=True)


def sub_trajectories_cross_once(pair: SweepPair) -> Iterator[str]:
    """The partial trajectory is below the next sub-trajectory up to some x, then above it."""
    return partial_meets_once(pair, outer=False, strict=False)


def sub_outer_chains_meet_once(pair: SweepPair) -> Iterator[str]:
    """The partial outer boundary and the next sub-outer chain meet in one point or segment."""
    return partial_meets_once(pair, outer=True, strict=True)


def sub_outer_chains_cross_once(pair: SweepPair) -> Iterator[str]:
    """The partial outer boundary is below the next sub-outer chain up to some x, then above it."""
    return partial_meets_once(pair, outer=True, strict=False)


def show_disjoint_chains(effort: Effort) -> Iterator[Observation]:
    for chains in functions.list_sub_chains(AT_A_WALL):
        if all(describe_meeting(*adjacent)[1] for adjacent in pairwise(chains)):
            yield "all chains meet despite a vertical edge"
    yield Evidence(
        f"For G = {AT_A_WALL.generatrix} and D = {AT_A_WALL.directrix}, which has a vertical "
        "edge, two consecutive chains do not meet."
    )


def lower_envelope_cm_is_correct(pair: SweepPair) -> Iterator[str]:
    """LowerEnvelope_CM returns the lower envelope of the first i sub-trajectories."""
    chains, _ = functions.list_sub_chains(pair)
    partial = reduce(lower_envelope_cm, map(to_graph, chains))
    yield lowest("sub-trajectory", chains, list(partial))
    yield functions.describe_difference(
        "the lower envelope", partial, functions.look_up_bottom(pair, "trajectory")
    )


def watch_slots(partial: Graph) -> Graph:
    """Copy an envelope to lists that count the slots read; the copying itself counts as well."""
    return Graph(CountedList(CountedList(partial.breaks)), CountedList(partial.pieces))


def envelope(pair: SweepPair) -> tuple[int, float]:
    """Count operations and slots read; the bound is the size of the input and trimmed pieces."""
    top, _, directrix = count_chains(pair)
    with watch_operations() as tally:
        pieces = [to_graph(trajectory_cc(top, part)) for part in find_convex_parts(directrix)]
        size = sum(len(piece.pieces) for piece in pieces)
        partial, before = watch_slots(pieces[0]), tally.total
        for piece in pieces[1:]:
            grown = lower_envelope_cm(partial, piece)
            # If the lists are not trimmed in place, they are copies.
            partial = grown if grown.breaks is partial.breaks else watch_slots(grown)
    return tally.total - before, 2 * size - len(partial.pieces)
