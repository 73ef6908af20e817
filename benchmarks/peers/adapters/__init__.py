"""Adapters of other programs, to be judged if they are installed.

Minkowski sum programs compute D + (-G); orbiting programs compute the path of G. Both polygons keep
their collinear vertices, but are oriented counter-clockwise, holes clockwise, and lose repeated
vertices, as several programs require. The adapters return every ring of an answer, with nothing
removed, joined or rounded, unless the adapter's docstring says so.

As a function: `load`. As a process that speaks the protocol of `exactsweep conform`:

    exactsweep conform -- python -m benchmarks.peers.adapters shapely
"""

from benchmarks.peers.adapters.adapter import Adapter, MissingError
from benchmarks.peers.adapters.names import NAMES, load

__all__ = ["NAMES", "Adapter", "MissingError", "load"]
