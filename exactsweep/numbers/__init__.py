"""Exact numbers and points: reading, limits, writing. This package imports no other package."""
