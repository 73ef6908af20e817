"""Conversion of exact coordinates to pixels, and the only SVG writer."""
