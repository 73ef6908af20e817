"""A figure of the paper: its drawing, its statements, and the checks of these."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from importlib import import_module
from typing import TYPE_CHECKING, Protocol, cast

from exactsweep.check import classify, reference_loops
from exactsweep.numbers.point import Vertex
from exactsweep.paper.claim import Evidence, Table, find_first_failure
from exactsweep.sweep import Sweep

if TYPE_CHECKING:
    from matplotlib.figure import Figure

Facts = Sequence[tuple[str, str]]


class PaperFigure(Protocol):
    """The interface of the module of a figure."""

    def list_facts(self) -> Facts:
        """List the figure's statements: pairs of a name and a computed value."""

    def find_failures(self) -> Iterator[str]:
        """Texts, empty where a fact is borne out by the definition or by another way."""

    def draw(self) -> Figure:
        """Make the Figure of matplotlib."""


def load(name: str) -> PaperFigure:
    """The module of a figure by its name."""
    return cast(PaperFigure, import_module(f"exactsweep.paper.figures.{name}"))


def check_figure(name: str, against: str) -> Evidence:
    """Compare a figure's statement with another way to derive it, which a sentence describes."""
    figure = load(name)
    rows = [list(fact) for fact in figure.list_facts()]
    table = Table("What the figure states", ("what", "value"), rows)
    return Evidence(against, find_first_failure(figure.find_failures()), tables=(table,))


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
    """Describe the difference of a fact from its expected value; empty if there is none.

    >>> differ("edges", 15, 16)
    'edges: 15, not 16'
    """
    return "" if found == expected else f"{name}: {found}, not {expected}"
