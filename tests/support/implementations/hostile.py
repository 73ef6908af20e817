"""Hostile programs: `python hostile.py KIND MARK`.

MARK is a word in the command line of all started processes, to find those that keep running.
"""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable

HELLO = '{"hello": "hostile", "loops": ["trajectory"], "numbers": "rational", "reference": "given"}'
GIGABYTE = 2**30
SLEEPER = [sys.executable, "-c", "import time; time.sleep(600)"]


def forever(text: str) -> None:
    while True:
        sys.stdout.write(text)


def gigabyte_line(line: str) -> None:
    for _ in range(GIGABYTE // 2**20):
        sys.stdout.write("7" * 2**20)
    sys.stdout.write("\n")


def deep_json(line: str) -> None:
    print('{"id": ' + "[" * 10**6 + "]" * 10**6 + "}", flush=True)


def stderr_flood(line: str) -> None:
    while True:
        sys.stderr.write("complaint\n" * 1000)


def ignores_termination(line: str) -> None:
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_IGN)
    while True:
        time.sleep(600)


def leaves_children(line: str) -> None:
    """Start a child in the group and one in a new session, both with the pipes."""
    for new in (False, True):
        subprocess.Popen([*SLEEPER, sys.argv[2]], start_new_session=new)
    sys.exit(0)


def leaves_children_in_silence(line: str) -> None:
    os.close(2)
    leaves_children(line)


def closes_output(line: str) -> None:
    os.close(1)
    time.sleep(600)


def never_ends(line: str) -> None:
    """Answer correctly, then ignore bye and the end of the input."""
    answer(line)
    ignores_termination(line)


def lingers(line: str) -> None:
    """Answer correctly, then close the output without exiting."""
    answer(line)
    closes_output(line)


def speaks_after_bye(line: str) -> None:
    answer(line)
    sys.stdin.readline()
    print("one thing more", flush=True)


def answer(line: str) -> None:
    print(json.dumps({"id": json.loads(line)["id"], "unsupported": "never"}), flush=True)


def long_int(line: str) -> None:
    print('{"id": 1' + "0" * 10**6 + "}", flush=True)


AFTER_A_CASE: dict[str, Callable[[str], object]] = {
    "endless-line": lambda line: forever("7" * 1000),
    "endless-lines": lambda line: forever("\n" * 1000),
    "gigabyte-line": gigabyte_line,
    "deep-json": deep_json,
    "long-int": long_int,
    "stderr-flood": stderr_flood,
    "ignores-termination": ignores_termination,
    "leaves-children": leaves_children,
    "leaves-children-in-silence": leaves_children_in_silence,
    "hides-a-child": lambda line: time.sleep(600),
    "closes-output": closes_output,
    "dies": lambda line: os.kill(os.getpid(), signal.SIGKILL),
    "never-ends": never_ends,
    "lingers": lingers,
    "speaks-after-bye": speaks_after_bye,
}
AT_ONCE: dict[str, Callable[[str], object]] = {
    "no-hello": ignores_termination,
    "dies-at-once": lambda line: sys.exit("no licence"),
    "endless-hello": lambda line: forever("7" * 1000),
    "garbage-hello": lambda line: print("Loading ...", flush=True),
    "deep-hello": deep_json,
    "partial-hello": lambda line: print('{"hello": "hostile"}', flush=True),
}


def main(kind: str) -> None:
    if kind in AT_ONCE:
        AT_ONCE[kind]("")
        return
    if kind == "hides-a-child":
        subprocess.Popen([*SLEEPER, sys.argv[2]], start_new_session=True, env={})
    print(HELLO, flush=True)
    if kind == "never-reads":
        time.sleep(600)
    AFTER_A_CASE[kind](sys.stdin.readline())


if __name__ == "__main__":
    main(sys.argv[1])
