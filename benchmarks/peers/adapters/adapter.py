"""The adapter of a program, and functions for all adapters."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from typing import Any, NamedTuple, cast

from exactsweep.conform.run.protocol import SUM, Hello, Numbers, Question
from exactsweep.corpus.answered import Shapes
from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.numbers.error import ExactSweepError
from exactsweep.numbers.number import Point, to_fraction

Number = Any
Position = tuple[Fraction, Fraction]
AskedRing = list[tuple[Number, Number]]
AskedShape = list[AskedRing]
AnsweredRings = Sequence[Sequence[Sequence[Number]]]


class MissingError(ExactSweepError):
    """A program that is not installed; the message states how to install it."""


def _do_nothing() -> None:
    pass


class Adapter(NamedTuple):
    """A program to judge.

    Attributes:
        hello: its hello.
        ask: computes the answer to a part, such as "no_fit", from D and G: lists of rings, the
            exterior counter-clockwise and holes clockwise.
        close: ends its processes.
    """

    hello: Hello
    ask: Callable[[str, AskedShape, AskedShape], Mapping[str, Any]]
    close: Callable[[], object] = _do_nothing

    def answer(
        self,
        directrix: Sequence[Any],
        generatrix: Sequence[Any],
        reference: object = None,
        parts: Iterable[str] = (),
    ) -> dict[str, Any]:
        """Answer a case for `CallablePeer`; raise NotImplementedError for unsupported input."""
        if self.hello.shapes != "any":
            directrix, generatrix = [directrix], [generatrix]
        d, g = prepare_shape(directrix), prepare_shape(generatrix)
        if self.hello.questions == (SUM,):
            g = reflect(g)
        fits = [question for question in self.hello.questions if question != "sweep"]
        found: dict[str, Any] = {}
        for part in parts or (*self.hello.loops, *fits):
            found |= self.ask(part, d, g)
        return found

    def limited(self, question: str) -> Adapter:
        """Return the adapter for one of its questions."""
        if question not in self.hello.questions:
            listed = ", ".join(self.hello.questions)
            raise MissingError(f"{self.hello.name} does not answer {question}, only {listed}")
        loops = self.hello.loops if question == "sweep" else ()
        chosen = cast(tuple[Question, ...], (question,))
        return self._replace(hello=replace(self.hello, questions=chosen, loops=loops))


def sum_adapter(
    name: str,
    numbers: Numbers,
    add: Callable[[AskedShape, AskedShape], AnsweredRings],
    *,
    shapes: Shapes = "simple",
    close: Callable[[], object] = _do_nothing,
) -> Adapter:
    """Make the adapter of a program that computes Minkowski sums.

    If the program accepts holes, inner fits are the holes of the sum of -G and a frame around the
    container.
    """

    def ask(part: str, directrix: AskedShape, generatrix: AskedShape) -> dict[str, Any]:
        inverse = reflect(generatrix)
        if part != "inner_fit":
            return {part: add(directrix, inverse)}
        if len(directrix) > 1:
            raise NotImplementedError("a container with holes")
        return {part: drop_outermost(add(build_frame(directrix[0], inverse[0]), inverse))}

    questions: tuple[Question, ...] = (SUM, "inner_fit") if shapes == "any" else (SUM,)
    return Adapter(Hello(name, (), numbers, "origin", questions, shapes), ask, close)


def reflect(shape: AskedShape) -> AskedShape:
    return [[(-x, -y) for x, y in ring] for ring in shape]


def build_frame(container: AskedRing, inverse: AskedRing) -> AskedShape:
    """Return a frame around the container, wider than the moving part."""
    xs, ys = zip(*container, strict=True)
    us, vs = zip(*inverse, strict=True)
    x, y = 1 + max(us) - min(us), 1 + max(vs) - min(vs)
    left, right, low, high = min(xs) - x, max(xs) + x, min(ys) - y, max(ys) + y
    return [[(left, low), (right, low), (right, high), (left, high)], container[::-1]]


def drop_outermost(rings: AnsweredRings) -> list[Sequence[Sequence[Number]]]:
    """Return all rings except the leftmost one."""

    def leftmost(k: int) -> Fraction:
        return min(to_fraction(x) for x, _ in rings[k])

    outermost = min(range(len(rings)), key=leftmost, default=None)
    return [ring for k, ring in enumerate(rings) if k != outermost]


def prepare_shape(shape: Sequence[AskedRing]) -> AskedShape:
    """Orient the exterior counter-clockwise and the holes clockwise by `prepare_ring`."""
    exterior, *holes = map(prepare_ring, shape)
    return [exterior, *(hole[::-1] for hole in holes)]


def prepare_ring(ring: AskedRing) -> AskedRing:
    """Orient a ring counter-clockwise, and remove repeated vertices.

    Example:
        >>> prepare_ring([(0, 0), (0, 2), (0, 2), (1, 1), (2, 0), (0, 0)])
        [(0, 0), (2, 0), (1, 1), (0, 2)]
    """
    distinct = [p for k, p in enumerate(ring) if p != ring[k - 1]]
    # Products of floats would be rounded.
    points = [Point(to_fraction(x), to_fraction(y)) for x, y in distinct]
    return distinct if find_doubled_area(points) > 0 else distinct[::-1]


def list_fillings(directrix: AskedRing, inverse: AskedRing) -> list[AskedRing]:
    """List shapes whose union with the sum of two boundaries is the sum of the polygons.

    For any other point p of D + (-G), D contains p + G or p + G contains D. So p is in D translated
    by a vertex of -G, or in -G translated by a vertex of D.
    """
    return [_move(directrix, inverse[0]), _move(inverse, directrix[0])]


def refer(ring: Sequence[Sequence[Number]], corner: tuple[Number, Number]) -> list[Position]:
    """Convert positions of a vertex of G to exact positions of its origin."""
    x, y = map(to_fraction, corner)
    return [(to_fraction(px) - x, to_fraction(py) - y) for px, py in ring]


def _move(ring: AskedRing, by: tuple[Number, Number]) -> AskedRing:
    return [(x + by[0], y + by[1]) for x, y in ring]


def require_range(first: AskedShape, second: AskedShape, most: int) -> None:
    """Raise NotImplementedError if the sum of rings can exceed a limit."""
    reach = sum(max(abs(c) for ring in shape for p in ring for c in p) for shape in (first, second))
    if reach > most:
        raise NotImplementedError(f"coordinates beyond {most}")
