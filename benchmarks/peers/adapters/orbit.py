"""libnfporb and SVGnest: programs that move G around D, from contact to contact.

Promise: libnfporb, that holes of D, caves, interlocking and perfect fits are found, with
long doubles and a tolerance of 10^-8 or, compiled otherwise, with rationals; SVGnest, doubles and a
tolerance of 10^-9. Neither looks at holes of G.

Questions: libnfporb, `generate_nfp(D, G)`; SVGnest, `noFitPolygon` with all edges
searched, again for each hole of D as it does itself, and for inner fits `noFitPolygonRectangle` in
rectangles and `noFitPolygon` inside in other containers. G starts with a corner, its least vertex,
and both programs answer with the path of that corner. Rings of one or two points, and rings that go
along a line and back, count as exact fits.

libnfporb's header is the user's, and `nfporb.cpp` in this folder calls it, as the programs
exactsweep-nfporb and exactsweep-nfporb-rational. SVGnest's source is in the folder that the
environment variable EXACTSWEEP_SVGNEST names, and is run by node: see `nest.js`.
"""

from __future__ import annotations

from shutil import which
from typing import Any

from benchmarks.peers.adapters.adapter import (
    Adapter,
    AskedShape,
    MissingError,
    Position,
    refer,
)
from benchmarks.peers.adapters.nest import start
from benchmarks.peers.adapters.program import Program, write_fraction, write_shape
from exactsweep.conform.judge.boundary import are_collinear
from exactsweep.conform.run.protocol import Hello, Numbers, Question


def adapter(name: str) -> Adapter:
    """Return the adapter of one of them.

    Raises:
        MissingError: the program is not to be found.
    """
    numbers: Numbers = "binary64"
    questions: tuple[Question, ...] = ("no_fit",)
    if is_svgnest := name == "svgnest-orbit":
        version, program = start("svgnest", "orbit")
        title, questions = f"SVGnest {version}, orbiting", ("no_fit", "inner_fit")
    else:
        title, command = "libnfporb, long double", "exactsweep-nfporb"
        if name.endswith("-rational"):
            numbers, title, command = "rational", "libnfporb, rational", f"{command}-rational"
        found = which(command)
        if found is None:
            raise MissingError(f"{name} is not installed: no program {command}, see nfporb.cpp")
        program = Program([found])

    def ask(part: str, directrix: AskedShape, generatrix: AskedShape) -> dict[str, Any]:
        if len(generatrix) > 1:
            raise NotImplementedError("holes of G")
        if part == "inner_fit" and len(directrix) > 1:
            raise NotImplementedError("a container with holes")
        first = generatrix[0].index(min(generatrix[0]))
        ring = [*generatrix[0][first:], *generatrix[0][:first]]
        write = repr if is_svgnest else write_fraction
        words = [write_shape(directrix, write), write_shape([ring], write)]
        answer = program.ask(" ".join([part, *words] if is_svgnest else words))
        rings, fits = sort_out([refer(one, ring[0]) for one in answer])
        return {part: rings, "exact_fits" if part == "no_fit" else "inner_exact_fits": fits}

    return Adapter(Hello(title, (), numbers, "origin", questions, "any"), ask, program.close)


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
        if are_collinear(distinct):
            fits.append((min(distinct), max(distinct)))
        else:
            rings.append(ring)
    return rings, fits
