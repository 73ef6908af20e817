import re
import subprocess
import sys
import tomllib
import weakref
from pathlib import Path
from typing import Any

import click
import pytest
from command import EXAMPLE, HOUSE, NOTCH, ROOT, refusal, run, shell

import exactsweep
from exactsweep import sweep
from exactsweep.cli import main
from exactsweep.text.report import report

# Writes until the reader closes the pipe.
UNREAD = "while (echo) 2>&-; do :; done"


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "empty"),
        (b"{", "line 1, column 2: not JSON: Expecting property name enclosed in double quotes"),
        (b"[[0, 0], [1, 0], [0, NaN]]", "$[2][1]: 'NaN' is not a number such as 3, -7/2, "),
        (b"[[0, 0], [1, 0], [0, 1e99999]]", "$[2][1]: '1e99999' has more than 4300 digits"),
        (b"[[0, 0], [2, 0], [1, 0], [0, 1]]", "spike at vertex 1: the boundary reverses"),
        (b"POLYGON ((0 0, 1 0", "line 1, column 19: expected ')', found the end"),
        (b"\xfe\xfe", "not UTF-8 text: invalid start byte at byte 0"),
        (b"[" * 100_000, "nested too deeply"),
        (b"\0" * (2**24 + 1), "more than 16 MiB (max_mib)"),
    ],
    ids=range(9),
)
def test_invalid_input_is_reported_in_one_line(
    tmp_path: Path, content: bytes, message: str
) -> None:
    path = tmp_path / "bad.txt"
    path.write_bytes(content)
    assert refusal(run("sweep", str(path), NOTCH)).startswith(f"{path}: {message}")
    assert refusal(run("sweep", HOUSE, str(path))).startswith(f"{path}: {message}")
    assert refusal(run("sweep", HOUSE, "-", stdin=content)).startswith(f"standard input: {message}")


@pytest.mark.parametrize(
    ("command", "code", "message"),
    [
        ("exactsweep sweep >/dev/full", 1, "Error: standard output: No space left on device\n"),
        ("exactsweep sweep --json -o /dev/full", 1, "Error: /dev/full: No space left on device\n"),
        ("exactsweep sweep >&-", 1, "Error: standard output: closed\n"),
        ("exactsweep explain >/dev/full", 1, "Error: standard output: No space left on device\n"),
        ("exactsweep explain >&-", 1, "Error: standard output: closed\n"),
        (
            "exactsweep reproduce --cite --out /dev/null/x",
            1,
            "Error: /dev/null/x: Not a directory\n",
        ),
        ("exactsweep verify - <&-", 1, "Error: standard input: closed\n"),
        (
            "exactsweep sweep --certificate | exactsweep verify - >/dev/full",
            1,
            "Error: standard output: No space left on device\n",
        ),
        (f"{{ {UNREAD}; exactsweep explain; echo $? >&2; }} | true", 0, "1\n"),
        (f"exactsweep sweep - '{NOTCH}' <&-", 1, "Error: standard input: closed\n"),
        (
            f"exactsweep sweep /dev/zero '{NOTCH}'",
            1,
            "Error: /dev/zero: more than 16 MiB (max_mib)\n",
        ),
        # The reader has closed the pipe, which is not an error of the input.
        (f"{{ {UNREAD}; exactsweep sweep; echo $? >&2; }} | true", 0, "1\n"),
        (
            r"exactsweep sweep $'n\nne\xff' x",
            1,
            "Error: 'n\\nne\\udcff': No such file or directory\n",
        ),
        ("PYTHONIOENCODING=ascii exactsweep sweep >/dev/null", 0, ""),
    ],
)
def test_broken_streams_are_reported_in_one_line(command: str, code: int, message: str) -> None:
    done = shell(command)
    assert (done.returncode, done.stdout, done.stderr) == (code, "", message)


def test_memory_is_released_before_the_error_message(monkeypatch: pytest.MonkeyPatch) -> None:
    class Large:
        """An object of a failed function."""

    held: list[weakref.ref[Large]] = []
    there: list[bool] = []
    show = click.ClickException.show

    def fail(*_: object, **named: object) -> None:
        large = Large()
        held.append(weakref.ref(large))
        raise MemoryError

    def look(error: click.ClickException, file: Any = None) -> None:
        there.append(held[0]() is not None)
        show(error, file)

    monkeypatch.setattr("exactsweep.cli.pair.read_two", fail)
    monkeypatch.setattr(click.ClickException, "show", look)
    assert refusal(run("sweep", HOUSE, NOTCH)) == "out of memory"
    assert there == [False]


@pytest.mark.parametrize(
    ("code", "absent"),
    [
        ("import exactsweep", {"click", "json", "rich"}),
        ("import exactsweep.cli", {"rich"}),
        ("from exactsweep.cli import main; main(['sweep'], standalone_mode=False)", set()),
    ],
)
def test_commands_import_only_their_modules(code: str, absent: set[str]) -> None:
    absent |= {
        "sympy",
        "numpy",
        "matplotlib",
        "shapely",
        "gmpy2",
        "ezdxf",
        "pyarrow",
        "distributed",
    }
    check = f"{code}; import sys; print('found:', *{absent} & set(sys.modules), end='')"
    done = subprocess.run([sys.executable, "-c", check], check=True, capture_output=True, text=True)
    assert done.stdout.endswith("found:")


def test_a_piped_report_is_not_wrapped_and_has_long_numbers_on_request() -> None:
    digits = 3000 * "7"
    result = sweep([(0, 0), (1, 0), (0, 1)], [(0, 0), (digits, 0), (0, 2)])
    lines = report(result).splitlines()
    assert lines[8].split() == ["directrix", "3", "7.77778e+2999", "7.77777777778e+2999~"]
    assert f"({digits},0)" in report(result, everything=True)
    assert not any(line != line.rstrip() for line in lines)
    assert len(lines) == len(report(EXAMPLE).splitlines())
    assert "".join(lines).isascii()
    assert "\x1b" not in "".join(lines)


@pytest.mark.parametrize("width", [30, 50, 80])
def test_reports_fit_the_terminal(width: int) -> None:
    plain = re.sub("\x1b\\[[0-9;]*m", "", report(EXAMPLE, width))
    assert max(map(len, plain.splitlines())) <= width
    # Lines are broken between vertices only.
    vertices = re.findall(r"\(\S+\)", report(EXAMPLE))
    assert re.findall(r"\(\S+\)", plain) == vertices


def test_the_module_is_the_command() -> None:
    done = subprocess.run(
        [sys.executable, "-m", "exactsweep", "verify"], capture_output=True, text=True, check=False
    )
    assert done.returncode == 2
    assert done.stderr.startswith("Usage: exactsweep verify [OPTIONS] FILE [G D]\n")


@pytest.mark.parametrize("before", ["", "sweep --", "reproduce ", "reproduce --seed ", "judge "])
@pytest.mark.parametrize("word", ["x" * 5000, "x " * 2500])
def test_long_words_are_shortened_in_errors(before: str, word: str) -> None:
    *given, last = f"{before}{word}".split(" ", before.count(" "))
    done = run(*given, last)
    assert done.exit_code > 0
    assert len(done.stderr) < 600
    assert "..." in done.stderr


def test_versions_agree() -> None:
    declared = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]
    assert declared == exactsweep.__version__
    assert run("--version").stdout == f"exactsweep, version {declared}\n"


def test_help_describes_every_command_in_full() -> None:
    listed = run("--help").stdout.partition("Commands:")[2]
    assert re.findall(r"^  (\w+)  +\S.*\.$", listed, re.M) == sorted(main.commands)
    assert "..." not in listed
    for group in ("", "corpus"):
        assert run(*group.split()).stderr == run(*group.split(), "--help").stdout
