"""The options of all commands, with their types; `python -m tests.goldens` rewrites them."""

from collections.abc import Iterator
from pathlib import Path

from command import list_commands

FILE = Path(__file__).parent / "options.txt"
_FACTS = ("min", "max", "min_open", "max_open", "choices", "dir_okay", "file_okay", "allow_dash")


def list_options() -> Iterator[str]:
    """Yield each command, and a line for each of its arguments and options."""
    for name, command in list_commands():
        yield f"{name}: {command.get_short_help_str(200)}"
        for one in command.params:
            kind = type(one.type).__name__
            facts = {fact: getattr(one.type, fact, None) for fact in _FACTS}
            listed = [
                f"{fact} {value}" for fact, value in facts.items() if value not in (None, False)
            ]
            marks = [
                mark for mark in ("required", "multiple", "hidden") if getattr(one, mark, False)
            ]
            default = getattr(one, "default", None)
            listed += marks + [f"default {default}"] * isinstance(
                default, int | float | str | tuple
            )
            words = " ".join([*one.opts, *one.secondary_opts])
            help = getattr(one, "help", None) or ""
            yield f"  {words} {one.metavar or ''} x{one.nargs} {kind} ({'; '.join(listed)}) {help}"


def test_options_are_golden() -> None:
    assert list(list_options()) == FILE.read_text(encoding="utf-8").splitlines()
