"""Exact planar sweeps, no-fit polygons, inner fits and Minkowski sums of polygons."""

from importlib import import_module
from typing import TYPE_CHECKING

from exactsweep.evidence.minkowski import minkowski_sum
from exactsweep.evidence.overlap import Overlap, overlap
from exactsweep.evidence.union import NoFitUnion, no_fit_union
from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.direction import DirectionError
from exactsweep.geometry.distance import distance_squared
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.polyline import Polyline
from exactsweep.geometry.region import Region
from exactsweep.numbers.error import ExactSweepError, NumberError
from exactsweep.numbers.limits import limits
from exactsweep.numbers.number import Point
from exactsweep.sweep import (
    InnerFit,
    NoFitPolygon,
    Sweep,
    free_positions,
    inner_fit_polygon,
    minkowski_difference,
    no_fit_polygon,
    sweep,
)

__all__ = [
    "DirectionError",
    "ExactSweepError",
    "InnerFit",
    "NoFitPolygon",
    "NoFitUnion",
    "NumberError",
    "Overlap",
    "Point",
    "Polygon",
    "PolygonError",
    "Polyline",
    "Region",
    "Sweep",
    "distance_squared",
    "free_positions",
    "inner_fit_polygon",
    "limits",
    "minkowski_difference",
    "minkowski_sum",
    "no_fit_polygon",
    "no_fit_union",
    "overlap",
    "sweep",
]
__version__ = "0.1.0"
_PACKAGES = {"batch", "check", "conform", "corpus", "draw", "formats", "layout", "lessons", "view"}

if not TYPE_CHECKING:

    def __getattr__(name: str) -> object:
        """Import a public package on first use, as `exactsweep.formats`."""
        if name in _PACKAGES:
            return import_module(f"exactsweep.{name}")
        raise AttributeError(f"module 'exactsweep' has no attribute {name!r}")
