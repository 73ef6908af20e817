"""Laws over random pairs, and pairs that break one made smaller."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from exactsweep.corpus.generator.shapes import Ring
from exactsweep.geometry.polygon import Polygon
from exactsweep.paper.claim import Effort
from exactsweep.paper.pairs import SweepPair, draw_pairs
from exactsweep.procedures.chain import split

MANY = 40
KINDS_OF_PAIRS = {
    "": "",
    "weak": " with vertical edges",
    "large": " of 24 to 64 vertices each",
    "far": " with coordinates of 30 digits",
    "resting": " with an edge of G on teeth",
}
Law = Callable[[SweepPair], str]
"""A function that describes how a pair breaks the law; empty if it does not."""


def break_law(law: Law, pairs: Iterable[SweepPair]) -> str:
    """Say with which pair a law breaks, made smaller, and how; empty if it holds for all.

    >>> law = lambda pair: "" if len(pair.directrix) < 4 else "four corners"
    >>> triangle = [(0, 0), (1, 0), (0, 1)]
    >>> break_law(law, [SweepPair(triangle, [*triangle[:2], (1, 1), (0, 2)])])
    'four corners; G = [(0, 0), (1, 0), (0, 1)], D = [(0, 0), (1, 0), (1, 1), (0, 2)]'
    """
    for pair in pairs:
        if find_wrong(law, pair):
            # To leave out vertices of a large one, one by one, would take minutes.
            least = shrink(law, pair) if sum(map(len, pair)) < MANY else pair
            return f"{find_wrong(law, least)}; G = {least.generatrix}, D = {least.directrix}"
    return ""


def find_wrong(law: Law, pair: SweepPair) -> str:
    """Ask a law about a pair; an exception is wrong too."""
    try:
        return law(pair)
    except Exception as error:
        return f"{type(error).__name__}: {error}"


def shrink(law: Law, pair: SweepPair) -> SweepPair:
    """Leave out vertices and halve coordinates as long as the law stays broken."""
    while smaller := next((p for p in _smaller(pair) if find_wrong(law, p)), None):
        pair = smaller
    return pair


def _smaller(pair: SweepPair) -> Iterator[SweepPair]:
    for which, ring in enumerate(pair):
        monotone = is_x_monotone(ring)
        for changed in _smaller_rings(ring):
            try:
                corners = [(int(x), int(y)) for x, y in Polygon(changed).vertices]
            except ValueError:
                continue
            if corners != ring and is_x_monotone(corners) >= monotone:
                yield SweepPair(corners, pair[1]) if which == 0 else SweepPair(pair[0], corners)


def is_x_monotone(ring: Ring) -> bool:
    """Decide whether a canonical ring falls apart into two X-monotone chains.

    >>> is_x_monotone([(0, 0), (2, 1), (3, 3)]), is_x_monotone([(0, 0), (4, 1), (1, 2), (3, 3)])
    (True, False)
    """
    try:
        split(ring)
    except ValueError:
        return False
    return True


def _smaller_rings(ring: Ring) -> Iterator[Ring]:
    for k in range(len(ring)):
        yield ring[:k] + ring[k + 1 :]
    left, low = min(x for x, _ in ring), min(y for _, y in ring)
    moved = [(x - left, y - low) for x, y in ring]
    yield [(x // 2, y) for x, y in moved]
    yield [(x, y // 2) for x, y in moved]


class Trial:
    """Laws tried on random pairs of several classes; keeps count, and the first failure.

    All trials of a run draw the same pairs, whose loops by the definition are kept.
    """

    def __init__(self, effort: Effort) -> None:
        self.effort = effort
        self.failure = ""
        self._tried: dict[str, list[str]] = {}
        self._counts: list[int] = []

    def of(self, law: Law, pairs: str) -> Trial:
        """Try a law on pairs; returns the trial itself.

        Args:
            law: its docstring's first line says what holds.
            pairs: how many of which class, such as "100 CC, 60 MM weak, 4 MM large".
        """
        text = (law.__doc__ or "").split("\n")[0]
        counts = self._tried.setdefault(text, [])
        self._counts.append(0)
        for number, kind, *how in map(str.split, pairs.split(",")):
            count = self.effort.cases(int(number))
            self._counts[-1] += count
            drawn = draw_pairs(self.effort, kind, count, *how)
            if not self.failure:
                self.failure = break_law(law, drawn)
            counts.append(f"{count} {kind}{KINDS_OF_PAIRS[''.join(how)]}")
        return self

    @property
    def sampled(self) -> int:
        """On how many pairs each law was tried, at least."""
        return min(self._counts, default=0)

    @property
    def tried(self) -> str:
        """Describe the trials, for the evidence."""
        return " ".join(
            f"{text} Pairs: {', '.join(counts)}." for text, counts in self._tried.items()
        )
