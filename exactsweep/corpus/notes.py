"""Notes on flags: what is special about a case, and which kind of bug it catches."""

import json
from functools import cache
from importlib.resources import files
from typing import NamedTuple


class Note(NamedTuple):
    """What a flag says about a case, and which kind of bug such cases catch."""

    meaning: str
    catches: str


@cache
def notes() -> dict[str, Note]:
    """Return the note on each flag there is, by name.

    Example:
        >>> notes()["rounded-answer"].meaning
        'At the integer scale, some coordinate of the answer is not an integer.'
    """
    text = files("exactsweep.corpus").joinpath("notes.json").read_text(encoding="utf-8")
    return {flag: Note(**note) for flag, note in json.loads(text).items()}
