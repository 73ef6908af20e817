"""Exact planar sweeps: no-fit polygons of convex and monotone polygons."""

from exactsweep.geometry.canonical import PolygonError
from exactsweep.geometry.direction import DirectionError
from exactsweep.geometry.number import NumberError, limits
from exactsweep.geometry.point import Point
from exactsweep.geometry.polygon import Polygon
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
