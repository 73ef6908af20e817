"""A figure of the paper: how it is drawn, what it states, and how that is checked."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from exactsweep.check import classify, reference_loops
from exactsweep.geometry.point import Vertex
from exactsweep.paper.claim import Claim, Evidence, Run, Status, Table, first_failure
from exactsweep.sweep import Sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Facts = Sequence[tuple[str, str]]


@dataclass(frozen=True)
class PaperFigure:
    """A figure.

    Attributes:
        number: as in the paper.
        section: of the paper.
        says: the caption, in our words.
        code: dotted names of what computes it.
        facts: what the figure states: pairs of a name and a computed value.
        failures: texts, empty where a fact is borne out by the definition or by another way.
        against: how the facts were checked, a sentence.
        draw: makes the Figure of matplotlib.
    """

    number: int
    section: str
    says: str
    code: tuple[str, ...]
    facts: Callable[[], Facts] = field(repr=False)
    failures: Callable[[], Iterator[str]] = field(repr=False)
    against: str
    draw: Callable[[], Figure] = field(repr=False)

    @property
    def name(self) -> str:
        """As in the ledger."""
        return f"Figure {self.number}"

    @property
    def claim(self) -> Claim:
        """The row of the ledger."""
        return Claim(self.name, self.section, self.says, Status.REPRODUCED, self.code, self._check)

    def _check(self, run: Run) -> Evidence:
        rows = [list(fact) for fact in self.facts()]
        table = Table("What the figure states", ("what", "value"), rows)
        return Evidence(self.against, first_failure(self.failures()), tables=(table,))


def loops_differ(s: Sweep) -> Iterator[str]:
    """Say which loops of a sweep are not those of the definition."""
    expected = reference_loops(s.generatrix, s.directrix)
    x, y = s.reference
    loops = {
        "trajectory": (s.trajectory.translated((-x, -y)), expected.trajectory),
        "inner loop": (s.inner, expected.inner),
        "outer loop": (s.outer, expected.outer),
    }
    for name, (found, right) in loops.items():
        yield "" if found.vertices == right else f"the {name} is not that of the definition"


def overlaps(s: Sweep, positions: Iterable[Vertex]) -> Iterator[str]:
    """Say at which drawn positions of the reference point G does not touch D without overlap."""
    for x, y in positions:
        t = x - s.reference.x, y - s.reference.y
        found = classify(s.directrix, s.generatrix, t).verdict
        yield "" if found == "CONTACT" else f"at ({x}, {y}) G is {found}"


def differ(name: str, found: object, expected: object) -> str:
    """Say that a fact is not what it has to be; empty if it is.

    >>> differ("edges", 15, 16)
    'edges: 15, not 16'
    """
    return "" if found == expected else f"{name}: {found}, not {expected}"
