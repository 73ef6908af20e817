"""Selection of polygons by name, index, layer or group."""

from collections.abc import Sequence

from exactsweep.formats.candidate import Candidate
from exactsweep.formats.depth import nest_candidates
from exactsweep.formats.error import FormatError
from exactsweep.numbers.error import quote
from exactsweep.words import count, suggest

_SHOWN = 4


def choose(candidates: Sequence[Candidate], choice: str | None) -> Candidate:
    """Return the selected candidate, or the only one; raises FormatError."""
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
    listed = ", ".join(f"#{i}" + _called(candidates[i]) for i in sound[:_SHOWN])
    others = f"; {count(len(faults), 'element')} rejected, the first: {faults[0]}" if faults else ""
    raise FormatError(
        f"contains {count(len(sound), 'polygon')}; choose one by name, index or layer, as in "
        f"FILE#{_shortest(candidates, sound[0])}: {listed}{' ...' * (len(sound) > _SHOWN)}{others}"
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
        f"{near or f'; there are {len(candidates)}'}"
    )


def is_group(candidates: Sequence[Candidate], choice: str | None) -> bool:
    """Return whether a choice selected the outlines of one group."""
    return bool(candidates) and all(
        choice in one.groups and choice not in (one.name, one.layer) for one in candidates
    )


def _shortest(candidates: Sequence[Candidate], index: int) -> str:
    """Return the name or layer if it is unambiguous, else the index."""
    one = candidates[index]
    for word in (one.name, one.layer):
        if word and [c for c in candidates if word in (c.name, c.layer) and not c.fault] == [one]:
            return word
    return str(index)


def _called(candidate: Candidate) -> str:
    name = candidate.name or candidate.layer
    return f" {quote(name)}" if name else ""
