"""The user's pairs, in any format, with computed answers."""

import json
import re
from pathlib import Path
from typing import Any

import pytest
from command import refusal, run
from judged import CONVEX, CORRECT, FAULTY, SLOT, SQUARE

from exactsweep.corpus import Case, case_to_json, find_case
from exactsweep.corpus.pairs import read_case, read_pairs
from exactsweep.corpus.selection import require_distinct
from exactsweep.formats import FormatError

SVG = '<svg><rect id="plate" width="6" height="4"/><circle id="disc" r="1"/></svg>'
WKT = "POLYGON ((0 0, 3 0, 0 3, 0 0)) POLYGON ((0 0, 1 0, 0 1, 0 0))"
LINES: list[dict[str, Any]] = [
    {"id": 7, "directrix": SLOT, "generatrix": SQUARE},
    {"directrix": {"vertices": SLOT}, "generatrix": SQUARE, "reference": ["1/2", 1]},
]


def write(tmp_path: Path, text: str) -> str:
    path = tmp_path / "pairs"
    path.write_text(text)
    return str(path)


def test_all_pairs_of_polygons_are_cases(tmp_path: Path) -> None:
    ids = [case.id for case in read_pairs(write(tmp_path, SVG), "1/10")]
    assert ids == ["plate/plate", "plate/disc", "disc/plate", "disc/disc"]
    cases = [*read_pairs(write(tmp_path, WKT))]
    assert [case.id for case in cases] == ["0/0", "0/1", "1/0", "1/1"]
    assert [str(case.directrix) for case in cases[:2]] == ["(0, 0) (3, 0) (0, 3)"] * 2


def test_lines_of_pairs_are_cases(tmp_path: Path) -> None:
    text = "\n" + "\n\n".join(map(json.dumps, LINES))
    first, second = read_pairs(write(tmp_path, text))
    assert (first, second) == (
        Case.of("7", "", SLOT, SQUARE),
        Case.of("pair-4", "", SLOT, SQUARE, ("1/2", 1)),
    )
    doubled = [vertex for vertex in SLOT for _ in range(2)]
    (given,) = read_pairs(write(tmp_path, json.dumps({"directrix": doubled, "generatrix": SQUARE})))
    assert given.directrix_ring == tuple(vertex for vertex in first.directrix_ring for _ in "ab")


def test_own_polygons_may_have_holes(tmp_path: Path) -> None:
    ring, hole = [[0, 0], [9, 0], [9, 9], [0, 9]], [[2, 2], [4, 2], [4, 4], [2, 4]]
    plate = {"exterior": ring, "holes": [hole]}
    expected = Case.of("plate", "", ring, SQUARE, directrix_holes=[hole])
    line = json.dumps({"id": "plate", "directrix": plate, "generatrix": SQUARE})
    assert [*read_pairs(write(tmp_path, line))] == [expected]
    around, *_ = read_pairs(write(tmp_path, json.dumps({"polygons": [plate, SQUARE]})))
    assert around.kind == "SS"
    shapes = [CORRECT[0], "-m", "exactsweep.conform.examples.shapes"]
    path = write(tmp_path, line)
    assert run("conform", "--pairs", path, "--", *shapes).exit_code == 0
    crossing = json.dumps({"directrix": {**plate, "holes": [ring]}, "generatrix": SQUARE})
    with pytest.raises(FormatError, match="hole 0"):
        list(read_pairs(write(tmp_path, crossing)))


def test_holes_may_have_separate_keys(tmp_path: Path) -> None:
    """The corpus and the protocol use these keys."""
    case = find_case("holes-room")
    data = case_to_json(case)
    hole = data["directrix_holes"][0]
    line = {k: data[k] for k in ("directrix", "directrix_holes", "generatrix", "reference")}
    path = write(tmp_path, json.dumps({**line, "class": "SS", "ask": ["no_fit"]}))
    assert [(one.holes, one.directrix_holes) for one in (*read_pairs(path), read_case(path))] == [
        (case.holes, case.directrix_holes)
    ] * 2
    write(tmp_path, json.dumps(data))
    assert [*read_pairs(path), read_case(path)] == [case, case]
    within = {"exterior": data["directrix"], "holes": [hole]}
    write(tmp_path, json.dumps({**line, "directrix": within}))
    with pytest.raises(FormatError, match="directrix already has holes"):
        read_case(path)


@pytest.mark.parametrize("name", ["directrix_hole", "expect", "exact_fits"])
def test_unknown_members_of_a_pair_are_rejected(tmp_path: Path, name: str) -> None:
    path = write(tmp_path, json.dumps({**LINES[0], name: []}))
    for read in (lambda: [*read_pairs(path)], lambda: read_case(path)):
        with pytest.raises(FormatError, match=re.escape(f"$ has an unknown key '{name}'")):
            read()
    data = case_to_json(find_case("fits-square"))
    write(tmp_path, json.dumps({**data, name: []}))
    with pytest.raises(ValueError, match=re.escape(f"$ has an unknown key '{name}'")):
        read_case(path)
    data["expected"][f"{name}s"] = []
    write(tmp_path, json.dumps(data))
    with pytest.raises(ValueError, match=re.escape(f"$.expected has an unknown key '{name}s'")):
        read_case(path)


def test_results_of_other_commands_are_cases(tmp_path: Path) -> None:
    d, g = (write_file(tmp_path / name, ring) for name, ring in (("d", SLOT), ("g", SQUARE)))
    of_slot = Case.of("", "", SLOT, SQUARE, (1, 2), inner_fit=True)
    for command, first, second in (("sweep", g, d), ("nfp", d, g), ("ifp", d, g)):
        path = str(tmp_path / command)
        reference = ("--reference", "1", "2", "--json", "-o", path)
        assert run(command, first, second, *reference).exit_code == 0
        case = read_case(path)
        assert (case.trajectory, case.exact_fits) == (of_slot.trajectory, of_slot.exact_fits)
        inside = of_slot.inner_regions if command == "ifp" else None
        assert case.inner_regions == inside
        assert next(read_pairs(path)).trajectory == case.trajectory
    placed = ("--placed", g, "--json", "-o", path)
    assert run("ifp", d, g, *placed).exit_code == 0
    with pytest.raises(FormatError, match="a case cannot have placed shapes"):
        read_case(path)


def write_file(path: Path, ring: object) -> str:
    path.write_text(json.dumps(ring))
    return str(path)


@pytest.mark.long
def test_the_user_s_pairs_are_judged(tmp_path: Path) -> None:
    path = write(tmp_path, "\n".join(map(json.dumps, LINES)))
    assert run("conform", "--pairs", path, "--", *CORRECT).exit_code == 0
    done = run("conform", "--pairs", path, "--", *FAULTY, "hull")
    assert done.exit_code == 1
    assert "2 of 2 cases judged, 2 failures" in done.stdout
    done = run(
        "conform", "--pairs", "-", "--filter", "id=7", "--", *CORRECT, stdin=Path(path).read_text()
    )
    assert "1 of 1 case judged" in done.stdout


def test_a_sum_is_a_pair_whose_second_summand_is_reflected(tmp_path: Path) -> None:
    line = {"a": SLOT, "b": [[0, 0], [1, 0], [0, 1]], "exterior": [], "holes": [], "area": "1"}
    (case,) = read_pairs(write(tmp_path, json.dumps(line)))
    reflected = [[0, 0], [-1, 0], [0, -1]]
    assert case == Case.of("pair-1", "", SLOT, reflected)
    path = json.dumps({**line, "b": {"path": [["0", "0"], ["4", "1"]], "closed": False}})
    with pytest.raises(FormatError, match=r"\$\.b: a case cannot have a path, only polygons"):
        list(read_pairs(write(tmp_path, path)))


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "empty"),
        ("\n \n", "empty"),
        ("[[0, 0], [1, 0], [2, 0]]", "0: zero area"),
        ('{"directrix": 1}', "line 1: $ has no generatrix"),
        ('\n{"directrix": 1, "generatrix": 2}', "line 2: directrix: $ is '1'"),
        (
            '{"directrix": [], "generatrx": []}',
            "line 1: $ has an unknown key 'generatrx'; did you mean 'gen",
        ),
        (json.dumps({**LINES[0], "reference": 3}), "line 1: $.reference[0] is '3', not a pair"),
        (json.dumps({**LINES[0], "id": []}), "line 1: $.id is a list, not a string or a number"),
        (json.dumps({**LINES[0], "generatrix": [[0, 0], [1, 1]]}), "line 1: generatrix: "),
        (json.dumps(LINES[0]) + "\n[]", "line 2: $ is a list, not an object"),
        ("[" * 100_000, "nested too deeply"),
        (json.dumps(LINES[0]) + "\n" + json.dumps(LINES[0]), "duplicate case id '7'"),
    ],
)
def test_invalid_pairs_are_rejected_by_line(tmp_path: Path, text: str, message: str) -> None:
    with pytest.raises(ValueError, match=re.escape(message)):
        list(require_distinct(read_pairs(write(tmp_path, text))))


@pytest.mark.parametrize("options", [("--cases", "a", "--pairs", "b"), ("--flatten", "1")])
def test_contradictory_options_are_rejected(options: tuple[str, ...]) -> None:
    assert run("conform", *options, "--", *CONVEX).exit_code == 2


def test_a_missing_file_is_rejected() -> None:
    said = refusal(run("conform", "--pairs", "/none", "--", *CONVEX))
    assert said == "/none: No such file or directory"
