"""Reader of pasted vertices: two numbers per line, tuples, braces, or counted pairs."""

import re
from collections.abc import Iterator, Sequence
from fractions import Fraction
from functools import partial

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.decimals import read_decimals, read_points
from exactsweep.formats.error import FormatError
from exactsweep.numbers.number import Point

_PLAIN = re.compile(r"[-+.,;0-9eE\s()\[\]{}]++")
_TO_LISTS = str.maketrans("(){};", "[][],")
_SIGNS = {
    "%PDF": ("PDF", "export SVG or DXF"),
    "ISO-10303": ("STEP", "export the flat outline as DXF"),
    "AC10": ("DWG", "save it as DXF"),
    "<!doctype html": ("HTML", "save its drawing as SVG"),
    "<html": ("HTML", "save its drawing as SVG"),
    "IN;": ("HPGL", "export SVG or DXF"),
    "\x1b%": ("HPGL", "export SVG or DXF"),
    "SP1": ("HPGL", "export SVG or DXF"),
}
_G_CODE = re.compile(r"(?:%\s*|[;(][^\n]*\n\s*)*+(?:N\d+\s*)?[GMO]\d", re.IGNORECASE)


def reject_unsupported(text: str) -> None:
    """Reject unsupported formats, recognized by their first characters."""
    start = text.lstrip()[:40].lower()
    for sign, (name, advice) in _SIGNS.items():
        if start.startswith(sign.lower()):
            raise FormatError(f"{name} is not supported; {advice}")
    if _G_CODE.match(text.lstrip()[:2000]):
        raise FormatError("G-code is not supported; export SVG or DXF")


def is_plain(text: str) -> bool:
    return bool(_PLAIN.fullmatch(text))


def to_json_text(text: str) -> str:
    """Rewrite tuples and braces as JSON lists.

    >>> to_json_text("{{0,0},{1,0},{0,1}};"), to_json_text("(0,0), (1,0), (0,1)")
    ('[[0,0],[1,0],[0,1]]', '[[0,0], [1,0], [0,1]]')
    """
    lists = re.sub(r",(?=\s*(?:\]|\Z))", "", text.translate(_TO_LISTS)).strip()
    return lists if re.match(r"\[\s*\[", lists) else f"[{lists}]"


def parse_numbers(text: str) -> list[Candidate]:
    """Read lines of two numbers, with blank lines between polygons, or counted pairs.

    >>> [len(one.vertices()) for one in parse_numbers("3 0 0 1 0 0 1")]
    [3]
    """
    lines = [line.strip(" ,;\t") for line in text.splitlines()]
    if all(len(line.replace(",", " ").split()) in (0, 2) for line in lines):
        return [*_read_lines(lines)]
    return [*_read_counted(read_decimals(text))]


def _read_lines(lines: Sequence[str]) -> Iterator[Candidate]:
    start = 0
    for k in range(len(lines) + 1):
        if k == len(lines) or not lines[k]:
            if k > start:
                points = partial(read_points, "\n".join(lines[start:k]))
                yield Candidate(f"line {start + 1}", points)
            start = k + 1


def _read_counted(numbers: Sequence[Fraction]) -> Iterator[Candidate]:
    k = 0
    while k < len(numbers):
        size, first = numbers[k], k + 1
        k = first + 2 * int(size)
        if size.denominator != 1 or not first < k <= len(numbers):
            raise FormatError("expected one pair of numbers per line, or a count and its pairs")
        points = [*map(Point, numbers[first:k:2], numbers[first + 1 : k : 2])]
        yield Candidate("", points.copy)
