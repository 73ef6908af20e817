"""Selection of polygons by name, index, layer or group, and of layers."""

from collections import Counter
from collections.abc import Sequence

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.depth import nest_candidates
from exactsweep.formats.error import FormatError
from exactsweep.formats.reading import Reading
from exactsweep.numbers.error import quote
from exactsweep.words import count, suggest

_SHOWN = 4


def choose(candidates: Sequence[Candidate], choice: str | None) -> Candidate:
    if choice is not None:
        found = select(candidates, choice)
        if len(found) == 1:
            return found[0]
        kind = "name" if found[0].name == choice else "layer"
        indices = [i for i, one in enumerate(candidates) if one in found]
        if not indices:
            number = (
                f"the group {quote(choice)} has {len(found)} outlines, not one; choose one by index"
            )
            raise FormatError(found[0].fault or number)
        raise FormatError(
            f"{len(found)} polygons have the {kind} {quote(choice)}; choose one by index: "
            f"{', '.join(f'#{i}' for i in indices[:_SHOWN])}{' ...' * (len(indices) > _SHOWN)}"
        )
    if not candidates:
        raise FormatError("contains no polygon")
    plain = [candidate for candidate in candidates if not candidate.ornament]
    if len(plain) == 1 or len(candidates) == 1:
        return (plain or candidates)[0]
    sound = [i for i, candidate in enumerate(candidates) if not candidate.fault]
    faults = [candidate.fault for candidate in candidates if candidate.fault]
    if not sound:
        raise FormatError(
            f"contains no polygon: {count(len(faults), 'element')} rejected, the first: "
            f"{faults[0]}{' ...' * (len(faults) > 1)}"
        )
    names = {i: candidates[i].name or candidates[i].layer for i in sound[:_SHOWN]}
    listed = ", ".join(f"#{i} {quote(name)}" if name else f"#{i}" for i, name in names.items())
    others = f"; {count(len(faults), 'element')} rejected, the first: {faults[0]}" if faults else ""
    raise FormatError(
        f"contains {count(len(sound), 'polygon')}; choose one by name, index or layer, as in "
        f"FILE#{_shortest_choice(candidates, sound[0])}: {listed}"
        f"{' ...' * (len(sound) > _SHOWN)}{others}"
    )


def select(candidates: Sequence[Candidate], choice: str) -> list[Candidate]:
    """Return all candidates with the given name, index, layer or group, in this priority.

    The prefix "layer:" selects only layers. If a layer has valid candidates, its rejected ones are
    dropped. In a group, outlines inside others are holes.
    """
    named = [candidate for candidate in candidates if candidate.name == choice]
    prefix, _, layer = choice.partition("layer:")
    if not (named or prefix):
        choice = layer
    # Names and layers may look like an index: the default layer of DXF is "0".
    is_index = not layer and choice.isascii() and choice.isdigit() and len(choice) < 10
    index = int(choice) if is_index else -1
    if len(named) != 1 and 0 <= index < len(candidates):
        return [candidates[index]]
    layered = [candidate for candidate in candidates if candidate.layer == choice]
    found = named or [one for one in layered if not one.fault] or layered
    if found:
        return found
    grouped = [candidate for candidate in candidates if choice in candidate.groups]
    if grouped:
        return nest_candidates(grouped)
    near = suggest(choice, [n for o in candidates for n in (o.name, o.layer, *o.groups) if n])
    raise FormatError(
        f"no polygon has the name, index, layer or group {quote(choice)}"
        f"{near or f'; there are {len(candidates)} polygons'}"
    )


def is_group(candidates: Sequence[Candidate], choice: str | None) -> bool:
    return bool(candidates) and all(
        choice in one.groups and choice not in (one.name, one.layer) for one in candidates
    )


def _shortest_choice(candidates: Sequence[Candidate], index: int) -> str:
    """Return the name or layer if it is unambiguous, else the index."""
    one = candidates[index]
    for word in (one.name, one.layer):
        if word and [c for c in candidates if word in (c.name, c.layer) and not c.fault] == [one]:
            return word
    return str(index)


def keep_layers(outlines: Sequence[Candidate], reading: Reading) -> Sequence[Candidate]:
    """Keep the outlines on the selected layers (or SVG groups), and count the others in a note."""
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
        reading.notes[f"skipped: {count(number, 'shape')} on {describe_layer(layer)}"] = None
    return found


def list_layers(outline: Candidate) -> list[str]:
    return [name for name in (outline.layer, *outline.groups) if name is not None]


def get_layer(outline: Candidate) -> str | None:
    return outline.groups[-1] if outline.layer is None and outline.groups else outline.layer


def describe_layer(layer: str | None) -> str:
    return "no layer" if layer is None else f"the layer {quote(layer)}"
