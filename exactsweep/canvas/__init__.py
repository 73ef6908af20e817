"""Conversion of exact coordinates to pixels, and the SVG writer."""
