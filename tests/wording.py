"""Words to avoid: `python tests/wording.py FOLDER...` lists them with their lines.

Module `test_wording` requires that there are none. Words count in Markdown outside of code, and
in comments, strings and names of sources. Strings of tests are data, except docstrings.
"""

from __future__ import annotations

import io
import re
import sys
import tokenize
import tomllib
from collections.abc import Iterator
from functools import cache
from pathlib import Path

TREE = Path(__file__).parents[1]
LIST = tomllib.loads(Path(__file__).with_suffix(".toml").read_text("utf-8"))
WORDS: dict[str, str] = LIST["words"]
KEPT: set[str] = {*LIST["names"]["kept"]}
FOLDERS = ("exactsweep", "tests", "benchmarks")
# The list itself.
SKIPPED = {"tests/test_wording.py"}

_QUOTED = re.compile("|".join(["`[^`\n]*`", *map(re.escape, KEPT)]))
_LISTED = re.compile(rf"\b({'|'.join(sorted(WORDS, key=len, reverse=True))})\b", re.I)


def list_files() -> dict[str, Path]:
    """List all sources and pages by their paths below the root."""
    found = [TREE / "README.md"]
    found += (
        p for name in FOLDERS for end in ("py", "md") for p in TREE.glob(f"{name}/**/*.{end}")
    )
    return {name: path for path in found if (name := str(path.relative_to(TREE))) not in SKIPPED}


def find_words(
    text: str, suffix: str = ".py", *, strings: bool = True
) -> Iterator[tuple[int, str]]:
    """Find the words of the list in a text, each with the number of its line.

    Args:
        text: a source or a page.
        suffix: ".py" or ".md".
        strings: whether strings count that are not docstrings.
    """
    for line, prose in _list_pages(text) if suffix == ".md" else _list_tokens(text, strings):
        # A phrase may continue on the next line.
        flat = re.sub(r"\s*\n\s*#?\s*", lambda gap: " " * len(gap[0]), prose)
        flat = re.sub(r"(?<=\S) {2,}(?=\S)", " ", flat)
        for match in _LISTED.finditer(flat):
            yield line, match[1].lower()


def _list_pages(text: str) -> Iterator[tuple[int, str]]:
    """Yield the paragraphs of a page without its code."""
    plain = re.sub(
        r"^```.*?^```|`[^`\n]*`", lambda m: "\n" * m[0].count("\n"), text, flags=re.M | re.S
    )
    line = 1
    for paragraph in re.split(r"(\n\s*\n)", plain):
        yield line, paragraph
        line += paragraph.count("\n")


def _list_tokens(text: str, strings: bool) -> Iterator[tuple[int, str]]:
    """Yield the comments, joined over lines, the strings, and the names as words."""
    comment, start, last = "", 0, 0
    for kind, token, (line, _), *_ in tokenize.generate_tokens(io.StringIO(text).readline):
        if kind == tokenize.COMMENT:
            comment, start = (f"{comment}\n{token}", start) if line == last + 1 else (token, line)
            last = line
            continue
        if comment and kind != tokenize.NL:
            yield start, comment
            comment = ""
        if kind == tokenize.STRING and (strings or '"""' in token[:5]):
            yield line, _QUOTED.sub("", token)
        elif kind == tokenize.NAME and token not in KEPT:
            yield line, _split_names(token.replace("_", " "))


def _split_names(text: str) -> str:
    return re.sub(r"(?<=[a-z])(?=[A-Z])", " ", text)


@cache
def find_in(name: str, path: Path) -> list[tuple[int, str]]:
    """Find the words in a file of the project."""
    text = path.read_text(encoding="utf-8")
    if not _LISTED.search(re.sub(r"[_\s#]+", " ", _split_names(text))):
        return []  # splitting the text into tokens takes longer
    return [*find_words(text, path.suffix, strings=name.startswith("exactsweep"))]


def main(folders: list[str]) -> None:
    """Print the words in the files below folders, by default in all files."""
    for name, path in list_files().items():
        if not folders or any(name.startswith(folder.rstrip("/")) for folder in folders):
            for line, word in find_in(name, path):
                print(f"{name}:{line}: {word} -> {WORDS[' '.join(word.split())]}")


if __name__ == "__main__":
    main(sys.argv[1:])
