"""Reports and JSON of Minkowski sums and overlaps."""

from collections.abc import Sequence
from typing import NamedTuple

from exactsweep.evidence.overlap import Overlap
from exactsweep.formats.exact_json import write_json
from exactsweep.geometry.polyline import Polyline
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.text import report
from exactsweep.text.results import write_json_value, write_object
from exactsweep.words import count, write_pair


class NamedOverlap(NamedTuple):
    first: str
    second: str
    found: Overlap


def sum_to_json(a: AnyPolygon, b: AnyPolygon | Polyline, found: Region) -> str:
    path = {"path": b.points, "closed": b.closed} if isinstance(b, Polyline) else None
    return write_object(
        {
            "a": write_json(write_json_value(a)),
            "b": write_json(path if path is not None else write_json_value(b)),  # type: ignore[arg-type]
            "exterior": write_json(found.exterior.vertices),
            "holes": write_json([hole.vertices for hole in found.holes]),
            "area": write_json(found.area),
        }
    )


def report_sum(
    a: AnyPolygon, b: AnyPolygon | Polyline, found: Region, terminal_width: int | None = None
) -> str:
    loops = {"exterior": found.exterior}
    loops |= {f"hole {k}": hole for k, hole in enumerate(found.holes)}
    width = max(map(len, [*loops, "b (path)"]))
    sizes = report.make_table(("", "vertices", "approx. area", "exact area"), {"vertices"}, width)
    sizes.add_row("a", str(len(a)), *report.write_area(a.area))
    if isinstance(b, Polyline):
        sizes.add_row("b (path)", str(len(b)), "", "")
    else:
        sizes.add_row("b", str(len(b)), *report.write_area(b.area))
    sizes.add_row("sum", str(len(found)), *report.write_area(found.area))
    texts = {name: str(loop).replace(", ", ",") for name, loop in loops.items()}
    return report.lay_out([sizes, report.list_facts(texts, width)], terminal_width)


def overlap_to_json(o: Overlap) -> str:
    return write_object(
        {
            "a": write_json(write_json_value(o.a)),
            "b": write_json(write_json_value(o.b)),
            **{name: write_json(value) for name, value in _list_results(o).items()},
        }
    )


def overlaps_to_json(found: Sequence[NamedOverlap]) -> str:
    return "".join(
        write_json({"a": first, "b": second} | _list_results(o)) + "\n"
        for first, second, o in found
    )


def _list_results(o: Overlap) -> dict[str, object]:
    return {
        "verdict": o.verdict,
        "area": o.area,
        "witness": o.witness,
        "distance_squared": o.distance_squared,
        "move": o.move,
        "depth_squared": o.depth_squared,
    }


def report_overlap(o: Overlap, terminal_width: int | None = None) -> str:
    facts: dict[str, str] = {"verdict": o.verdict}
    if o.verdict == "OVERLAP":
        rounded, exact = report.write_area(o.area)
        facts["common area"] = f"{exact}, about {rounded}" if rounded else exact
        facts["depth"] = report.approximate(report.take_root(o.depth_squared), up=True)
        facts["least move"] = f"{write_pair(o.move)} of b"
    elif o.verdict == "FREE":
        facts["distance"] = report.approximate(report.take_root(o.distance_squared))
        facts["nearest"] = " ".join(map(write_pair, o.nearest))
    if o.witness is not None:
        where = "inside both" if o.verdict == "OVERLAP" else "on both boundaries"
        facts["witness"] = f"{write_pair(o.witness)}, {where}"
    return report.lay_out([report.list_facts(facts, 0)], terminal_width)


def report_overlaps(
    found: Sequence[NamedOverlap], free: int, terminal_width: int | None = None
) -> str:
    """List the pairs that overlap or touch, and count the free ones."""
    numbers = ("approx. area", "approx. depth")
    table = report.make_table(("a", "b", "verdict", *numbers), numbers)
    for first, second, o in found:
        depth = report.approximate(report.take_root(o.depth_squared), up=True)
        table.add_row(first, second, o.verdict, report.approximate(o.area), depth)
    overlapping = sum(o.verdict == "OVERLAP" for *_, o in found)
    touching = len(found) - overlapping
    total = f"{count(overlapping, 'overlap')}, {touching} in contact, {free} free\n"
    return (report.lay_out([table], terminal_width) if found else "") + total
