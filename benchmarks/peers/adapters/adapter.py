"""The adapter of a program, and the functions that all adapters share."""

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
    """A program that is not installed here; the message says how to get it."""


def _do_nothing() -> None:
    """Do nothing."""


class Adapter(NamedTuple):
    """A program that can be judged.

    Attributes:
        hello: its name and version, and what it can do.
        ask: of a part, such as "trajectory", "no_fit" or "inner_fit", of D and of G, each a list of
            rings, the exterior counter-clockwise and the holes clockwise: what the answer holds of
            that part. Numbers are of the type that the hello asks for.
        close: ends what runs for the adapter, if anything does.
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
        """Answer a case, as `CallablePeer` asks.

        Args:
            directrix: D, a list of pairs, or of rings where the hello takes any shapes.
            generatrix: G, likewise; or -G if the only question is a Minkowski sum.
            reference: not looked at: the hello says which it is.
            parts: the parts to answer; by default all that the hello promises.

        Returns:
            The answer, without the id.

        Raises:
            NotImplementedError: the program does not take such numbers, or such a shape.
        """
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
        """Return the adapter for one of its questions.

        Raises:
            MissingError: it is none of them.
        """
        if question not in self.hello.questions:
            listed = ", ".join(self.hello.questions)
            raise MissingError(f"{self.hello.name} is not asked for {question}, but for {listed}")
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
    """Return the adapter of a program that computes Minkowski sums.

    A program that accepts holes is asked for inner fits, too, as its users do: the holes of the sum
    of a frame around the container and -G.

    Args:
        name: of the program, with its version.
        numbers: the numbers that it reads.
        add: of D and of -G, each a list of rings: the rings of their sum.
        shapes: the shapes that it accepts.
        close: ends what runs for it.
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
    """Return a shape reflected in the origin."""
    return [[(-x, -y) for x, y in ring] for ring in shape]


def build_frame(container: AskedRing, inverse: AskedRing) -> AskedShape:
    """Return a frame whose hole is the container, wide enough for what moves inside."""
    xs, ys = zip(*container, strict=True)
    us, vs = zip(*inverse, strict=True)
    x, y = 1 + max(us) - min(us), 1 + max(vs) - min(vs)
    left, right, low, high = min(xs) - x, max(xs) + x, min(ys) - y, max(ys) + y
    return [[(left, low), (right, low), (right, high), (left, high)], container[::-1]]


def drop_outermost(rings: AnsweredRings) -> list[Sequence[Sequence[Number]]]:
    """Return the rings except for the one that reaches farthest to the left."""

    def leftmost(k: int) -> Fraction:
        return min(to_fraction(x) for x, _ in rings[k])

    outermost = min(range(len(rings)), key=leftmost, default=None)
    return [ring for k, ring in enumerate(rings) if k != outermost]


def prepare_shape(shape: Sequence[AskedRing]) -> AskedShape:
    """Return the exterior counter-clockwise and the holes clockwise; see `prepare_ring`."""
    exterior, *holes = map(prepare_ring, shape)
    return [exterior, *(hole[::-1] for hole in holes)]


def prepare_ring(ring: AskedRing) -> AskedRing:
    """Return a ring counter-clockwise and without repeated vertices.

    Example:
        >>> prepare_ring([(0, 0), (0, 2), (0, 2), (1, 1), (2, 0), (0, 0)])
        [(0, 0), (2, 0), (1, 1), (0, 2)]
    """
    distinct = [p for k, p in enumerate(ring) if p != ring[k - 1]]
    # Floats are made exact: their products would be rounded.
    points = [Point(to_fraction(x), to_fraction(y)) for x, y in distinct]
    return distinct if find_doubled_area(points) > 0 else distinct[::-1]


def list_fillings(directrix: AskedRing, inverse: AskedRing) -> list[AskedRing]:
    """Return what fills the sum of two boundaries up to that of the polygons.

    A point of the sum of two polygons that is not in the sum of their boundaries has all of the
    one, moved to it, inside the other, or the other way round: so it is in D moved by a vertex of
    -G, or in -G moved by a vertex of D.
    """
    return [_move(directrix, inverse[0]), _move(inverse, directrix[0])]


def refer(ring: Sequence[Sequence[Number]], corner: tuple[Number, Number]) -> list[Position]:
    """Return positions of G's origin, exactly, for those of one of its corners."""
    x, y = map(to_fraction, corner)
    return [(to_fraction(px) - x, to_fraction(py) - y) for px, py in ring]


def _move(ring: AskedRing, by: tuple[Number, Number]) -> AskedRing:
    """Return a ring moved by a vector."""
    return [(x + by[0], y + by[1]) for x, y in ring]


def require_range(first: AskedShape, second: AskedShape, most: int) -> None:
    """Refuse rings of ints whose sum may have coordinates beyond a limit.

    Raises:
        NotImplementedError: it may; an unsupported case.
    """
    reach = sum(max(abs(c) for ring in shape for p in ring for c in p) for shape in (first, second))
    if reach > most:
        raise NotImplementedError(f"coordinates beyond {most}")
