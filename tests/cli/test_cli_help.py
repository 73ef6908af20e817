"""Help, suggestions, the width of reports, and completion."""

import json
import os
import re
import shlex
from pathlib import Path

import click
import pytest
from command import HOUSE, NOTCH, list_commands, refusal, run, shell
from partlist import part_list

from exactsweep.cli import output
from exactsweep.corpus import find_layout_case
from exactsweep.formats import format_polygons


@pytest.mark.parametrize(("name", "command"), list(list_commands()))
def test_help_has_an_example_that_runs(name: str, command: click.Command) -> None:
    shown = run(*name.split(), "--help").stdout
    examples = re.findall(r"^ +exactsweep (.*)$", shown.partition("  Example")[2], re.M)
    assert examples
    assert ("  Examples:\n" in shown) == (len(examples) > 1)
    for example in examples:
        assert f"{example} ".startswith(f"{name} ")
        command.make_context(name, shlex.split(example.removeprefix(name)))
    assert "\\b" not in shown


def test_unknown_polygons_get_a_suggestion(tmp_path: Path) -> None:
    path = tmp_path / "parts.json"
    path.write_text(format_polygons(part_list(8), "json"))
    result = run("sweep", f"{path}#shin-5", NOTCH)
    assert result.stderr.endswith(
        "parts.json: no polygon has the name, index, layer or group 'shin-5'; "
        "did you mean 'shim-5'?\n"
    )


@pytest.mark.parametrize("shell_name", ["bash", "zsh", "fish"])
def test_completion_can_be_installed(shell_name: str) -> None:
    done = shell(f"_EXACTSWEEP_COMPLETE={shell_name}_source exactsweep")
    assert "_EXACTSWEEP_COMPLETE" in done.stdout


@pytest.mark.parametrize(
    ("words", "completed"),
    [("exactsweep ba", "plain,batch"), ("exactsweep sweep --fl", "plain,--flatten"),
     ("exactsweep batch --compute a", "plain,areas"), ("exactsweep sweep ho", "file,ho")],
)  # fmt: skip
def test_words_are_completed(words: str, completed: str) -> None:
    count = len(words.split()) - 1
    done = shell(
        f"COMP_WORDS='{words}' COMP_CWORD={count} _EXACTSWEEP_COMPLETE=bash_complete exactsweep"
    )
    assert completed in done.stdout.splitlines()


@pytest.mark.parametrize(
    "command",
    [
        "sweep",
        "nfp {notch} {house}",
        "nfp {parts} {parts}",
        "ifp {notch} {house}",
        "layout {layout}",
        pytest.param("layout {layout} {layout}", marks=pytest.mark.long),
    ],
)
def test_reports_fit_a_terminal_and_are_plain_in_files(
    command: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On a terminal, words may be broken, but none is missing."""
    layout, parts, file = (tmp_path / name for name in ("layout.json", "parts.json", "report"))
    layout.write_text(json.dumps(find_layout_case("layouts-all-at-once").data))
    parts.write_text(format_polygons(part_list(2), "json"))
    name, *given = command.format(house=HOUSE, notch=NOTCH, layout=layout, parts=parts).split()
    plain = run(name, *given).stdout
    monkeypatch.setattr(
        output, "measure_terminal", lambda to: os.terminal_size((40, 24)) if to == "-" else None
    )
    run(name, *given, "-o", str(file))
    assert file.read_text() == plain
    shown = re.sub(r"\x1b\[[\d;]*m", "", run(name, *given).stdout)
    assert max(map(len, shown.splitlines())) <= 40 < max(map(len, plain.splitlines()))
    assert sorted("".join(shown.split())) == sorted("".join(plain.split()))


def test_the_bar_needs_a_terminal(tmp_path: Path) -> None:
    parts = tmp_path / "parts.json"
    parts.write_text(format_polygons(part_list(4), "json"))
    done = run(
        "batch", "--all", str(parts), str(parts), "--workers", "1", "-o", str(tmp_path / "o")
    )
    assert (done.stdout[:8], done.stderr) == ("16 pairs", "")


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("house.json", "block.wkt"), "'house.json' is a file; a command comes first"),
        (("swep",), "Did you mean 'sweep'?"),
        (("help", "swep"), "No such command or topic 'swep'; did you mean 'sweep'?"),
        (("lesson", "galery"), "no lesson 'galery'; did you mean 'gallery'?"),
        (("sweep", "house.json"), "One file is missing: give both files"),
        (("view", "-o", "sweep.pdf"), "use 'exactsweep draw' for pictures"),
        (("verify", __file__.replace("test_cli_help.py", "options.txt")), "not JSON"),
    ],
)
def test_usage_errors_suggest_a_remedy(arguments: tuple[str, ...], words: str) -> None:
    done = run(*arguments)
    assert done.exit_code in (1, 2)
    assert words in done.stderr


def test_a_file_without_a_claim_is_not_a_certificate(tmp_path: Path) -> None:
    path = tmp_path / "house.json"
    path.write_text("[[0, 0], [1, 0], [0, 1]]")
    message = "not a certificate; commands write one with --certificate"
    assert refusal(run("verify", str(path))) == f"{path}: {message}"


def test_a_path_is_the_second_summand(tmp_path: Path) -> None:
    path = tmp_path / "line.wkt"
    path.write_text("LINESTRING (0 0, 1 0)")
    assert "is a path; give it second, as B." in run("sum", str(path), str(path)).stderr


def test_a_layout_is_not_a_list_of_polygons(tmp_path: Path) -> None:
    path = tmp_path / "nest.json"
    path.write_text(json.dumps(find_layout_case("layouts-slot").data))
    assert refusal(run("overlap", str(path))).endswith("a layout; 'exactsweep layout' judges it")
