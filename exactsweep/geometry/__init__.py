"""Points, polygons, chains of points and what is asked of them: nothing here knows of sweeps."""
