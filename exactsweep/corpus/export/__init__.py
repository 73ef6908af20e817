"""Cases for other programs: JSON lines, WKT, GeoJSON, and a sheet to look at."""

from exactsweep.corpus.case_json import case_to_line
from exactsweep.corpus.export.geojson import cases_to_geojson
from exactsweep.corpus.export.sheet import cases_to_svg
from exactsweep.corpus.export.wkt import cases_to_wkt

__all__ = ["case_to_line", "cases_to_geojson", "cases_to_svg", "cases_to_wkt"]
