"""A part list of a sheet-metal shop: brackets, gussets, flanges, combs, half washers."""

from pathlib import Path

from exactsweep.formats import NamedPolygon, read_polygons


def part_list(count: int) -> list[NamedPolygon]:
    """Return up to 32 parts, equally many of each kind, some rotated by multiples of 90 degrees."""
    return read_polygons(Path(__file__).with_name("parts.json"))[:count]
