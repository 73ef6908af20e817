"""Exact planar sweeps: no-fit polygons of convex and monotone polygons."""

from exactsweep.direction import DirectionError
from exactsweep.number import NumberError, limits
from exactsweep.polygon import Point, Polygon, PolygonError
from exactsweep.sweep import Sweep, no_fit_polygon, sweep

__all__ = [
    "DirectionError",
    "NumberError",
    "Point",
    "Polygon",
    "PolygonError",
    "Sweep",
    "limits",
    "no_fit_polygon",
    "sweep",
]
__version__ = "0.1.0"
