"""Tests of laws on random pairs, reduction of counterexamples, and searches of tiny grids."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cache
from itertools import combinations, pairwise, product

from exactsweep.corpus.generator.shapes import Ring
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.polygon import Polygon
from exactsweep.paper.claim import Counterexample, Effort, Evidence, find_first_failure
from exactsweep.paper.pairs import SweepPair, draw_pairs, list_corners
from exactsweep.procedures.chain import Chain, inverse, split

# For larger pairs, removing vertices one by one would take minutes.
SHRINK_LIMIT = 40
KINDS_OF_PAIRS = {
    "": "",
    "weak": " with vertical edges",
    "large": " of 24 to 64 vertices each",
    "far": " with coordinates of 30 digits",
    "resting": " with an edge of G on teeth",
}
Law = Callable[[SweepPair], Iterable[str]]
"""A function that yields how a pair breaks the law; empty strings are ignored."""


def find_violation(law: Law, pairs: Iterable[SweepPair]) -> str:
    """Describe a pair that breaks a law, reduced if it is small; return "" if there is none.

    >>> law = lambda pair: ["" if len(pair.directrix) < 4 else "four corners"]
    >>> triangle = [(0, 0), (1, 0), (0, 1)]
    >>> find_violation(law, [SweepPair(triangle, [*triangle[:2], (1, 1), (0, 2)])])
    'four corners; G = [(0, 0), (1, 0), (0, 1)], D = [(0, 0), (1, 0), (1, 1), (0, 2)]'
    """
    for pair in pairs:
        if find_failure(law, pair):
            least = shrink(law, pair) if sum(map(len, pair)) < SHRINK_LIMIT else pair
            return f"{find_failure(law, least)}; G = {least.generatrix}, D = {least.directrix}"
    return ""


def find_failure(law: Law, pair: SweepPair) -> str:
    """Test a law on a pair; an exception counts as a failure."""
    try:
        return find_first_failure(law(pair))
    except Exception as error:
        return f"{type(error).__name__}: {error}"


def shrink(law: Law, pair: SweepPair) -> SweepPair:
    """Remove vertices and halve coordinates while the law still fails."""
    while smaller := next((p for p in _smaller(pair) if find_failure(law, p)), None):
        pair = smaller
    return pair


def _smaller(pair: SweepPair) -> Iterator[SweepPair]:
    for name, ring in pair._asdict().items():
        for changed in _smaller_rings(ring):
            with suppress(ValueError):
                corners = list_corners(changed)
                if corners != ring and is_x_monotone(corners) >= is_x_monotone(ring):
                    yield pair._replace(**{name: corners})


def is_x_monotone(ring: Ring) -> bool:
    with suppress(ValueError):
        bottom, top = split(ring)
        return all(map(Chain.of, (bottom, inverse(top))))
    return False


def _smaller_rings(ring: Ring) -> Iterator[Ring]:
    for k in range(len(ring)):
        yield ring[:k] + ring[k + 1 :]
    left, low = min(x for x, _ in ring), min(y for _, y in ring)
    moved = [(x - left, y - low) for x, y in ring]
    yield [(x // 2, y) for x, y in moved]
    yield [(x, y // 2) for x, y in moved]


def try_laws(laws: Iterable[tuple[Law, str]], effort: Effort) -> Evidence:
    """Test laws, each on its pairs, as in "100 CC, 60 MM weak, 4 MM large", up to a failure."""
    # All laws share the pairs, so that their reference loops can be cached.
    tried: dict[str, list[str]] = {}
    sampled, failure = [], ""
    for law, pairs in laws:
        numbers = []
        for number, kind, *how in map(str.split, pairs.split(",")):
            numbers.append(effort.cases(int(number)))
            failure = failure or find_violation(law, draw_pairs(effort, kind, numbers[-1], *how))
            text = (law.__doc__ or "").split("\n")[0]
            drawn = f"{numbers[-1]} {kind}{KINDS_OF_PAIRS[''.join(how)]}"
            tried.setdefault(text, []).append(drawn)
        sampled.append(sum(numbers))
    summary = " ".join(f"{text} Pairs: {', '.join(drawn)}." for text, drawn in tried.items())
    return Evidence(summary, failure, sampled=min(sampled, default=0))


@cache
def list_polygons(side: int, vertices: int) -> tuple[tuple[tuple[int, int], ...], ...]:
    """List the strictly X-monotone polygons with k corners on a grid that touch both axes."""
    found = set()
    for chosen in combinations(sorted(product(range(side + 1), repeat=2)), vertices):
        first, *others, last = chosen
        if first[0] > 0 or min(y for _, y in chosen) > 0:
            continue
        for sides in product((True, False), repeat=len(others)):
            bottom = [first, *(p for p, low in zip(others, sides, strict=True) if low), last]
            top = [first, *(p for p, low in zip(others, sides, strict=True) if not low), last]
            if any(p[0] == q[0] for chain in (bottom, top) for p, q in pairwise(chain)):
                continue
            with suppress(PolygonError):
                corners = Polygon([*bottom, *top[-2:0:-1]]).vertices
                ring = tuple((int(x), int(y)) for x, y in corners)
                if len(ring) == vertices and set(bottom) <= set(split(ring)[0]):
                    found.add(ring)
    return tuple(sorted(found, key=_size))


def _size(ring: Sequence[tuple[int, int]]) -> tuple[int, Sequence[tuple[int, int]]]:
    return max(x for x, _ in ring) + max(y for _, y in ring), ring


SHAPES: dict[str, Callable[[Ring], bool]] = {
    "any": lambda ring: True,
    "convex": lambda ring: Polygon(ring).is_convex,
    "bent": lambda ring: not Polygon(ring).is_convex,
}


def list_tiny_pairs(side: int, most: int, generatrix: str, directrix: str) -> Iterator[SweepPair]:
    for total in range(6, most + 1):
        pairs = []
        for n in range(3, total - 2):
            gs = _choose(side, n, generatrix)
            ds = _choose(side, total - n, directrix)
            pairs += [SweepPair(g, d) for g in gs for d in ds]
        yield from sorted(pairs, key=lambda p: (_size(p.generatrix)[0] + _size(p.directrix)[0], p))


@cache
def _choose(side: int, vertices: int, shape: str) -> list[Ring]:
    return [ring for ring in map(list, list_polygons(side, vertices)) if SHAPES[shape](ring)]


def search_grid(
    side: int,
    most: int,
    generatrix: str,
    directrix: str,
    fails: Law,
) -> Evidence:
    """Search a grid with coordinates from 0 to `side` for the smallest counterexample.

    `most` limits the number of vertices of both polygons together; `generatrix` and `directrix` are
    keys of SHAPES; `fails` yields the faults of a pair.

    >>> def four_corners(pair):
    ...     if len(pair.generatrix) == 4:
    ...         yield "a square"
    >>> search_grid(2, 7, "convex", "convex", four_corners).cases[0].generatrix
    [(0, 0), (1, 0), (2, 1), (1, 1)]
    """
    where = f"with up to {most} vertices on the {side + 1} by {side + 1} grid"
    return search(list_tiny_pairs(side, most, generatrix, directrix), fails, where)


def search(pairs: Iterable[SweepPair], fails: Law, where: str) -> Evidence:
    number = 0
    for number, pair in enumerate(pairs, 1):
        if text := find_first_failure(fails(pair)):
            how = f"the first of all pairs {where}, smallest first"
            tried = (
                f"The first {number:,} pairs {where}." if number > 1 else f"The first pair {where}."
            )
            return Evidence(tried, "", (Counterexample(text, how, *pair),), searched=number)
    return Evidence(f"All {number:,} pairs {where}.", searched=number)


def expect_none(convex: Evidence) -> Evidence:
    """Turn a counterexample among convex polygons into a failure."""
    failures = (f"two convex polygons: {case.text}" for case in convex.cases)
    return replace(convex, failure=find_first_failure(failures), cases=())
