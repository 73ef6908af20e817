"""The thirteen figures of the paper, redrawn from computed sweeps of other polygons."""
