"""Selection of layers."""

from collections import Counter
from collections.abc import Sequence

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.numbers.error import quote
from exactsweep.words import count, suggest


def keep_layers(outlines: Sequence[Candidate], reading: Reading) -> Sequence[Candidate]:
    """Keep the outlines on the selected layers, and count the others in a note.

    SVG groups with an id count as layers. Raises FormatError if a layer does not exist.
    """
    wanted, ignored = ({*map(str.casefold, n)} for n in (reading.layers, reading.ignored_layers))
    if not wanted and not ignored:
        return outlines
    known = {name.casefold(): name for one in outlines for name in list_layers(one)}
    for name in (*reading.layers, *reading.ignored_layers):
        if name.casefold() not in known:
            names = [layer for layer in known.values() if layer]
            listed = f"; the layers are {', '.join(map(quote, names))}" if names else ""
            raise FormatError(f"no layer {quote(name)}{suggest(name, names) or listed}")
    found, left = [], Counter[str | None]()
    for one in outlines:
        its = {*map(str.casefold, list_layers(one))}
        if its & ignored or (wanted and not its & wanted):
            hidden = next((name for name in list_layers(one) if name.casefold() in ignored), None)
            left[hidden or get_layer(one)] += 1
        else:
            found.append(one)
    for layer, number in left.items():
        reading.notes[f"skipped: {count(number, 'shape')} on {tell_layer(layer)}"] = None
    return found


def list_layers(outline: Candidate) -> list[str]:
    return [name for name in (outline.layer, *outline.groups) if name is not None]


def get_layer(outline: Candidate) -> str | None:
    """Return the layer of an outline, else its innermost group, else None."""
    return outline.groups[-1] if outline.layer is None and outline.groups else outline.layer


def tell_layer(layer: str | None) -> str:
    return "no layer" if layer is None else f"the layer {quote(layer)}"
