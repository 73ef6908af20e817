"""Sabotages of the procedures for polygons of any shape."""
