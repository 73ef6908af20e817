"""Classification of failures by their fault.

Two failures have the same fault if their verdict, part and kinds of witness are the same, and their
reasons differ in numbers and quoted values only. For crashes, the exit code or signal, the error on
standard error and the place in the stack trace must be the same.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from exactsweep.conform.judge.verdict import Verdict
from exactsweep.conform.judge.witness import PART_NAMES
from exactsweep.conform.run.complaint import find_error, find_place
from exactsweep.conform.run.peer import cut

_ENDED = ("exited with code", "was killed by signal")
# Line numbers of source files stay; other numbers depend on the case.
_NUMBER = re.compile(
    r"(\bline \d+|[\w/\\-]+\.[A-Za-z]\w*:\d+)|0x[0-9a-fA-F]+|\d+(?:[./]\d+)*(?:[eE][+-]?\d+)?"
)
# An apostrophe between letters is no quotation mark.
_QUOTED = re.compile(r"""(?<!\w)'[^']*'(?!\w)|"[^"]*"|`[^`]*`""")


def name_fault(
    verdict: Verdict,
    reason: str,
    parts: Sequence[Mapping[str, Any]] = (),
    stderr: str = "",
    id: str = "",
) -> str:
    r"""Name the fault of a failure in one line; return the verdict of a right answer.

    Example:
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
        # The reason has a shortened error.
        said = [reason.partition(";")[0], _forget_values(find_error(stderr)), find_place(stderr)]
    else:
        said = [_forget_values(reason), find_place(stderr)]
    return f"{verdict.value}: {'; '.join(filter(None, said))}"


def _name_difference(part: Mapping[str, Any]) -> str:
    named = next(iter(part["diagnosis"]), "") or part["kind"] or part["reason"]
    shown = (part[side] and part[side]["classified"] for side in ("unsound", "conservative"))
    return ", ".join(
        [PART_NAMES[part["name"]], write_cause(named), *(kind.lower() for kind in shown if kind)]
    )


def _forget_values(text: str) -> str:
    return write_cause(_QUOTED.sub("#", text))


def write_cause(text: str) -> str:
    """Replace the numbers of a diagnosis.

    >>> write_cause("translated by (3,-1/2)")
    'translated by (#,-#)'
    """
    return _NUMBER.sub(lambda found: found[1] or "#", cut(text))
