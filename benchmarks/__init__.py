"""Benchmarks: how the procedures grow, beside their claimed bounds, and beside other programs."""
