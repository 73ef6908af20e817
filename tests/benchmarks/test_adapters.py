"""Other programs are asked correctly, judged, and run as processes."""

import json
import shutil
import subprocess
import sys
from collections.abc import Iterator
from fractions import Fraction
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest
from command import PATIENCE, eventually, processes
from strategies import points

from benchmarks.peers.adapters import NAMES, Adapter, MissingError, klayout_sum, load, npm
from benchmarks.peers.adapters.__main__ import _write
from benchmarks.peers.adapters.adapter import build_frame, prepare_ring
from benchmarks.peers.adapters.names import NPM
from benchmarks.peers.adapters.npm import SCRIPT
from benchmarks.peers.adapters.orbit import sort_out
from benchmarks.peers.adapters.program import ProgramError
from exactsweep import Point
from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.outcome import judge_case
from exactsweep.conform.run.peer import CallablePeer
from exactsweep.conform.run.process import ProcessPeer, Terms
from exactsweep.conform.run.protocol import read_hello
from exactsweep.corpus import Case, find_case, generate

BOX = [(0, 0), (4, 0), (4, 4), (0, 4)]
EXACT = ("pysfcgal", "cgal-reduced")
ROUNDING = ("shapely", "pyclipper", "clipper2", "klayout")
NO_SUMS = ("libnfporb", "libnfporb-rational", "svgnest-orbit", "convex-minkowski-sum")
SUMS = [name for name in NAMES if name not in NO_SUMS]
CLIPPERS = {"pyclipper": ("minkowski_sum",), "clipper2": ("minkowski_sum",)}
COMMAND = [sys.executable, "-m", "benchmarks.peers.adapters"]
PACKAGES = SCRIPT.with_name("package.json")


def installed(name: str) -> Adapter:
    """Load the adapter of a program, or skip the test."""
    try:
        adapter = load(name)
    except MissingError as error:
        pytest.skip(str(error))
    assert read_hello(json.dumps(adapter.hello.to_json())) == adapter.hello
    return adapter


def verdicts(name: str, cases: Iterator[Case]) -> set[Verdict]:
    adapter = installed(name)
    peer = CallablePeer(adapter.answer, adapter.hello)
    try:
        return {judge_case(peer, case).verdict for case in cases}
    finally:
        adapter.close()


@pytest.mark.parametrize("name", EXACT)
def test_an_exact_program_is_exact_except_for_exact_fits(name: str) -> None:
    allowed = {Verdict.EXACT, Verdict.EQUIVALENT, Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS}
    families = "convex", "notched", "rounded-crossings", "fractions"
    drawn = (case for family in families for case in generate(family, 3, 3))
    assert verdicts(name, drawn) <= allowed


@pytest.mark.parametrize("name", NAMES)
def test_every_program_answers_a_square_around_a_square(name: str) -> None:
    square = [(0, 0), (4, 0), (4, 4), (0, 4)]
    case = Case.of("squares", "", square, square[::-1])
    assert verdicts(name, iter([case])) <= {Verdict.EXACT, Verdict.EQUIVALENT}


@pytest.mark.parametrize("name", ROUNDING)
def test_a_crossing_at_thirds_is_rounded(name: str) -> None:
    # The end position of G, between the walls of the notch.
    notch = [(0, 0), (6, 0), (6, 5), (4, 5), (3, 1), (1, 5), (0, 5)]
    case = Case.of("thirds", "", notch, [(0, 0), (1, 0), (1, 1), (0, 1)])
    assert any(c.denominator > 1 for vertex in case.trajectory.vertices for c in vertex)
    assert verdicts(name, iter([case])) == {Verdict.WITHIN}


@pytest.mark.parametrize("name", SUMS)
def test_slits_of_a_sum_are_optional(name: str) -> None:
    allowed = {Verdict.EXACT, Verdict.EQUIVALENT, Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS}
    assert verdicts(name, iter([find_case("fits-square")])) <= allowed


def test_klayout_removes_collinear_vertices() -> None:
    # A sum of raw rings, with the collinear vertices of this case, is wrong.
    assert verdicts("klayout", iter([find_case("sampled-respelled-1")])) == {Verdict.EQUIVALENT}


@pytest.mark.parametrize(("name", "bits"), [("pyclipper", 62), ("clipper2", 61)])
def test_cases_beyond_the_promised_range_are_skipped(name: str, bits: int) -> None:
    for reach, is_asked in ((2**bits - 2, True), (2**bits - 1, False), (2**62, False)):
        case = Case.of("large", "", [(0, 0), (reach, 0), (0, reach)], [(0, 0), (1, 0), (0, 1)])
        assert (verdicts(name, iter([case])) != {Verdict.UNSUPPORTED}) == is_asked


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
    reflected = [["0", "0"], ["-6", "0"], ["0", "-6"]]
    given = {"a": triangle, "b": reflected, "directrix": triangle, "generatrix": triangle}
    case = {"id": "a", **given, "ask": ["minkowski_sum"]}
    thin = [["0", "0"], ["1/3", "0"], ["0", "1"]]
    fraction = {**case, "id": "b", "a": thin, "directrix": thin}
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
    (ring,) = answers[0]["minkowski_sum"]
    found = {(Fraction(x), Fraction(y)) for x, y in ring}
    assert {(-6, 0), (0, -6), (6, -6), (6, 0), (0, 6), (-6, 6)} <= found
    assert ("minkowski_sum" in answers[1]) == (hello.numbers == "rational")


def test_a_program_answers_before_the_next_question() -> None:
    pytest.importorskip("shapely")
    peer = ProcessPeer(Terms([*COMMAND, "shapely"], seconds=PATIENCE))
    judged = [judge_case(peer, Case.of(f"{k}", "", BOX, BOX)).verdict for k in range(2)]
    peer.kill()
    assert {*judged} <= {Verdict.EXACT, Verdict.EQUIVALENT}


def test_programs_are_listed() -> None:
    done = subprocess.run(COMMAND, capture_output=True, text=True, timeout=PATIENCE, check=True)
    assert [line.split()[0] for line in done.stdout.splitlines()] == list(NAMES)


def test_answers_are_written_exactly() -> None:
    assert json.dumps([Fraction(1, 3), 0.1], default=_write) == '["1/3", 0.1]'


def test_missing_programs_are_rejected_by_name(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "shapely", None)
    with pytest.raises(MissingError, match=r"shapely is not installed.*exactsweep\[peers\]"):
        load("shapely")
    monkeypatch.setattr(shutil, "which", lambda _: None)
    monkeypatch.setattr("benchmarks.peers.adapters.cgal_sum.which", lambda _: None)
    with pytest.raises(MissingError, match=r"cgal-full is not installed: compile .*cgal_sums\.cpp"):
        load("cgal-full")
    with pytest.raises(MissingError, match="no adapter 'abacus'; choose from shapely, "):
        load("abacus")


@pytest.mark.parametrize("name", ["shapely", "klayout", "pysfcgal", "cgal-reduced"])
def test_programs_with_holes_answer_a_plate_and_a_bin(name: str) -> None:
    plate = [(0, 0), (9, 0), (9, 9), (0, 9)]
    hole = [(2, 2), (6, 2), (6, 6), (2, 6)]
    part = [(0, 0), (3, 0), (3, 3), (0, 3)]
    around = Case.of("plate", "", plate, part, directrix_holes=[hole])
    inside = Case.of("bin", "", plate, part, inner_fit=True)
    assert len(around.holes) == len(inside.inner_regions or ()) == 1
    adapter = installed(name)
    for question, case in (("minkowski_sum", around), ("inner_fit", inside)):
        limited = adapter.limited(question)
        outcome = judge_case(CallablePeer(limited.answer, limited.hello), case)
        assert outcome.verdict in (Verdict.EXACT, Verdict.EQUIVALENT), (question, outcome)
    adapter.close()


def test_a_program_gets_its_own_questions() -> None:
    adapter = installed("pyclipper")
    with pytest.raises(MissingError, match="does not answer inner_fit, only minkowski_sum"):
        adapter.limited("inner_fit")
    holed = Case.of("holed", "", BOX, BOX, directrix_holes=[[(1, 1), (2, 1), (1, 2)]])
    outcome = judge_case(CallablePeer(adapter.answer, adapter.hello), holed)
    assert outcome.verdict is Verdict.UNSUPPORTED
    assert outcome.reason == "skipped: the program accepts only simple pairs"


def test_false_holes_of_a_sum_of_boundaries_are_filled() -> None:
    """A square in the middle of a large one does not touch its boundary."""
    for name in CLIPPERS:
        for case in (
            Case.of("large", "", [(10 * x, 10 * y) for x, y in BOX], BOX),
            find_case("caves-open"),
        ):
            assert verdicts(name, iter([case])) <= {Verdict.EXACT, Verdict.EQUIVALENT}, case.id


def test_orbits_become_rings_segments_and_points() -> None:
    a, b, c = points((0, 0), (4, 0), (0, 4))
    rings, fits = sort_out([[a, b, c, a], [c, c], [a, b, a], []])
    assert rings == [[a, b, c, a]]
    assert fits == [(c, c), (a, b)]


def test_nesting_programs_need_the_user_s_source(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    for name in ("svgnest-orbit", "svgnest-clipper", "deepnest-clipper"):
        variable = f"EXACTSWEEP_{name.partition('-')[0].upper()}"
        monkeypatch.setenv(variable, str(tmp_path))
        with pytest.raises(
            MissingError, match=f"needs node, and the variable {variable} must name the folder"
        ):
            load(name)
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(MissingError, match="as exactsweep-nfporb-rational"):
        load("libnfporb-rational")


@pytest.mark.long
def test_a_nesting_program_runs_unchanged(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A stand-in for the user's source with the same functions."""
    if shutil.which("node") is None:
        pytest.skip("node is not installed")
    (tmp_path / "util").mkdir()
    (tmp_path / "util" / "clipper.js").write_text("var ClipperLib = {};")
    (tmp_path / "util" / "geometryutil.js").write_text(
        "(function (root) { root.GeometryUtil = {"
        "isRectangle: () => true,"
        "noFitPolygonRectangle: (A, B) => [[{x: 7, y: 0}, {x: 7, y: 0}]],"
        "noFitPolygon: (A, B, inside) => inside ? null : [[...A], [{x: B[0].x, y: B[0].y}]],"
        "}; })(this);"
    )
    (tmp_path / "svgnest.js").write_text(
        "function toClipperCoordinates() { throw 1; }\n"
        "p.map(function(pair) {\n"
        "  function toClipperCoordinates(p) { return p; }\n"
        "  function toNestCoordinates(p) { return p; }\n"
        "  function minkowskiDifference(A, B) {"
        " return [toNestCoordinates(toClipperCoordinates(B))]; }\n"
        "});\n"
    )
    monkeypatch.setenv("EXACTSWEEP_SVGNEST", str(tmp_path))
    d, g = [(0.5, 0.0), (4.0, 0.0), (0.0, 4.0)], [(1.0, 1.0), (3.0, 1.0), (1.0, 3.0)]
    clipper, orbit = load("svgnest-clipper"), load("svgnest-orbit")
    try:
        (ring,) = clipper.answer(d, g).values()
        # It answers for G's first vertex; for the origin, subtract a corner.
        assert ring == [(0, 0), (2, 0), (0, 2)]
        (ring,) = clipper.answer(d, g[::-1]).values()
        assert ring[0] == (0, 0)
        assert clipper.hello.shapes == "simple"
        found = {
            **orbit.answer([d, d], [g], parts=["no_fit"]),
            **orbit.answer([d], [g], parts=["inner_fit"]),
        }
        # For G's origin: its least corner is (1, 1). The hole has no answer.
        assert found["no_fit"] == [[(x - 1, y - 1) for x, y in d]]
        assert found["exact_fits"] == [((0, 0), (0, 0))]
        assert found["inner_exact_fits"] == [((6, -1), (6, -1))]
        for shapes, message in (([d], [g, g]), "holes of G"), (([d, d], [g]), "a container with"):
            with pytest.raises(NotImplementedError, match=message):
                orbit.answer(*shapes, parts=["inner_fit"])
    finally:
        clipper.close()
        orbit.close()


def test_an_npm_package_runs_unchanged(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """A stand-in for a package, whose union returns its greatest argument."""
    monkeypatch.delenv("EXACTSWEEP_NPM", raising=False)
    with pytest.raises(
        MissingError, match="polygon-clipping needs node, and the variable EXACTSWEEP_NPM"
    ):
        load("polygon-clipping")
    if shutil.which("node") is None:
        pytest.skip("node is not installed")
    package = tmp_path / "node_modules" / "polygon-clipping"
    package.mkdir(parents=True)
    (package / "package.json").write_text('{"version": "1.2.3", "main": "main.js"}')
    (package / "main.js").write_text(
        "const reach = ([ring]) => Math.max(...ring.map(([x]) => x));\n"
        "exports.union = (...given) => {\n"
        "  if (given.length > 30) throw new Error('too  many');\n"
        "  return [given.sort((a, b) => reach(b) - reach(a))[0]];\n"
        "};\n"
    )
    monkeypatch.setenv("EXACTSWEEP_NPM", str(tmp_path))
    adapter = load("polygon-clipping")
    try:
        assert (adapter.hello.name, adapter.hello.shapes) == ("polygon-clipping 1.2.3", "simple")
        assert adapter.hello.numbers == "binary64"
        d, g = [(0.0, 0.0), (4.5, 0.0), (0.0, 4.0)], [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]
        (rings,) = adapter.answer(d, g).values()
        assert max(float(x) for ring in rings for x, _ in ring) == 5.5
        many = [(float(k), float(k * k)) for k in range(12)]
        with pytest.raises(ProgramError, match=r"^too many$"):
            adapter.answer(many, g)
    finally:
        adapter.close()


@pytest.mark.parametrize(
    ("name", "title", "numbers"),
    [
        ("libnfporb", "libnfporb, long double", "binary64"),
        ("libnfporb-rational", "libnfporb, rational", "rational"),
        ("cgal-full", "CGAL 6.0, full", "rational"),
    ],
)
def test_a_program_on_the_path_answers(
    name: str, title: str, numbers: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """A stand-in for a compiled program with a single answer."""
    for program in ("exactsweep-nfporb", "exactsweep-nfporb-rational", "exactsweep-cgal"):
        (tmp_path / program).write_text(
            f"#!{sys.executable}\nimport sys\n"
            "print('6.0') if 'version' in sys.argv else None\n"
            "for line in sys.stdin if 'version' not in sys.argv else ():\n"
            "    print('1 4 0 0 2 0 2 2 0 2', flush=True)\n"
        )
        (tmp_path / program).chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path))
    adapter = installed(name)
    assert (adapter.hello.name, adapter.hello.numbers) == (title, numbers)
    shape = [(0, 0), (1, 0), (0, 1)]
    given: Any = [shape] if adapter.hello.shapes == "any" else shape
    (ring,) = adapter.answer(given, given, parts=["no_fit"])["no_fit"]
    found = [Point(Fraction(x), Fraction(y)) for x, y in ring]
    assert found == list(points((0, 0), (2, 0), (2, 2), (0, 2)))
    assert processes(str(tmp_path))
    adapter.close()
    eventually(lambda: not processes(str(tmp_path)))


def test_a_frame_is_wider_than_the_moving_shape() -> None:
    container, moving = [(0, 0), (4, 0), (4, 3)], [(5, 7), (6, 7), (6, 9)]
    frame = [(-2, -3), (6, -3), (6, 6), (-2, 6)]
    assert build_frame(container, moving) == [frame, container[::-1]]


def test_versions_of_npm_packages_are_pinned() -> None:
    pinned = json.loads(PACKAGES.read_text(encoding="utf-8"))["dependencies"]
    assert pinned.keys() == set(NPM)
    assert all(version[0].isdigit() for version in pinned.values())


def test_programs_are_asked_within_their_range() -> None:
    # Differences of 32-bit ints must stay in range; doubles represent each int up to 2**53.
    assert 2 * (klayout_sum.MOST + 1) == 2**31
    assert float(npm.MOST) < float(npm.MOST + 1) == float(npm.MOST + 2)


def test_a_ring_is_prepared_exactly() -> None:
    # Doubled area 2^-1074: lost in products of floats.
    tiny = [(0.0, 0.0), (0.0, 5e-324), (1.0, 0.0)]
    assert prepare_ring(tiny) == tiny[::-1]
    assert prepare_ring(tiny[::-1]) == tiny[::-1]


def test_the_peers_of_the_test_environment_are_installed() -> None:
    """All programs but CGAL come with the extra, so the tests above are not skipped unnoticed."""
    modules = ("shapely", "pyclipper", "clipper2", "klayout", "pysfcgal")
    if not all(map(find_spec, modules)):
        pytest.skip("the extra 'peers' is not installed")
    questions = {name: load(name).hello.questions for name in (*ROUNDING, "pysfcgal")}
    both = ("minkowski_sum", "inner_fit")
    assert questions == {**dict.fromkeys((*ROUNDING, "pysfcgal"), both), **CLIPPERS}
