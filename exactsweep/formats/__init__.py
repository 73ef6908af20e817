"""Text formats: polygons in, as JSON, WKT or GeoJSON; sweeps out, as JSON or WKT; certificates."""

from exactsweep.formats.certificates import read_certificate
from exactsweep.formats.error import FormatError
from exactsweep.formats.files import MAX_BYTES, file_name, read_text
from exactsweep.formats.json_text import (
    certificate_to_json,
    story_to_json,
    sweep_to_json,
    verification_to_json,
)
from exactsweep.formats.polygons import parse_polygon, read_polygon
from exactsweep.formats.wkt import sweep_to_wkt

__all__ = [
    "MAX_BYTES",
    "FormatError",
    "certificate_to_json",
    "file_name",
    "parse_polygon",
    "read_certificate",
    "read_polygon",
    "read_text",
    "story_to_json",
    "sweep_to_json",
    "sweep_to_wkt",
    "verification_to_json",
]
