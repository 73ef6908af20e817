"""Programs that compute a + b."""

import json
import re
from typing import Any

import pytest
from command import ROOT
from right_answers import WRITINGS, judge_writing

from exactsweep import Polygon, Region, no_fit_polygon
from exactsweep.conform import conform
from exactsweep.conform.judge.compare import compare
from exactsweep.conform.report.html import SIDE, draw_panels
from exactsweep.conform.run.outcome import judge_answer
from exactsweep.conform.run.peer import read_answer
from exactsweep.conform.run.protocol import (
    Hello,
    ProtocolError,
    UnsupportedError,
    adapt,
    read_hello,
)
from exactsweep.conform.run.protocol import write_case_line as write_line
from exactsweep.corpus import Case, cases, find_case
from exactsweep.geometry.vectors import is_on_segment

HELLO = '{"hello": "mine", "questions": ["minkowski_sum"], "shapes": "any", "numbers": "rational"}'
SQUARE = [(0, 0), (1, 0), (1, 1), (0, 1)]
ROOM = find_case("holes-room")


def add(a: Any, b: Any) -> Any:
    """Compute the sum of two shapes, lists of rings, by the no-fit polygon."""
    found = no_fit_polygon(Region(a[0], a[1:]), Region(b[0], b[1:]).reflected())
    return [found.exterior, *found.holes]


def judge(case: Case, rings: object, **options: Any) -> Any:
    return compare(case, {"minkowski_sum": rings}, **options).parts[0]


def test_a_case_is_asked_as_two_summands() -> None:
    hello = read_hello(HELLO)
    line = json.loads(write_line(ROOM, hello))
    assert [*line] == ["id", "class", "a", "b", "a_holes", "ask"]
    assert line["ask"] == ["minkowski_sum"]
    assert line["a"] == [[str(c) for c in p] for p in ROOM.directrix_ring]
    assert line["b"] == [[str(-c) for c in p] for p in ROOM.generatrix_ring]
    both = Hello("both", (), questions=("no_fit", "minkowski_sum"), shapes="any")
    assert {"directrix", "generatrix", "reference", "a", "b"} <= json.loads(
        write_line(ROOM, both)
    ).keys()
    answer = {
        "id": ROOM.id,
        "minkowski_sum": [
            [[str(c) for c in p] for p in ring.vertices]
            for ring in add([line["a"], *line["a_holes"]], [line["b"]])
        ],
    }
    assert judge_answer(ROOM, ROOM, read_answer(answer), hello).verdict == "exact"


def test_the_page_shows_the_questions() -> None:
    page = (ROOT / "exactsweep/conform/MINKOWSKI.md").read_text(encoding="utf-8")
    hello, lines = re.findall(r"^```json\n(.*?)^```$", page, re.M | re.S)
    line, answer = lines.splitlines()
    given, said = json.loads(line), read_hello(hello.strip())
    reflected = [[f"-{c}".replace("--", "") for c in p] for p in given["b"]]
    case = Case.of(given["id"], "", given["a"], reflected)
    assert line == write_line(case, said)
    assert judge_answer(case, case, read_answer(json.loads(answer)), said).verdict == "exact"
    square = Case.of("square", "", SQUARE, SQUARE)
    wrong = compare(square, {"minkowski_sum": [[(-1, -1), (1, -1), (0, 1)]]}).parts[0].unsound
    assert wrong is not None
    words, _, _ = wrong.says.partition(";")
    assert f"`{words}`" in page


def test_a_sum_does_not_depend_on_the_reference_point() -> None:
    chosen = [*cases(prefix="holes-", max_size=30), *cases(prefix="worked-")]
    chosen += [Case.of("off", "", SQUARE, [(5, 5), (6, 5), (5, "13/2")], ("1/3", 7))]
    run = conform(add, chosen, name="add", questions=["minkowski_sum"], shapes="any")
    assert run.summary.total() == run.summary.judged == len(chosen)
    assert run.passed
    assert {outcome.verdict for outcome in run.outcomes} <= {"exact", "equivalent"}


def test_a_sum_by_doubles_is_within() -> None:
    def nearly(a: Any, b: Any) -> Any:
        return [[(float(x), float(y)) for x, y in ring.vertices] for ring in add(a, b)]

    run = conform(
        nearly,
        cases(prefix="holes-", max_size=30),
        name="nearly",
        questions=["minkowski_sum"],
        shapes="any",
        numbers="binary64",
    )
    assert {o.verdict for o in run.outcomes} <= {"exact", "equivalent", "within", "unsupported"}


def test_mistakes_are_named_in_terms_of_sums() -> None:
    d, g = [(0, 0), (7, 1), (9, 6), (4, 3), (1, 8)], [(2, 1), (5, 2), (3, 4)]
    case = Case.of("odd", "", d, g, ("1/2", 7))
    exact = [loop.vertices for loop in add([d], [[(-x, -y) for x, y in g]])]
    assert judge(case, exact).verdict == "exact"
    wrong = {
        "exact for a + (-b), b reflected": [loop.vertices for loop in add([d], [g])],
        "exact for -(a + b)": [[(-x, -y) for x, y in ring] for ring in exact],
        "translated by (1,-2)": [[(x + 1, y - 2) for x, y in ring] for ring in exact],
        "a itself": [d],
    }
    for words, rings in wrong.items():
        assert judge(case, rings).diagnosis[0] == words
    part = judge(case, [exact[0][:-1]])
    assert part.verdict == "unsound"
    assert " in a plus " in part.unsound.says
    assert part.unsound.says.endswith("it is outside the answered Minkowski sum")
    larger = judge(case, [Polygon(exact[0]).scaled(2).vertices])
    assert "is not the sum of a point of a and a point of b" in larger.conservative.says


def test_the_witness_is_drawn_where_the_sum_is() -> None:
    far = Case.of("far", "", SQUARE, SQUARE, (1000, 1000))
    run = conform(lambda a, b: a, [far], name="mine", questions=["minkowski_sum"])
    (panel, *_) = draw_panels(next(run.show()))
    assert panel.caption == "Minkowski sum"
    assert panel.witness is not None
    assert all(0 < c < SIDE for c in panel.witness)


def test_a_slit_may_be_traced_or_omitted() -> None:
    slot = find_case("fits-square")
    exact, ((foot, tip),) = slot.trajectory.vertices, slot.exact_fits
    k = next(k for k, b in enumerate(exact) if is_on_segment(foot, exact[k - 1], b))
    traced = [*exact[:k], foot, tip, foot, *exact[k:]]
    for ring in (exact, traced):
        found = compare(slot, {"minkowski_sum": ring})
        assert found.verdict in ("exact", "equivalent")
        assert [part.name for part in found.parts] == ["minkowski_sum"]


def test_numbers_without_a_negative_are_skipped() -> None:
    case = Case.of("edge", "", SQUARE, [(-(2**31), 0), (1, 0), (0, 1)])
    asked = Hello("mine", (), "int32", questions=("minkowski_sum",))
    with pytest.raises(UnsupportedError, match="int32 cannot represent the case"):
        adapt(case, asked)
    assert adapt(case, Hello("mine", (), "int64", questions=("minkowski_sum",))) is case


@pytest.mark.parametrize(
    "name", ["clockwise", "keyholed from vertex to vertex", "a fan of triangles"]
)
def test_a_correct_sum_passes_in_any_notation(name: str) -> None:
    judged = judge_writing(WRITINGS[name], [ROOM], parts=("minkowski_sum",))
    assert judged.number == 1
    assert not judged.convicted


def test_only_positions_need_a_reference_in_the_hello() -> None:
    assert read_hello(HELLO).questions == ("minkowski_sum",)
    more = HELLO.replace('["minkowski_sum"]', '["minkowski_sum", "no_fit"]')
    with pytest.raises(ProtocolError, match='the hello has no "reference"'):
        read_hello(more)
