"""Round trips: under one limit, every reader reads the output for accepted input.

The limit is low, and the input reaches it, so that answers exceed it by far: sums of three numbers,
intersections of lines through twelve, and of lines through those.
"""

import json
import subprocess
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path
from random import Random

import pytest
from command import run
from judged import CORRECT

from exactsweep import Polygon, Region, Sweep, limits, no_fit_polygon, sweep
from exactsweep.check import verify
from exactsweep.corpus import Case
from exactsweep.corpus.case_json import case_from_json, case_to_json, case_to_line
from exactsweep.formats import format_polygons, parse_regions
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.limits import get_limits
from exactsweep.text.results import certificate_to_json, no_fit_to_json, sweep_to_json

DIGITS = 30
BELOW = 10 ** (DIGITS - 2)
Points = list[tuple[Fraction, Fraction]]


def between(rng: Random) -> Fraction:
    """A number of 28 digits above and below, from 0 to 1."""
    below = rng.randrange(BELOW) + 1
    return Fraction(rng.randrange(below), below)


def zigzag(rng: Random, teeth: int) -> Points:
    """A monotone polygon whose numbers share no factors."""
    columns = range(2 * teeth + 1)
    bottom = [(k + between(rng), 3 * (k % 2) + between(rng)) for k in columns]
    return bottom + [(k + between(rng), 9 + between(rng)) for k in reversed(columns)]


def diamond(rng: Random) -> Points:
    """A polygon with edges of slopes 1 and -1, so that all loops have finite decimals."""
    x, y, a, b = (Fraction(rng.randrange(BELOW) + 1, BELOW) for _ in "xyab")
    return [(x, y), (x + a, y - a), (x + a + b, y - a + b), (x + b, y + b)]


def cave(rng: Random) -> Points:
    """A polygon that is not monotone."""
    a, b = between(rng), between(rng)
    xs: list[int | Fraction] = [0, 4, 4, 2 + a, 2, 3, 3, 1 + b, 1, 0]
    ys: list[int | Fraction] = [0, a, 4, 4, 3, 3 - b, 1, 1, 4, 4]
    return [(Fraction(x), Fraction(y)) for x, y in zip(xs, ys, strict=True)]


def pairs() -> Iterator[tuple[str, Points, Points]]:
    rng = Random(30)
    yield "diamonds", diamond(rng), diamond(rng)
    yield "zigzags", zigzag(rng, 1), zigzag(rng, 2)
    yield "cave", diamond(rng), cave(rng)
    huge = Fraction(10**DIGITS - 1)
    yield "huge", [(0 * huge, huge), (1 / huge, huge), (huge, 2 * huge)], cave(rng)


PAIRS = [pytest.param(g, d, id=name) for name, g, d in pairs()]


def longest(s: Sweep) -> int:
    numbers = [c for loop in (s.trajectory, s.inner, s.outer) for v in loop for c in v]
    return max(len(part) for c in numbers for part in format_fraction(c).lstrip("-").split("/"))


def is_decimal(polygons: list[Polygon]) -> bool:
    try:
        return bool(format_polygons(polygons, "wkt"))
    except ValueError:
        return False


def test_the_pairs_are_beyond_the_limit() -> None:
    """Without rule (2), hardly any of their answers could be read."""
    lengths = [longest(sweep(*parameter.values)) for parameter in PAIRS]  # type: ignore[arg-type]
    with limits(max_digits=DIGITS):
        assert DIGITS < max(lengths) <= get_limits().answer_digits
    assert sum(length > 2 * DIGITS for length in lengths) >= 2
    assert max(lengths) > 15 * DIGITS, lengths


@pytest.mark.parametrize(("g", "d"), PAIRS)
@pytest.mark.long
def test_answers_are_read_by_all_commands(
    g: Points, d: Points, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("g.json").write_text(format_polygons([Polygon(g)], "json"))
    Path("d.json").write_text(format_polygons([Polygon(d)], "json"))
    with limits(max_digits=DIGITS):
        s, n = sweep(g, d), no_fit_polygon(d, g)
        written = [
            ("sweep", "g.json", "d.json", "--json", "-o", "s.json"),
            ("sweep", "g.json", "d.json", "--certificate", "-o", "s.cert"),
            ("nfp", "d.json", "g.json", "--json", "-o", "n.json"),
            ("nfp", "d.json", "g.json", "--certificate", "-o", "n.cert"),
            ("ifp", "d.json", "g.json", "--certificate", "-o", "i.cert"),
            ("batch", "--all", "g.json", "d.json", "--workers", "1", "-o", "b.jsonl"),
        ]
        read = [
            *(("verify", name) for name in ("s.cert", "n.cert", "i.cert")),
            *(("convert", name, "--to", "json") for name in ("s.json", "n.json", "b.jsonl")),
            ("sweep", "g.json", "s.json#trajectory"),
            ("sweep", "g.json", "s.json#outer", "-o", "again.json", "--json"),
            ("nfp", "s.json#inner", "g.json"),
            ("ifp", "s.json#outer", "g.json"),
            ("compare", "s.json", "s.json"),
            ("batch", "--all", "g.json", "s.json", "--workers", "1", "-o", "more.jsonl"),
        ]
        judged = [
            ("conform", "--pairs", "n.json", "--", *CORRECT),
            ("conform", "--cases", "case.jsonl", "--", *CORRECT),
            ("judge", "--cases", "case.jsonl"),
        ]
        case = Case.of("long", "numbers at the limit", g, d)
        Path("case.jsonl").write_text(case_to_line(case) + "\n")
        for arguments in written + read:
            result = run(*arguments)
            assert result.exit_code == 0, (arguments, result.stderr[-300:])
        assert verify(json.loads(certificate_to_json(n))).proved
        loops = {"trajectory": s.trajectory, "inner": s.inner, "outer": s.outer}
        found = {part.name: part.region.exterior for part in parse_regions(sweep_to_json(s))}
        assert {name: found[name] for name in loops} == loops
        assert parse_regions(no_fit_to_json(n))
        # Return the output of the program in a pipe.
        answers = subprocess.run(
            CORRECT, input=case_to_line(case), capture_output=True, text=True, check=True
        ).stdout
        for arguments in judged:
            result = run(*arguments, stdin=answers)
            assert not result.stderr, (arguments, result.stderr[-300:])
            # The program accepts only monotone polygons.
            is_asked = s.kind != "SS" or "no case was judged" not in result.output
            assert (result.exit_code == 0) == is_asked, (arguments, result.output[-300:])
        assert case_from_json(json.loads(json.dumps(case_to_json(case)))) == case


FORMS = ("json", "wkt", "geojson", "svg", "dxf", "csv")


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize(("g", "d"), PAIRS)
def test_loops_are_read_from_every_format_that_can_represent_them(
    g: Points, d: Points, form: str
) -> None:
    s = sweep(g, d)
    loops = [s.trajectory, s.inner, s.outer, *s.no_fit_holes]
    loops = [loop for loop in loops if form == "json" or is_decimal([loop])]
    with limits(max_digits=DIGITS):
        for loop in loops:
            (part,) = parse_regions(format_polygons([loop], form))
            assert part.region == Region(loop)
            # and as a Python value
            assert Polygon([map(format_fraction, vertex) for vertex in loop]) == loop
