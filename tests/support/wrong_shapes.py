"""Sabotages of the procedures for polygons of any shape."""

from collections.abc import Callable
from typing import Any

from sabotage import Procedure, sabotage

from exactsweep.geometry.canonical import find_doubled_area
from exactsweep.procedures import any_shape, contact_lines, cover, crossings, free_positions, ss


def is_point(fit: Any) -> bool:
    """Decide whether an exact fit is a single position."""
    return bool(fit[0] == fit[1])


@sabotage(
    "no-fit polygon: no holes", ss.no_fit_ss, "Loops of any shape", "Size of a no-fit polygon"
)
def forget_holes(right: Procedure) -> Procedure:
    return lambda *arguments: right(*arguments)._replace(within=[])


@sabotage("no-fit polygon: the last hole forgotten", ss.no_fit_ss, "Size of a no-fit polygon")
def forget_last_hole(right: Procedure) -> Procedure:
    def no_fit_ss(*arguments: Any) -> Any:
        found = right(*arguments)
        return found._replace(within=found.within[:-1])

    return no_fit_ss


@sabotage("no-fit polygon: single positions forgotten", ss.no_fit_ss, "Exact fits of any shape")
def forget_points(right: Procedure) -> Procedure:
    def no_fit_ss(*arguments: Any) -> Any:
        found = right(*arguments)
        return found._replace(fits=[fit for fit in found.fits if not is_point(fit)])

    return no_fit_ss


@sabotage("no-fit polygon: a corner of the exterior is cut", ss.no_fit_ss, "Contact segments")
def cut_corner(right: Procedure) -> Procedure:
    def no_fit_ss(*arguments: Any) -> Any:
        found = right(*arguments)
        (exterior,) = found.around
        return found._replace(around=[exterior[:-1] if len(exterior) > 3 else exterior])

    return no_fit_ss


@sabotage("inner fit: only the first region", ss.inner_fit_ss, "Inner fit")
def take_first_region(right: Procedure) -> Procedure:
    def inner_fit_ss(*arguments: Any) -> Any:
        found = right(*arguments)
        return found._replace(regions=found.regions[:1])

    return inner_fit_ss


@sabotage("inner fit: exact fits forgotten", ss.inner_fit_ss, "Inner fit")
def forget_inner_fits(right: Procedure) -> Procedure:
    return lambda *arguments: right(*arguments)._replace(fits=[])


@sabotage(
    "loops: not parted where they come back to a point",
    free_positions._part_where_it_touches,
    "Inner fit",
)
def leave_pinched(right: Procedure) -> Procedure:
    return lambda ring: iter([list(ring)])


@sabotage(
    "contact segments: those of G's vertices forgotten",
    contact_lines.find_contact_stretches,
    "Loops of any shape",
    "Contact segments",
)
def forget_one_side(right: Procedure) -> Procedure:
    return lambda stationary, moving: right(stationary, moving)[::2]


@sabotage(
    "contact segments: right, but each one many times",
    contact_lines.find_contact_stretches,
    "Contact segments",
)
def repeat_stretches(right: Procedure) -> Procedure:
    return lambda stationary, moving: right(stationary, moving) * 12


@sabotage(
    "squares that are known to be overlapped: one stretch too many is left out",
    cover.leave_out_covered,
    "Loops of any shape",
)
def leave_out_more(right: Procedure) -> Procedure:
    return lambda *arguments: right(*arguments)[:-1]


@sabotage(
    "crossings: none is found", crossings.cut_at_crossings, "Loops of any shape", "Contact segments"
)
def find_no_crossing(right: Procedure) -> Procedure:
    return lambda stretches: None


@sabotage(
    "swept area: of several places that are not swept only the first",
    any_shape.ShapeSolution,
    "Swept area of any shape",
)
def keep_first_unswept(right: Procedure) -> Procedure:
    class Forgetful(right):  # type: ignore[misc, valid-type]
        @property
        def unswept(self) -> Any:
            return super().unswept[:1]

    return Forgetful


@sabotage("no-fit polygon: holes of an area below two are lost", ss.no_fit_ss, "Loops of any shape")
def forget_small_holes(right: Procedure) -> Procedure:
    def no_fit_ss(*arguments: Any) -> Any:
        found = right(*arguments)
        return found._replace(within=[r for r in found.within if find_doubled_area(r) >= 4])

    return no_fit_ss


for fault, keep in (
    ("loops inside a region after the first are lost", lambda r: [(e, h[:1]) for e, h in r]),
    ("regions after the second are lost", lambda regions: regions[:2]),
):

    def keep_few(right: Procedure, keep: Callable[[Any], Any] = keep) -> Procedure:
        def inner_fit_ss(*arguments: Any) -> Any:
            found = right(*arguments)
            return found._replace(regions=keep(found.regions))

        return inner_fit_ss

    sabotage(f"inner fit: {fault}", ss.inner_fit_ss, "Inner fit")(keep_few)
