"""Classification of failures by their fault, from the verdict, the reason and standard error.

Failures have the same fault if their verdict, part and kinds of witness are equal, and their
reasons differ only in numbers and quoted values. Crashes also need the same exit code or signal,
error on standard error and place in the stack trace.
"""

import re
from collections.abc import Mapping, Sequence
from typing import Any

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.judge.witness import PART_NAMES
from exactsweep.conform.run.peer import cut

_TRACEBACK = "Traceback (most recent call last):"
_PANIC = re.compile(r"^thread '.*' (?:\(\d+\) )?panicked at ")
_THROWN = re.compile(r"^terminate called after throwing an instance of '(.*)'")
_WHAT = re.compile(r"^\s+what\(\):\s*(.*)")
# A line that names an error of Node, Java, C#, Python, sanitizers, Go, assert or valgrind.
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
# Lines below the error that carry no information.
_TRAILER = re.compile(
    r"^(?:Node\.js v\d|note: run with `RUST_BACKTRACE|stack backtrace:|\(Use `node --trace|"
    r"Aborted|Segmentation fault|==\d+==\s*ABORTING|=+$|\s*at |-+ \w+ stack trace -|\s*\d+: )"
)
_CARET = re.compile(r"^\s*\^+$")  # the caret line below the source line of an error
_REJECTED = re.compile(r'rejected with the reason "(.*)"')
_PLACES = (
    re.compile(r'File "(?:[^"]*[/\\])?([^"/\\]*)", line (\d+)'),
    re.compile(r"\bat (?:.*[ (])?(?:file://)?(?!node:)(?:[^\s()]*[/\\])?([\w.-]+\.\w+):(\d+)"),
)
_ENDED = ("exited with code", "was killed by signal")
# Line numbers of source files stay; other numbers depend on the case.
_NUMBER = re.compile(
    r"(\bline \d+|[\w/\\-]+\.[A-Za-z]\w*:\d+)|0x[0-9a-fA-F]+|\d+(?:[./]\d+)*(?:[eE][+-]?\d+)?"
)
# An apostrophe between letters is not a quotation mark.
_QUOTED = re.compile(r"""(?<!\w)'[^']*'(?!\w)|"[^"]*"|`[^`]*`""")


def find_error(stderr: str) -> str:
    r"""Find the line of standard error that names the error, or "".

    Python writes it last, Node and Java before the stack, Rust and C++ in two lines, and sanitizers
    above a long report.

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


def name_fault(
    verdict: Verdict,
    reason: str,
    parts: Sequence[Mapping[str, Any]] = (),
    stderr: str = "",
    id: str = "",
) -> str:
    r"""Name the fault of a failure in one line; return the verdict of a correct answer.

    >>> name_fault(Verdict.CRASH, "says: division by zero in row 12")
    'crash: says: division by zero in row #'
    >>> said = 'File "/app/nfp.py", line 7, in slide\nKeyError: 12'
    >>> name_fault(Verdict.CRASH, "exited with code 1", stderr=said)
    'crash: exited with code 1; KeyError: #; nfp.py line 7'
    """
    if verdict in (Verdict.EXACT, Verdict.EQUIVALENT, Verdict.UNSUPPORTED):
        return verdict.value
    if id:
        reason, stderr = (text.replace(id, "#") for text in (reason, stderr))
    worst = max(parts, key=lambda part: Verdict(part["verdict"]).severity, default=None)
    if worst is not None:
        said = [_name_difference(worst)]
    elif reason.startswith(_ENDED):
        # The reason contains only a shortened error.
        said = [reason.partition(";")[0], _mask_values(find_error(stderr)), find_place(stderr)]
    else:
        said = [_mask_values(reason), find_place(stderr)]
    return f"{verdict.value}: {'; '.join(filter(None, said))}"


def _name_difference(part: Mapping[str, Any]) -> str:
    named = next(iter(part["diagnosis"]), "") or part["kind"] or part["reason"]
    shown = (part[side] and part[side]["classified"] for side in ("unsound", "conservative"))
    return ", ".join(
        [PART_NAMES[part["name"]], mask_numbers(named), *(kind.lower() for kind in shown if kind)]
    )


def _mask_values(text: str) -> str:
    return mask_numbers(_QUOTED.sub("#", text))


def mask_numbers(text: str) -> str:
    return _NUMBER.sub(lambda found: found[1] or "#", cut(text))
