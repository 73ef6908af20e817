import os
from collections.abc import Callable, Iterable
from pkgutil import resolve_name

import click
from click.shell_completion import CompletionItem

Offer = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]

CASES = "exactsweep.corpus.shipped:list_ids"
THEMES = "exactsweep.corpus:themes"
FLAGS = "exactsweep.corpus:notes"
FAMILIES = "exactsweep.corpus:FAMILIES"
CLASSES = "exactsweep.corpus.case:KINDS"
"""Import paths of lists of names, or of functions that return them, resolved on completion."""

Source = str | Callable[[], Iterable[str]]


def list_names(source: Source) -> Iterable[str]:
    found = resolve_name(source) if isinstance(source, str) else source
    names: Iterable[str] = found() if callable(found) else found
    return names


def list_claims() -> Iterable[str]:
    from exactsweep.paper.ledger import CLAIMS

    return [claim.name for claim in CLAIMS]


def list_verdicts() -> list[str]:
    from exactsweep.conform.judge.verdict import Verdict

    return [verdict.value for verdict in Verdict if verdict.is_judgement]


def list_filters() -> Iterable[str]:
    yield "id="
    yield "size="
    yield from (f"class={kind}" for kind in list_names(CLASSES))
    yield from (f"flag={flag}" for flag in list_names(FLAGS))


def offer(*sources: Source, files: bool = False) -> Offer:
    """Make a completion function for names, and optionally for files."""

    def complete(
        ctx: click.Context, option: click.Parameter, incomplete: str
    ) -> list[CompletionItem]:
        names = (name for source in sources for name in list_names(source))
        found = [
            CompletionItem(_escape(name))
            for name in names
            if name.lower().startswith(incomplete.lower())
        ]
        return found or ([CompletionItem(incomplete, type="file")] if files else [])

    return complete


def _escape(name: str) -> str:
    # Other shells escape names themselves.
    is_bash = os.environ.get("_EXACTSWEEP_COMPLETE", "").startswith("bash")
    return name.replace(" ", "\\ ") if is_bash else name
