"""The line that names the error, in the standard error of various runtimes."""

import pytest

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.run.fault import find_error, find_place, name_fault

NODE = """/app/mine.js:2
if (k == 0) BigInt("4.0");
            ^

{}
    at BigInt (<anonymous>)
    at Object.<anonymous> (/app/mine.js:{}:13)
    at Module._compile (node:internal/modules/cjs/loader:1521:14)

Node.js v20.20.2
"""
PYTHON = """Traceback (most recent call last):
  File "/app/mine.py", line 6, in <module>
    try: {}["a"]
KeyError: 'a'

During handling of the above exception, another exception occurred:

Traceback (most recent call last):
  File "/app/mine.py", line 7, in <module>
    except KeyError: raise ValueError("second
ValueError: second
line
"""
RUST = """
thread 'main' (14066) panicked at src/main.rs:1:118:
index out of bounds: the len is 2 but the index is 9
note: run with `RUST_BACKTRACE=1` environment variable to display a backtrace
"""
JAVA = """Exception in thread "main" java.lang.RuntimeException: outer
\tat A.main(A.java:12)
Caused by: java.lang.IllegalStateException: inner
\t... 1 more
"""
CPP = """terminate called after throwing an instance of 'std::out_of_range'
  what():  vector::_M_range_check
Aborted
"""
ADDRESS = """=================================================================
==7==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x602 at pc 0x55
READ of size 4 at 0x602000000048 thread T0
SUMMARY: AddressSanitizer: heap-buffer-overflow /app/mine.cpp:7 in main
==7==ABORTING
"""
UNDEFINED = "mine.cpp:7:149: runtime error: signed integer overflow: 1 + 2\nmore\n"
ASSERT = "mine: mine.cpp:7: int main(int, char**): Assertion `x.size()==4' failed.\nAborted\n"
GO = "panic: runtime error: index out of range [5] with length 3\n\ngoroutine 1 [running]:\n"
SHARP = "Unhandled exception. System.DivideByZeroException: no\n   at Mine.Main() in M.cs:line 3\n"
MODULE = """node:internal/modules/cjs/loader:1228
  throw err;
  ^

Error: Cannot find module './nope'
Require stack:
- /app/mine.js
    at Module._resolveFilename (node:internal/modules/cjs/loader:1225:15)
    at Object.<anonymous> (/app/mine.js:2:1) {
  code: 'MODULE_NOT_FOUND',
  requireStack: [ '/app/mine.js' ]
}

Node.js v20.20.2
"""
REJECTED = """node:internal/process/promises:389
      new UnhandledPromiseRejection(reason);
      ^

UnhandledPromiseRejection: This error originated either by throwing inside of an async function \
without a catch block, or by rejecting a promise which was not handled with .catch(). The promise \
rejected with the reason "no area".
    at throwUnhandledRejectionsMode (node:internal/process/promises:389:7) {
  code: 'ERR_UNHANDLED_REJECTION'
}

Node.js v20.20.2
"""
ABORTED = """Assertion failed: no area
----- Native stack trace -----

 1: 0xb7a3a0 node::Abort() [node]
----- JavaScript stack trace -----

1: abort (node:internal/process/per_thread:190:12)
2: /app/mine.js:1:37
"""
NAMED = {
    MODULE: ("Error: Cannot find module './nope'", "mine.js line 2"),
    NODE.format("Gap: of 2\nunits", 3): ("Gap: of 2", "mine.js line 3"),
    REJECTED: ("unhandled rejection: no area", ""),
    ABORTED: ("Assertion failed: no area", ""),
    NODE.format("TypeError: no", 2): ("TypeError: no", "mine.js line 2"),
    NODE.format("E [Error]: own", 3): ("E [Error]: own", "mine.js line 3"),
    PYTHON: ("ValueError: second", "mine.py line 7"),
    RUST: (
        "thread 'main' (14066) panicked at src/main.rs:1:118: "
        "index out of bounds: the len is 2 but the index is 9",
        "main.rs line 1",
    ),
    JAVA: (
        'Exception in thread "main" java.lang.RuntimeException: outer',
        "A.java line 12",
    ),
    CPP: ("std::out_of_range: vector::_M_range_check", ""),
    ADDRESS: (
        "==7==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x602 at pc 0x55",
        "",
    ),
    UNDEFINED: (UNDEFINED.splitlines()[0], ""),
    ASSERT: (ASSERT.splitlines()[0], ""),
    GO: (GO.splitlines()[0], ""),
    SHARP: (SHARP.splitlines()[0], ""),
    "loading\nabout to fail\n\n": ("about to fail", ""),
    "Uncaught:\n'a string'\n(Use `node --trace-uncaught ...` to show)\n\nNode.js v20\n": (
        "'a string'",
        "",
    ),
    "Node.js v20\n": ("Node.js v20", ""),
    "": ("", ""),
}


@pytest.mark.parametrize("stderr", NAMED)
def test_the_error_line_is_found(stderr: str) -> None:
    assert (find_error(stderr), find_place(stderr)) == NAMED[stderr]


def test_crashes_of_one_program_are_distinguished() -> None:
    """Their last lines are equal."""
    said = [NODE.format(error, 2) for error in ("TypeError: no", "RangeError: too far")]
    said.append(NODE.format("TypeError: no", 5))
    names = {name_fault(Verdict.CRASH, "exited with code 1", stderr=text) for text in said}
    assert len(names) == 3


@pytest.mark.parametrize(
    ("one", "other"),
    [
        ("KeyError: 'a'", "KeyError: 'it is 7'"),
        ("answers 'x-1', which was not sent", "answers null, which was not sent"),
        ("$.trajectory[3] has 3 coordinates", "$.trajectory[12] has 3 coordinates"),
        ('bad "0.5" at 3', 'bad "1e9" at 4'),
    ],
)
def test_values_do_not_distinguish_faults(one: str, other: str) -> None:
    is_null = "null" in other
    names = {name_fault(Verdict.MALFORMED, reason) for reason in (one, other)}
    assert len(names) == 1 + is_null


def test_an_apostrophe_is_not_a_quotation_mark() -> None:
    names = {name_fault(Verdict.CRASH, f"can't {word} and won't") for word in ("read", "write")}
    assert len(names) == 2
