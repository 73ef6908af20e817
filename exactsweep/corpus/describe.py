"""Descriptions of cases, flags and families."""

from collections.abc import Iterator, Sequence
from textwrap import fill

from exactsweep.corpus.answered import NUMBER_TYPES
from exactsweep.corpus.case import Case
from exactsweep.corpus.generator import FAMILIES
from exactsweep.corpus.names import require_known
from exactsweep.corpus.shipped import find_case, list_ids, notes
from exactsweep.numbers.digits import format_fraction
from exactsweep.numbers.number import Point
from exactsweep.words import CLASSES

_WIDTH = 100


def describe(name: str) -> str:
    """Describe a case, a flag or a family of the generator by its name.

    Example:
        >>> print(describe("huge"), end="")
        huge, a flag
        Some coordinate is beyond 2^53.
        Catches: Integers that pass through a double, and overflow.
    """
    found = []
    if name in notes():
        found.append(f"{name}, a flag\n{_note(name, '')}")
    if name in FAMILIES:
        family = FAMILIES[name]
        found.append(f"{name}, a family of the generator, {family.level}\n{family.description}\n")
    if found:
        return "\n".join(found)
    if not name.startswith("gen-"):
        require_known(name, [*list_ids(), *notes(), *FAMILIES], "case, flag or family")
    return "".join(_case(find_case(name)))


def _case(case: Case) -> Iterator[str]:
    yield f"{case.id}: {case.title}\n\n"
    yield f"class          {CLASSES[case.kind]}\n"
    yield f"integer scale  {case.integer_scale}\n"
    yield f"input fits     {_types(case.representable)}\n"
    yield f"answer fits    {_types(case.answer_representable)}\n\n"
    yield from _rings("directrix", case.directrix_rings)
    yield from _rings("generatrix", case.generatrix_rings)
    yield _points("reference", [case.reference])
    yield "\n"
    yield from _rings("trajectory", [loop.vertices for loop in (case.trajectory, *case.holes)])
    yield from (_points("exact fit", fit) for fit in case.exact_fits)
    yield _points("inner loop", case.inner.vertices)
    yield _points("outer loop", case.outer.vertices)
    yield from (_points("unswept", loop.vertices) for loop in case.unswept)
    yield f"swept area  {format_fraction(case.area)}\n"
    if (regions := case.inner_regions) is not None:
        fits = case.inner_exact_fits
        yield "\nG inside D\n" if regions or fits else "\nG inside D: it does not fit\n"
        for region in regions:
            yield from _rings("region", region.rings)
        yield from (_points("exact fit", fit) for fit in fits)
    if case.note:
        yield f"\n{fill(case.note, _WIDTH)}\n"
    for flag in case.flags:
        yield f"\n{flag}\n{_note(flag, '  ')}"


def _rings(name: str, rings: Sequence[Sequence[Point]]) -> Iterator[str]:
    for k, ring in enumerate(rings):
        yield _points("  hole" if k else name, ring)


def _note(flag: str, indent: str) -> str:
    note = notes()[flag]
    lines = note.meaning, f"Catches: {note.catches}"
    return "".join(
        fill(line, _WIDTH, initial_indent=indent, subsequent_indent=indent) + "\n" for line in lines
    )


def _types(held: frozenset[str]) -> str:
    return ", ".join(name for name in NUMBER_TYPES if name in held) or "none of these types"


def _points(name: str, points: Sequence[Point]) -> str:
    text = " ".join(f"({','.join(map(format_fraction, point))})" for point in points)
    return f"{name:10}  {text}\n"
