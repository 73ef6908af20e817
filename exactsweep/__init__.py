"""Exact planar sweeps: no-fit polygons of polygons of any shape."""

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.direction import DirectionError
from exactsweep.geometry.error import ExactSweepError
from exactsweep.geometry.limits import limits
from exactsweep.geometry.number import NumberError
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon
from exactsweep.geometry.region import Region
from exactsweep.sweep import (
    InnerFit,
    NoFitPolygon,
    Sweep,
    inner_fit_polygon,
    no_fit_polygon,
    sweep,
)

__all__ = [
    "DirectionError",
    "ExactSweepError",
    "InnerFit",
    "NoFitPolygon",
    "NumberError",
    "Point",
    "Polygon",
    "PolygonError",
    "Region",
    "Sweep",
    "inner_fit_polygon",
    "limits",
    "no_fit_polygon",
    "sweep",
]
__version__ = "0.1.0"
