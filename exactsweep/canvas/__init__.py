"""Exact places to pixels, and the one writer of SVG."""
