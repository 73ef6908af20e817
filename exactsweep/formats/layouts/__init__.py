"""Readers of layouts from nesting programs; they return Layout JSON with exact numbers."""

from exactsweep.formats.layouts.model import FoundLayout
from exactsweep.formats.layouts.reading import parse_layouts, read_layout, read_layouts

__all__ = ["FoundLayout", "parse_layouts", "read_layout", "read_layouts"]
