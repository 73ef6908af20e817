"""The corpus as a folder of data for programs in any language."""

import json
from collections.abc import Iterator
from hashlib import sha256
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path

from exactsweep.corpus.case_json import case_to_json
from exactsweep.corpus.shipped import cases, read_schema, themes

VERSION = 3  # new cases increase it; existing cases never change
# The digested members of a case: the question and the answers.
_ANSWERED = (
    *("id", "class", "directrix", "directrix_holes", "generatrix", "generatrix_holes"),
    *("reference", "expected"),
)


def write_corpus(folder: Path) -> int:
    """Write all shipped cases, instructions and readers; return the number of files."""
    sums = []
    for name, data in _list_files():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
        sums.append(f"{sha256(data).hexdigest()}  {name}\n")
    (folder / "SHA256SUMS").write_text("".join(sums), encoding="utf-8", newline="")
    return len(sums) + 1


def digest_release(version: int) -> str:
    """Return the digest of all questions and answers up to a version; see HOW-TO-READ.md."""
    lines = sorted(
        json.dumps(
            {name: value for name, value in case_to_json(case).items() if name in _ANSWERED},
            sort_keys=True,
            separators=(",", ":"),
        )
        for case in cases()
        if case.version <= version
    )
    return sha256("".join(f"{line}\n" for line in lines).encode()).hexdigest()


def _list_files() -> Iterator[tuple[str, bytes]]:
    package = files("exactsweep.corpus")
    yield "VERSION", f"{VERSION}\n".encode()
    yield "schema.json", read_schema().encode()
    yield "notes.json", package.joinpath("notes.json").read_bytes()
    yield from _list_under(package.joinpath("release"))
    for theme in themes():
        lines = (
            json.dumps(
                {"version": case.version, **case_to_json(case)},
                separators=(",", ":"),
                ensure_ascii=False,
            )
            for case in cases(prefix=f"{theme}-")
        )
        yield f"cases/{theme}.jsonl", "".join(f"{line}\n" for line in lines).encode()


def _list_under(folder: Traversable, prefix: str = "") -> Iterator[tuple[str, bytes]]:
    for entry in sorted(folder.iterdir(), key=lambda entry: entry.name):
        if entry.is_dir():
            yield from _list_under(entry, f"{prefix}{entry.name}/")
        else:
            yield f"{prefix}{entry.name}", entry.read_bytes()
