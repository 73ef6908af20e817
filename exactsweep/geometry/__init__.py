"""Points, polygons and regions, and functions of them; this package does not know sweeps."""
