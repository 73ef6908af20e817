"""Layouts of nesting programs in: as data of the Layout JSON, exactly as written."""

from exactsweep.formats.layouts.found import FoundLayout
from exactsweep.formats.layouts.reading import parse_layouts, read_layout, read_layouts

__all__ = ["FoundLayout", "parse_layouts", "read_layout", "read_layouts"]
