"""Detection of the containers in a drawing."""

import re
from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from typing import NamedTuple

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.choice import select
from exactsweep.formats.decimals import show_number
from exactsweep.formats.depth import describe_place
from exactsweep.formats.error import FormatError
from exactsweep.numbers.error import quote
from exactsweep.numbers.number import Point

_WORDS = re.compile(r"(sheet|bin|board|container|stock)s?(?:[\W_]*\d+)?", re.IGNORECASE)
_LISTED = 4

_BoundingBox = tuple[Fraction, Fraction, Fraction, Fraction]


class Sheet(NamedTuple):
    container: Candidate | None
    defects: list[Candidate]  # outlines that no part may overlap
    outlines: list[Candidate]  # all other outlines in the container
    copies: list[Candidate]  # copies of the container on its own layer


def find_sheets(outlines: Sequence[Candidate], container: str | None) -> list[Sheet]:
    """Find the containers of a drawing, and assign all other outlines to them; see the README.

    `container` is the name, index or layer of the container, or a group, whose outermost outline is
    the container; case is ignored. Raises FormatError if there is no such container.
    """
    boxes = {id(one): _bound(one) for one in outlines}

    def size(one: Candidate) -> Fraction:
        left, low, right, high = boxes[id(one)]
        return (right - left) * (high - low)

    marked = _list_marked(outlines, container, boxes)
    by_size = sorted(marked, key=size, reverse=True)
    found: list[Candidate] = []
    for one in by_size:
        if not any(_overlap(boxes[id(one)], boxes[id(other)]) for other in found):
            found.append(one)
    on_layer = [one for one in found if one.layer is not None and _is_word(one.layer)]
    if container is None and len(on_layer) != 1:
        around = _find_enclosing(outlines, boxes)
        found = [around] if around is not None else found
    elif container is None:
        found = on_layer
    if not found:
        largest = max(outlines, key=size)
        others = [one for one in outlines if one is not largest]
        ties = any(size(one) == size(largest) and not _is_copy(one, largest) for one in others)
        if ties or not all(_contains_center(boxes[id(largest)], boxes[id(one)]) for one in others):
            raise FormatError(_list_candidates(sorted(outlines, key=size, reverse=True), boxes))
        found = [largest]
    found.sort(key=lambda one: next(k for k, other in enumerate(outlines) if other is one))
    layers = {
        one.layer for one in found if one.layer and (_is_word(one.layer) or one.layer == container)
    }
    sheets = [Sheet(one, [], [], []) for one in found]
    for one in outlines:
        if not any(one is other for other in found):
            # The sheet that contains the center of the box, else one that meets it, else the first.
            fitting = (
                s
                for test in (_contains_center, _overlap)
                for s in sheets
                if test(boxes[id(s.container)], boxes[id(one)])
            )
            sheet = next(fitting, sheets[0])
            held = sheet.container
            if held is not None and boxes[id(one)] == boxes[id(held)] and _is_copy(one, held):
                sheet.copies.append(one)
                continue
            grouped = container is not None and container.casefold() in map(
                str.casefold, one.groups
            )
            is_defect = one.layer in layers or grouped
            (sheet.defects if is_defect else sheet.outlines).append(one)
    return sheets


def _list_marked(
    outlines: Sequence[Candidate], container: str | None, boxes: dict[int, _BoundingBox]
) -> list[Candidate]:
    if container is None:
        return [
            one
            for one in outlines
            if any(word and _is_word(word) for word in (one.name, one.layer, *one.words))
        ]
    spelled = {
        word
        for one in outlines
        for word in (one.name, one.layer, *one.groups)
        if word is not None and word.casefold() == container.casefold()
    }
    choice = container if container in spelled or len(spelled) != 1 else spelled.pop()
    grouped = [one for one in outlines if choice in one.groups]
    if grouped and not any(choice in (one.name, one.layer) for one in outlines):
        around = _find_enclosing(grouped, boxes)
        if around is None:
            raise FormatError(f"no outline of the group {quote(choice)} contains the others")
        return [around]
    found = select(outlines, choice)
    if len(found) > 1 and all(one.name == choice for one in found):
        number = [str(k) for k, one in enumerate(outlines) if any(one is o for o in found)]
        raise FormatError(
            f"{len(found)} outlines have the name {quote(choice)}; choose one by index: "
            f"{', '.join(number[:_LISTED])}"
        )
    return found


def _is_word(word: str) -> bool:
    return _WORDS.fullmatch(word) is not None


def _bound(outline: Candidate) -> _BoundingBox:
    vertices = outline.vertices()
    if not vertices:
        raise FormatError(f"{describe_place(outline)}: no vertices")
    xs, ys = zip(*vertices, strict=True)
    return min(xs), min(ys), max(xs), max(ys)


def _find_enclosing(
    outlines: Sequence[Candidate], boxes: dict[int, _BoundingBox]
) -> Candidate | None:
    """Find the outline whose box contains all others, ignoring copies of it."""
    lefts, lows, rights, highs = zip(*(boxes[id(one)] for one in outlines), strict=True)
    whole = min(lefts), min(lows), max(rights), max(highs)
    found = [one for one in outlines if boxes[id(one)] == whole]
    return found[0] if found and all(_is_copy(one, found[0]) for one in found) else None


def _is_copy(one: Candidate, other: Candidate) -> bool:
    alike = one.layer == other.layer and one.error == other.error
    return alike and _list_edges(one) == _list_edges(other)


def _list_edges(outline: Candidate) -> set[frozenset[Point]]:
    rings = [ring.vertices() for ring in (outline, *outline.holes())]
    edges = (frozenset(edge) for ring in rings for edge in pairwise((*ring, ring[0])))
    return {edge for edge in edges if len(edge) == 2}


def _overlap(one: _BoundingBox, other: _BoundingBox) -> bool:
    left, low, right, high = one
    west, south, east, north = other
    return left < east and west < right and low < north and south < high


def _contains_center(sheet: _BoundingBox, box: _BoundingBox) -> bool:
    left, low, right, high = sheet
    west, south, east, north = box
    return 2 * left <= west + east <= 2 * right and 2 * low <= south + north <= 2 * high


def _list_candidates(largest: Sequence[Candidate], boxes: dict[int, _BoundingBox]) -> str:
    listed = []
    for one in largest[:_LISTED]:
        left, low, right, high = boxes[id(one)]
        size = f"{show_number(right - left)} x {show_number(high - low)}"
        listed.append(f"{describe_place(one)}, {size}")
    return (
        "no outline contains all others; name the container (--container). The largest are "
        f"{'; '.join(listed)}"
    )
