"""Benchmarks: the growth of the procedures, and comparisons with other programs."""
