"""A figure of the paper as a value; `drawings.toml` names the function that computes each one."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from pkgutil import resolve_name
from typing import Any, NamedTuple, cast

from exactsweep.check import classify
from exactsweep.draw import place_generatrix
from exactsweep.numbers.number import Loop, Point, Vertex
from exactsweep.paper import read_toml
from exactsweep.paper.claim import Observation, Table
from exactsweep.paper.functions import compare_loops
from exactsweep.paper.pairs import Chains
from exactsweep.procedures.chain import split
from exactsweep.sweep import Sweep


class PaperFigure(NamedTuple):
    """A computed figure of the paper.

    `facts` are its statements, as pairs of a name and a value; `laws` are triples of a name, a
    value, and the value by another method. `shapes` are points, chains and lists of chains, `words`
    are labels; "a_name" is a name for panel a only. `sweeps` are paired with drawn positions of G.
    """

    facts: Sequence[tuple[str, object]] = ()
    laws: Sequence[tuple[str, object, object]] = ()
    shapes: Mapping[str, Any] = {}
    words: Mapping[str, Sequence[str]] = {}
    sweeps: Sequence[tuple[Sweep, Sequence[Point]]] = ()

    def list_shapes(self) -> dict[str, Any]:
        shapes: dict[str, Any] = {}
        for s, positions in self.sweeps:
            for name in ("directrix", "trajectory", "inner", "outer"):
                shapes[name] = getattr(s, name).vertices
            shapes["undercuts"] = [undercut.polygon.vertices for undercut in s.undercuts]
            shapes["placed"] = place(s, positions)
        return {**shapes, **self.shapes}

    def find_failures(self) -> Iterator[str]:
        for s, positions in self.sweeps:
            yield from compare_loops(s)
            yield from _compare_positions(s, positions)
        for name, found, expected in self.laws:
            if found != expected:
                yield f"{name}: {found}, not {expected}"


def join_panels(panels: Mapping[str, PaperFigure]) -> PaperFigure:
    """Join panels, with their letters as prefixes of names; the key "" adds no prefix."""
    shapes: dict[str, Any] = {}
    words: dict[str, Sequence[str]] = {}
    for letter, panel in panels.items():
        prefix = f"{letter}_" if letter else ""
        shapes |= {prefix + name: shape for name, shape in panel.list_shapes().items()}
        words |= {prefix + name: texts for name, texts in panel.words.items()}
    facts, laws, sweeps = (
        [one for panel in panels.values() for one in getattr(panel, part)]
        for part in ("facts", "laws", "sweeps")
    )
    return PaperFigure(facts, laws, shapes, words, sweeps)


def find_computation(name: str) -> Callable[[], PaperFigure]:
    function = read_toml("figures/drawings.toml")[name]["compute"]
    return cast(Callable[[], PaperFigure], resolve_name(f"exactsweep.paper.figures.{function}"))


def load(name: str) -> PaperFigure:
    return find_computation(name)()


def check_figure(name: str) -> Iterator[Observation]:
    figure = load(name)
    rows = [[what, str(value)] for what, value in figure.facts]
    yield Table("The statements of the figure", ("what", "value"), rows)
    yield from figure.find_failures()


def _compare_positions(s: Sweep, positions: Iterable[Vertex]) -> Iterator[str]:
    for x, y in positions:
        t = x - s.reference.x, y - s.reference.y
        found = classify(s.directrix, s.generatrix, t).verdict
        if found != "CONTACT":
            yield f"at ({x}, {y}) the verdict on G is {found}, not CONTACT"


def take_half(s: Sweep) -> Chains:
    bottom, top = split(s.generatrix.vertices)
    return Chains(top, bottom, split(s.directrix.vertices)[0])


def place(s: Sweep, positions: Iterable[Point]) -> list[Loop]:
    return [place_generatrix(s, position).vertices for position in positions]


def write_list(values: Iterable[object]) -> str:
    return ", ".join(map(str, values))


def find_middle(p: Vertex, q: Vertex, *, share: Fraction = Fraction(1, 2)) -> Point:
    """Return the point at a share of a segment, by default the midpoint."""
    return Point(p[0] + share * (q[0] - p[0]), p[1] + share * (q[1] - p[1]))


def shift(points: Iterable[Vertex], by: Vertex) -> list[Vertex]:
    return [(x + by[0], y + by[1]) for x, y in points]
