"""Answers of Python functions in any form of vertices, and filters and options of the command."""

from collections.abc import Iterator
from fractions import Fraction
from typing import Any

import pytest
from command import run
from judged import CONVEX, SQUARE

from exactsweep import Polygon, Region, inner_fit_polygon, no_fit_polygon
from exactsweep.conform import conform
from exactsweep.conform.run.peer import make_plain
from exactsweep.corpus import Case, cases
from exactsweep.corpus.selection import SelectionError, read_filters, select
from exactsweep.corpus.shipped import list_summaries

NOTCHED = [(0, 0), (9, 0), (9, 5), (7, 2), (4, 5), (0, 5)]
CASE = Case.of("notched", "", NOTCHED, SQUARE)
LOOP = no_fit_polygon(NOTCHED, SQUARE).exterior


def generate() -> Iterator[Iterator[Fraction]]:
    for x, y in LOOP.vertices:
        yield iter((x, y))


def endless() -> Iterator[tuple[int, int]]:
    while True:
        yield 0, 0


def judge(answer: Any) -> Any:
    (outcome,) = conform(lambda d, g, r: answer, [CASE], name="mine").outcomes
    return outcome


@pytest.mark.parametrize("named", [False, True])
@pytest.mark.parametrize("form", ["polygon", "region", "generator", "numpy", "shapely", "coords"])
def test_vertices_come_in_any_form(form: str, named: bool) -> None:
    places = [(float(x), float(y)) for x, y in LOOP.vertices]
    answer: Any = None
    match form:
        case "polygon":
            answer = LOOP
        case "region":
            answer = Region(LOOP)
        case "generator":
            answer = generate()
        case "numpy":
            answer = pytest.importorskip("numpy").array(places)
        case _:
            shape = pytest.importorskip("shapely").Polygon(places)
            answer = shape if form == "shapely" else shape.exterior.coords
    outcome = judge({"trajectory": answer} if named else answer)
    assert outcome.verdict in ("exact", "within"), outcome.reason


def test_rings_of_regions_are_rings() -> None:
    plate = Region([(0, 0), (9, 0), (9, 9)], [[(5, 1), (6, 1), (6, 2)]])
    assert len(make_plain(plate)) == 2
    shapely = pytest.importorskip("shapely")
    one = shapely.Polygon(plate.rings[0], plate.rings[1:])
    several = shapely.MultiPolygon([one, shapely.box(20, 20, 21, 21)])
    assert [len(make_plain(shape)) for shape in (one, several)] == [2, 3]


def test_results_of_the_package_are_answers() -> None:
    """A slot exactly as wide as G has one region of positions and a segment: an exact fit."""
    flask = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 5), (1, 5), (1, 3), (0, 3)]
    assert len(make_plain(inner_fit_polygon(flask, SQUARE))) == 1
    assert make_plain(inner_fit_polygon(SQUARE, SQUARE)) == []
    assert len(make_plain(no_fit_polygon(flask, SQUARE))) == 1


def test_other_values_are_unchanged() -> None:
    for answer in ("POLYGON", {"trajectory": "POLYGON"}):
        assert judge(answer).reason == "$.trajectory is 'POLYGON', not a list of vertices"
    assert judge({"trajectory": {"a": 1}}).verdict == "malformed"
    case = Case.of("a", "", SQUARE, SQUARE)
    run = conform(lambda *_: 3, [case], name="three", loops=["trajectory", "inner"])
    assert run.outcomes[0].reason == "returns int, not a mapping"
    assert judge({"trajectory": Polygon(SQUARE), "rounding": 3}).verdict == "unsound"


def test_an_endless_answer_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("exactsweep.conform.run.peer._MAX_ITEMS", 1000)
    assert judge(endless()).verdict == "malformed"


def test_exiting_the_interpreter_is_a_crash_of_one_case() -> None:
    def leave(d: Any, g: Any, r: Any) -> Any:
        raise SystemExit(3)

    found = conform(leave, cases(max_size=6), name="mine")
    assert {outcome.verdict for outcome in found.outcomes} == {"crash"}
    assert found.outcomes[0].reason == "SystemExit: 3"


# Filters and options.


def test_filters_may_be_repeated() -> None:
    wanted = read_filters(["id=fits-s", "id=worked-s", "class=CC", "class=CM", "size=12"])
    assert wanted == {
        "prefix": ["fits-s", "worked-s"],
        "kind": ["CC", "CM"],
        "max_size": 12,
    }
    chosen = [case.id for case in cases(**wanted)]
    everything = [c for c in list_summaries() if c.id.startswith(("fits-s", "worked-s"))]
    assert chosen == [c.id for c in everything if c.kind in ("CC", "CM") and c.size <= 12]
    few = [*cases(prefix=["fits-", "worked-", "sizes-"])]
    assert chosen == [case.id for case in select(few, **wanted)]
    assert {name.partition("-")[0] for name in chosen} == {"fits", "worked"}
    both = read_filters(["flag=exact-fit", "flag=undercut"])
    assert [c for c in few if {"exact-fit", "undercut"} <= {*c.flags}] == [*select(few, **both)]
    with pytest.raises(SelectionError, match="more than one size="):
        read_filters(["size=1", "size=2"])


def test_an_unknown_id_prefix_is_rejected() -> None:
    done = run("conform", "--filter", "id=worked", "--filter", "id=wroked", "--", *CONVEX)
    assert done.stderr == "Error: no theme or case 'wroked'; did you mean 'worked'?\n"


OURS = ("--filter", "id=worked-s")


def test_options_after_the_program_are_rejected() -> None:
    done = run("conform", *CONVEX, *OURS)
    assert done.exit_code == 2
    assert "--filter after the program would be passed to it." in done.stderr
    for words in ([*CONVEX, "--html=a"], [*CONVEX, "--resume"]):
        assert run("conform", *words).exit_code == 2


@pytest.mark.long
def test_options_of_the_program_follow_a_double_dash() -> None:
    assert run("conform", *OURS, "--", *CONVEX, "--html=a").exit_code == 0
    assert run("conform", *OURS, *CONVEX, "-o", "--other").exit_code == 0
