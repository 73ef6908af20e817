"""Conversion of exact places to pixels, and the one writer of SVG."""
