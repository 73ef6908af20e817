"""Results as exact JSON, and as named regions."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from fractions import Fraction
from typing import TYPE_CHECKING

from exactsweep.evidence.minkowski import MinkowskiSum
from exactsweep.evidence.no_fit import NoFitAnswer, RegionAnswer
from exactsweep.evidence.steps import Step, explain
from exactsweep.evidence.sweep import SweepAnswer
from exactsweep.formats.candidate import NamedRegion
from exactsweep.geometry.direction import Vector
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import AnyPolygon, Region
from exactsweep.numbers.digits import format_fraction

if TYPE_CHECKING:
    from exactsweep.check import Verification

_ZERO = Fraction(0)


def sweep_to_json(sweep: SweepAnswer, error: Fraction = _ZERO) -> str:
    """Format a sweep and its input as JSON, one key per line.

    The direction is a pair of integers, null for kind "SS"; all other numbers are strings for
    `to_fraction`. `error` is the sum of the errors of both polygons; 0 is omitted.
    """
    loops = {"trajectory": sweep.trajectory, "inner": sweep.inner, "outer": sweep.outer}
    texts = {
        **_input(sweep),
        **{name: _write(loop.vertices) for name, loop in loops.items()},
        **({"unswept": _write(_loops(sweep.unswept))} if sweep.kind == "SS" else {}),
        "area": _write(sweep.area),
        **_format_error(error),
    }
    return write_object(texts)


def no_fit_to_json(n: NoFitAnswer, error: Fraction = _ZERO) -> str:
    return write_object(
        {
            "stationary": _write(write_json_value(n.stationary)),
            "orbiting": _write(write_json_value(n.orbiting)),
            "kind": _write(n.kind),
            "reference": _write(n.reference),
            "exterior": _write(n.exterior.vertices),
            "holes": _write(_loops(n.holes)),
            "exact_fits": _write(n.exact_fits),
            "area": _write(n.area),
            **_format_error(error),
        }
    )


def regions_to_json(f: RegionAnswer, error: Fraction = _ZERO) -> str:
    return write_object(
        {
            **{name: _write(value) for name in f.asked if (value := getattr(f, name)) != ()},
            "regions": _write([_rings(region) for region in f.regions]),
            "exact_fits": _write(f.exact_fits),
            "area": _write(f.area),
            **_format_error(error),
        }
    )


def _format_error(error: Fraction) -> dict[str, str]:
    return {"error": _write(error)} if error else {}


def write_json_value(shape: AnyPolygon) -> object:
    """Convert a shape to a list of vertices or, if it has holes, to an object with its rings."""
    return _rings(shape) if isinstance(shape, Region) and shape.holes else shape.vertices


def _rings(region: Region) -> dict[str, object]:
    return {"exterior": region.exterior.vertices, "holes": _loops(region.holes)}


def _loops(loops: Iterable[Polygon]) -> list[object]:
    return [loop.vertices for loop in loops]


def certificate_to_json(result: SweepAnswer | NoFitAnswer | RegionAnswer | MinkowskiSum) -> str:
    found = result.certificate()
    return write_object(
        {name: json.dumps(value, separators=(",", ":")) for name, value in found.items()}
    )


def explanation_to_json(sweep: SweepAnswer) -> str:
    """Format the steps of a sweep as JSON, like `sweep_to_json`.

    "features" maps each vertex, and the edge that starts there, to its index in the input.
    """
    steps = [_write(_step(step)) for step in explain(sweep)]
    loops = [hole.vertices for hole in sweep.no_fit_holes]
    along = sweep.contacts_along(loops)
    segments = iter(sweep.contacts_along([fit for fit in sweep.exact_fits if fit[0] != fit[1]]))
    fit_contacts = [
        sweep.contacts_at(fit[0]) if fit[0] == fit[1] else next(segments)[0]
        for fit in sweep.exact_fits
    ]
    return write_object(
        {
            **_input(sweep),
            "features": _write(
                {
                    "generatrix": list_indices(sweep.generatrix),
                    "directrix": list_indices(sweep.directrix),
                }
            ),
            "undercuts": _write(
                [
                    u._asdict() | {"polygon": u.polygon.vertices, "area": u.polygon.area}
                    for u in sweep.undercuts
                ]
            ),
            "exact_fits": _write(sweep.exact_fits),
            "exact_fit_contacts": _write(fit_contacts),
            "holes": _write(
                [
                    {"loop": loop, "contacts": found}
                    for loop, found in zip(loops, along, strict=True)
                ]
            ),
            "steps": "[\n    " + ",\n    ".join(steps) + "\n  ]",
        }
    )


def verification_to_json(verification: Verification) -> str:
    return write_object({name: _write(part) for name, part in verification._asdict().items()})


def _input(sweep: SweepAnswer) -> dict[str, str]:
    return {
        "generatrix": _write(write_json_value(sweep.generatrix)),
        "directrix": _write(write_json_value(sweep.directrix)),
        "kind": _write(sweep.kind),
        "direction": direction_to_json(sweep.direction),
        "reference": _write(sweep.reference),
    }


def direction_to_json(direction: Vector | None) -> str:
    if direction is None:
        return "null"
    return f"[{', '.join(format_fraction(Fraction(component)) for component in direction)}]"


def list_indices(shape: AnyPolygon) -> dict[str, list[int]]:
    """List the input indices of vertices, and of the edges that start there."""
    size = len(shape)
    return {
        "vertices": [shape.vertex_index(k) for k in range(size)],
        "edges": [shape.edge_index(k) for k in range(size)],
    }


def _step(step: Step) -> dict[str, object]:
    return {
        **step._asdict(),
        "direction": [Fraction(component) for component in step.direction],
        "touches": [touch._asdict() for touch in step.touches],
        "landmarks": [landmark._asdict() for landmark in step.landmarks],
    }


def write_object(texts: Mapping[str, str]) -> str:
    """Format a JSON object from formatted values, one key per line."""
    lines = (f"  {json.dumps(name)}: {text}" for name, text in texts.items())
    return "{\n" + ",\n".join(lines) + "\n}\n"


def _write(value: object) -> str:
    return json.dumps(
        value,
        default=lambda v: write_json_value(v) if isinstance(v, Region) else format_fraction(v),
    )


def sweep_to_regions(
    sweep: SweepAnswer, stays: Fraction = _ZERO, moves: Fraction = _ZERO
) -> list[NamedRegion]:
    """Name the loops of a sweep, given the errors of both polygons.

    The error of the generatrix counts twice, except in the trajectory.
    """
    loops = {"trajectory": sweep.trajectory, "inner": sweep.inner, "outer": sweep.outer}
    loops |= {f"unswept {k}": loop for k, loop in enumerate(sweep.unswept)}
    return [
        NamedRegion(Region(loop), name, None, stays + moves * (1 if name == "trajectory" else 2))
        for name, loop in loops.items()
    ]


def no_fit_to_regions(
    n: NoFitAnswer, stays: Fraction = _ZERO, moves: Fraction = _ZERO
) -> list[NamedRegion]:
    return [NamedRegion(Region(n.exterior, n.holes), "nfp", None, stays + moves)]


def name_regions(
    f: RegionAnswer, stays: Fraction = _ZERO, moves: Fraction = _ZERO
) -> list[NamedRegion]:
    regions = enumerate(f.regions)
    return [NamedRegion(region, f"region {k}", None, stays + moves) for k, region in regions]
