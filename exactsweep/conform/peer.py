"""What an implementation is to the runner: something that can be asked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple, Protocol

from exactsweep.conform.protocol import Hello
from exactsweep.conform.verdict import Verdict
from exactsweep.corpus import Case
from exactsweep.formats.exact_json import described

SECONDS = 10.0
"""Seconds that an answer may take, unless the caller says otherwise."""
_MAX_REASON = 200


class Answer(NamedTuple):
    """What came of asking: a result to be compared, or a verdict and its reason."""

    result: Mapping[str, Any] | None = None
    verdict: Verdict | None = None
    reason: str = ""
    seconds: float = 0.0
    stderr: str = ""


class Peer(Protocol):
    """An implementation that can be asked."""

    hello: Hello

    def ask(self, case: Case) -> Answer:
        """Put a case to it, as `asked` has it."""

    def close(self) -> str | None:
        """Say bye; return what went wrong then, or None."""


def answered(result: Mapping[str, Any]) -> Answer:
    """Tell an answer from the reason why there is none."""
    for name, verdict in (("unsupported", Verdict.UNSUPPORTED), ("error", Verdict.CRASH)):
        if name in result:
            said = result[name]
            reason = said if isinstance(said, str) else described(said)
            return Answer(verdict=verdict, reason=f"says: {cut(reason)}")
    return Answer(result=result)


def cut(reason: str) -> str:
    """Put a foreign message on one line, cut short, without what terminals take for orders.

    >>> cut("first   second ") + cut(chr(27))
    'first second�'
    """
    words = " ".join(reason[:_MAX_REASON].split())
    return "".join(c if c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in words)
