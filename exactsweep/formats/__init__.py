"""Readers and writers of polygons in JSON, GeoJSON, WKT, CSV, SVG, DXF and other libraries."""

from exactsweep.formats.candidate import NamedPolygon, NamedRegion
from exactsweep.formats.error import FormatError
from exactsweep.formats.exact_json import read_certificate
from exactsweep.formats.files import read_text, show_path
from exactsweep.formats.interchange import (
    from_numpy,
    from_shapely,
    from_sympy,
    from_wkt,
    parts_from_shapely,
    to_numpy,
    to_shapely,
    to_sympy,
)
from exactsweep.formats.part_list import Coordinates, PartList
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
    "Coordinates",
    "FormatError",
    "NamedPolygon",
    "NamedRegion",
    "PartList",
    "format_polygons",
    "from_numpy",
    "from_shapely",
    "from_sympy",
    "from_wkt",
    "parse_polygon",
    "parse_polygons",
    "parse_region",
    "parse_regions",
    "parts_from_shapely",
    "read_certificate",
    "read_polygon",
    "read_polygons",
    "read_region",
    "read_regions",
    "read_text",
    "round_region",
    "round_regions",
    "show_path",
    "to_numpy",
    "to_shapely",
    "to_sympy",
]
