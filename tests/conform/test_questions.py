"""Shapes and questions: the questions to a program, and the judging of answers of any shape."""

import json
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import pytest
from shipped_cases import shipped_cases

from exactsweep import Region, inner_fit_polygon, no_fit_polygon, sweep
from exactsweep.check import classify
from exactsweep.conform import Verdict, compare, conform, shrink
from exactsweep.conform.run.protocol import Hello, adapt, read_hello, write_case_line
from exactsweep.conform.run.run import Run
from exactsweep.corpus import Case, find_case, generate
from exactsweep.corpus.generator.families import LEVELS

Answer = dict[str, Any]
OLD = {"hello": "old", "loops": ["trajectory"], "numbers": "rational", "reference": "given"}
NEW = {**OLD, "questions": ["no_fit", "inner_fit"], "shapes": "any"}
ALL = {
    "loops": ("trajectory", "inner", "outer"),
    "questions": ("sweep", "no_fit", "inner_fit"),
    "shapes": "any",
}
CHOSEN = [case for family in LEVELS["any shape"][1].split() for case in generate(family, 17, 3)]
CHOSEN += [find_case(id) for id in ("components-unswept", "containers-exact", "plates-sizes")]

RIGHT: dict[str, Answer] = {}
"""Right answers, by the id of the case, found once."""


def right(d: Any, g: Any, reference: Any) -> Answer:
    one, other = Region(d[0], d[1:]), Region(g[0], g[1:])
    n = no_fit_polygon(one, other, reference=reference)
    f = inner_fit_polygon(one, other, reference=reference)
    s = sweep(other, one, reference=reference)
    return {
        "trajectory": s.trajectory.vertices,
        "inner": [loop.vertices for loop in (s.inner, *s.unswept)],
        "outer": s.outer.vertices,
        "no_fit": [loop.vertices for loop in (n.exterior, *n.holes)],
        "exact_fits": n.exact_fits,
        "inner_fit": [ring for region in f.regions for ring in region.rings],
        "inner_exact_fits": f.exact_fits,
    }


def judged(change: Callable[[Answer], Answer], chosen: list[Case] = CHOSEN) -> Run:
    asked = iter(chosen)

    def function(d: Any, g: Any, reference: Any) -> Answer:
        id = next(asked).id
        if id not in RIGHT:
            RIGHT[id] = right(d, g, reference)
        return {**RIGHT[id], **change(RIGHT[id])}

    return conform(function, chosen, name="changed", **ALL)  # type: ignore[arg-type]


def verdicts(run: Run) -> dict[str, Verdict]:
    return {outcome.id: outcome.verdict for outcome in run.outcomes}


def test_correct_answers_of_any_shape_are_exact() -> None:
    assert set(verdicts(judged(lambda answer: {})).values()) == {Verdict.EXACT}


@pytest.mark.parametrize(
    ("part", "change", "is_wrong", "verdict"),
    [
        ("no_fit", lambda rings: rings[:1], lambda case: case.holes, Verdict.CONSERVATIVE),
        (
            "inner_fit",
            lambda rings: [],
            lambda case: case.inner_regions,
            Verdict.CONSERVATIVE,
        ),
        ("inner", lambda rings: rings[:1], lambda case: case.unswept, Verdict.UNSOUND),
        (
            "exact_fits",
            lambda fits: [],
            lambda case: case.exact_fits,
            Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS,
        ),
        (
            "inner_exact_fits",
            lambda fits: [],
            lambda case: case.inner_exact_fits,
            Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS,
        ),
        (
            "exact_fits",
            lambda fits: [fit for fit in fits if fit[0] != fit[1]],
            lambda case: any(p == q for p, q in case.exact_fits),
            Verdict.EQUIVALENT_EXCEPT_FOR_EXACT_FITS,
        ),
    ],
)
def test_missing_parts_are_found(
    part: str,
    change: Callable[[Any], Any],
    is_wrong: Callable[[Case], object],
    verdict: Verdict,
) -> None:
    found = verdicts(judged(lambda answer: {part: change(answer[part])}))
    expected = {case.id: verdict if is_wrong(case) else Verdict.EXACT for case in CHOSEN}
    assert any(map(is_wrong, CHOSEN))
    assert found == expected


def test_positions_outside_a_container_are_unsound() -> None:
    """The positions at which G overlaps D, instead of those inside D."""
    run = judged(lambda answer: {"inner_fit": answer["no_fit"][:1]})
    assert set(verdicts(run).values()) == {Verdict.UNSOUND}
    for outcome in run.show():
        (part,) = (part for part in outcome.parts if part["name"] == "inner_fit")
        assert part["unsound"]["classified"] == "OVERLAP"
        assert "extends beyond D" in part["unsound"]["says"]
        case = next(case for case in CHOSEN if case.id == outcome.id)
        # There, the point is in G, but not in D: outside, or in a hole.
        moved = case.generatrix.translated(part["unsound"]["translation"])
        around = speck(*part["unsound"]["point"])
        assert classify(moved, around, (0, 0)).verdict == "OVERLAP"
        assert classify(case.directrix, around, (0, 0)).verdict != "OVERLAP"


def speck(x: str, y: str) -> Region:
    """A tiny triangle around a point."""
    px, py, e = Fraction(x), Fraction(y), Fraction(1, 10**40)
    return Region([(px - e, py - e), (px + e, py - e), (px, py + e)])


def test_roles_exchanged_are_diagnosed_in_any_shape() -> None:
    def exchanged(d: Any, g: Any, reference: Any) -> Answer:
        n = no_fit_polygon(Region(g[0], g[1:]), Region(d[0], d[1:]), reference=reference)
        return {"no_fit": [loop.vertices for loop in (n.exterior, *n.holes)], "exact_fits": []}

    chosen = [case for case in CHOSEN if case.kind == "SS" and case.holes]
    run = conform(exchanged, chosen, name="x", questions=["no_fit"], shapes="any")
    assert run.summary.diagnosis() == (
        f"all {len(chosen)} differing answers: exact for exchanged roles: D around G"
    )


def test_a_hello_without_questions_gets_sweeps() -> None:
    said = read_hello(json.dumps(OLD))
    assert said == Hello("old")
    assert said.to_json() == {**OLD, "questions": ["sweep"], "shapes": "monotone"}
    plate, notch = find_case("holes-room"), find_case("worked-roof")
    line = json.loads(write_case_line(notch, said))
    assert list(line) == ["id", "class", "directrix", "generatrix", "reference", "ask"]
    assert line["ask"] == ["trajectory"]
    with pytest.raises(ValueError, match=r"^skipped: the program accepts only monotone pairs$"):
        adapt(plate, said)


def test_the_hello_states_shapes_and_questions() -> None:
    said = read_hello(json.dumps(NEW))
    assert said.questions == ("no_fit", "inner_fit")
    assert (said.loops, said.shapes) == ((), "any")
    assert read_hello(json.dumps(said.to_json())) == said
    plate = find_case("holes-room")
    line = json.loads(write_case_line(plate, said))
    assert line["directrix_holes"] == [[["1", "1"], ["4", "1"], ["4", "3"], ["1", "3"]]]
    assert "generatrix_holes" not in line
    assert line["ask"] == ["no_fit", "inner_fit"]
    assert json.loads(write_case_line(find_case("worked-roof"), said))["ask"] == ["no_fit"]


@pytest.mark.parametrize(
    ("shapes", "kinds"),
    [
        ("convex", {"CC"}),
        ("monotone", {"CC", "CM", "MM"}),
        ("simple", {"CC", "CM", "MM", "SS"}),
        ("any", {"CC", "CM", "MM", "SS"}),
    ],
)
def test_programs_are_only_asked_supported_questions(shapes: str, kinds: set[str]) -> None:
    asked = []

    def function(d: Any, g: Any, reference: Any) -> Answer:
        asked.append((d, g))
        raise NotImplementedError("no")

    run = conform(function, [*CHOSEN, find_case("worked-roof")], name="x", shapes=shapes)
    skipped = [outcome for outcome in run.outcomes if outcome.reason == "no"]
    assert {outcome.kind for outcome in skipped} <= kinds
    assert len(asked) == len(skipped)
    if shapes != "any":
        # Rings, not lists of rings.
        assert all(len(ring[0]) == 2 for pair in asked for ring in pair)
        holed = {case.id for case in CHOSEN if "hole" in case.flags}
        assert holed.isdisjoint(outcome.id for outcome in skipped)


def test_inner_fits_are_asked_if_the_case_has_them() -> None:
    roof = find_case("worked-roof")
    with pytest.raises(ValueError, match="skipped: the case has no inner fit"):
        adapt(roof, Hello("x", (), questions=("inner_fit",), shapes="any"))
    # An answer to a question that was not asked is ignored.
    assert (
        compare(roof, {"no_fit": roof.trajectory.vertices, "inner_fit": [[9]]}).verdict == "exact"
    )


def test_cases_of_any_shape_are_adapted() -> None:
    for case in (find_case("caves-two-rooms-thirds"), find_case("containers-defects-thirds")):
        whole = adapt(case, Hello("x", (), "integer", "first", ("no_fit", "inner_fit"), "any"))
        again = Case.of(
            case.id,
            case.title,
            whole.directrix_ring,
            whole.generatrix_ring,
            whole.generatrix_ring[0],
            case.flags,
            directrix_holes=whole.directrix_holes,
            generatrix_holes=whole.generatrix_holes,
        )
        assert case.integer_scale == 3
        assert again == Case(**{**vars_of(whole), "flags": again.flags})


def vars_of(case: Case) -> dict[str, Any]:
    return {name: getattr(case, name) for name in Case.__dataclass_fields__}


@pytest.mark.long
def test_a_case_with_holes_is_shrunk_with_them() -> None:
    case = find_case("plates-sizes")

    def loses_holes(case: Case) -> str:
        return compare(
            case, {"no_fit": case.trajectory.vertices, "exact_fits": case.exact_fits}
        ).verdict

    assert loses_holes(case) == Verdict.CONSERVATIVE
    small = shrink(case, loses_holes, tries=300, seconds=20)
    assert loses_holes(small) == Verdict.CONSERVATIVE
    assert len(small.directrix_holes) == 1
    assert small.size < 12


def test_every_case_of_the_corpus_has_a_shape() -> None:
    for case in shipped_cases():
        holed = bool(case.directrix_holes or case.generatrix_holes)
        assert (case.shapes == "any") == holed == ("hole" in case.flags)
        assert (case.kind == "SS") == (case.shapes in ("simple", "any"))
