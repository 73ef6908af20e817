"""Formats: polygons in and out, as JSON, GeoJSON, WKT, SVG, DXF and objects; results as text."""

from exactsweep.formats.candidate import NamedPolygon, NamedRegion
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import read_certificate
from exactsweep.formats.files import MAX_BYTES, file_name, read_text
from exactsweep.formats.interchange import from_numpy, from_shapely, to_numpy, to_shapely
from exactsweep.formats.polygons import (
    parse_polygon,
    parse_polygons,
    parse_region,
    parse_regions,
    read_polygon,
    read_polygons,
    read_region,
    read_regions,
)
from exactsweep.formats.rounding import round_region, round_regions
from exactsweep.formats.writing import FORMATS, format_polygons

__all__ = [
    "FORMATS",
    "MAX_BYTES",
    "FormatError",
    "NamedPolygon",
    "NamedRegion",
    "file_name",
    "format_polygons",
    "from_numpy",
    "from_shapely",
    "parse_polygon",
    "parse_polygons",
    "parse_region",
    "parse_regions",
    "read_certificate",
    "read_polygon",
    "read_polygons",
    "read_region",
    "read_regions",
    "read_text",
    "round_region",
    "round_regions",
    "to_numpy",
    "to_shapely",
]
