"""Polygons and regions as values, with their predicates and searches."""
