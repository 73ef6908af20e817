"""Other programs: asked rightly, judged, and spoken to as processes."""

import json
import shutil
import subprocess
import sys
from collections.abc import Iterator
from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path

import pytest
from click.testing import CliRunner
from command import PATIENCE
from strategies import points

from exactsweep.conform.adapters import NAMES, Adapter, MissingError, load
from exactsweep.conform.adapters.adapter import prepared
from exactsweep.conform.adapters.table import main
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.journal import Journal
from exactsweep.conform.run.outcome import judge_case
from exactsweep.conform.run.peer import CallablePeer
from exactsweep.conform.run.protocol import Hello
from exactsweep.corpus import Case, find_case, generate

EXACT = ("pysfcgal", "cgal-reduced")
ROUNDING = ("shapely", "pyclipper", "clipper2", "klayout")
COMMAND = [sys.executable, "-m", "exactsweep.conform.adapters"]


def installed(name: str) -> Adapter:
    try:
        return load(name)
    except MissingError as error:
        pytest.skip(str(error))


def verdicts(name: str, cases: Iterator[Case]) -> set[Verdict]:
    adapter = installed(name)
    peer = CallablePeer(adapter.answer, adapter.hello)
    try:
        return {judge_case(peer, case).verdict for case in cases}
    finally:
        adapter.close()


@pytest.mark.parametrize("name", EXACT)
def test_an_exact_program_is_exact_but_for_exact_fits(name: str) -> None:
    allowed = {Verdict.EXACT, Verdict.EQUIVALENT, Verdict.EQUIVALENT_BUT_FOR_EXACT_FITS}
    families = "convex", "notched", "rounded-crossings", "fractions"
    drawn = (case for family in families for case in generate(family, 3, 3))
    assert verdicts(name, drawn) <= allowed


@pytest.mark.parametrize("name", NAMES)
def test_a_square_around_a_square_is_within_everybody(name: str) -> None:
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    case = Case.of("squares", "", square, square[::-1])
    assert verdicts(name, iter([case])) <= {Verdict.EXACT, Verdict.EQUIVALENT}


@pytest.mark.parametrize("name", ROUNDING)
def test_a_crossing_at_thirds_is_rounded(name: str) -> None:
    # Where G stops, between the walls of the notch.
    notch = [(0, 0), (6, 0), (6, 5), (4, 5), (3, 1), (1, 5), (0, 5)]
    case = Case.of("thirds", "", notch, [(0, 0), (1, 0), (1, 1), (0, 1)])
    assert any(c.denominator > 1 for vertex in case.trajectory.vertices for c in vertex)
    assert verdicts(name, iter([case])) == {Verdict.WITHIN}


@pytest.mark.parametrize("name", NAMES)
def test_nobody_answers_exact_fits(name: str) -> None:
    assert verdicts(name, iter([find_case("fits-square")])) == {
        Verdict.EQUIVALENT_BUT_FOR_EXACT_FITS
    }


@pytest.mark.parametrize("name", ["pyclipper", "clipper2"])
def test_what_is_beyond_the_promised_range_is_not_asked(name: str) -> None:
    large = [(0, 0), (2**62, 0), (0, 2**62)]
    case = Case.of("large", "", large, large)
    assert verdicts(name, iter([case])) == {Verdict.UNSUPPORTED}


def test_pyclipper_loses_a_vertex_of_a_convex_integer_pair() -> None:
    """The smallest example of the adapters' README, by hand."""
    case = Case.of("lost", "", [(0, 0), (1, 0), (0, 3)], [(0, 0), (1, 1), (0, 1)])
    assert points((1, 0))[0] in case.trajectory.vertices
    assert verdicts("pyclipper", iter([case])) == {Verdict.UNSOUND}


@pytest.mark.parametrize("name", ["shapely", "pyclipper", "pysfcgal", "cgal-reduced"])
def test_an_adapter_speaks_the_protocol(name: str) -> None:
    adapter = installed(name)
    hello = adapter.hello
    adapter.close()
    triangle = [["0", "0"], ["6", "0"], ["0", "6"]]
    case = {"id": "a", "directrix": triangle, "generatrix": triangle, "reference": ["0", "0"]}
    fraction = {**case, "id": "b", "directrix": [["0", "0"], ["1/3", "0"], ["0", "1"]]}
    lines = [case, fraction, {"bye": True}, case]
    said = subprocess.run(
        [*COMMAND, name],
        input="".join(f"{json.dumps(line)}\n" for line in lines),
        capture_output=True,
        text=True,
        timeout=PATIENCE,
        check=True,
    ).stdout.splitlines()
    assert json.loads(said[0]) == hello.to_json()
    answers = [json.loads(line) for line in said[1:]]
    assert [answer["id"] for answer in answers] == ["a", "b"]
    (ring,) = answers[0]["trajectory"]
    found = {(Fraction(x), Fraction(y)) for x, y in ring}
    assert {(-6, 0), (0, -6), (6, -6), (6, 0), (0, 6), (-6, 6)} <= found
    assert ("trajectory" in answers[1]) == (hello.numbers == "rational")


def test_programs_are_listed() -> None:
    done = subprocess.run(COMMAND, capture_output=True, text=True, timeout=PATIENCE, check=True)
    assert [line.split()[0] for line in done.stdout.splitlines()] == list(NAMES)


def test_what_is_not_installed_is_refused_by_name(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "shapely", None)
    with pytest.raises(MissingError, match=r"shapely is not installed.*exactsweep\[peers\]"):
        load("shapely")
    monkeypatch.setattr(shutil, "which", lambda _: None)
    monkeypatch.setattr("exactsweep.conform.adapters.cgal_sum.which", lambda _: None)
    with pytest.raises(MissingError, match=r"cgal-full is not installed: compile .*cgal_sums\.cpp"):
        load("cgal-full")
    with pytest.raises(MissingError, match="no adapter 'abacus'; there are shapely, "):
        load("abacus")


def test_journals_become_a_table(tmp_path: Path) -> None:
    square = [(0, 0), (8, 0), (8, 8), (0, 8)]
    case = Case.of("squares", "", square, [(0, 0), (1, 0), (1, 1), (0, 1)])
    loop = case.trajectory.vertices
    off = [(float(x) + 3.2 * (x == 8), float(y)) for x, y in loop]
    for numbers, expected in (("binary64", "(0.4)"), ("rational", "(3.2)")):
        path = tmp_path / numbers
        hello = Hello("a program", ("trajectory",), numbers, "origin")  # type: ignore[arg-type]
        answers = iter([{"trajectory": loop}, {"trajectory": off}, {"unsupported": "no"}])
        peer = CallablePeer(lambda *_, found=answers: next(found), hello)
        with Journal(path, command=[], hello=hello, seconds=1) as journal:
            for _ in range(3):
                journal.add(judge_case(peer, case))
        table = CliRunner().invoke(main, [str(path)]).stdout.splitlines()
        assert table[0].startswith("| program | cases | exact or equivalent | but for exact fits |")
        assert table[2] == f"| a program | 2 | 1 |  |  | 1 {expected} |  |  |  |  |  |"


def test_a_ring_is_prepared_exactly() -> None:
    # Doubled area 2^-1074: lost in products of floats.
    tiny = [(0.0, 0.0), (0.0, 5e-324), (1.0, 0.0)]
    assert prepared(tiny) == tiny[::-1]
    assert prepared(tiny[::-1]) == tiny[::-1]


def test_the_peers_of_the_test_environment_are_there() -> None:
    """So that nothing above is skipped unseen: all but CGAL come with the extra."""
    modules = ("shapely", "pyclipper", "clipper2", "klayout", "pysfcgal")
    if not all(map(find_spec, modules)):
        pytest.skip("the extra 'peers' is not installed")
    assert [load(name).hello.loops for name in (*ROUNDING, "pysfcgal")] == [("trajectory",)] * 5
