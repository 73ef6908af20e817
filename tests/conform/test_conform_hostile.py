"""The runner survives misbehaving processes in bounded memory, and leaves none running."""

import resource
import sys
from collections.abc import Iterator
from pathlib import Path
from uuid import uuid4

import pytest
from command import eventually, processes
from judged import HOSTILE, SQUARE
from tiers import mostly_long

from exactsweep.conform.run.channel import Channel, ClosedError
from exactsweep.conform.run.outcome import judge_case
from exactsweep.conform.run.peer import MAX_STDERR
from exactsweep.conform.run.process import ProcessPeer, Terms
from exactsweep.conform.run.protocol import ProtocolError
from exactsweep.corpus import Case

CASE = Case.of("square", "", SQUARE, SQUARE)
MEGABYTES = 1024  # of ru_maxrss

SURVIVED = {
    "endless-line": ("malformed", "a line of more than 16 MiB (max_mib)"),
    "endless-lines": ("malformed", "'' is not a line of JSON"),
    "gigabyte-line": ("malformed", "a line of more than 16 MiB (max_mib)"),
    "deep-json": ("malformed", "nested too deeply"),
    "long-int": ("malformed", "unreadable JSON"),
    "stderr-flood": ("timeout", "no answer within 0.5 s"),
    "ignores-termination": ("timeout", "no answer within 0.5 s"),
    "never-reads": ("timeout", "no answer within 0.5 s"),
    "closes-output": ("crash", "closed its output"),
    "leaves-children": ("crash", "exited with code 0"),
    "leaves-children-in-silence": ("crash", "exited with code 0"),
    "dies": ("crash", "was killed by signal 9, SIGKILL"),
}
if any(Path("/proc/self/task").glob("*/children")):
    SURVIVED["hides-a-child"] = ("timeout", "no answer within 0.5 s")
REFUSED = {
    "no-hello": "no hello within 0.5 s",
    "dies-at-once": "no hello: exited with code 1; it says: no licence",
    "endless-hello": "no hello: a line of more than 16 MiB (max_mib)",
    "garbage-hello": "'Loading ...' is not a line of JSON",
    "deep-hello": "nested too deeply",
    "partial-hello": 'the hello has no "loops"',
}
AFTER_BYE = {
    "never-ends": "did not exit within 0.3 s after bye",
    "lingers": "closed its output, but did not exit within 0.3 s after bye",
    "speaks-after-bye": "kept writing after bye: 'one thing more'",
}


@pytest.fixture
def mark() -> Iterator[str]:
    """A word for the command line, which no process may have in the end."""
    word = uuid4().hex
    yield word
    eventually(lambda: not processes(word))


def peak() -> int:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def test_a_program_ends_if_its_start_is_interrupted(
    monkeypatch: pytest.MonkeyPatch, mark: str
) -> None:
    def interrupt(*_: object) -> bytes:
        # A process gets its command line shortly after it starts.
        eventually(lambda: bool(processes(mark)))
        raise KeyboardInterrupt

    monkeypatch.setattr("exactsweep.conform.run.process.Channel.receive", interrupt)
    with pytest.raises(KeyboardInterrupt):
        ProcessPeer(Terms([*HOSTILE, "no-hello", mark]))


BRIEF = ("endless-lines", "deep-json", "long-int", "closes-output", "leaves-children", "dies")


@pytest.mark.parametrize("kind", mostly_long(SURVIVED, BRIEF))
def test_a_hostile_process_gets_a_verdict_each_time(kind: str, mark: str) -> None:
    verdict, reason = SURVIVED[kind]
    # The runner waits briefly for the case without an answer, and longer for all others.
    peer = ProcessPeer(Terms([*HOSTILE, kind, mark], seconds=0.5 if verdict == "timeout" else 600))
    before = peak()
    for _ in range(2):
        outcome = judge_case(peer, CASE)
        assert outcome.verdict == verdict
        assert reason in outcome.reason
    assert len(outcome.reason) < 300
    assert len(outcome.stderr) <= MAX_STDERR
    assert peak() - before < 100 * MEGABYTES
    peer.kill()


@pytest.mark.parametrize("kind", REFUSED)
def test_a_process_without_a_hello_is_rejected(kind: str, mark: str) -> None:
    with pytest.raises(ProtocolError) as error:
        ProcessPeer(Terms([*HOSTILE, kind, mark]), to_start=0.5 if kind == "no-hello" else 600)
    assert REFUSED[kind] in str(error.value)
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("command", ["no-such-program", "", "/", "\0"])
def test_a_program_that_cannot_start_is_rejected(command: str) -> None:
    with pytest.raises(ProtocolError, match="cannot run"):
        ProcessPeer(Terms([command]))


@pytest.mark.parametrize("kind", AFTER_BYE)
def test_a_process_that_continues_after_bye_is_killed_and_reported(
    kind: str, mark: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    seconds = 600 if kind == "speaks-after-bye" else 0.3
    monkeypatch.setattr("exactsweep.conform.run.process.EXIT_SECONDS", seconds)
    peer = ProcessPeer(Terms([*HOSTILE, kind, mark]))
    assert judge_case(peer, CASE).verdict == "unsupported"
    assert peer.close() == AFTER_BYE[kind]


def test_a_case_larger_than_a_pipe_does_not_block(mark: str) -> None:
    peer = ProcessPeer(Terms([*HOSTILE, "never-reads", mark], seconds=0.3))
    ring = [(k, k * k) for k in range(4000)]
    large = Case.of("large", "", ring, SQUARE)
    assert judge_case(peer, large).verdict == "timeout"
    peer.kill()


def test_an_exit_is_not_a_timeout() -> None:
    channel = Channel([sys.executable, "-c", "print('one'); print('half', end='')"])
    assert channel.receive(600) == "one"
    with pytest.raises(ClosedError, match="exited with code 0"):
        channel.receive(600)
    channel.kill()


def test_a_changed_hello_after_a_restart_is_a_crash(tmp_path: Path) -> None:
    program = tmp_path / "fickle.py"
    program.write_text(
        "import json, os, sys\n"
        "print(json.dumps({'hello': str(os.getpid()), 'loops': ['inner'], 'numbers': 'rational',"
        " 'reference': 'given'}), flush=True)\n"
        "sys.stdin.readline()\n"
    )
    peer = ProcessPeer(Terms([sys.executable, str(program)]))
    assert judge_case(peer, CASE).reason == "exited with code 0"
    assert judge_case(peer, CASE).reason == "cannot be restarted: the hello changed after a restart"
    peer.kill()
