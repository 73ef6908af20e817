"""Rounding of records."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from exactsweep.formats.rounding import Rounding, Side, round_fits, round_region
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region


def round_values(values: Mapping[str, Any], rounding: Rounding) -> dict[str, Any]:
    """Round the columns of a record; areas are computed from the exact loops.

    Outward, the trajectory, the outer loop and the exterior grow, all other loops shrink or vanish,
    and exact fits that would move are dropped.
    """
    places, outward = rounding

    def round_loop(loop: Polygon, side: Side) -> Polygon | None:
        region = round_region(Region(loop), places, side if outward else "closest").region
        return None if region is None else region.exterior

    found = dict(values)
    for name, value in values.items():
        if isinstance(value, Fraction):
            found[name] = round(value, places)
        elif name == "exact_fits":
            found[name], _ = round_fits(value, rounding)
        elif isinstance(value, Polygon):
            found[name] = round_loop(value, "inward" if name == "inner" else "outward")
        elif name in ("holes", "unswept"):
            loops = (round_loop(loop, "inward") for loop in value)
            found[name] = [loop for loop in loops if loop is not None]
    return found
