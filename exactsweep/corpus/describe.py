"""Cases, flags and families in words."""

from collections.abc import Iterator, Sequence
from textwrap import fill

from exactsweep.corpus.case import Case
from exactsweep.corpus.generator import FAMILIES
from exactsweep.corpus.names import require_known
from exactsweep.corpus.representable import NUMBER_TYPES
from exactsweep.corpus.shipped import find_case, list_ids, notes
from exactsweep.geometry.region import Region
from exactsweep.numbers.number import format_fraction
from exactsweep.numbers.point import Fit, Point
from exactsweep.words import CLASSES

_WIDTH = 100


def describe(name: str) -> str:
    """Describe what has this name: a case, a flag or a family of the generator.

    Args:
        name: the id of a shipped or generated case, a flag, or a family.

    Returns:
        Lines of text.

    Raises:
        UnknownNameError: nothing has this name; the message suggests one that is similar.

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
    for name, rings in (
        ("directrix", case.directrix_rings),
        ("generatrix", case.generatrix_rings),
    ):
        yield _points(name, rings[0])
        for hole in rings[1:]:
            yield _points("  hole", hole)
    yield _points("reference", [case.reference])
    yield "\n"
    yield _points("trajectory", case.trajectory.vertices)
    for loop in case.holes:
        yield _points("  hole", loop.vertices)
    for fit in case.exact_fits:
        yield _points("exact fit", fit)
    yield _points("inner loop", case.inner.vertices)
    yield _points("outer loop", case.outer.vertices)
    for loop in case.unswept:
        yield _points("unswept", loop.vertices)
    yield f"swept area  {format_fraction(case.area)}\n"
    if case.inner_regions is not None:
        yield from _inside(case.inner_regions, case.inner_exact_fits)
    if case.note:
        yield f"\n{fill(case.note, _WIDTH)}\n"
    for flag in case.flags:
        yield f"\n{flag}\n{_note(flag, '  ')}"


def _inside(regions: Sequence[Region], fits: Sequence[Fit]) -> Iterator[str]:
    yield "\nG inside D\n" if regions or fits else "\nG inside D: it does not fit\n"
    for region in regions:
        yield _points("region", region.exterior.vertices)
        for hole in region.holes:
            yield _points("  hole", hole.vertices)
    for fit in fits:
        yield _points("exact fit", fit)


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
