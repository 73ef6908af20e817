"""The same sweeps by other programs, side by side, and what of their answers is exact."""
