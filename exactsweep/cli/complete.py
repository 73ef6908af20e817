"""Completion in the shell: names of cases, flags, families, claims and verdicts."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable

import click
from click.shell_completion import CompletionItem

Offer = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]
"""A function that click calls with the beginning of a word."""


def list_cases() -> Iterable[str]:
    """The ids of the corpus."""
    from exactsweep.corpus.shipped import list_ids

    return list_ids()


def list_themes() -> Iterable[str]:
    """The themes of the corpus."""
    from exactsweep.corpus import themes

    return themes()


def list_flags() -> Iterable[str]:
    """The flags of cases."""
    from exactsweep.corpus import notes

    return notes()


def list_families() -> Iterable[str]:
    """The families of the generator."""
    from exactsweep.corpus import FAMILIES

    return FAMILIES


def list_classes() -> Iterable[str]:
    """The classes of pairs."""
    from exactsweep.corpus.case import KINDS

    return KINDS


def list_claims() -> Iterable[str]:
    """The claims of the paper."""
    from exactsweep.paper.ledger import CLAIMS

    return [claim.name for claim in CLAIMS]


def list_verdicts() -> list[str]:
    """The verdicts that `--accept` takes: those that say something of an answer."""
    from exactsweep.conform.judge.verdict import Verdict

    unjudged = (Verdict.UNSUPPORTED, Verdict.UNDECIDED)
    return [verdict.value for verdict in Verdict if verdict not in unjudged]


def list_filters() -> Iterable[str]:
    """The filters of cases, each with its value."""
    yield "id="
    yield "size="
    yield from (f"class={kind}" for kind in list_classes())
    yield from (f"flag={flag}" for flag in list_flags())


def offer(*sources: Callable[[], Iterable[str]], files: bool = False) -> Offer:
    """Make what click asks for completions.

    Args:
        sources: lists of names, which are only made when Tab is pressed.
        files: whether a file may stand there, too.

    Example:
        >>> found = offer(list_classes)(click.Context(click.Command("")), click.Option(["-c"]), "C")
        >>> [item.value for item in found]
        ['CC', 'CM']
    """

    def complete(
        ctx: click.Context, option: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        names = (name for source in sources for name in source())
        found = [
            CompletionItem(_escape(name))
            for name in names
            if name.lower().startswith(incomplete.lower())
        ]
        return found or ([CompletionItem(incomplete, type="file")] if files else [])

    return complete


def _escape(name: str) -> str:
    # Other shells do that themselves.
    is_bash = os.environ.get("_EXACTSWEEP_COMPLETE", "").startswith("bash")
    return name.replace(" ", "\\ ") if is_bash else name
