"""`exactsweep corpus` as a user meets it."""

import json
from fractions import Fraction

import pytest
from command import EXACTSWEEP, refusal, run, shell
from shipped_cases import shipped_cases

from exactsweep.corpus import (
    FAMILIES,
    Case,
    case_from_json,
    cases,
    find_case,
    notes,
    themes,
)
from exactsweep.corpus.shipped import read_schema

CORPUS = f"{EXACTSWEEP} corpus"


def lines(*arguments: str) -> list[str]:
    result = run("corpus", *arguments)
    assert result.exit_code == 0, result.output
    assert result.stderr == ""
    return result.stdout.splitlines()


def read(text: list[str]) -> list[Case]:
    return [case_from_json(json.loads(line)) for line in text]


def test_list_has_a_line_for_each_case() -> None:
    assert [line.split()[0] for line in lines("list")] == [case.id for case in shipped_cases()]
    assert lines("list", "--prefix", "fits-square") == [
        "fits-square             CM   12  A square into a slot as wide",
        "fits-square-from-above  CM   12  A square into a slot as wide, from above",
    ]


def test_list_filters_as_the_function_does() -> None:
    found = lines("list", "--flag", "huge", "--flag", "undercut", "--class", "MM")
    expected = [case.id for case in cases(flags=["huge", "undercut"], kind="MM")]
    assert [line.split()[0] for line in found] == expected
    assert len(lines("list", "--max-size", "7")) == len(list(cases(max_size=7)))
    assert lines("list", "worked-s") == lines("list", "--prefix", "worked-s") != []
    assert len(lines("list", "fits", "sizes")) == sum(
        len(lines("list", n)) for n in ("fits", "sizes")
    )


@pytest.mark.parametrize(
    ("what", "names"), [("themes", themes()), ("flags", notes()), ("families", FAMILIES)]
)
def test_list_of_other_things(what: str, names: dict[str, object]) -> None:
    assert [line.split()[0] for line in lines("list", what)] == list(names)


def test_show_as_json_is_one_line() -> None:
    for id in "fits-square", "gen-turned-9-4":
        assert read(lines("show", id, "--json")) == [find_case(id)]


def test_export_as_json_is_a_case_a_line() -> None:
    assert read(lines("export", "fits", "worked-roof", "gen-grid-1-2")) == [
        *cases(prefix="fits-"),
        find_case("worked-roof"),
        find_case("gen-grid-1-2"),
    ]
    assert read(lines("export", "fits-square")) == [find_case("fits-square")]
    assert read(lines("export", "--class", "CC", "--max-size", "6")) == list(
        cases(kind="CC", max_size=6)
    )


def test_export_as_geojson_is_exact_where_it_says_so() -> None:
    text = run("corpus", "export", "sizes", "spelling", "--to", "geojson").stdout
    by_id = {case.id: case for case in shipped_cases()}
    seen = {True: 0, False: 0, None: 0}
    for feature in json.loads(text)["features"]:
        properties, geometry = feature["properties"], feature["geometry"]
        case = by_id[properties["case"]]
        if properties["figure"] not in ("directrix", "generatrix"):
            continue
        given = set(getattr(case, f"{properties['figure']}_ring"))
        if geometry is None:
            seen[None] += 1
            assert not properties["exact"]
            continue
        (ring,) = geometry["coordinates"]
        assert ring[0] == ring[-1]
        seen[properties["exact"]] += 1
        assert ({(Fraction(x), Fraction(y)) for x, y in ring} == given) == properties["exact"]
    assert min(seen.values()) > 0


def test_generate_takes_families_in_turn() -> None:
    found = read(lines("generate", "--family", "grid", "--family", "fits", "--count", "5"))
    assert [case.id for case in found] == [
        *["gen-grid-0-0", "gen-fits-0-0", "gen-grid-0-1", "gen-fits-0-1", "gen-grid-0-2"]
    ]
    everything = read(lines("generate", "--count", str(len(FAMILIES) + 1)))
    assert [case.id for case in everything] == [
        *(f"gen-{family}-0-0" for family in FAMILIES),
        "gen-convex-0-1",
    ]


def test_schema_is_that_of_the_package() -> None:
    assert run("corpus", "schema").stdout == read_schema()


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["show", "huuge"], "no case, flag or family 'huuge'; did you mean 'huge'?"),
        (["show", "gen-fit-1-1"], "no family 'fit'; did you mean 'fits'?"),
        (["show", "huge", "--json"], "no case 'huge'; did you mean 'fits-huge'?"),
        (["export", "fitz"], "no theme or case 'fitz'; did you mean 'fits'?"),
        (["export", "gen-grid"], "'gen-grid' is not of the form gen-FAMILY-SEED-NUMBER"),
        (["list", "--flag", "hugh"], "no flag 'hugh'; did you mean 'huge'?"),
        (["list", "--class", "cc"], "no class 'cc'; there are CC, CM, MM"),
        (["list", "flag"], "no theme or case 'flag'; did you mean 'flags'?"),
        (["generate", "--family", "grids", "--count", "1"], "no family 'grids'; did you mean"),
        (["export", "worked", "-o", "/nowhere/x"], "/nowhere/x: No such file or directory"),
    ],
)
def test_refusals_are_one_line(arguments: list[str], message: str) -> None:
    assert refusal(run("corpus", *arguments)).startswith(message)


@pytest.mark.parametrize(
    "arguments",
    [
        ["generate"],
        ["generate", "--count", "-1"],
        ["generate", "--count", "1", "--seed", "x"],
        ["export", "--to", "png"],
        ["show"],
        ["list", "--max-size", "many"],
        ["list", "flags", "--class", "CC"],
        ["list", "themes", "--max-size", "0"],
    ],
)
def test_wrong_usage_is_exit_code_2(arguments: list[str]) -> None:
    assert run("corpus", *arguments).exit_code == 2


@pytest.mark.long
def test_a_pipe_that_is_closed_ends_the_command_quietly() -> None:
    for command in "generate --count 100000", "export", "list":
        result = shell(f"{CORPUS} {command} | head -n 1 | cut -c 1-5")
        assert (len(result.stdout), result.stderr) == (6, "")


def test_generation_streams() -> None:
    """The first of a great many cases is there at once."""
    result = shell(f"{CORPUS} generate --count 1000000000 | head -n 2")
    assert len(result.stdout.splitlines()) == 2
