"""Tests of laws on random pairs, and reduction of counterexamples."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress

from exactsweep.corpus.generator.shapes import Ring
from exactsweep.paper.claim import Effort, Evidence, find_first_failure
from exactsweep.paper.pairs import SweepPair, draw_pairs, list_corners
from exactsweep.procedures.chain import Chain, inverse, split

MANY = 40
KINDS_OF_PAIRS = {
    "": "",
    "weak": " with vertical edges",
    "large": " of 24 to 64 vertices each",
    "far": " with coordinates of 30 digits",
    "resting": " with an edge of G on teeth",
}
Law = Callable[[SweepPair], Iterable[str]]
"""A function that yields how a pair breaks the law; empty strings are ignored."""


def break_law(law: Law, pairs: Iterable[SweepPair]) -> str:
    """Describe a reduced pair that breaks a law; return an empty string if none does.

    >>> law = lambda pair: ["" if len(pair.directrix) < 4 else "four corners"]
    >>> triangle = [(0, 0), (1, 0), (0, 1)]
    >>> break_law(law, [SweepPair(triangle, [*triangle[:2], (1, 1), (0, 2)])])
    'four corners; G = [(0, 0), (1, 0), (0, 1)], D = [(0, 0), (1, 0), (1, 1), (0, 2)]'
    """
    for pair in pairs:
        if find_wrong(law, pair):
            # For a large pair, removing vertices one by one would take minutes.
            least = shrink(law, pair) if sum(map(len, pair)) < MANY else pair
            return f"{find_wrong(law, least)}; G = {least.generatrix}, D = {least.directrix}"
    return ""


def find_wrong(law: Law, pair: SweepPair) -> str:
    """Test a law on a pair; an exception is a failure."""
    try:
        return find_first_failure(law(pair))
    except Exception as error:
        return f"{type(error).__name__}: {error}"


def shrink(law: Law, pair: SweepPair) -> SweepPair:
    """Remove vertices and halve coordinates while the law still fails."""
    while smaller := next((p for p in _smaller(pair) if find_wrong(law, p)), None):
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
    """Test laws on random pairs up to the first failure.

    All laws of a run get the same pairs, so that their loops by the definition can be cached.

    Args:
        laws: each law with its pairs, as in "100 CC, 60 MM weak, 4 MM large". The first line of its
            docstring states the law.
        effort: the seed and the number of trials.
    """
    tried: dict[str, list[str]] = {}
    sampled, failure = [], ""
    for law, pairs in laws:
        numbers = []
        for number, kind, *how in map(str.split, pairs.split(",")):
            numbers.append(effort.cases(int(number)))
            failure = failure or break_law(law, draw_pairs(effort, kind, numbers[-1], *how))
            text = (law.__doc__ or "").split("\n")[0]
            drawn = f"{numbers[-1]} {kind}{KINDS_OF_PAIRS[''.join(how)]}"
            tried.setdefault(text, []).append(drawn)
        sampled.append(sum(numbers))
    summary = " ".join(f"{text} Pairs: {', '.join(drawn)}." for text, drawn in tried.items())
    return Evidence(summary, failure, sampled=min(sampled, default=0))
