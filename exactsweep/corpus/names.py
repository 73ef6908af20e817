"""Names in user input, with suggestions for unknown ones."""

from collections.abc import Collection

from exactsweep.numbers.error import ExactSweepError, quote
from exactsweep.words import suggest


class UnknownNameError(ExactSweepError):
    """An unknown name; the message suggests a similar one."""


def require_known(name: str, names: Collection[str], thing: str) -> str:
    """Return a name if it is known; otherwise suggest a similar one.

    >>> require_known("exact-fits", ["exact-fit", "undercut"], "flag")
    Traceback (most recent call last):
    exactsweep.corpus.names.UnknownNameError: no flag 'exact-fits'; did you mean 'exact-fit'?
    """
    if name in names:
        return name
    shown = sorted(names)
    some = f"; choose from {', '.join(shown[:8])}{', ...' if len(shown) > 8 else ''}"
    raise UnknownNameError(f"no {thing} {quote(name)}{suggest(name, names) or some}")
