"""Sabotages of the procedures for polygons of any shape."""

from collections.abc import Callable
from typing import Any

from sabotage import Procedure, Sabotage, sabotage

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.procedures import any_shape, cover, crossings, positions, segments, walk

Change = Callable[[Any], Any]


def changing(**changes: Change) -> Sabotage:
    """Change some fields of a procedure's result."""

    def sabotaged(right: Procedure) -> Procedure:
        def wrong(*arguments: Any) -> Any:
            found = right(*arguments)
            changed = {name: change(getattr(found, name)) for name, change in changes.items()}
            return found._replace(**changed)

        return wrong

    return sabotaged


def giving(change: Change) -> Sabotage:
    """Change a procedure's whole result."""
    return lambda right: lambda *arguments: change(right(*arguments))


def cut_corner(loops: Any) -> Any:
    (exterior,) = loops
    return [exterior[:-1] if len(exterior) > 3 else exterior]


def keep_first_unswept(right: Procedure) -> Procedure:
    class Forgetful(right):  # type: ignore[misc, valid-type]
        @property
        def unswept(self) -> Any:
            return super().unswept[:1]

    return Forgetful


NO_FIT: dict[str, Sabotage] = {
    "no holes": changing(within=lambda loops: []),
    "the last hole is forgotten": changing(within=lambda loops: loops[:-1]),
    "single positions forgotten": changing(fits=lambda fits: [(a, b) for a, b in fits if a != b]),
    "a corner of the exterior is cut": changing(around=cut_corner),
    "holes of an area below two are lost": changing(
        within=lambda loops: [loop for loop in loops if find_doubled_area(loop) >= 4]
    ),
}
INNER_FIT = {
    "only the first region": changing(regions=lambda regions: regions[:1]),
    "exact fits forgotten": changing(fits=lambda fits: []),
    "loops inside a region after the first are lost": changing(
        regions=lambda regions: [(exterior, holes[:1]) for exterior, holes in regions]
    ),
    "regions after the second are lost": changing(regions=lambda regions: regions[:2]),
}
OTHERS: dict[str, tuple[Procedure, Sabotage]] = {
    "loops: of several pieces, the last one counter-clockwise follows": (
        walk._follow,
        lambda right: (
            lambda piece, leaving, choose=max: right(piece, leaving, min if choose is max else max)
        ),
    ),
    "contact segments: those of G's vertices are forgotten": (
        segments.find_contact_segments,
        giving(lambda found: found[::2]),
    ),
    "contact segments: right, but each one is repeated many times": (
        segments.find_contact_segments,
        giving(lambda found: found * 12),
    ),
    "squares in O: one segment too many is dropped": (
        cover.leave_out_covered,
        giving(lambda found: found[:-1]),
    ),
    "crossings: none are found": (
        crossings.record_crossing,
        lambda right: lambda first, second, bits: None,
    ),
    "swept area: only the first of several unswept holes": (
        any_shape.ShapeSolution,
        keep_first_unswept,
    ),
}

for fault, wrong in NO_FIT.items():
    sabotage(f"no-fit polygon: {fault}", positions.find_sum)(wrong)
for fault, wrong in INNER_FIT.items():
    sabotage(f"inner fit: {fault}", positions.find_inner_fit)(wrong)
for fault, (procedure, wrong) in OTHERS.items():
    sabotage(fault, procedure)(wrong)
