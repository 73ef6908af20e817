"""`exactsweep corpus`, run in a separate process; transcripts/corpus.txt has its output."""

import json

import pytest
from command import EXACTSWEEP, run, shell
from shipped_cases import shipped_cases

from exactsweep.corpus import FAMILIES, case_from_json, cases, find_case
from exactsweep.corpus.names import require_known
from exactsweep.corpus.shipped import read_schema

CORPUS = f"{EXACTSWEEP} corpus"


def lines(*arguments: str) -> list[str]:
    result = run("corpus", *arguments)
    assert (result.exit_code, result.stderr) == (0, "")
    return result.stdout.splitlines()


def test_all_cases_and_families_are_listed() -> None:
    assert [line.split()[0] for line in lines("list")] == [case.id for case in shipped_cases()]
    drawn = [
        json.loads(line)["id"] for line in lines("generate", "--count", f"{len(FAMILIES) + 1}")
    ]
    assert drawn == [*(f"gen-{family}-0-0" for family in FAMILIES), "gen-convex-0-1"]


def test_json_export_has_one_case_per_line() -> None:
    found = lines("export", "fits", "gen-grid-1-2")
    expected = [*cases(prefix="fits-"), find_case("gen-grid-1-2")]
    assert [case_from_json(json.loads(line)) for line in found] == expected
    assert run("corpus", "schema").stdout == read_schema()


@pytest.mark.long
def test_a_pipe_that_is_closed_ends_the_command_quietly() -> None:
    for command in "generate --count 100000", "export", "list":
        result = shell(f"{CORPUS} {command} | head -n 1 | cut -c 1-5")
        assert (len(result.stdout), result.stderr) == (6, "")


def test_generation_streams() -> None:
    """The first of many cases is printed immediately."""
    result = shell(f"{CORPUS} generate --count 1000000000 | head -n 2")
    assert len(result.stdout.splitlines()) == 2


@pytest.mark.parametrize(("count", "more"), [(8, ""), (9, ", ...")])
def test_eight_known_names_are_listed(count: int, more: str) -> None:
    names = [str(k) for k in range(1, 1 + count)]
    with pytest.raises(ValueError, match=f"; choose from 1, 2, 3, 4, 5, 6, 7, 8{more}$"):
        require_known("unlike them", names, "digit")
