"""Damaged files and invalid option values.

Readable parts survive a round trip; everything else is rejected in one sentence.
"""

import json
import re
from collections.abc import Callable
from pathlib import Path
from random import Random
from typing import Any

import click
import pytest
from command import EXAMPLE, HOUSE, NOTCH, list_commands, run
from drawings import every_drawing
from tiers import mostly_long

from exactsweep import ExactSweepError, Region
from exactsweep.batch.work import Work
from exactsweep.check import verify
from exactsweep.conform import compare
from exactsweep.conform.run.protocol import read_object
from exactsweep.corpus import case_from_json, find_case
from exactsweep.corpus.case_json import case_to_line
from exactsweep.formats import FORMATS, NamedRegion, format_polygons, parse_regions
from exactsweep.formats.exact_json import parse_certificate
from exactsweep.formats.reading import Options

TRIED, LINES_TRIED = 1500, 500
PARTS = [
    NamedRegion(Region([(0, 0), (9, 0), (9, 9), (0, 9)], [[(1, 1), (2, 1), (1, 2)]]), "a & <b>"),
    NamedRegion(Region([(20, 0), ("20.5", "1e-3"), (23, "1.25")]), "c"),
]
PIECES = [
    *("0", "-0", "1e309", "1e4300", "1e99999", "nan", "--1", "1..2", "\x00", "\ufeff", "\u2028"),
    *("(", ")", "[", "]", "{", "}", "<", ">", "&", '"', ",", "#", "1/3", "9" * 5000, "\ud800"),
    *("POLYGON", "EMPTY", "null", "</svg>", "<g>", 'transform="scale(0)"', "rotate(1e9)"),
    *("SECTION", "ENDSEC", "  0\n", "210", "-1", "z", "A1 1 0 0 0 1 1", "vertices", "holes"),
]
OPTIONS: list[Options] = [{}, {"nested": True}, {"join": "1/2"}, {"unit": "mm"}]


def mutate(text: str, rng: Random) -> str:
    for _ in range(rng.choice([1, 1, 2, 3])):
        start = rng.randrange(len(text) + 1)
        end = min(len(text), start + rng.choice([1, 2, 5, 20, 200]))
        piece = rng.choice(
            [rng.choice(PIECES), "", text[start:end] * 9, chr(rng.randrange(1, 300))]
        )
        text = text[:start] + piece + text[rng.choice([start, end]) :]
    return text or "["


@pytest.mark.parametrize("form", mostly_long(FORMATS, ["wkt", "geojson", "json"]))
def test_damaged_inputs_are_read_or_refused(form: str) -> None:
    rng = Random(f"mutations {form}")
    texts = [format_polygons([part], form) for part in PARTS]
    if form == "svg":
        texts += [one.text for one in every_drawing() if one.name.endswith(".svg")]
    read = 0
    for _ in range(TRIED):
        text, options = mutate(rng.choice(texts), rng), rng.choice(OPTIONS)
        try:
            found = parse_regions(text, rng.choice([None, "1/10"]), **options)
        except ExactSweepError as error:
            said = str(error)
        else:
            said = "read"
            read += 1
            again = parse_regions(format_polygons(found, "json")) if found else []
            assert [part.region for part in again] == [part.region for part in found], text
        assert said.isprintable(), text
        assert 0 < len(said) < 1000, text
    assert 0 < read < TRIED


VALUES = ["", "-1", "1e9", "nan", "a" * 5000, "\x00", "½", "9" * 400, "1/0", "1e-9999", "\udcff"]
COMMANDS = {
    "sweep": (HOUSE, NOTCH),
    "convert": (NOTCH, "--to", "json"),
    "compare": ("s.json", "s.json"),
    "corpus generate": ("--count", "1", "--family", "fits"),
}


@pytest.mark.parametrize("name", COMMANDS)
def test_wrong_option_values_give_one_line_of_error(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    run("sweep", HOUSE, NOTCH, "--json", "-o", "s.json")
    tried = 0
    for option in dict(list_commands())[name].params:
        if not isinstance(option, click.Option) or option.is_flag:
            continue
        for value in VALUES:
            given = [*name.split(), option.opts[0], *[value] * option.nargs, *COMMANDS[name]]
            result = run(*given)
            assert isinstance(result.exception, SystemExit | None), (given, result.exception)
            if result.exit_code:
                assert re.search(r"^Error: .*\n\Z", result.stderr, re.M), given
                assert result.stderr.splitlines()[-1].isprintable(), given
            tried += 1


@pytest.mark.parametrize("title", ["a\x00$", "\udcff"])
def test_a_title_may_be_anything(title: str, tmp_path: Path) -> None:
    """Formerly, invalid text caused an error of matplotlib."""
    path = tmp_path / "o.svg"
    result = run("draw", HOUSE, NOTCH, "--title", title, "-o", str(path))
    assert (result.exit_code, result.stderr) == (0, "")
    assert repr(title)[1:-1] in path.read_text()


def test_lone_surrogates_are_not_xml() -> None:
    with pytest.raises(ExactSweepError, match=r"^not XML: lone surrogate"):
        parse_regions('<svg><path id="\ud800" d="M0 0h1v1z"/></svg>')


CASE = find_case("directions-y")
PAIR = '{"id": "a", "generatrix": [[0,0],[1,0],[0,1]], "directrix": [[0,0],["7/2",0],[0,3]]}'
ANSWER = json.dumps(
    {"id": CASE.id, "trajectory": [[str(x), str(y)] for x, y in CASE.trajectory], "exact_fits": []}
)
CERTIFICATE = EXAMPLE.certificate()
WORK = Work("loops", (), ())


def prove(text: str) -> None:
    """Check a certificate, which must be proved only if its claim is true."""
    found: Any = parse_certificate(text)
    verdict = verify(found)
    assert verdict.proved or found != CERTIFICATE
    # Several proofs may exist.
    assert not verdict.proved or {**found, "proof": None} == {**CERTIFICATE, "proof": None}, text
    if not verdict.proved:
        raise ExactSweepError(verdict.reason)


def compute(text: str) -> None:
    record = json.loads(WORK.line(0, text.encode(errors="surrogatepass")))
    assert "internal error" not in record.get("error", ""), text
    if "error" in record:
        raise ExactSweepError(record["error"])


LINES: dict[str, tuple[str, Callable[[str], object]]] = {
    "pairs of a batch": (PAIR, compute),
    "cases": (case_to_line(CASE), lambda text: case_from_json(read_object(text))),
    "answers that are compared": (ANSWER, lambda text: compare(CASE, parse_certificate(text))),
    "certificates": (json.dumps(CERTIFICATE), prove),
}


@pytest.mark.parametrize("what", LINES)
def test_damaged_lines_are_read_or_refused(what: str) -> None:
    rng = Random(f"lines {what}")
    good, read = LINES[what]
    refused = 0
    for _ in range(LINES_TRIED):
        text = mutate(good, rng)
        try:
            read(text)
        except ExactSweepError as error:
            said = str(error)
            refused += 1
        else:
            said = "read"
        assert said.isprintable(), text
        assert len(said) < 500, text
    assert LINES_TRIED / 2 < refused < LINES_TRIED
