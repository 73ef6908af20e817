"""Section 4: convex generatrix, monotone directrix; chains, undercuts, sizes and times."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import chain, pairwise

from exactsweep import Point, sweep
from exactsweep.check import classify, point_in_polygon
from exactsweep.draw.intervals import SweepFeatures
from exactsweep.evidence.undercut import Undercut
from exactsweep.numbers.number import Vertex
from exactsweep.paper.checks.section1 import STEP
from exactsweep.paper.checks.section2 import contacts_are_correct
from exactsweep.paper.checks.section3 import returns
from exactsweep.paper.claim import Counterexample, Effort, Evidence, Observation, Table
from exactsweep.paper.costs import RUNS
from exactsweep.paper.functions import (
    compare_loops,
    evaluate,
    keep_corners,
    list_sub_chains,
    look_up_bottom,
    lower_undercuts,
    reaches,
    sample_between,
)
from exactsweep.paper.kernel import find_convex_parts
from exactsweep.paper.pairs import SweepPair, draw_pairs


def lowest(name: str, chains: Sequence[Sequence[Vertex]], envelope: Sequence[Vertex]) -> str:
    """Describe where an envelope differs from the minimum of some chains, if anywhere."""
    for x in sample_between(envelope, *chains):
        least = min((evaluate(chain, x) for chain in chains if reaches(chain, x)), default=None)
        found = evaluate(envelope, x) if reaches(envelope, x) else None
        if least != found:
            return f"at {x}, the lowest {name} is at {least}, the envelope at {found}"
    return ""


def sub_trajectories_suffice(pair: SweepPair) -> Iterator[str]:
    """The trajectory and the outer boundary are lower envelopes over the convex parts of D_b."""
    paths, outers = list_sub_chains(pair)
    yield lowest("sub-trajectory", paths, look_up_bottom(pair, "trajectory"))
    yield lowest("sub-outer chain", outers, look_up_bottom(pair, "outer"))


def is_monotone(name: str, chain: Iterable[Vertex]) -> Iterator[str]:
    for p, q in pairwise(chain):
        if p[0] >= q[0]:
            yield f"{name} is not strictly X-monotone at x = {p[0]}"


trajectory_cm_is_correct = returns(trajectory="Trajectory_CM")
outer_cm_is_correct = returns(outer="SweepO_CM")
inner_cm_is_correct = returns(inner="SweepI_CM")
inner_is_monotone = returns(
    "The inner boundary is strictly X-monotone.", is_monotone, inner="SweepI_CM"
)
MONOTONE = "If G and D have no vertical edges, the chains are strictly X-monotone."
loops_are_monotone = returns(MONOTONE, is_monotone, trajectory="Trajectory_CM", outer="SweepO_CM")


def few_undercuts(pair: SweepPair) -> Iterator[str]:
    """There are fewer undercuts than convex parts of D_b, each with at most n_t bottom edges."""
    s, (top, _, directrix) = sweep(*pair), pair.chains
    yield from compare_loops(s, "inner")
    lower = lower_undercuts(s)
    if len(lower) >= len(find_convex_parts(directrix)):
        yield f"{len(lower)} undercuts for {len(find_convex_parts(directrix))} convex parts"
    for undercut in lower:
        if len(undercut.bottom) > len(top):
            yield f"an undercut with {len(undercut.bottom) - 1} edges"


def bottom_chains_have_two_forms(pair: SweepPair) -> Iterator[str]:
    """A bottom chain is a piece of G's boundary, or one edge parallel to the shared segment."""
    for undercut in sweep(*pair).undercuts:
        yield from _form(undercut, pair)
    yield from undercuts_fill_the_inner_loop(pair)


def undercuts_fill_the_inner_loop(pair: SweepPair) -> Iterator[str]:
    """The undercuts are disjoint, and their union is the difference of the inner loop and D."""
    s = sweep(*pair)
    if sum(u.polygon.area for u in s.undercuts) + s.directrix.area != s.inner.area:
        yield "the union of the undercuts is not the difference of the inner loop and D"
    yield from compare_loops(s, "inner")


def count_forms(effort: Effort) -> Iterator[Observation]:
    random = draw_pairs(effort, "CM", effort.cases(150))
    resting = draw_pairs(effort, "CM", effort.cases(40), "resting")
    swept = (sweep(*pair) for pair in chain(random, resting))
    forms = Counter(undercut.intersection for s in swept for undercut in s.undercuts)
    point, segment = forms["point"], forms["segment"]
    yield Evidence(f"Undercuts: {point} closed in a point, {segment} along a segment.")
    yield "" if len(forms) == 2 else "only one of the two forms occurs"


def _form(undercut: Undercut, pair: SweepPair) -> Iterator[str]:
    bottom, positions = undercut.bottom, undercut.positions

    def rests(t: Point) -> bool:
        """Decide whether G touches D at a position, with both chain ends on G's boundary."""
        placed = [Point(x + t.x, y + t.y) for x, y in pair.generatrix]
        is_closed = all(point_in_polygon(end, placed) == 0 for end in (bottom[0], bottom[-1]))
        return is_closed and classify(pair.directrix, pair.generatrix, t).verdict == "CONTACT"

    if undercut.intersection == "segment":
        (a, b), (c, d) = (bottom[0], bottom[-1]), (positions[0], positions[-1])
        if len(bottom) != 2 or (b.x - a.x) * (d.y - c.y) != (b.y - a.y) * (d.x - c.x):
            yield f"not a single parallel edge: {undercut}"
        ends = [(c, d), (d, c)]
        beyond = [Point(p.x + STEP * (p.x - q.x), p.y + STEP * (p.y - q.y)) for p, q in ends]
        if c == d or [rests(t) for t in (c, d, *beyond)] != [True, True, False, False]:
            yield f"not at both ends of the segment alone: {undercut}"
    else:
        (t,) = positions
        placed = [Point(x + t.x, y + t.y) for x, y in pair.generatrix]
        if any(point_in_polygon(p, placed) for p in bottom):
            yield f"the bottom chain is off the boundary of G: {undercut}"
        if not set(bottom[1:-1]) <= set(placed):
            yield f"a vertex is not a corner of G: {undercut}"


def labels_name_the_extremes(pair: SweepPair) -> Iterator[str]:
    """The contacts at the positions that close an undercut include both of its extreme points."""
    s = sweep(*pair)
    yield from contacts_are_correct(s)
    yield from compare_loops(s, "inner")
    features = SweepFeatures(s)
    for undercut in s.undercuts:
        spots = {
            spot
            for t in undercut.positions
            for c in s.contacts_at(t)
            for spot in features.spot(c, t)
        }
        if missed := set(undercut.extremes) - spots:
            yield f"no contact at ({min(missed).x}, {min(missed).y}), an end of an undercut"


def sizes_are_bounded(pair: SweepPair) -> Iterator[str]:
    """T has at most m_b + k n_t edges, the outer loop k n_b more, the inner m_b + (k - 1) n_t."""
    chains, parts = pair.chains, find_convex_parts(pair.chains.directrix)
    n_t, n_b, m_b = (len(keep_corners(chain)) - 1 for chain in chains)
    for loop, procedure, most in (
        ("trajectory", "Trajectory_CM", m_b + len(parts) * n_t),
        ("outer", "SweepO_CM", m_b + len(parts) * (n_t + n_b)),
        ("inner", "SweepI_CM", m_b + (len(parts) - 1) * n_t),
    ):
        size, expected = len(list(RUNS[procedure](chains))), len(look_up_bottom(pair, loop))
        if size != expected or size - 1 > most:
            yield f"{procedure}: {size - 1} edges, {expected - 1} by the definition, bound {most}"


def find_large_parts(effort: Effort) -> Iterator[Observation]:
    rows = []
    for n_b in (4, 8, 16):
        pair = build_deep_teeth(n_b)
        edges, bound = len(look_up_bottom(pair, "outer")) - 1, len(pair.chains.directrix) - 1
        rows.append([str(n_b), str(bound), str(edges)])
        yield from parts_are_bounded(pair)
    growing = [int(row[2]) for row in rows]
    if all(later > 1.5 * before for before, later in pairwise(growing)):
        yield Counterexample(
            f"the outer boundary has {growing[0]} edges, although m_b n_t = {bound}, and grows "
            "with n_b",
            "built by hand: deep teeth, and a G with one top edge",
            *build_deep_teeth(4),
        )
    yield Table("G_t with one edge, D_b with four teeth", ("n_b", "m_b n_t", "edges"), rows)


def parts_are_bounded(pair: SweepPair) -> Iterator[str]:
    """The k sub-trajectories have at most m_b + k n_t edges in all, the outer chains k n_b more."""
    n_t, n_b, m_b = (len(chain) - 1 for chain in pair.chains)
    paths, outers = list_sub_chains(pair)
    k = len(paths)
    inner, outer = (sum(len(keep_corners(c)) - 1 for c in found) for found in (paths, outers))
    if inner > m_b + k * n_t or outer > m_b + k * (n_t + n_b):
        yield f"{inner} and {outer} edges in all sub-trajectories and sub-outer chains"
    yield from sub_trajectories_suffice(pair)


def build_deep_teeth(n_b: int) -> SweepPair:
    """Build a convex G with one top edge and n_b bottom edges, and a D with four deep teeth."""
    generatrix = [(2 * k, k * (k - n_b)) for k in range(n_b + 1)]
    width, depth = 2 * n_b + 2, n_b * n_b
    bottom = [(width * k, -depth if k % 2 else 0) for k in range(9)]
    return SweepPair(generatrix, [*bottom, (4 * width, depth)])
