"""Comparison with other programs on the same sweeps: running time and exactness."""
