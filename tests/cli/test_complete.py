"""Shell completion, and its names compared with those that commands accept."""

import os
import subprocess

import pytest
from click.shell_completion import ShellComplete
from command import EXACTSWEEP, PATIENCE, run

from exactsweep.cli import main
from exactsweep.cli.complete import (
    CASES,
    CLASSES,
    FAMILIES,
    FLAGS,
    THEMES,
    Source,
    list_claims,
    list_filters,
    list_names,
    list_verdicts,
)


def offered(*words: str) -> list[str]:
    *before, last = words
    items = ShellComplete(main, {}, "exactsweep", "_X").get_completions(before, last)
    return [item.value for item in items if item.type == "plain"]


@pytest.mark.parametrize(
    ("words", "expected"),
    [
        (("reprod",), ["reproduce"]),
        (("reproduce", "Lemma 5.3"), ["Lemma 5.3"]),
        (("reproduce", "lemma 5.3"), ["Lemma 5.3"]),
        (("corpus", "show", "directions-y"), ["directions-y"]),
        (("corpus", "show", "exact-f"), ["exact-fit"]),
        (("corpus", "list", "--class", "C"), ["CC", "CM"]),
        (("corpus", "list", "the"), ["themes"]),
        (("corpus", "generate", "--family", "near-p"), ["near-parallel"]),
        (("corpus", "export", "--format", "g"), ["geojson"]),
        (("compare", "directions-y"), ["directions-y"]),
        (("conform", "--filter", "class=M"), ["class=MM"]),
        (("conform", "--filter", "flag=exact-f"), ["flag=exact-fit"]),
        (("conform", "--accept", "unso"), ["unsound"]),
        (("corpus", "show", "zzz"), []),
    ],
)
def test_names_are_completed(words: tuple[str, ...], expected: list[str]) -> None:
    assert offered(*words)[: len(expected)] == expected
    assert bool(offered(*words)) == bool(expected)


@pytest.mark.parametrize(
    ("words", "expected"), [(["compare"], ["file"]), (["corpus", "generate", "--family"], [])]
)
def test_files_complete_arguments_that_may_be_files(words: list[str], expected: list[str]) -> None:
    items = ShellComplete(main, {}, "exactsweep", "_X").get_completions(words, "my-case.js")
    assert [item.type for item in items] == expected


@pytest.mark.parametrize(
    ("source", "arguments"),
    [
        (CASES, ("corpus", "show")),
        (FLAGS, ("corpus", "show")),
        (FAMILIES, ("corpus", "show")),
        (THEMES, ("corpus", "list", "--prefix")),
        (CLASSES, ("corpus", "list", "--max-size", "9", "--class")),
        (list_claims, ("reproduce", "--list")),
    ],
)
def test_completions_are_accepted(source: Source, arguments: tuple[str, ...]) -> None:
    names = list(list_names(source))
    assert names
    for name in names[:: max(1, len(names) // 3)]:
        result = run(*arguments, name)
        assert (result.exit_code, result.stderr) == (0, "")


def test_offered_verdicts_and_filters_are_accepted() -> None:
    for verdict in list_verdicts():
        result = run("compare", "directions-y", "-", "--accept", verdict, stdin="{}")
        assert result.exit_code in (0, 1)
        assert "is not one of" not in result.stderr
    for words in list_filters():
        assert words.split("=")[0] in ("id", "size", "class", "flag")


@pytest.mark.parametrize(("shell", "text"), [("bash", "Lemma\\ 5.3"), ("zsh", "Lemma 5.3")])
def test_blanks_are_escaped_for_bash_only(shell: str, text: str) -> None:
    environment = {
        **os.environ,
        "_EXACTSWEEP_COMPLETE": f"{shell}_complete",
        "COMP_WORDS": "exactsweep reproduce Lemma\\ 5.3",
        "COMP_CWORD": "2",
    }
    done = subprocess.run(
        [EXACTSWEEP], env=environment, capture_output=True, text=True, timeout=PATIENCE
    )
    assert text in done.stdout
