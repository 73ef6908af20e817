"""The line of standard error that names the error of a failed program.

Python writes it last, Node and Java before the stack, Rust in two lines, and sanitizers above a
long report.
"""

from __future__ import annotations

import re

_TRACEBACK = "Traceback (most recent call last):"
_PANIC = re.compile(r"^thread '.*' (?:\(\d+\) )?panicked at ")
_THROWN = re.compile(r"^terminate called after throwing an instance of '(.*)'")
_WHAT = re.compile(r"^\s+what\(\):\s*(.*)")
_NAMED = re.compile(
    r"""
      ^(?:.*\ )?(?:Uncaught\ |Unhandled\ exception\.?\ |Exception\ in\ thread\ "[^"]*"\ )
    | ^(?:[\w$]+[.:]+)*(?:[A-Z][\w$]*)?(?:Error|Exception|Exit|Interrupt|Fault)\b
      (?:\ \[\w+\])?(?::|\ \(|$)
    | ^(?:==\d+==\s*)?(?:ERROR|WARNING|SUMMARY):\ \w+Sanitizer:
    | :\ runtime\ error:\ | ^(?:runtime|fatal)\ error:\ | ^panic:\ | :\ Assertion\ .*\ failed
    | ^==\d+==\ (?:Invalid|Conditional|Process\ terminating)
    """,
    re.VERBOSE,
)
"""A line that names an error of Node, Java, C#, Python, sanitizers, Go, assert or valgrind."""
_TRAILER = re.compile(
    r"^(?:Node\.js v\d|note: run with `RUST_BACKTRACE|stack backtrace:|\(Use `node --trace|"
    r"Aborted|Segmentation fault|==\d+==\s*ABORTING|=+$|\s*at |-+ \w+ stack trace -|\s*\d+: )"
)
"""A line without information below the error."""
_CARET = re.compile(r"^\s*\^+$")
"""The line between the source line of an error and its name."""
_REJECTED = re.compile(r'rejected with the reason "(.*)"')
_PLACES = (
    re.compile(r'File "(?:[^"]*[/\\])?([^"/\\]*)", line (\d+)'),
    re.compile(r"\bat (?:.*[ (])?(?:file://)?(?!node:)(?:[^\s()]*[/\\])?([\w.-]+\.\w+):(\d+)"),
)


def find_error(stderr: str) -> str:
    r"""Find the line of standard error that names the error, or "".

    This is the last line of a Python traceback, else the first line that looks like an error, else
    the last line with information. Rust panics and C++ exceptions are joined from two lines.

    Example:
        >>> find_error("TypeError: not a BigInt\n    at f.js:1\n\nNode.js v20.1.0")
        'TypeError: not a BigInt'
        >>> find_error("thread 'main' panicked at src/main.rs:7:9:\nindex out of bounds\nnote: run")
        "thread 'main' panicked at src/main.rs:7:9: index out of bounds"
    """
    lines = [line.rstrip() for line in stderr.splitlines() if line.strip()]
    if _TRACEBACK in lines:
        named = [line for line in lines[lines.index(_TRACEBACK) :] if _NAMED.search(line)]
        # An exception with another name is on the last line.
        return (named or lines)[-1].strip()
    for line, after in zip(lines, [*lines, ""][1:], strict=True):
        if _PANIC.match(line):
            return f"{line} {after.strip()}" if line.endswith(":") else line
        if thrown := _THROWN.match(line):
            said = _WHAT.match(after)
            return f"{thrown[1]}: {said[1]}" if said else f"uncaught exception {thrown[1]}"
        if _NAMED.search(line):
            return line.strip()
        if after and _CARET.match(line):
            rejected = _REJECTED.search(after)
            return f"unhandled rejection: {rejected[1]}" if rejected else after.strip()
    rest = [line for line in lines if not _TRAILER.match(line)]
    return (rest or lines or [""])[-1].strip()


def find_place(stderr: str) -> str:
    r"""Find the file and line of the error in a stack trace, or "".

    >>> find_place('  File "/app/nfp.py", line 7, in slide\nKeyError: 12')
    'nfp.py line 7'
    >>> find_place("Error: no\n    at f (/app/nfp.js:3:9)\n    at node:internal/main:2:1")
    'nfp.js line 3'
    """
    for innermost, pattern in ((-1, _PLACES[0]), (0, _PLACES[1])):
        if found := pattern.findall(stderr):
            return " line ".join(found[innermost])
    return ""
