"""Other programs on the same sweeps: times, and exactness of their answers."""
