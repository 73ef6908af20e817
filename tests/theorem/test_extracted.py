"""Certificates as input of the checker in Coq: the extracted program, and theorems."""

import copy
import json
import subprocess
from collections import Counter
from collections.abc import Iterable, Iterator
from contextlib import suppress
from fractions import Fraction
from itertools import islice
from pathlib import Path
from random import Random
from typing import Any

import pytest
from certified import CAVE, rect
from certified import SQUARE as UNIT
from command import run
from compare_checkers import compare
from falsify import change
from weakened_coq import list_falsified, weaken

from exactsweep import Polyline, Region, inner_fit_polygon, minkowski_sum, no_fit_polygon, sweep
from exactsweep.check.standalone import Refused
from exactsweep.corpus import cases, layout_cases
from exactsweep.layout import Layout, LayoutError, judge_layout
from exactsweep.theorem import extracted
from exactsweep.theorem.claims import to_claim, write_numbers
from exactsweep.theorem.coq import write_theorem
from exactsweep.theorem.extracted import PROOF, ask, build_checker, missing_tools
from exactsweep.theorem.terms import Number, option, write_coq, write_words

TRAY = [(0, 0), (5, 0), (5, "7/2"), (0, 4)]

KINDS = ["no_fit", "inner_fit", "sweep", "sum", "layout", "faults"]
CLOSED = "Closed under the global context\n"

STRAIGHT = [
    "3.3770839959 3.3770839959",
    "3.3770839959 0.5000000041",
    "0.5000000041 1.5000001437",
    "1.5000001437 0.5000000041",
    "0.5000000041 2.5325586023",
    "0.5000000041 0.5000000041",
]
TILTED = [
    "1.6885588704 1.9596130358",
    "3.1724757975 1.9364750985",
    "2.4365089790 2.6238341263",
    "2.4245256889 1.2722540080",
    "1.5362873291 3.1724757975",
]

needs_tools = pytest.mark.skipif(bool(missing_tools()), reason=f"no {', '.join(missing_tools())}")


def small_certificates() -> dict[str, Any]:
    valid = next(case for case in layout_cases() if case.expected.get("valid"))
    return {
        "no_fit": no_fit_polygon(CAVE, UNIT).certificate(),
        "inner_fit": inner_fit_polygon(TRAY, UNIT).certificate(),
        "sweep": sweep(UNIT, CAVE).certificate(),
        "sum": minkowski_sum(Region(UNIT), Polyline([(0, 0), (3, 1), (1, 4)])).certificate(),
        "layout": judge_layout(valid.layout).certificate(),
        "faults": judge_layout(faulty_layout()).certificate(),
    }


def faulty_layout() -> Layout:
    """Return squares, a disc and slots with errors: all kinds of faults but one."""
    square = {
        "id": "square",
        "exterior": rect(0, 0, 4, 4),
        "error": "1/10",
        "demand": 1,
        "turns": ["0"],
    }
    disc = {"id": "disc", "pieces": [{"points": [["0", "0"]], "radius": "1"}], "mirrored": False}
    slot = {"id": "slot", "pieces": [{"points": [["0", "0"], ["3", "0"]], "radius": "1/2"}]}
    return Layout.from_json(
        {
            "container": {"exterior": [["0", "0"], ["20", "0"], ["20", "20"], ["0", "20"]]},
            "defects": [{"exterior": [["15", "15"], ["16", "15"], ["16", "16"], ["15", "16"]]}],
            "parts": [square, disc, {**slot, "error": "1/8", "demand": 4}],
            "placements": [
                {"part": "square", "move": ["1", "1"]},
                {"part": "square", "move": ["4", "2"], "turn": "90"},
                {"part": "square", "move": ["17", "3"], "turn": "33"},
                {"part": "disc", "move": ["5", "5"], "mirrored": True},
                {"part": "disc", "move": ["14", "15"]},
                {"part": "slot", "move": ["6", "7"], "turn": "30"},
                {"part": "slot", "move": ["19", "12"], "turn": "70"},
            ],
            "spacing": "1/2",
            "margin": "1/4",
        }
    )


def accepted(certificates: Iterable[Any]) -> list[bool]:
    return [ask(certificate) == "accepted" for certificate in certificates]


def corpus_certificates(size: int, step: int) -> Iterator[Any]:
    for case in islice(cases(max_size=size), None, None, step):
        yield no_fit_polygon(case.directrix, case.generatrix).certificate()
        yield inner_fit_polygon(case.directrix, case.generatrix).certificate()
        yield sweep(case.generatrix, case.directrix).certificate()
    for layout in layout_cases():
        if "valid" in layout.expected:
            with suppress(LayoutError):  # nothing is proved about some
                yield json.loads(json.dumps(judge_layout(layout.layout).certificate()))


def test_terms_have_one_word_for_each_number() -> None:
    term = [(Fraction(1, 2), option(None)), (Fraction(-3), option(Number(4)))]
    assert [*write_words(term)] == ["2", "1/2", "0", "-3/1", "1", "4"]
    assert write_coq(term) == "[((1 # 2), None); ((-3), (Some 4%nat))]"
    claim = to_claim(small_certificates()["no_fit"])
    assert write_numbers(claim).split()[:4] == ["no_fit", "1", "12", "0/1"]


@pytest.mark.parametrize("kind", KINDS)
def test_a_theorem_has_the_numbers_of_the_certificate(kind: str) -> None:
    text = write_theorem(small_certificates()[kind], "name")
    assert "name.v" in text
    assert "Theorem proved : Statements." in text
    assert text.count("(") == text.count(")")
    if kind in ("no_fit", "sweep"):
        assert "(4, 5); (0, 5)]" in text
        assert "[((2, 2), (4, 2))]" in text


def test_other_versions_have_no_theorem() -> None:
    certificate = small_certificates()["no_fit"]
    with pytest.raises(ValueError, match="version"):
        to_claim({**certificate, "version": 2})


def test_overlap_and_outside_are_distinguished() -> None:
    certificate = json.loads(json.dumps(small_certificates()["faults"]))
    kinds = {"overlap": "outside", "outside": "overlap"}
    for fault in certificate["faults"]:
        if fault["kind"] in kinds:
            with pytest.raises(ValueError, match="kind"):
                to_claim({**certificate, "faults": [{**fault, "kind": kinds[fault["kind"]]}]})


def test_rotations_match_the_placements_and_the_allowed_ones() -> None:
    square = {"id": "a", "exterior": [["0", "0"], ["1", "0"], ["1", "1"], ["0", "1"]], "error": "2"}
    layout = {
        "parts": [{**square, "turns": ["0", "33"]}],
        "placements": [
            {"part": "a", "move": ["0", "0"], "turn": "33"},
            {"part": "a", "move": ["9", "9"]},
        ],
    }
    certificate = judge_layout(Layout.from_json(layout)).certificate()
    rational = certificate["turns"][0]

    def read(turn: str, stands: Any) -> Any:
        changed = json.loads(json.dumps(certificate))
        changed["layout"]["placements"][1]["turn"] = turn
        changed["turns"][1] = stands
        return to_claim(changed).statement["layout"][1]

    layout = read("33", rational)
    allowed = (Fraction(1), Fraction(0)), (Fraction(33),)
    assert [e.arguments for e in layout["kinds"][0]["rotations"].arguments[0]] == [*allowed]
    for turn, degrees in (("33", option(Fraction(33))), ("34", option(Fraction(34)))):
        assert read(turn, rational)["placements"][1]["degrees"] == degrees
    assert read(rational, rational)["placements"][1]["degrees"] == option(None)
    assert read("33", ["1", "0"])["placements"][1]["slack"] > Fraction(1, 2)
    with pytest.raises(Refused, match="different rotation"):
        read("0", rational)


@needs_tools
@pytest.mark.long
def test_rational_rotations_do_not_count_as_the_exact_ones() -> None:
    square = {"id": "a", "exterior": rect(0, 0, 1, 1), "turns": ["33"]}
    placements = [{"part": "a", "move": ["0", "0"], "turn": "33"}]
    layout = {"parts": [square], "placements": placements}
    certificate = json.loads(json.dumps(judge_layout(Layout.from_json(layout)).certificate()))
    assert ask(certificate) == "accepted"
    placements = [{**placements[0], "turn": certificate["turns"][0]}]
    changed = {**certificate, "layout": {**layout, "placements": placements}}
    assert ask(changed) == "rejected"
    faults = {"valid": False, "proof": None, "faults": [{"kind": "turn", "part": "a"}]}
    assert ask({**changed, **faults}) == "accepted"
    assert ask({**certificate, **faults}) == "rejected"


def test_a_theorem_is_written_on_the_command_line(tmp_path: Path) -> None:
    for name, points in (("d", CAVE), ("g", UNIT)):
        ring = ",".join(f"{x} {y}" for x, y in [*points, points[0]])
        (tmp_path / f"{name}.wkt").write_text(f"POLYGON(({ring}))")
    done = run("nfp", str(tmp_path / "d.wkt"), str(tmp_path / "g.wkt"), "--certificate")
    (tmp_path / "proof.json").write_text(done.stdout)
    done = run("verify", str(tmp_path / "proof.json"), "--coq", str(tmp_path / "claim.v"))
    assert done.exit_code == 0
    assert (tmp_path / "claim.v").read_text() == write_theorem(
        small_certificates()["no_fit"], "claim"
    )


@needs_tools
@pytest.mark.long
def test_both_checkers_agree_on_true_and_changed_certificates() -> None:
    rng, true = Random(4), list(corpus_certificates(12, 80))
    assert {compare(one, 60) for one in true} == {"both prove"}
    found = Counter(compare(change(one, rng)[1], 60) for one in true for _ in range(5))
    assert not [kind for kind in found if kind.startswith("DIFFERENT")]
    assert 0 < found["both prove"] < found["both reject"]


@needs_tools
@pytest.mark.long
def test_false_certificates_are_rejected_by_single_conditions() -> None:
    falsified = json.loads(json.dumps([*list_falsified()]))
    assert {ask(one) for one in falsified} == {"rejected"}


@needs_tools
@pytest.mark.long
def test_dropped_conditions_of_the_extracted_checker_change_answers() -> None:
    """Most others are implied by those that remain, such as the convexity of sums."""
    noticed, dropped = weaken(60, Random(1))
    assert len(dropped) > 300
    assert len(noticed) > 150


@needs_tools
@pytest.mark.long
def test_rounded_containers_contain_parts_near_their_hull() -> None:
    tray = {"points": [["0", "0"], ["9", "0"], ["9", "6"], ["0", "6"]], "radius": "2"}
    square = {"id": "a", "exterior": [["0", "0"], ["4", "0"], ["4", "4"], ["0", "4"]]}
    answers = []
    for x, margin in (("-1", "0"), ("-3/2", "0"), ("-3/2", "1/2"), ("-1", "1/2")):
        layout = {"container": {"pieces": [tray]}, "parts": [square], "margin": margin}
        placements = [{"part": "a", "move": [x, "-1"]}]
        judged = judge_layout(Layout.from_json({**layout, "placements": placements}))
        answers.append((judged.valid, ask(json.loads(json.dumps(judged.certificate())))))
    assert answers == [(valid, "accepted") for valid in (True, True, False, True)]


@needs_tools
@pytest.mark.long
def test_malformed_lines_are_not_accepted() -> None:
    true = small_certificates()["no_fit"]
    assert accepted([true, None, {}, {**true, "holes": 3}, {**true, "exact_fits": [[]]}, true]) == [
        True,
        False,
        False,
        False,
        False,
        True,
    ]
    whole = write_numbers(to_claim(true))
    cut = whole.rsplit(" ", 1)[0]
    lines = f"no_fit\nno_fit 1 1/0\nother 3\nno_fit -1\n{cut}\n{whole} 0\n{whole}\n"
    done = subprocess.run(
        [build_checker()], input=lines, capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == ["unreadable"] * 6 + ["accepted"]


def test_a_checker_that_cannot_be_built_is_reported(tmp_path: Path) -> None:
    with pytest.raises(RuntimeError, match=r"not installed|could not be built"):
        build_checker(tmp_path)


def overlapping(**changes: Any) -> dict[str, Any]:
    """Return a certificate that two squares overlap, with changes of its layout."""
    place = [{"part": "a", "move": [x, "0"]} for x in ("0", "1")]
    square = {"id": "a", "exterior": [["0", "0"], ["2", "0"], ["2", "2"], ["0", "2"]]}
    fault = {"kind": "overlap", "placements": [0, 1], "point": ["3/2", "1"]}
    layout = {"parts": [square], "placements": place, **changes}
    head = {"format": "exactsweep certificate", "version": 3, "claim": "layout", "valid": False}
    turns = [e.get("turn", ["1", "0"]) for e in layout["placements"]]
    return {**head, "layout": layout, "turns": turns, "faults": [fault]}


@needs_tools
@pytest.mark.long
def test_faults_of_layouts_with_negative_numbers_or_scaled_parts_are_rejected() -> None:
    square = overlapping()["layout"]["parts"][0]
    moved = overlapping()["layout"]["placements"]
    scaled = [{**e, "turn": ["2", "0"]} for e in moved]
    disc = {"pieces": [{"points": [["0", "0"]], "radius": "-1"}]}
    wrong: list[dict[str, Any]] = [
        {"spacing": "-1"},
        {"margin": "-1"},
        {"placements": scaled},
        {"parts": [{**square, "error": "-1/2"}]},
        {"parts": [square, {**disc, "id": "b"}]},
        {"defects": [disc]},
        {"defects": [{"exterior": square["exterior"], "spacing": "-1"}]},
        {"container": {"exterior": square["exterior"], "error": "-1"}},
    ]
    true = [{}, {"spacing": "1", "container": {"exterior": square["exterior"], "error": "1"}}]
    asked = [*true, *wrong]
    assert accepted(overlapping(**e) for e in asked) == [True] * len(true) + [False] * len(wrong)


def test_a_container_has_rings_or_pieces() -> None:
    exterior = overlapping()["layout"]["parts"][0]["exterior"]
    both = overlapping(container={"pieces": [], "exterior": exterior})
    with pytest.raises(Refused, match="rounded pieces alone"):
        to_claim(both)
    empty = to_claim(overlapping(container={"pieces": []})).statement["layout"][1]
    assert empty["sheet"] == option(None)


@needs_tools
@pytest.mark.long
def test_a_slow_check_ends_at_the_time_limit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow = tmp_path / "slow"
    slow.write_text("#!/bin/sh\nexec sleep 60\n")
    slow.chmod(0o700)
    certificate = small_certificates()["no_fit"]
    assert ask(certificate) == "accepted"
    assert ask({**certificate, "holes": []}) == "rejected"
    monkeypatch.setattr(extracted, "build_checker", lambda: slow)
    assert ask(certificate, seconds=0.1) == "out of time"
    monkeypatch.setattr(extracted, "build_checker", lambda: Path("/bin/false"))
    with pytest.raises(RuntimeError, match="failed"):
        ask(certificate)


def compile_theorem(folder: Path, name: str, certificate: Any) -> subprocess.CompletedProcess[str]:
    (folder / f"{name}.v").write_text(write_theorem(certificate, name))
    command = ["coqc", "-R", str(PROOF), "Exactsweep", f"{name}.v"]
    return subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)


@needs_tools
@pytest.mark.long
@pytest.mark.parametrize("kind", KINDS)
def test_coq_proves_a_certificate_and_not_a_changed_one(tmp_path: Path, kind: str) -> None:
    build_checker()
    certificate = small_certificates()[kind]
    wrong = copy.deepcopy(certificate)
    if kind in ("layout", "faults"):
        wrong["layout"]["placements"][-1]["move"][0] += "1"
    elif kind == "inner_fit":
        wrong["regions"][0]["exterior"][0][0] = "1/3"
    elif kind == "sum":
        wrong["path"][1][0] = "2"
    else:
        wrong["exact_fits"] = []
    done = compile_theorem(tmp_path, "right", certificate)
    assert (done.stdout, done.returncode) == (CLOSED, 0)
    done = compile_theorem(tmp_path, "wrong", wrong)
    assert (done.stdout, done.returncode != 0) == ("", True)
    failure = '"true = true" while it is expected to have type "accepted = true"'
    assert failure in " ".join(done.stderr.split())


def eleven_squares() -> Layout:
    """Return the best known packing of 11 unit squares, in a square of side 3.877084 (rounded up).

    Five squares are rotated by 40.1819373 degrees, as a rational rotation.
    """
    tangent = Fraction("0.3657693076")
    cosine, sine = (1 - tangent**2) / (1 + tangent**2), 2 * tangent / (1 + tangent**2)
    square = [["-1/2", "-1/2"], ["1/2", "-1/2"], ["1/2", "1/2"], ["-1/2", "1/2"]]
    corners = [["0", "0"], ["3.877084", "0"], ["3.877084", "3.877084"], ["0", "3.877084"]]
    return Layout.from_json(
        {
            "container": {"exterior": corners},
            "parts": [{"id": "square", "exterior": square, "demand": 11}],
            "placements": [
                *({"part": "square", "move": place.split()} for place in STRAIGHT),
                *(
                    {"part": "square", "move": place.split(), "turn": [str(cosine), str(sine)]}
                    for place in TILTED
                ),
            ],
        }
    )


@needs_tools
@pytest.mark.long
def test_eleven_squares_in_a_square_are_a_theorem(tmp_path: Path) -> None:
    build_checker()
    judged = judge_layout(eleven_squares())
    assert judged.valid
    done = compile_theorem(tmp_path, "squares", judged.certificate())
    assert (done.stdout, done.returncode) == (CLOSED, 0)
