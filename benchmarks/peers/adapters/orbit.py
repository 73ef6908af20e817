"""libnfporb and SVGnest: orbiting programs, which move G around D from contact to contact.

Promise: libnfporb supports holes of D, cavities, interlocking and perfect fits, with long doubles
and a tolerance of 10^-8, or with rationals; SVGnest uses doubles and a tolerance of 10^-9. Both
ignore holes of G.

Questions: `generate_nfp(D, G)` of libnfporb; `noFitPolygon` of SVGnest with all edges searched,
also for each hole of D, and for inner fits `noFitPolygonRectangle` in rectangles and `noFitPolygon`
in other containers. The answer is the path of G's least vertex. Rings of one or two points, and
rings that trace a line in both directions, are exact fits.

`nfporb.cpp` in this folder includes libnfporb's header; compile it as exactsweep-nfporb and
exactsweep-nfporb-rational. The environment variable EXACTSWEEP_SVGNEST names the folder with
SVGnest's source, which `nest.js` loads.
"""

from __future__ import annotations

from shutil import which
from typing import Any

from benchmarks.peers.adapters.adapter import Adapter, AskedShape, MissingError, Position, refer
from benchmarks.peers.adapters.nest import start
from benchmarks.peers.adapters.program import Program, write_fraction, write_shape
from exactsweep.conform.judge.boundary import are_collinear
from exactsweep.conform.run.protocol import Hello, Numbers, Question


def adapter(name: str) -> Adapter:
    """Make the adapter of either program."""
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
            raise MissingError(f"{name} is not installed: compile nfporb.cpp as {command}")
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
    """Separate rings from single positions and from lines traced in both directions.

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
