"""libnfporb and SVGnest: programs that move G around D, from contact to contact.

Promise: libnfporb, that holes of D, caves, interlocking and perfect fits are found, with
long doubles and a tolerance of 10^-8 or, compiled otherwise, with rationals; SVGnest, doubles and a
tolerance of 10^-9. Neither looks at holes of G.

Questions: libnfporb, `generate_nfp(D, G)`; SVGnest, `noFitPolygon` with all edges
searched, again for each hole of D as it does itself, and for inner fits `noFitPolygonRectangle` in
rectangles and `noFitPolygon` inside in other containers. G starts with a corner, its least vertex,
and both programs answer with the path of that corner. Rings of one or two points, and rings that go
along a line and back, count as exact fits.

libnfporb's header is the user's, and `nfporb.cpp` beside this module calls it, as the programs
exactsweep-nfporb and exactsweep-nfporb-rational. SVGnest's source is in the folder that the
environment variable EXACTSWEEP_SVGNEST names, and is run by node: see `nest.js`.
"""

from __future__ import annotations

from collections.abc import Callable
from shutil import which
from typing import Any

from exactsweep.conform.adapters.adapter import (
    Adapter,
    AnsweredRings,
    AskedRing,
    AskedShape,
    MissingError,
    Position,
    refer,
)
from exactsweep.conform.adapters.nest import start
from exactsweep.conform.adapters.program import Program, write_shape
from exactsweep.conform.run.protocol import Hello, Numbers, Question
from exactsweep.corpus.case import Shapes
from exactsweep.geometry.vectors import turn


def adapter(name: str) -> Adapter:
    """Return the adapter of one of them.

    Raises:
        MissingError: the program is not to be found.
    """
    if name == "svgnest-orbit":
        version, program = start("svgnest", "orbit")
        return _adapter(
            f"SVGnest {version}, orbiting",
            "binary64",
            ("no_fit", "inner_fit"),
            "any",
            lambda part, d, g: program.ask(f"{part} {write_shape(d, repr)} {write_shape(g, repr)}"),
            program.close,
        )
    command = "exactsweep-nfporb" + ("-rational" if name.endswith("-rational") else "")
    found = which(command)
    if found is None:
        raise MissingError(f"{name} is not installed: no program {command}, see nfporb.cpp")
    running = Program([found])
    rational = command.endswith("-rational")
    return _adapter(
        f"libnfporb, {'rational' if rational else 'long double'}",
        "rational" if rational else "binary64",
        ("no_fit",),
        "any",
        lambda _, d, g: running.ask(f"{write_shape(d)} {write_shape(g)}"),
        running.close,
    )


def _adapter(
    name: str,
    numbers: Numbers,
    questions: tuple[Question, ...],
    shapes: Shapes,
    orbit: Callable[[str, AskedShape, AskedShape], AnsweredRings],
    close: Callable[[], object],
) -> Adapter:
    def ask(part: str, directrix: AskedShape, generatrix: AskedShape) -> dict[str, Any]:
        if len(generatrix) > 1:
            raise NotImplementedError("holes of G")
        if part == "inner_fit" and len(directrix) > 1:
            raise NotImplementedError("a container with holes")
        ring = _from_least(generatrix[0])
        found = orbit(part, directrix, [ring])
        rings, fits = sort_out([refer(one, ring[0]) for one in found])
        return {part: rings, "exact_fits" if part == "no_fit" else "inner_exact_fits": fits}

    return Adapter(Hello(name, (), numbers, "origin", questions, shapes), ask, close)


def _from_least(ring: AskedRing) -> AskedRing:
    first = ring.index(min(ring))
    return [*ring[first:], *ring[:first]]


def sort_out(
    found: list[list[Position]],
) -> tuple[list[list[Position]], list[tuple[Position, Position]]]:
    """Tell rings from single positions and from lines along which an orbit went and came back.

    >>> from fractions import Fraction
    >>> a, b, c = (Fraction(0), Fraction(0)), (Fraction(2), Fraction(0)), (Fraction(0), Fraction(1))
    >>> rings, fits = sort_out([[a, b, c, a], [b, b], [a, b, a]])
    >>> len(rings), [fit == (a, b) for fit in fits]
    (1, [False, True])
    """
    rings, fits = [], []
    for ring in found:
        distinct = list(dict.fromkeys(ring))
        if not distinct:
            continue
        low, high = min(distinct), max(distinct)
        if not any(turn(low, high, p) for p in distinct):
            fits.append((low, high))
        else:
            rings.append(ring)
    return rings, fits
