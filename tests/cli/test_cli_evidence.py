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
from command import EXACTSWEEP, EXAMPLE, PATIENCE, refusal, run
from linear import require_linear

from exactsweep.check.standalone import prove


def on_a_terminal(command: str) -> str:
    """Return the output on a terminal of 24 lines and 80 columns."""
    end, terminal = pty.openpty()
    fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    environment = {**os.environ, "PAGER": "sed s/^/page:/", "TERM": "xterm"}
    for name in ("COLUMNS", "LINES", "NO_COLOR"):
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
    # On Linux, reading from a terminal without other users ends with an error.
    with contextlib.suppress(OSError):
        while piece := os.read(end, 4096):
            shown += piece
    os.close(end)
    assert child.wait(timeout=PATIENCE) == 0
    return shown.decode()


def test_a_long_explanation_is_paged_and_a_short_one_has_bold_words() -> None:
    assert on_a_terminal("explain").startswith("page:Class CM")
    shown = on_a_terminal("sweep")
    assert "page:" not in shown
    assert "\x1b[1m" in shown


def test_a_certificate_is_proved_by_the_checker_alone(tmp_path: Path) -> None:
    path = tmp_path / "proof.json"
    assert run("sweep", "--certificate", "-o", str(path)).output == ""
    assert prove(json.loads(path.read_text()))


def test_a_false_certificate_gets_a_reason_and_a_witness() -> None:
    proof = EXAMPLE.certificate()
    # Into the notch, as deep as the tip of the house fits.
    proof["inner"][5], proof["inner"][4] = ["11/4", "2"], ["4", "2"]
    result = run("verify", "-", stdin=json.dumps(proof))
    assert (result.exit_code, result.stderr) == (1, "")
    verdict = json.loads(run("verify", "--json", "-", stdin=json.dumps(proof)).stdout)
    assert verdict["proved"] is False
    reason, *witness = result.stdout.splitlines()
    assert reason == f"standard input: not proved: {verdict['reason']}"
    assert witness == [f"witness: ({','.join(verdict['witness'])})"] * bool(verdict["witness"])


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "line 1, column 1: not JSON: Expecting value"),
        (b"proved", "line 1, column 1: not JSON: Expecting value"),
        (b"{}{}", "line 1, column 3: not JSON: Extra data"),
        (b'{"kind": "CC", "kind": "CM"}', "duplicate key 'kind'"),
        (b"[" * 100_000, "nested too deeply"),
        (b'{"version":' * 100_000, "nested too deeply"),
        (b"9" * 5000, "unreadable JSON: Exceeds the limit"),
        (b"\xff", "not UTF-8 text: invalid start byte at byte 0"),
        (b" " * (2**24 + 1), "more than 16 MiB (max_mib)"),
    ],
    ids=range(9),
)
def test_malformed_certificates_are_rejected_in_one_line(content: bytes, message: str) -> None:
    found = refusal(run("verify", "-", stdin=content))
    assert found.startswith(f"standard input: {message}")


@pytest.mark.parametrize(
    "change",
    [
        {"version": 1e999},
        {"area": 72},
        {"area": "1e999999999"},
        {"claim": "no_fit"},
        {"exact_fits": [[["0", "1e400"]] * 2]},
        {"outer": {"0": "0"}},
    ],
    ids=range(6),
)
def test_hostile_certificates_are_not_proved(change: dict[str, object]) -> None:
    reject_changed(change)


@pytest.mark.parametrize(("member", "part"), [("exterior", ["0", "0"]), ("holes", [])])
def test_long_certificates_are_rejected_in_linear_time(member: str, part: list[str]) -> None:
    require_linear(lambda n: reject_changed({member: [part] * (n // 8)}))


def reject_changed(change: dict[str, object]) -> None:
    result = run("verify", "-", stdin=json.dumps({**EXAMPLE.certificate(), **change}))
    assert (result.exit_code, result.stderr) == (1, "")
    assert len(result.stdout.splitlines()) <= 2
