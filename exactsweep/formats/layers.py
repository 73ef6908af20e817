"""The choice of layers of a drawing."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.numbers.error import quote
from exactsweep.words import count, suggest


def keep_layers(outlines: Sequence[Candidate], reading: Reading) -> Sequence[Candidate]:
    """Keep the outlines on the layers that a reading asks for, and note the number of others.

    Raises:
        FormatError: the file has no layer of a given name.
    """
    if not reading.layers and not reading.ignored_layers:
        return outlines
    known = {one.layer.casefold(): one.layer for one in outlines if one.layer is not None}
    for name in (*reading.layers, *reading.ignored_layers):
        if name.casefold() not in known:
            names = [layer for layer in known.values() if layer]
            listed = f"; the layers are {', '.join(map(quote, names))}" if names else ""
            raise FormatError(f"no layer {quote(name)}{suggest(name, names) or listed}")
    wanted: set[str | None] = {name.casefold() for name in reading.layers} or {None, *known}
    wanted -= {name.casefold() for name in reading.ignored_layers}
    found = [one for one in outlines if _fold(one) in wanted]
    left = Counter(one.layer for one in outlines if _fold(one) not in wanted)
    for layer, number in left.items():
        place = "on no layer" if layer is None else f"on the layer {quote(layer)}"
        reading.notes[f"skipped: {count(number, 'shape')} {place}"] = None
    return found


def _fold(outline: Candidate) -> str | None:
    return None if outline.layer is None else outline.layer.casefold()
