"""The commands explain and verify, and certificates on the command line."""

import contextlib
import fcntl
import json
import os
import pty
import struct
import subprocess
import termios
from pathlib import Path

import pytest
from command import EXACTSWEEP, EXAMPLE, HOUSE, NOTCH, PATIENCE, refusal, run
from linear import require_linear

from exactsweep.check.standalone import prove
from exactsweep.text.explanation import tell


def test_the_example_is_told() -> None:
    told = run("explain").stdout
    assert told == "".join(f"{line}\n" for line in tell(EXAMPLE))
    assert run("explain", HOUSE, NOTCH, "-o-").stdout == told


def test_a_story_goes_to_a_file(tmp_path: Path) -> None:
    path = tmp_path / "told"
    assert run("explain", "-o", str(path)).output == ""
    assert path.read_text() == run("explain").stdout


def test_the_steps_are_written_as_json() -> None:
    # Clockwise, and with a vertex that is no corner: numbers are those of the file all the same.
    notch = "[[0, 0], [0, 5], [1, 5], [2, 5], [3, 1], [7, 5], [8, 5], [8, 0]]"
    document = json.loads(run("explain", HOUSE, "-", "--json", stdin=notch).stdout)
    step = document["steps"][5]
    assert step == {
        "start": ["5", "5"],
        "end": ["13/5", "13/5"],
        "direction": ["-1", "-1"],
        "half": "upper",
        "touches": [
            {"contact": ["VE", 1, 4], "start": ["5", "5"], "end": ["13/5", "13/5"]},
        ],
        "landmarks": [{"mark": "undercut", "number": 0, "position": ["13/5", "13/5"]}],
        "ending": "stop",
        "reasons": [["VE", 0, 3]],
    }
    assert len(document["steps"]) == len(document["generatrix"]) + 4
    assert document["features"]["directrix"] == {
        "vertices": [0, 7, 6, 5, 4, 3, 1],
        "edges": [7, 6, 5, 4, 3, 1, 0],
    }
    assert document["undercuts"][0]["area"] == "8/5"
    assert document["undercuts"][0]["extremes"] == [["23/5", "13/5"], ["13/5", "13/5"]]
    assert document["exact_fits"] == []


def on_a_terminal(command: str) -> str:
    """Return the output on a terminal of 24 lines and 80 columns."""
    end, terminal = pty.openpty()
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    environment = {**os.environ, "PAGER": "sed s/^/page:/", "TERM": "xterm"}
    for name in ("COLUMNS", "LINES"):
        environment.pop(name, None)
    child = subprocess.Popen(
        [EXACTSWEEP, *command.split()],
        env=environment,
        stdin=terminal,
        stdout=terminal,
        stderr=terminal,
        close_fds=True,
    )
    os.close(terminal)
    shown = b""
    # Linux ends a terminal without other users by an error.
    with contextlib.suppress(OSError):
        while piece := os.read(end, 4096):
            shown += piece
    os.close(end)
    assert child.wait(timeout=PATIENCE) == 0
    return shown.decode()


def test_a_long_story_pages_on_a_terminal_and_a_short_one_does_not() -> None:
    assert on_a_terminal("explain").startswith("page:Class CM")
    assert "page:" not in on_a_terminal("sweep")


def test_a_certificate_is_proved(tmp_path: Path) -> None:
    path = str(tmp_path / "proof.json")
    assert run("sweep", HOUSE, NOTCH, "--certificate", "-o", path).output == ""
    assert json.loads(Path(path).read_text()) == EXAMPLE.certificate()
    for result in (run("verify", path), run("verify", "-", stdin=Path(path).read_bytes())):
        said = "proved\nCM of 5 and 7 vertices\n"
        assert (result.exit_code, result.stdout, result.stderr) == (0, said, "")
    assert run("verify", path, HOUSE, NOTCH).exit_code == 0
    other = run("verify", path, NOTCH, HOUSE)
    assert (other.exit_code, other.stdout) == (1, "generatrix: not the polygon that is given\n")
    assert run("verify", path, HOUSE).exit_code == 2
    proved = str(tmp_path / "proved.json")
    assert run("verify", path, "--add-proof", proved).exit_code == 0
    assert run("verify", proved).exit_code == 0
    assert prove(json.loads(Path(proved).read_text()))
    assert run("sweep", HOUSE, NOTCH, "--proof", "-o", path).output == ""
    assert json.loads(Path(path).read_text()) == json.loads(Path(proved).read_text())
    verdict = run("verify", "--json", path)
    assert json.loads(verdict.stdout) == {"proved": True, "reason": "proved", "witness": None}


def test_a_false_certificate_is_answered_by_reason_and_witness() -> None:
    proof = EXAMPLE.certificate()
    # Into the notch, as deep as the point of the house would fit.
    proof["inner"][5], proof["inner"][4] = ["11/4", "2"], ["4", "2"]
    result = run("verify", "-", stdin=json.dumps(proof))
    assert (result.exit_code, result.stderr) == (1, "")
    verdict = json.loads(run("verify", "--json", "-", stdin=json.dumps(proof)).stdout)
    assert verdict["proved"] is False
    reason, *witness = result.stdout.splitlines()
    assert reason == verdict["reason"]
    assert witness == [f"witness: ({','.join(verdict['witness'])})"] * bool(verdict["witness"])


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        ("{}", "the key 'format' is missing"),
        ("[]", "a certificate is an object, not a list"),
        ("null", "a certificate is an object, not a NoneType"),
        ('{"format": "exactsweep certificate", "version": 2}', "the key 'generatrix' is missing"),
    ],
)
def test_what_is_no_certificate_is_not_proved(content: str, reason: str) -> None:
    result = run("verify", "-", stdin=content)
    assert (result.exit_code, result.stdout, result.stderr) == (1, f"{reason}\n", "")


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "line 1, column 1: not JSON: Expecting value"),
        (b"proved", "line 1, column 1: not JSON: Expecting value"),
        (b"{}{}", "line 1, column 3: not JSON: Extra data"),
        (b'{"kind": "CC", "kind": "CM"}', "the name 'kind' is twice in one object"),
        (b"[" * 100_000, "nested too deeply"),
        (b'{"version":' * 100_000, "nested too deeply"),
        (b"9" * 5000, "not JSON that can be read: Exceeds the limit"),
        (b"\xff", "not UTF-8 text: invalid start byte at byte 0"),
        (b" " * (2**24 + 1), "more than 16 MiB (max_mib)"),
    ],
    ids=range(9),
)
def test_malformed_certificates_are_refused_in_one_line(content: bytes, message: str) -> None:
    found = refusal(run("verify", "-", stdin=content))
    assert found.startswith(f"standard input: {message}")


@pytest.mark.parametrize(
    "change",
    [
        {"version": 1e999},
        {"area": 72},
        {"area": "1e999999999"},
        {"direction": [1, 10**4000]},
        {"outer": {"0": "0"}},
    ],
    ids=range(5),
)
def test_hostile_certificates_are_not_proved(change: dict[str, object]) -> None:
    refuse_changed(change)


@pytest.mark.parametrize(("member", "part"), [("trajectory", ["0", "0"]), ("contacts", [])])
def test_long_certificates_are_refused_in_linear_time(member: str, part: list[str]) -> None:
    require_linear(lambda n: refuse_changed({member: [part] * (n // 8)}))


def refuse_changed(change: dict[str, object]) -> None:
    result = run("verify", "-", stdin=json.dumps({**EXAMPLE.certificate(), **change}))
    assert (result.exit_code, result.stderr) == (1, "")
    assert len(result.stdout.splitlines()) <= 2
